#!/usr/bin/env bash
# check.sh [BASE]: the rules that no compiler keeps: format, links and names in the documentation, includes, planted faults
# that still apply; and clang-tidy on the sources changed since BASE (default: the parent commit).
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root"
source scripts/setup.sh
install_packages "$check_packages"
base=${1:-HEAD~1}
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
python3 scripts/check_functions.py || fail "a function is longer than a screen"
for patch in tests/planted_faults/*.patch; do
  patch --dry-run -s -p1 <"$patch" >/dev/null || fail "$patch does not apply any more"
done

# The compile commands are those of a release without tests. Headers precompiled by one compiler are of no use to another.
build=build/check
mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'plotting/*.cpp' 2>/dev/null)
if ((${#changed[@]} > 0)); then
  install_packages "$build_packages"
  cmake -S . -B "$build" -G Ninja -DLIGNE_TESTS=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
  printf '%s\0' "${changed[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" 2>/dev/null ||
    fail "clang-tidy complains"
fi
((failed == 0)) && echo "check: all rules kept"
exit "$failed"
