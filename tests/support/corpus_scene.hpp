#pragma once
/// The scenes of tests/corpus.

#include "scene/model/scene.hpp"
#include "support/standard.hpp"

namespace ligne::test {

/// Files of more bytes hold thousands of faces: a plain check of everything against everything takes seconds.
inline constexpr std::uintmax_t kLargeSceneBytes = 100'000;

/// The scenes of at most that many bytes, by name.
std::vector<std::filesystem::path> corpus_files(std::uintmax_t most_bytes = std::numeric_limits<std::uintmax_t>::max());

/// The module of tests/corpus/maker that makes the scene: "solids", "touching" and so on.
std::string family_of(const std::filesystem::path& file);

/// A number of the scene that counts on within its family.
std::size_t place_in_family(const std::filesystem::path& file);

Scene scene_of_file(const std::filesystem::path& file);

/// By the name of its file without ".json".
Scene corpus_scene(const std::string& name);

}  // namespace ligne::test
