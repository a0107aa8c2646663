# Completion of the program's arguments in bash.
_voussoir() {
  local current=${COMP_WORDS[COMP_CWORD]} options
  COMPREPLY=()
  case $current in
    -*)
      options="--set --sweep --find --result --directories --print-parameters \
        --print-reference --quiet --verbosity --help --version"
      mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
      ;;
    *)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$current"
                               compgen -d -S / -- "$current")
      compopt -o filenames 2>/dev/null
      ;;
  esac
}
complete -F _voussoir voussoir
