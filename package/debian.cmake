# Debian packages by cpack: ligne, libligne-dev and, where it is built, python3-ligne. Made from a build of its own:
#   cmake -S . -B build/deb -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DLIGNE_TESTS=OFF -DLIGNE_PYTHON=ON
#   cmake --build build/deb && (cd build/deb && cpack)
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
set(CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS
    "libglm-dev, libcairo2-dev, libmuparser-dev, libpng-dev, libpugixml-dev, libtbb-dev")
if(TARGET TIFF::TIFF)
  string(APPEND CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS ", libtiff-dev")
endif()
if(TARGET GDAL::GDAL)
  string(APPEND CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS ", libgdal-dev")
endif()
if(DRACO_INCLUDE_DIR AND DRACO_LIBRARY)
  string(APPEND CPACK_DEBIAN_LIBLIGNE-DEV_PACKAGE_DEPENDS ", libdraco-dev")
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

# What every package has of documentation.
string(TIMESTAMP changelog_date "%a, %d %b %Y 00:00:00 +0000" UTC)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/copyright
     "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: ligne\n\nFiles: *\n")
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
string(REGEX MATCH "Copyright[^\n]*" copyright_line "${license}")
string(REGEX REPLACE "^Copyright *(\\([cC]\\))? *" "" copyright_line "${copyright_line}")
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(STRIP "${license}" license)
string(REGEX REPLACE "\n" "\n " license "${license}")
file(APPEND ${CMAKE_CURRENT_BINARY_DIR}/copyright "Copyright: ${copyright_line}\nLicense: Expat\n ${license}\n")
file(READ ${PROJECT_SOURCE_DIR}/plotting/fonts/LICENCE font_license)
string(REGEX REPLACE "\n\n+" "\n.\n" font_license "${font_license}")
string(STRIP "${font_license}" font_license)
string(REGEX REPLACE "\n" "\n " font_license "${font_license}")
file(APPEND ${CMAKE_CURRENT_BINARY_DIR}/copyright
     "\nFiles: plotting/fonts/*\nCopyright: see the text of the licence\nLicense: Hershey\n ${font_license}\n")
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${component})
  file(WRITE ${folder}/changelog.Debian
       "${component} (${PROJECT_VERSION}-1) unstable; urgency=low\n\n  * Packages of version ${PROJECT_VERSION}; CHANGELOG.md tells what is new.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${changelog_date}\n")
  execute_process(COMMAND gzip -9nf ${folder}/changelog.Debian)
  install(FILES ${folder}/changelog.Debian.gz ${CMAKE_CURRENT_BINARY_DIR}/copyright
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${component} COMPONENT ${component})
endforeach()
include(CPack)
