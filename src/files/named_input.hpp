#pragma once
/// Inputs named on the command line: files, and "-".

#include "files/input_file.hpp"

namespace ligne {

/// The name of a file for messages; "-" is standard input.
std::string shown_input(const std::filesystem::path& file);

/// The bytes of a file, or of standard input for "-".
std::vector<std::byte> read_named_input(const std::filesystem::path& file, InputFiles& opened,
                                        std::uintmax_t most = kLargestInput);

}  // namespace ligne
