#pragma once
/// The files plotting/devices/*.toml as they were when the program was built: so it finds them wherever it is put.

#include <span>
#include <string_view>

namespace ligne {

struct EmbeddedDevice {
  std::string_view name;  ///< of the file
  std::string_view toml;
};

std::span<const EmbeddedDevice> embedded_devices();

}  // namespace ligne
