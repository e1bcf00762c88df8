// Every scene of the corpus of the geometry fuzzer, among them those that were once drawn wrongly, drawn and judged again.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "byte_scene.hpp"
#include "support/scene_json.hpp"
#include "scene/reader.hpp"

namespace ligne::test {
namespace {

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/fuzz/corpus/geometry";
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

ByteScene scene_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  return scene_of_bytes(bytes);
}

class GeometryReplay : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(GeometryReplay, AgreesWithTheOracle) {
  const ByteScene scene = scene_of_file(GetParam());
  EXPECT_GT(scene.scene.faces.size(), 0u);
  EXPECT_EQ(faults_of(scene), "");
}

// Otherwise a failure could not be looked at.
TEST_P(GeometryReplay, IsReadBackAsItIsShown) {
  const Scene scene = scene_of_file(GetParam()).scene;
  const std::string text = scene_json(scene);
  Warnings warnings;
  const Scene again = read_scene(std::as_bytes(std::span(text)), ModelFormat::ligne_scene, {}, "scene", {}, warnings);
  EXPECT_EQ(scene_json(again), text);
}

INSTANTIATE_TEST_SUITE_P(Corpus, GeometryReplay, testing::ValuesIn(corpus()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
