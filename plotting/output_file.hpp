#pragma once
/// Files that are whole or not there.

#include <filesystem>
#include <string_view>

namespace ligne {

/// Writes the bytes beside the file and renames; "-" is standard output. Throws std::runtime_error with one line,
/// "FILE: cause", and leaves no half-written file.
void write_output(const std::filesystem::path& file, std::string_view bytes);

}  // namespace ligne
