#pragma once
/// A scene of tests/corpus.

#include <filesystem>
#include <string>

#include "scene/readers/reader.hpp"

namespace ligne::test {

/// By the name of its file without ".json".
inline Scene corpus_scene(const std::string& name) {
  Warnings warnings;
  return read_scene(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus" / (name + ".json"), {}, warnings);
}

}  // namespace ligne::test
