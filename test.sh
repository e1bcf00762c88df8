#!/usr/bin/env bash
# Builds everything with its tests and runs them all. Further arguments go to ctest: ./test.sh -R cli -V
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
folder=$root/build/test
source "$root/scripts/setup.sh"

mkdir -p "$folder"
if command -v flock >/dev/null 2>&1; then
  exec 9>"$folder/.ligne-lock"
  flock 9
fi
install_packages "$build_packages$test_packages"
# Optimized, but with the assertions on.
build "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DLIGNE_TESTS=ON -DLIGNE_WERROR=ON
exec ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel "$(nproc 2>/dev/null || echo 1)" "$@"
