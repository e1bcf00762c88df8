#pragma once
/// Reads whole files.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_error.hpp"

namespace ligne {

/// Files that a reader has opened, or would have opened, and that must not be overwritten. They are compared by
/// identity, not by name (std::filesystem::equivalent).
using InputFiles = std::vector<std::filesystem::path>;

/// Largest size of an input in bytes: more than a binary model with 32-bit indices needs, and than a grid that fits
/// into memory.
inline constexpr std::uintmax_t kLargestInput = std::uintmax_t{1} << 36;

/// Largest number of bytes read from an input whose size is not known before, such as a pipe or a file of /proc.
inline constexpr std::uintmax_t kLargestUnsized = std::uintmax_t{1} << 28;

/// Reads the bytes of a file or a pipe; adds the file to `opened`. Throws InputError with `name` for directories,
/// devices and sockets, for a pipe that nobody opens for writing within a second, and for more than `most` bytes, or
/// than kLargestUnsized if the size is not known.
std::vector<std::byte> read_input(const std::filesystem::path& file, const std::string& name, InputFiles& opened,
                                  std::uintmax_t most = kLargestInput);

/// The bytes as characters.
inline std::string_view as_characters(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace ligne
