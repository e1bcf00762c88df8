# Set-up shared by ligne.sh and test.sh: the packages, and the build. To be sourced by bash; $root is the project's folder.

# One package a line: Debian package, what shows that it is there (command, pkg-config name, header, file of a font, other
# file, or module of the system's Python), why.
# A line that begins with "optional" is a package that the build can do without.
readonly build_packages='
g++                  cmd:c++                         C++20 compiler
cmake                cmd:cmake                       build
ninja-build          cmd:ninja                       build
pkg-config           cmd:pkg-config                  finds Cairo
libcairo2-dev        pc:cairo                        SVG, PDF and PNG
libglm-dev           hdr:glm/glm.hpp                 vectors and matrices
libtinygltf-dev      hdr:tiny_gltf.h                 glTF files
libcli11-dev         hdr:CLI/CLI.hpp                 command line
libtbb-dev           hdr:oneapi/tbb/task_arena.h     threads
nlohmann-json3-dev   hdr:nlohmann/json.hpp           JSON
libmuparser-dev      hdr:muParser.h                  formulas
libpugixml-dev       hdr:pugixml.hpp                 SVG drawings that are to be plotted, 3MF files
zlib1g-dev           hdr:zlib.h                      3MF files
libtomlplusplus-dev  hdr:toml++/toml.h               plotters and pens as TOML
libpng-dev           hdr:png.h                       grids of heights and palettes of models as PNG
fonts-dejavu-core    font:DejaVuSans.ttf             text in PDF and PNG
optional libtiff-dev  hdr:tiffio.h                    grids of heights as GeoTIFF
optional libdraco-dev hdr:draco/compression/decode.h compressed glTF files
'
readonly test_packages='
libgtest-dev         hdr:gtest/gtest.h               unit tests
libbenchmark-dev     hdr:benchmark/benchmark.h       benchmarks
libembree-dev        hdr:embree3/rtcore.h            ray casting, to check visibility with
libcgal-dev          hdr:CGAL/Lazy_exact_nt.h        exact arithmetic for the oracle
optional libeigen3-dev hdr:eigen3/Eigen/Core         planes of CGAL, to check surfaces with
librsvg2-bin         cmd:rsvg-convert                an independent reader of our SVG
poppler-utils        cmd:pdftotext                   an independent reader of our PDF
hp2xx                cmd:hp2xx                       an independent reader of our HPGL
optional libmeshoptimizer-dev hdr:meshoptimizer.h     an independent encoder of compressed glTF views
libpolyclipping-dev  hdr:polyclipping/clipper.hpp    an independent clipper of polygons
pybind11-dev         hdr:pybind11/pybind11.h         the Python module
python3-dev          file:/usr/bin/python3-config    headers of Python
python3-numpy        python:numpy                    arrays of the Python module
python3-pytest       python:pytest                   tests of the Python module
python3-hypothesis   python:hypothesis               the same with made up arrays
python3-matplotlib   python:matplotlib               recipes of docs/python.md
python3-shapely      python:shapely                  the same
python3-markdown     python:markdown                 the pages as a web site
mypy                 cmd:mypy                        types of the Python module
'
readonly check_packages='
git                  cmd:git                         names of the sources, and which have changed
clang-format         cmd:clang-format                format of the sources
clang-tidy           cmd:clang-tidy                  mistakes and needless copies
python3              cmd:python3                     checks of the documentation
patch                cmd:patch                       planted faults
'

# True when the probe (cmd:, pc:, hdr:, font:, file: or python:) finds its thing.
is_there() {
  case $1 in
    cmd:*) command -v "${1#cmd:}" >/dev/null 2>&1 ;;
    pc:*) pkg-config --exists "${1#pc:}" >/dev/null 2>&1 ;;
    hdr:*) printf '#if !__has_include(<%s>)\n#error missing\n#endif\n' "${1#hdr:}" | c++ -x c++ -E - >/dev/null 2>&1 ;;
    file:*) [[ -e ${1#file:} ]] ;;
    python:*) /usr/bin/python3 -c "import ${1#python:}" >/dev/null 2>&1 ;;
    font:*) fc-list 2>/dev/null | grep -qF "/${1#font:}:" ;;
  esac
}

# Installs the packages of a list that are missing.
install_packages() {
  local package probe why need=() optional=() missing=()
  while read -r package probe why; do
    if [[ $package == optional ]]; then
      read -r package probe why <<<"$probe $why"
      optional+=("$package")
    fi
    [[ -z $package ]] || need+=("$package $probe")
  done <<<"$1"

  if ! command -v apt-get >/dev/null 2>&1; then
    for why in "${need[@]}"; do
      read -r package probe <<<"$why"
      [[ " ${optional[*]} " == *" $package "* ]] || is_there "$probe" || missing+=("$package")
    done
    [[ ${#missing[@]} -eq 0 ]] && return
    echo "ligne: there is no apt-get here; please install what Debian calls: ${missing[*]}" >&2
    return 1
  fi

  local names=() installed
  for why in "${need[@]}"; do names+=("${why%% *}"); done
  installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "${names[@]}" 2>/dev/null || true) "
  for package in "${names[@]}"; do
    [[ $installed == *" installed:$package "* ]] || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    as_root=(sudo -n)
    if ! sudo -n true 2>/dev/null; then
      echo "ligne: packages are missing, please install them: sudo apt-get install ${missing[*]}" >&2
      return 1
    fi
  fi
  tell "installing ${missing[*]}"
  mkdir -p "$root/build"
  local log=$root/build/install.log apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600)
  if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    return 1
  fi
}

# A word to whoever watches; standard output belongs to the program.
tell() { if [[ -t 2 ]]; then echo "$* ..." >&2; fi; }

# The set of flags with which ligne.sh and test.sh build, so that both use the same objects. Warnings are errors with the
# compiler of Debian 12, with which every change is built; another one may warn of more, and must not keep anyone from building.
build_options() {
  local warnings_are_errors=OFF
  if [[ $(c++ -dumpfullversion -dumpversion 2>/dev/null) =~ ^12\. ]]; then warnings_are_errors=ON; fi
  printf '%s\n' -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O3 -DLIGNE_UNITY=ON "-DLIGNE_WERROR=$warnings_are_errors"
  if command -v ccache >/dev/null 2>&1; then echo -DCMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
}

# A folder that was moved is configured anew.
forget_moved_folder() {
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt"; then rm -f "$1/CMakeCache.txt"; fi
}

# build FOLDER TARGET CMAKE-ARGUMENT...: configures and builds; the log is shown only when that fails. Afterwards the file
# .built-TARGET in the folder is as old as the beginning of the build: sources edited while it ran are newer.
build() {
  local folder=$1 target=$2 log=$1/build.log options
  shift 2
  mkdir -p "$folder"
  tell "building ligne"
  touch "$folder/.build-started"
  mapfile -t options < <(build_options)
  # Headers compiled in advance, and the macros of dates that nobody uses, keep nothing from the cache.
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
  if ! { cmake -S "$root" -B "$folder" -G Ninja "${options[@]}" "$@" && cmake --build "$folder" --target "$target"; } >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    echo "ligne: the build failed; its log is $log" >&2
    return 1
  fi
  mv "$folder/.build-started" "$folder/.built-$target"
}
