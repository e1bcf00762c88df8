#pragma once
/// Whole files, read.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_error.hpp"

namespace ligne {

/// The files that a reader has opened, or would have: nothing may be written in their place. They are distinguished by what
/// they are, not by their names (std::filesystem::equivalent).
using InputFiles = std::vector<std::filesystem::path>;

/// More than any model whose corners 32-bit indices can number takes in a binary format, and any grid that memory holds.
inline constexpr std::uintmax_t kLargestInput = std::uintmax_t{1} << 36;

/// The most that is taken of an input without a size before it is read, a pipe or a file of /proc.
inline constexpr std::uintmax_t kLargestUnsized = std::uintmax_t{1} << 28;

/// Bytes of a file or a pipe; adds the file to `opened`. Throws InputError, in which `name` stands for the file: for
/// directories, devices and sockets, for a pipe that nobody opens for writing within a second, and for more bytes than
/// `most`, or than kLargestUnsized where the size is not known.
std::vector<std::byte> read_input(const std::filesystem::path& file, const std::string& name, InputFiles& opened,
                                  std::uintmax_t most = kLargestInput);

/// Bytes as characters.
inline std::string_view as_characters(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace ligne
