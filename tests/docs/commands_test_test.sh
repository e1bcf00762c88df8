#!/usr/bin/env bash
# run_blocks.sh fails where a command of a page fails, and where there is none to run.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/tests/docs" "$folder/docs/methods" "$folder/bench" "$folder/examples/models"
cp "$here/run_blocks.sh" "$folder/tests/docs"
touch "$folder"/{README,CONTRIBUTING,docs/page,docs/methods/page,bench/README}.md
sed -n '/^stand_ins=/,/^.$/p' "$here/run_blocks.sh" | awk 'NF == 2 { print $2 }' | while read -r file; do
  mkdir -p "$folder/$(dirname "$file")" && touch "$folder/$file"
done

# check WANTED LINE...: a page of these lines passes (0) or fails (1), with a program that knows one command.
printf '#!/bin/sh\n[ "$1" = draw ]\n' >"$folder/program"
chmod +x "$folder/program"
check() {
  local wanted=$1 status=0
  shift
  printf '%s\n' "$@" >"$folder/docs/page.md"
  LIGNE_MODELS_DIR=$folder/none bash "$folder/tests/docs/run_blocks.sh" "$folder/program" >"$folder/log" 2>&1 || status=$?
  [[ $status -eq $wanted ]] || { echo "status $status, not $wanted, of: $*" >&2; cat "$folder/log" >&2; exit 1; }
}

check 0 '```sh' 'ligne draw a' './ligne.sh draw b' '```'
check 0 '```sh' 'ligne draw a' '```' '```' 'ligne gone' '```'
check 1 '```sh' 'ligne gone' '```'
check 1 '```sh' 'ligne gone' 'ligne draw a' '```'
check 1 '```sh' 'ligne draw a' './ligne.sh gone' '```'
check 1 '```' 'ligne draw a' '```'
check 1 'ligne draw a'
