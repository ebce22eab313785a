// SPDX-License-Identifier: MIT
// Scripts by which shells complete what is typed. They ask the program (complete.cpp).
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <memory>

#include "commands.h"
#include "options.h"

namespace penumbra {
namespace {

constexpr const char* bash_script =
    R"(# Completion of penumbra for bash; the program itself says what may follow.
_penumbra() {
  local line=${COMP_LINE:0:COMP_POINT} words current kept candidate
  read -ra words <<< "$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  if [[ ${words[0]} =~ ^~[[:alnum:]_.-]*/ ]]; then # somebody's home
    eval "words[0]=${words[0]%%/*}/\${words[0]#*/}"
  fi
  current=${words[-1]}
  kept=${current%"${current##*[:=]}"} # bash replaces only what follows these
  COMPREPLY=()
  while IFS=$'\t' read -r candidate _; do
    if [[ $candidate == :files ]]; then
      compopt -o filenames 2> /dev/null
      while IFS= read -r candidate; do
        COMPREPLY+=("${candidate#"$kept"}")
      done < <(compgen -f -- "${current#--*=}")
    else
      COMPREPLY+=("${candidate#"$kept"}")
    fi
  done < <("${words[0]}" complete -- "${words[@]:1}" 2> /dev/null)
}
complete -F _penumbra penumbra
)";

constexpr const char* zsh_script = R"(#compdef penumbra
# Completion of penumbra for zsh; the program itself says what may follow.
_penumbra() {
  local line has_files
  local -a candidates
  for line in "${(@f)$("${(Q)words[1]}" complete -- "${(@Q)words[2,CURRENT]}" 2> /dev/null)}"; do
    if [[ $line == :files ]]; then
      has_files=yes
    elif [[ -n $line ]]; then
      candidates+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}")
    fi
  done
  (( $#candidates )) && _describe -t candidates penumbra candidates
  if [[ -n $has_files ]]; then
    compset -P '--*='
    _files
  fi
}
if [[ ${funcstack[1]-} == _penumbra ]]; then
  _penumbra "$@"
else
  compdef _penumbra penumbra
fi
)";

constexpr const char* fish_script =
    R"(# Completion of penumbra for fish; the program itself says what may follow.
function __penumbra_complete
    set -l words (commandline -opc)
    set -l typed (commandline -ct)
    for line in ($words[1] complete -- $words[2..-1] "$typed" 2> /dev/null)
        if test "$line" = :files
            __fish_complete_path "$typed"
        else
            printf '%s\n' $line
        end
    end
end
complete -c penumbra -f -a '(__penumbra_complete)'
)";

const char* script(Shell shell) {
  switch (shell) {
    case Shell::bash: return bash_script;
    case Shell::zsh: return zsh_script;
    case Shell::fish: return fish_script;
  }
  return "";
}

}  // namespace

Command add_completion(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "completion", "Print the script by which a shell completes commands, options and values");
  const auto shell = std::make_shared<Shell>();
  add_parsed(*app, "SHELL", "", "bash, zsh or fish", [shell](const std::string& text) {
    *shell = parse_shell(text);
  })->required();
  app->footer(
      "An installed penumbra has them where shells look. For this shell alone:\n\n"
      "Examples:\n"
      "  source <(penumbra completion bash)\n"
      "  source <(penumbra completion zsh)      # after compinit\n"
      "  penumbra completion fish | source\n");
  return {app, [shell] {
            fmt::print("{}", script(*shell));
            return 0;
          }};
}

}  // namespace penumbra
