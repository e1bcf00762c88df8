#!/usr/bin/env bash
# pages_test.sh LIGNE PAGES: man pages and completions name the options that the help names, and bash completes them.
set -euo pipefail
ligne=$1 pages=$2
failed=0
complain() { echo "$*" >&2; failed=1; }

for command in draw surface plot compile info compare methods devices study; do
  options=$("$ligne" help "$command" all | grep -oE '^  (-[a-z],)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+')
  page=$(zcat "$pages/ligne-$command.1.gz" | sed 's/\\-/-/g')
  zsh=$(sed -n "/^    $command)/,/;;/p" "$pages/_ligne")
  fish=$(grep -F "__fish_seen_subcommand_from $command'" "$pages/ligne.fish")
  for option in $options; do
    grep -qF "fB$option\\fR" <<<"$page" || complain "ligne-$command.1 lacks $option"
    grep -qF -- "$option[" <<<"$zsh" || complain "_ligne lacks $option of $command"
    grep -qE -- "-l ${option#--}( |$)" <<<"$fish" || complain "ligne.fish lacks $option of $command"
  done
done

# shellcheck source=/dev/null
source "$pages/ligne.bash"
compopt() { :; }
completions() {
  COMP_WORDS=(ligne "$@") COMP_CWORD=$#
  _ligne
  echo "${COMPREPLY[*]}"
}
expect() {
  local expected=$1
  shift
  local found
  found=$(completions "$@")
  [[ $found == "$expected" ]] || complain "completion of 'ligne $*' is '$found', not '$expected'"
}
expect "draw devices" d
expect "iso" draw --view i
expect "camera" draw --view c
expect "none dashed solid" draw --hidden ""
expect "dashed" draw --hidden = d
expect "--hatch --hatch-spacing --hatch-angle --hatch-levels --hatch-cross" draw model.obj --hatch
expect "refuse outline hatch" plot --fill ""
expect "same apart none" surface --underside ""
expect "" draw --crease ""
for command in draw surface plot compile info compare methods devices study; do
  for option in $("$ligne" help "$command" all | grep -oE '^  (-[a-z],)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+'); do
    [[ " $(completions "$command" "$option") " == *" $option "* ]] || complain "bash does not complete $option of $command"
  done
done
exit "$failed"
