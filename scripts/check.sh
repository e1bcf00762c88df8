#!/usr/bin/env bash
# check.sh [BASE]: the rules that no compiler keeps: format, links and names in the documentation, includes, planted faults
# that still apply; and clang-tidy on the sources changed since BASE (default: the parent commit). LIGNE_CHECK_BASE is another way to
# name BASE; where it is no commit of this clone, as on the first push of a branch, the parent commit is taken.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root"
source scripts/setup.sh
install_packages "$check_packages"
base=${1:-}
if [[ -z $base ]]; then
  base=${LIGNE_CHECK_BASE:-HEAD~1}
  git rev-parse --verify -q "$base^{commit}" >/dev/null || base=HEAD~1
fi
failed=0
fail() {
  echo "check: $1" >&2
  failed=1
}

git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror || fail "not as clang-format would have it"
left=$(git ls-files '*.orig' '*.rej')
[[ -z $left ]] || fail "left over from patches: $left"
python3 scripts/check_docs.py || fail "the documentation names what is not there, or breaks its rules"
scripts/check_includes.sh || fail "an include climbs"
python3 scripts/check_layout.py || fail "a folder is crowded, a file is long, or headers include each other"
python3 scripts/check_comments.py || fail "a comment hides its subject"
python3 scripts/check_types.py || fail "two files define one type"
python3 scripts/check_functions.py || fail "a function is longer than a screen"
for patch in tests/planted_faults/*.patch; do
  patch --dry-run -s -p1 <"$patch" >/dev/null || fail "$patch does not apply any more"
done

# Without the commit to compare with, clang-tidy would be left out and nobody told.
git rev-parse --verify -q "$base^{commit}" >/dev/null ||
  { echo "check: $base is not in this clone; fetch more of its history (git fetch --unshallow, or fetch-depth: 2)" >&2 && exit 1; }

# The compile commands are those of a release without tests. Headers precompiled by one compiler are of no use to another.
build=build/check
mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'plotting/*.cpp' 'studies/*.cpp')
echo "check: clang-tidy on ${#changed[@]} sources changed since $(git rev-parse --short "$base")"
if ((${#changed[@]} > 0)); then
  install_packages "$build_packages"
  cmake -S . -B "$build" -G Ninja -DLIGNE_TESTS=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
  printf '%s\0' "${changed[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" 2>/dev/null ||
    fail "clang-tidy complains"
fi
((failed == 0)) && echo "check: all rules kept"
exit "$failed"
