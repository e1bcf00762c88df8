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
      {};  ///< where files that the model names are looked up, and nowhere else; empty: there are none
};

}  // namespace ligne
