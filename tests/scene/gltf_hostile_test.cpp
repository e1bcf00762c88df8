// Files that lie. Each gives one InputError that names the place, and nothing else happens.

#include "gltf_builder.hpp"
#include "reader_tools.hpp"
#include "scene/readers/gltf/gltf_reader.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using gltf_test::Builder;
using gltf_test::json;
using gltf_test::square;

std::string error_of(const std::string& bytes, bool binary = false, const std::filesystem::path& folder = {}) {
  ReadReport report;
  Warnings warnings;
  return reader_test::error_line([&] {
    read_gltf({std::as_bytes(std::span(bytes)), "M", folder}, binary, report, warnings);
  });
}

TEST(GltfHostile, DeepJson) {
  const std::string deep(100000, '[');
  EXPECT_EQ(error_of(deep), "M: JSON: nested deeper than 256 levels at byte 256");
  Builder b = square();
  std::string text = b.text();
  text.insert(1, "\"extras\":" + std::string(200000, '[') + std::string(200000, ']') + ",");
  EXPECT_TRUE(error_of(text).starts_with("M: JSON: nested deeper")) << error_of(text);
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
  for (std::size_t n = 0; n < good.size(); ++n) {
    EXPECT_NE(error_of(good.substr(0, n), true), "no error") << n;
  }
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
