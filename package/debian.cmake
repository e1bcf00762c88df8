# Debian packages by cpack: ligne, libligne-dev, with a shared library libligne0.2 (named by its soname), and, where it is built,
# python3-ligne. The README has the commands; they need a build of their own with the prefix /usr.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ligne)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "maintainers <maintainers@users.noreply.h-seed-b3cbc896.example>" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL ligne libligne-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_LIGNE_PACKAGE_NAME ligne)
set(CPACK_DEBIAN_LIGNE_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_LIGNE_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_COMPONENT_LIGNE_DESCRIPTION "exact hidden-line drawings of 3D meshes and surfaces
Draws 3D polygon scenes, and surfaces z = f(x,y), as clean lines with the
hidden parts removed: SVG and PDF for papers and technical drawings, HPGL
and G-code for pen plotters.")

set(CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_NAME libligne-dev)
set(CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_SECTION libdevel)
if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL ${runtime_component})
  string(TOUPPER ${runtime_component} runtime_key)
  set(CPACK_DEBIAN_${runtime_key}_PACKAGE_NAME ${runtime_component})
  set(CPACK_DEBIAN_${runtime_key}_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_${runtime_key}_PACKAGE_DEPENDS fonts-dejavu-core)
  # Debian's policy (8.1.1) asks for the trigger; CPack alone makes scripts that call ldconfig.
  set(CPACK_DEBIAN_${runtime_key}_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/triggers)
  set(CPACK_COMPONENT_${runtime_key}_DESCRIPTION "exact hidden-line drawings of 3D meshes, shared library
The library that programs made with libligne-dev run with.")
  set(CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS "${runtime_component} (= ${PROJECT_VERSION}-1), libglm-dev")
else()
  set(CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS
      "libglm-dev, libcairo2-dev, libmuparser-dev, libpng-dev, libpugixml-dev, libtbb-dev, zlib1g-dev")
  if(TARGET TIFF::TIFF)
    string(APPEND CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS ", libtiff-dev")
  endif()
  if(TARGET GDAL::GDAL)
    string(APPEND CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS ", libgdal-dev")
  endif()
  if(DRACO_INCLUDE_DIR AND DRACO_LIBRARY)
    string(APPEND CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS ", libdraco-dev")
  endif()
endif()
set(CPACK_COMPONENT_LIBLIGNE-DEV_DESCRIPTION "exact hidden-line drawings of 3D meshes, C++ library
Headers and library for programs of one's own, found by CMake and by
pkg-config.")

if(LIGNE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python3-ligne)
  set(CPACK_DEBIAN_PYTHON3-LIGNE_PACKAGE_NAME python3-ligne)
  set(CPACK_DEBIAN_PYTHON3-LIGNE_PACKAGE_SECTION python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON3-LIGNE_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy, fonts-dejavu-core")
  set(CPACK_DEBIAN_PYTHON3-LIGNE_PACKAGE_SUGGESTS "python3-shapely, python3-matplotlib")
  set(CPACK_COMPONENT_PYTHON3-LIGNE_DESCRIPTION "exact hidden-line drawings of 3D meshes, Python module
Meshes as numpy arrays in, visible strokes as numpy arrays or files out.")
endif()

# Files of Debian alone (copyright and changelog in share/doc, its folder of completions) come into the packages when cpack makes them
# (debian_files.cmake), and are not installed by cmake --install.
string(TIMESTAMP changelog_date "%a, %d %b %Y 00:00:00 +0000" UTC)
configure_file(debian_files.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/debian_files.cmake @ONLY)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_BINARY_DIR}/debian_files.cmake)
include(CPack)
