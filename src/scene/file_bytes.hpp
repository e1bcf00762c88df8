#pragma once
/// Whole files.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ligne {

/// Bytes of a file of any kind, also of a pipe; throws InputError, in which `name` stands for the file.
std::vector<std::byte> read_bytes(const std::filesystem::path& file, const std::string& name);

}  // namespace ligne
