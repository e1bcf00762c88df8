#!/usr/bin/env bash
# links_test.sh finds what it is there to find.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/docs/images"
touch "$folder/docs/images/a.svg"

# check WANTED LINE...: a page of these lines passes (0) or fails (1).
check() {
  local wanted=$1 status=0
  shift
  printf '%s\n' "# A page, of its own" '![](images/a.svg)' "$@" >"$folder/docs/page.md"
  "${BASH:-bash}" "$here/links_test.sh" "$folder" >/dev/null 2>&1 || status=$?
  [[ $status -eq $wanted ]] || { echo "status $status, not $wanted, of: $*" >&2; exit 1; }
}

check 0 '[here](page.md) [there](#a-page-of-its-own) [out](https://example.org/none)'
check 0 '`[no](link.md)`' '```' '[no](link.md)' '```'
check 1 '[gone](gone.md)'
check 1 '<img src="images/gone.svg">'
check 1 '[here](page.md#nowhere)'
touch "$folder/docs/images/orphan.svg"
check 1
rm "$folder/docs/images/orphan.svg"
head -c 400000 /dev/zero >"$folder/docs/images/a.svg"
check 1
