#!/usr/bin/env bash
# check_odr.sh: links the program with the optimizer of link time, which sees all sources at once and names every type that two of
# them define otherwise. The compiler alone sees one source at a time, and the linker takes either definition in silence.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root"
source scripts/setup.sh
install_packages "$build_packages"

# Sources that are compiled together are no test: their clashes are errors of the compiler already, or hidden.
cmake -S . -B build/odr -G Ninja -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DLIGNE_UNITY=OFF \
  -DCMAKE_CXX_FLAGS='-flto=auto -fno-fat-lto-objects -Wodr -Werror=odr -Wlto-type-mismatch -Werror=lto-type-mismatch' \
  -DCMAKE_AR="$(command -v gcc-ar)" -DCMAKE_RANLIB="$(command -v gcc-ranlib)"
cmake --build build/odr --target ligne
build/odr/src/cli/ligne draw examples/models/gear-pair.json -o build/odr/gear-pair.svg
echo "check_odr: one definition of each type"
