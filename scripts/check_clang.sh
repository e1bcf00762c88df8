#!/usr/bin/env bash
# check_clang.sh [SUFFIX]: compiles every source of src, plotting, package and python with clang and libc++, whose C++20 has gaps
# (src/base/portable.hpp), then builds the program with clang and libstdc++, and has it draw an example. With libc++ nothing can be linked on Debian:
# its C++ libraries are made with libstdc++. SUFFIX (default: -16) is that of clang's packages.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root"
source scripts/setup.sh
suffix=${1:--16}
install_packages "$build_packages
clang$suffix            cmd:clang++$suffix    the compiler
libc++$suffix-dev       file:/usr/lib/llvm$suffix/include/c++/v1/version    the standard library
libc++abi$suffix-dev    file:/usr/lib/llvm$suffix/include/c++/v1/cxxabi.h   the same
pybind11-dev         hdr:pybind11/pybind11.h         the Python module
python3-dev          file:/usr/bin/python3-config    headers of Python"

options=(-S . -G Ninja "-DCMAKE_CXX_COMPILER=clang++$suffix" -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DLIGNE_WERROR=ON -DLIGNE_UNITY=ON)
cmake "${options[@]}" -B build/clang-libc++ -DCMAKE_CXX_FLAGS=-stdlib=libc++ -DLIGNE_PYTHON=ON
mapfile -t objects < <(ninja -C build/clang-libc++ -t targets all | sed -n 's/^\(.*\.o\): CXX_COMPILER.*/\1/p')
ninja -C build/clang-libc++ "${objects[@]}"
echo "check_clang: ${#objects[@]} objects compiled with libc++"

cmake "${options[@]}" -B build/clang
cmake --build build/clang --target ligne
build/clang/src/cli/ligne draw examples/models/gear-pair.json -o build/clang/gear-pair.svg
echo "check_clang: $(grep -c '<path' build/clang/gear-pair.svg) lines drawn by the program of clang and libstdc++"
