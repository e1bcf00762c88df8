#pragma once
/// A model file in memory.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace ligne {

struct ModelBytes {
  std::span<const std::byte> bytes;
  std::string name;  ///< for error messages
  std::filesystem::path folder =
      {};  ///< the only folder in which files that the model refers to are looked up; empty: there are none
};

}  // namespace ligne
