# What the scripts of contrib share; to be sourced by them.

# The project's top directory.
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
  echo "$(basename "$0"): $1" >&2
  exit 1
}

# The packages of contrib/packages.txt: those to run, and those that have the
# purpose, such as "test".
packages() {
  awk -v purpose="$1" '!/^#/ && NF {
      wanted = NF == 1
      for (i = 2; i <= NF; ++i) wanted = wanted || $i == purpose
      if (wanted) print $1
    }' "$top/contrib/packages.txt"
}

# Install those packages that are missing.
install_packages() {
  command -v dpkg-query >/dev/null ||
    fail "this is not Debian; install what contrib/packages.txt lists by hand."
  local package missing=()
  for package in $(packages "$1"); do
    dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null |
      grep -q '^install ok installed$' || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "run it as root, or install ${missing[*]}."
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq ||
    fail "the lists of packages cannot be updated."
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null ||
    fail "the packages cannot be installed."
}

# Make the bare Debian of a name in a directory, from where this machine has its
# own packages.
make_debian() {
  local mirror
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
    sed -n '/debian\/*$/{p;q}')
  mmdebstrap --quiet --variant=minbase --include=ca-certificates,git "$1" "$2" \
    ${mirror:+"deb $mirror $1 main"} || fail "there is no Debian '$1'."
}

# Whether the build directory was made for another one: the clone was copied or moved.
is_of_another_clone() {
  local cache="$directory/CMakeCache.txt" entry
  [ -f "$cache" ] || return 1
  for entry in "CMAKE_HOME_DIRECTORY $top" "CMAKE_CACHEFILE_DIR $directory"; do
    [ "$(sed -n "s/^${entry%% *}:INTERNAL=//p" "$cache")" -ef "${entry#* }" ] ||
      return 0
  done
  return 1
}

# Build a target in build/debug or build/release, with options NAME=VALUE for
# CMake, which runs only if an option or the list of files has changed. The type
# Debug:NAME is Debug in build/NAME. The files of a room are compiled as few, but
# one by one with VOUSSOIR_JUMBO=OFF in the environment. In a clone that was copied
# or moved nothing is kept, since paths in it lead to the sources of the other.
build() {
  local type=${1%:*} name=${1#*:} target=$2 option stale=no
  shift 2
  set -- VOUSSOIR_JUMBO="${VOUSSOIR_JUMBO:-ON}" "$@"
  directory="$top/build/${name,,}"
  if is_of_another_clone; then
    echo "$directory was copied or moved here, and is built anew"
    find "$directory" -depth \( -name CMakeFiles -o -name CMakeCache.txt \) \
      -exec rm -rf {} +
    rm -f "$directory/Makefile" "$directory/voussoir"
  fi
  [ -e "$directory/voussoir" ] ||
    echo "The first build of the program takes about three minutes on two cores"
  for option in "$@"; do
    grep -qs "^${option%%=*}:[A-Z]*=${option#*=}$" "$directory/CMakeCache.txt" ||
      stale=yes
  done
  [ -f "$directory/Makefile" ] &&
    [ -z "$(find "$top/tests" -type d -newer "$directory/Makefile")" ] || stale=yes
  if [ $stale = yes ]; then
    echo "Configuring $directory"
    cmake -S "$top" -B "$directory" -DCMAKE_BUILD_TYPE="$type" "${@/#/-D}" \
      >/dev/null || fail "CMake cannot configure $directory."
    touch "$directory/Makefile"
  fi
  make --no-print-directory -C "$directory" -j "$(nproc)" "$target" |
    { grep --line-buffered -E '^\[ *[0-9]+%\] (Building|Linking)|\*\*\*' || true; } ||
    fail "the build in $directory failed."
}
