// Models made by others: counts and boxes as their own page states them (README.md beside them).

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <iterator>

#include "scene/clean/clean.hpp"
#include "scene/readers/gltf_reader.hpp"

namespace ligne {
namespace {

struct Model {
  const char* file;
  std::size_t triangles, vertices;
  Point3 min, max;
};

void PrintTo(const Model& model, std::ostream* out) { *out << model.file; }

class GltfModel : public testing::TestWithParam<Model> {};

TEST_P(GltfModel, CountsAndBox) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_MODELS_DIR) / GetParam().file;
  if (!std::filesystem::is_directory(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  ReadReport report;
  Warnings warnings;
  Scene scene =
      read_gltf(std::as_bytes(std::span(bytes)), file.extension() == ".glb", file.parent_path(), "M", report, warnings);
  EXPECT_EQ(report.triangles, GetParam().triangles);
  EXPECT_EQ(scene.faces.size(), GetParam().triangles);
  if (GetParam().vertices != 0) {
    EXPECT_EQ(report.vertices, GetParam().vertices);
  }

  finish_scene(scene, warnings);
  Point3 min(1e300), max(-1e300);
  for (const Point3& p : scene.vertices) min = glm::min(min, p), max = glm::max(max, p);
  // The page gives four decimals.
  constexpr double kDecimals = 0.5e-4 + 1e-9;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(min[i], GetParam().min[i], kDecimals);
    EXPECT_NEAR(max[i], GetParam().max[i], kDecimals);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, GltfModel,
    testing::Values(Model{"2CylinderEngine.glb", 121496, 84657, {-371.6923, -180.9716, -140}, {371.6922, 92.0416, 128}},
                    Model{"lantern/Lantern.gltf", 5394, 4145, {-3.9224, 0.1839, -2.3157}, {11.5688, 25.8481, 2.3157}},
                    Model{"BoxInterleaved-embedded.gltf", 12, 24, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}},
                    Model{"SimpleSparseAccessor-embedded.gltf", 12, 14, {0, 0, 0}, {6, 4, 0}},
                    Model{"no_indices_3storybuilding.glb", 72, 216, {-23.2071, 0, 0}, {32.873, 9, 63.3614}},
                    Model{"simple_pole.glb", 580, 936, {-0.5, 0, -6}, {0.5, 20.5, 6}},
                    Model{"primitive-modes/Mesh_PrimitiveMode_04.gltf", 2, 4, {-0.5, -0.5, 0}, {0.5, 0.5, 0}},
                    Model{"primitive-modes/Mesh_PrimitiveMode_11.gltf", 2, 4, {-0.5, -0.5, 0}, {0.5, 0.5, 0}},
                    Model{"primitive-modes/Mesh_PrimitiveMode_14.gltf", 2, 4, {-0.5, -0.5, 0}, {0.5, 0.5, 0}}));

TEST(GltfModels, DracoEngine) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_MODELS_DIR) / "draco/2CylinderEngine.gltf";
  if (!std::filesystem::is_directory(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  ReadReport report;
  Warnings warnings;
  const auto read = [&] {
    return read_gltf(std::as_bytes(std::span(bytes)), false, file.parent_path(), "M", report, warnings);
  };
#ifdef LIGNE_HAVE_DRACO
  Scene scene = read();
  EXPECT_EQ(report.triangles, 110336u);
  finish_scene(scene, warnings);
  Point3 min(1e300), max(-1e300);
  for (const Point3& p : scene.vertices) min = glm::min(min, p), max = glm::max(max, p);
  // The encoder has kept 11 bits or more of each mesh's box.
  constexpr double kQuantized = 744.0 / 2048;
  EXPECT_NEAR(min.x, -371.6923, kQuantized);
  EXPECT_NEAR(max.y, 92.0416, kQuantized);
  EXPECT_NEAR(max.z, 128, kQuantized);
#else
  try {
    read();
    FAIL() << "read without libdraco";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("KHR_draco_mesh_compression"), std::string::npos);
  }
#endif
}

}  // namespace
}  // namespace ligne
