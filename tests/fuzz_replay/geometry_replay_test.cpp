// Every scene of the corpus of the geometry fuzzer, among them those that were once drawn wrongly, drawn and judged again.

#include "byte_scene.hpp"
#include "scene/readers/reader.hpp"
#include "scene/surfaces/mesh_writer.hpp"
#include "support/test.hpp"

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
  const std::string text = write_ligne_scene(scene);
  Warnings warnings;
  const Scene again = read_scene({std::as_bytes(std::span(text)), "scene"}, ModelFormat::ligne_scene, {}, warnings);
  EXPECT_EQ(again.vertices, scene.vertices);
  EXPECT_TRUE(std::ranges::equal(again.faces.corners(), scene.faces.corners()));
  ASSERT_EQ(again.faces.size(), scene.faces.size());
  ASSERT_EQ(again.objects.size(), scene.objects.size());
  for (std::size_t f = 0; f < scene.faces.size(); ++f) EXPECT_EQ(again.faces.contour_count(f), scene.faces.contour_count(f));
  for (std::size_t i = 0; i < scene.objects.size(); ++i) EXPECT_EQ(again.objects[i].precision, scene.objects[i].precision);
}

INSTANTIATE_TEST_SUITE_P(Corpus, GeometryReplay, testing::ValuesIn(corpus()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
