#include "plotting/devices/toml_reading.hpp"

namespace ligne {
namespace {

/// Most characters of the library's message, which quotes the file.
constexpr std::size_t kLongestReason = 200;

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw InputError(file + ":" + std::to_string(e.source().begin.line), printable(e.description(), kLongestReason));
  }
}

}  // namespace ligne
