# Writes the files plotting/devices/*.toml into a C++ source; ${device_source} is its name.
file(GLOB device_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/devices/*.toml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${device_files})
set(device_entries "")
foreach(file IN LISTS device_files)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND device_entries "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
set(device_source ${CMAKE_CURRENT_BINARY_DIR}/embedded_devices.cpp)
file(CONFIGURE OUTPUT ${device_source} @ONLY CONTENT
"// Made by cmake/EmbedDevices.cmake.
#include \"plotting/devices/embedded.hpp\"

namespace ligne {
namespace {

constexpr EmbeddedDevice kDevices[] = {
@device_entries@};

}  // namespace

std::span<const EmbeddedDevice> embedded_devices() { return kDevices; }

}  // namespace ligne
")
