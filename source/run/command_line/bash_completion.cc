// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/parameters/pattern_description.h>
#include <voussoir/run/command_line/bash_completion.h>

#include <boost/algorithm/string/join.hpp>

#include <ostream>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

/** Behind the lists of options, entries and sections. */
const char *const script = R"(
# The candidates in a list, one a line, that begin with what is typed. Readline
# replaces the word behind the last break, and blanks outside quotes are escaped.
_voussoir_offer() {
  local typed=$1 quote=$2 candidate kept=""
  if [ -z "$quote" ]; then
    typed=${typed//\\/}
    case $typed in *=*) kept=${typed%=*}= ;; esac
  fi
  while IFS= read -r candidate; do
    case $candidate in "$typed"*) ;; *) continue ;; esac
    case $candidate in *=) compopt -o nospace 2>/dev/null ;; esac
    candidate=${candidate#"$kept"}
    [ -n "$quote" ] || candidate=${candidate// /\\ }
    COMPREPLY+=("$candidate")
  done <<<"$3"
}

_voussoir() {
  local line=${COMP_LINE:0:COMP_POINT} current=${COMP_WORDS[COMP_CWORD]} ending
  local quoted='--(set|sweep|find)[= ]+(["'\''])([^"'\'']*)$'
  local bare='--(set|sweep|find)[= ]+(([^"'\''\ ]|\\.)*)$'
  local section='--print-parameters=(([^"'\''\ ]|\\.)*)$'
  COMPREPLY=()
  if [[ $line =~ $quoted ]]; then
    _voussoir_offer "${BASH_REMATCH[3]}" quoted "$_voussoir_entries"
  elif [[ $line =~ $bare ]]; then
    _voussoir_offer "${BASH_REMATCH[2]}" "" "$_voussoir_entries"
  elif [[ $line =~ $section ]]; then
    _voussoir_offer "${BASH_REMATCH[1]}" "" "$_voussoir_sections"
  elif [[ $line =~ --as[=\ ]+([a-z]*)$ ]]; then
    _voussoir_offer "${BASH_REMATCH[1]}" "" $'prm\njson\nxml'
  elif [[ $current == -* ]]; then
    _voussoir_offer "$current" "" "$_voussoir_options"
  else
    for ending in prm json xml; do
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
        compgen -f -X "!*.$ending" -- "$current")
    done
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
      compgen -d -S / -- "$current")
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _voussoir voussoir
)";

/** "Section/Name=", or with each of the values that it accepts. */
void add_entry(const std::string &path, const Json &entry, Names &entries)
{
  const PatternDescription accepted =
      read_pattern(entry.at("pattern_description"));
  Names values = accepted.choices;
  if (accepted.kind == PatternDescription::Kind::truth)
    values = {"true", "false"};
  if (values.empty())
    values.emplace_back();
  for (const std::string &value : values)
    entries.push_back(path + '=' + value);
}
} // namespace

void print_bash_completion(std::ostream &out,
                           const Names &options,
                           const Json &parameters)
{
  Names entries, sections;
  for_each_entry(parameters, [&](const std::string &path, const Json &entry) {
    add_entry(path, entry, entries);
  });
  add_sections(parameters, sections);
  out << "# Completion of the arguments of voussoir in bash.\n";
  for (const auto &[name, list] :
       {std::pair("options", options), std::pair("entries", entries),
        std::pair("sections", sections)})
    out << "_voussoir_" << name << "='" << boost::algorithm::join(list, "\n")
        << "'\n";
  out << script;
}
} // namespace Voussoir
