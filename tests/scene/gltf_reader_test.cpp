#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>

#ifdef LIGNE_HAVE_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif

#include "gltf_builder.hpp"
#include "reader_tools.hpp"
#include "scene/clean/clean.hpp"
#include "scene/model/bounds.hpp"
#include "scene/readers/gltf/gltf_draco.hpp"

namespace ligne {
namespace {

using gltf_test::Builder;
using gltf_test::json;
using gltf_test::square;
using reader_test::read_raw;
using reader_test::Result;

/// Three times the float32 rounding of 1; the rounding of the transform is far below.
TEST(GltfReader, TransformsScaleThePrecision) {
  Builder b = square();
  b.root["nodes"][0]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  b.root["nodes"][0]["scale"] = {2, 3, 1};
  const Result read = read_raw([](const ModelReading& in) { return read_gltf(in, false); }, b.text());
  EXPECT_NEAR(read.scene.objects[0].precision, 3 * std::numeric_limits<float>::epsilon() / 2, 1e-13);
}

#ifdef LIGNE_HAVE_DRACO
/// A triangle as wide as the largest number of 11 bits, so that the encoder rounds to whole numbers.
TEST(GltfReader, DracoStepsAreKnown) {
  const std::array corners{glm::vec3(0), glm::vec3(2047, 0, 0), glm::vec3(0, 1023.25f, 0)};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), &corners[0], &corners[1], &corners[2]);
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  const auto decoded = [&](int bits) {
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return decode_draco(std::as_bytes(std::span(buffer.data(), buffer.size())), {{"POSITION", id}}, "M", "P");
  };
  const DracoMesh rounded = decoded(11), exact = decoded(-1);
  EXPECT_EQ(rounded.step, 1);
  EXPECT_EQ(std::ranges::count(rounded.positions, Point3(0, 1023, 0)), 1);
  EXPECT_EQ(exact.step, 0);
  EXPECT_EQ(std::ranges::count(exact.positions, Point3(0, 1023.25, 0)), 1);
}
#endif

TEST(GltfModels, DracoEngine) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_MODELS_DIR) / "draco/2CylinderEngine.gltf";
  if (!std::filesystem::is_directory(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
  const std::string bytes = test::bytes_of_file(file);
  ReadReport report;
  Warnings warnings;
  const auto read = [&] {
    return read_gltf({{std::as_bytes(std::span(bytes)), "M", file.parent_path()}, report, warnings}, false);
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
  for (const Object& object : scene.objects) {
    EXPECT_GT(object.precision, object_size(scene, object) * 0x1p-20) << object.name;
    EXPECT_LT(object.precision, kQuantized / 2) << object.name;
  }
#else
  test::expect_parts(test::failure_of(read), {"KHR_draco_mesh_compression"});
#endif
}

// Files that lie. Each gives one InputError that names the place, and nothing else happens.

std::string error_of(const std::string& bytes, bool binary = false) {
  ReadReport report;
  Warnings warnings;
  return reader_test::error_line([&] { read_gltf({{std::as_bytes(std::span(bytes)), "M"}, report, warnings}, binary); });
}

TEST(GltfHostile, DeepNodes) {
  Builder b = square();
  b.root["nodes"] = json::array();
  constexpr int kDepth = 20000;
  for (int i = 0; i < kDepth; ++i) b.root["nodes"].push_back({{"children", {i + 1}}});
  b.root["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(error_of(b.text()), "no error");
  // Each node twice below the one before it: more of them than anything can walk through.
  for (int i = 0; i < 60; ++i) b.root["nodes"][i]["children"] = {i + 1, i + 1};
  EXPECT_TRUE(error_of(b.text()).starts_with("M: node 1: is a child twice"));
}

TEST(GltfHostile, ManyInstancesOfALargeMesh) {
  Builder b;
  b.mesh(b.accessor<float>(std::vector<float>(3 * 30000, 1.0f), 3), -1);
  b.root["nodes"] = json::array();
  for (int i = 0; i < 5000; ++i) b.root["nodes"].push_back({{"mesh", 0}});
  EXPECT_NE(error_of(b.text()).find("repeated meshes have more than"), std::string::npos);
}

TEST(GltfHostile, Container) {
  Builder b = square();
  const std::string good = b.glb();
  EXPECT_EQ(error_of(good, true), "no error");
  for (std::size_t n = 0; n < good.size(); ++n) EXPECT_NE(error_of(good.substr(0, n), true), "no error") << n;
  // Every single byte of the file turned round: an error or a scene, but nothing worse.
  for (std::size_t n = 0; n < good.size(); ++n) {
    for (const int bit : {0, 3, 7}) {
      std::string bad = good;
      bad[n] = static_cast<char>(bad[n] ^ 1 << bit);
      error_of(bad, true);
    }
  }
  std::string lying = good;
  lying[15] = '\x7f';
  EXPECT_TRUE(error_of(lying, true).starts_with("M: GLB: chunk 0 of ")) << error_of(lying, true);
  std::string version = good;
  version[4] = 1;
  EXPECT_EQ(error_of(version, true), "M: is glTF 1.0, which is not read: convert it with gltf-pipeline -i OLD -o NEW.glb");
}

}  // namespace
}  // namespace ligne
