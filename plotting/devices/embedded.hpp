#pragma once
/// The files plotting/devices/*.toml, embedded when the program is built, so that it finds them wherever it is
/// installed.

#include <span>
#include <string_view>

namespace ligne {

struct EmbeddedDevice {
  std::string_view name;  ///< name of the file
  std::string_view toml;
};

std::span<const EmbeddedDevice> embedded_devices();

}  // namespace ligne
