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

struct Lie {
  const char* name;
  std::function<void(json&)> tell;
  const char* error;
};

void PrintTo(const Lie& lie, std::ostream* out) { *out << lie.name; }

class GltfLie : public testing::TestWithParam<Lie> {};

TEST_P(GltfLie, GivesOneError) {
  Builder b = square();
  const std::string text = b.text();
  GetParam().tell(b.root);
  const std::string error = error_of(b.root.dump());
  EXPECT_TRUE(error.starts_with(std::string("M: ") + GetParam().error)) << error;
}

constexpr std::uint64_t kFourGiB = std::uint64_t{1} << 32;

json nodes(std::initializer_list<json> children) {
  json out = json::array();
  for (const json& c : children) out.push_back({{"mesh", 0}, {"children", c}});
  return out;
}

json sparse(const json& change) {
  json out{{"count", 1}, {"indices", {{"bufferView", 1}, {"componentType", 5123}}}, {"values", {{"bufferView", 0}}}};
  out.merge_patch(change);
  return out;
}

INSTANTIATE_TEST_SUITE_P(
    All, GltfLie,
    testing::Values(
        Lie{"NoAsset", [](json& r) { r.erase("asset"); }, "glTF: asset is missing"},
        Lie{"Version1", [](json& r) { r["asset"]["version"] = "1.0"; }, "is glTF 1.0, which is not read"},
        Lie{"VersionNumber", [](json& r) { r["asset"]["version"] = 2; }, "glTF, asset: version is not a string"},
        Lie{"RootArray", [](json& r) { r = json::array(); }, "glTF: is not a JSON object"},
        Lie{"NodesObject", [](json& r) { r["nodes"] = json::object(); }, "glTF: nodes is not an array"},
        Lie{"NodeNumber", [](json& r) { r["nodes"][0] = 5; }, "node 0: is not a JSON object"},
        Lie{"SceneOutOfRange", [](json& r) { r["scene"] = 0; }, "glTF: scene names number 0 of 0"},
        Lie{"SceneNode", [](json& r) { r["scenes"] = json::array({{{"nodes", {1}}}}); }, "scene 0: nodes names number 1 of "
                                                                                         "1"},
        Lie{"MeshOutOfRange", [](json& r) { r["nodes"][0]["mesh"] = 1; }, "node 0: mesh names number 1 of 1"},
        Lie{"MeshNegative", [](json& r) { r["nodes"][0]["mesh"] = -1; }, "node 0: mesh is not a whole number"},
        Lie{"MeshText", [](json& r) { r["nodes"][0]["mesh"] = "0"; }, "node 0: mesh is not a whole number"},
        Lie{"MeshHuge", [](json& r) { r["nodes"][0]["mesh"] = 1e300; }, "node 0: mesh is not a whole number"},
        Lie{"OwnChild", [](json& r) { r["nodes"] = nodes({{0}}); }, "node 0: is its own child"},
        Lie{"OwnAncestor", [](json& r) { r["nodes"] = nodes({{1}, {2}, {0}}); }, "node 0: is its own ancestor"},
        Lie{"AncestorBelowRoot", [](json& r) { r["nodes"] = nodes({json::array(), {2}, {1}}); }, "node 1: is its own "
                                                                                                 "ancestor"},
        Lie{"TwoParents", [](json& r) { r["nodes"] = nodes({{2}, {2}, json::array()}); },
            "node 2: is a child twice, of node 0 and of node 1"},
        Lie{"ChildTwice", [](json& r) { r["nodes"] = nodes({{1, 1}, json::array()}); }, "node 1: is a child twice"},
        Lie{"RootTwice", [](json& r) { r["scene"] = 0, r["scenes"] = json::array({{{"nodes", {0, 0}}}}); }, "node 0: is in "
                                                                                                            "the scene twice"},
        Lie{"ExponentialGraph",
            [](json& r) {
              r["nodes"] = json::array();
              for (int i = 0; i < 60; ++i) r["nodes"].push_back({{"children", {i + 1, i + 1}}});
              r["nodes"].push_back({{"mesh", 0}});
            },
            "node 1: is a child twice"},
        Lie{"MatrixShort", [](json& r) { r["nodes"][0]["matrix"] = {1, 2}; }, "node 0: matrix does not have 16 numbers"},
        Lie{"ScaleText", [](json& r) { r["nodes"][0]["scale"] = {1, 2, "3"}; }, "node 0: scale has a value that is not a "
                                                                                "number"},
        Lie{"NoAttributes", [](json& r) { r["meshes"][0]["primitives"][0].erase("attributes"); },
            "mesh 0, primitive 0: attributes is missing"},
        Lie{"PositionOutOfRange", [](json& r) { r["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 2; },
            "mesh 0, primitive 0, attributes: POSITION names number 2 of 2"},
        Lie{"ModeUnknown", [](json& r) { r["meshes"][0]["primitives"][0]["mode"] = 7; }, "mesh 0, primitive 0: mode 7 is "
                                                                                         "not known"},
        Lie{"MaterialOutOfRange", [](json& r) { r["meshes"][0]["primitives"][0]["material"] = 0; },
            "mesh 0, primitive 0: material names number 0 of 0"},
        Lie{"PrimitiveText", [](json& r) { r["meshes"][0]["primitives"][0] = "x"; }, "mesh 0, primitive 0: is not a JSON "
                                                                                     "object"},
        Lie{"PositionsScalar", [](json& r) { r["accessors"][0]["type"] = "SCALAR"; }, "accessor 0: holds positions, but is "
                                                                                      "not a VEC3"},
        Lie{"PositionsUnsigned", [](json& r) { r["accessors"][0]["componentType"] = 5125; }, "accessor 0: holds positions "
                                                                                             "of 32-bit"},
        Lie{"IndicesVec3", [](json& r) { r["accessors"][1]["type"] = "VEC3"; }, "accessor 1: holds indices, but is not a "
                                                                                "SCALAR"},
        Lie{"IndicesFloat", [](json& r) { r["accessors"][1]["componentType"] = 5126; }, "accessor 1: holds indices that are "
                                                                                        "not unsigned"},
        Lie{"TypeUnknown", [](json& r) { r["accessors"][0]["type"] = "VEC9"; }, "accessor 0: type \"VEC9\" is not known"},
        Lie{"TypeMissing", [](json& r) { r["accessors"][0].erase("type"); }, "accessor 0: type \"\" is not known"},
        Lie{"ComponentType", [](json& r) { r["accessors"][0]["componentType"] = 0; }, "accessor 0: componentType 0 is not "
                                                                                      "known"},
        Lie{"CountFourGiB", [](json& r) { r["accessors"][0]["count"] = kFourGiB; }, "accessor 0: has more than"},
        Lie{"CountLarge", [](json& r) { r["accessors"][0]["count"] = kFourGiB - 2; }, "accessor 0: 4294967294 elements do "
                                                                                      "not fit"},
        Lie{"CountOverflow", [](json& r) { r["accessors"][0]["count"] = std::numeric_limits<std::uint64_t>::max(); }, "accessor 0: "},
        Lie{"CountNegative", [](json& r) { r["accessors"][0]["count"] = -3; }, "accessor 0: count is not a whole number"},
        Lie{"CountOneTooMany", [](json& r) { r["accessors"][0]["count"] = 5; }, "accessor 0: 5 elements do not fit into "
                                                                                "bufferView 0 of 48 bytes"},
        Lie{"OffsetOverflow", [](json& r) { r["accessors"][0]["byteOffset"] = std::numeric_limits<std::uint64_t>::max(); },
            "accessor 0: 4 elements do not fit"},
        Lie{"ZerosFourGiB",
            [](json& r) {
              r["accessors"][0].erase("bufferView");
              r["accessors"][0]["count"] = kFourGiB - 2;
            },
            "accessor 0: claims 4294967294 elements, but has no bufferView"},
        Lie{"IndexCountNotWhole", [](json& r) { r["accessors"][1]["count"] = 5; }, "accessor 1: its 5 corners are not whole "
                                                                                   "triangles"},
        Lie{"IndexOutOfRange", [](json& r) { r["accessors"][0]["count"] = 3; }, "accessor 1: index 3 at 5 is not below the "
                                                                                "3 vertices"},
        Lie{"ViewOutOfRange", [](json& r) { r["accessors"][0]["bufferView"] = 2; }, "accessor 0: bufferView names number 2 "
                                                                                    "of 2"},
        Lie{"ViewOutsideBuffer", [](json& r) { r["bufferViews"][0]["byteLength"] = 61; }, "bufferView 0: bytes 0 + 61 lie "
                                                                                          "outside of buffer 0"},
        Lie{"ViewOffsetOverflow", [](json& r) { r["bufferViews"][0]["byteOffset"] = std::numeric_limits<std::uint64_t>::max(); },
            "bufferView 0: bytes 18446744073709551615 + 48 lie outside"},
        Lie{"StrideOdd", [](json& r) { r["bufferViews"][0]["byteStride"] = 13; }, "bufferView 0: byteStride 13 is not a "
                                                                                  "multiple of 4"},
        Lie{"StrideSmall", [](json& r) { r["bufferViews"][0]["byteStride"] = 8; }, "accessor 0: its elements are larger"},
        Lie{"BufferOutOfRange", [](json& r) { r["bufferViews"][0]["buffer"] = 1; }, "bufferView 0: buffer names number 1 of "
                                                                                    "1"},
        Lie{"BufferLengthFourGiB", [](json& r) { r["buffers"][0]["byteLength"] = kFourGiB; },
            "buffer 0: byteLength 4294967296 is more than the 60 bytes of its data uri"},
        Lie{"BufferLengthMissing", [](json& r) { r["buffers"][0].erase("byteLength"); }, "buffer 0: byteLength is missing"},
        Lie{"BufferWithoutUri", [](json& r) { r["buffers"][0].erase("uri"); }, "buffer 0: has no uri"},
        Lie{"BufferNotBase64", [](json& r) { r["buffers"][0]["uri"] = "data:,hello"; }, "buffer 0: its data uri is not "
                                                                                        "base64"},
        Lie{"BufferBrokenBase64", [](json& r) { r["buffers"][0]["uri"] = "data:;base64,AB\nC"; }, "buffer 0: its data uri "
                                                                                                  "is broken base64"},
        Lie{"SparseCount", [](json& r) { r["accessors"][0]["sparse"] = sparse({{"count", 5}}); }, "accessor 0, sparse: "
                                                                                                  "count 5 is more"},
        Lie{"SparseIndexTooLarge",
            [](json& r) { r["accessors"][0]["sparse"] = sparse({{"indices", {{"byteOffset", 10}}}}), r["accessors"][0]["count"] = 3; },
            "accessor 0: sparse index 3 of 3 elements"},
        Lie{"SparseIndicesFloat", [](json& r) { r["accessors"][0]["sparse"] = sparse({{"indices", {{"componentType", 5126}}}}); },
            "accessor 0: its sparse indices are not unsigned"},
        Lie{"SparseViewOutOfRange", [](json& r) { r["accessors"][0]["sparse"] = sparse({{"values", {{"bufferView", 9}}}}); },
            "accessor 0, sparse, values: bufferView names number 9 of 2"},
        Lie{"SparseOffset", [](json& r) { r["accessors"][0]["sparse"] = sparse({{"values", {{"byteOffset", 40}}}}); },
            "accessor 0, sparse values: 1 elements do not fit"},
        Lie{"ExtensionNumber", [](json& r) { r["extensionsRequired"] = {1}; }, "glTF: extensionsRequired has a value"},
        Lie{"DracoGarbage",
            [](json& r) {
              r["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                                          {"attributes", {{"POSITION", 0}}}};
            },
            "bufferView 0: "},
        Lie{"DracoWithoutView",
            [](json& r) {
              r["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"attributes", {{"POSITION", 0}}}};
            },
            "mesh 0, primitive 0, extensions, KHR_draco_mesh_compression: bufferView is missing"}),
    [](const testing::TestParamInfo<Lie>& info) { return info.param.name; });

class GltfUri : public testing::TestWithParam<const char*> {};

TEST_P(GltfUri, OutsideOfTheFolderIsRefused) {
  Builder b = square();
  b.root["buffers"].push_back({{"byteLength", 60}, {"uri", GetParam()}});
  const std::string error = error_of(b.text(), false, testing::TempDir());
  EXPECT_NE(error.find("is not a file in the folder of the model"), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(All, GltfUri,
                         testing::Values("../a.bin", "/etc/passwd", "%2e%2e/a.bin", "a/%2E./../../b.bin", "..%2fa.bin",
                                         "%2Fetc/passwd", "file:///etc/passwd", "http://example.org/a.bin", "C:\\a.bin",
                                         "..\\a.bin", "", "a%00b"));

TEST(GltfHostile, MissingFile) {
  Builder b = square();
  b.root["buffers"].push_back({{"byteLength", 60}, {"uri", "absent\n.bin"}});
  EXPECT_EQ(error_of(b.text(), false, testing::TempDir()), "M: buffer 0: there is no file \"absent\\n.bin\"");
}

TEST(GltfHostile, FolderInsteadOfFile) {
  Builder b = square();
  b.root["buffers"].push_back({{"byteLength", 60}, {"uri", "."}});
  EXPECT_EQ(error_of(b.text(), false, testing::TempDir()), "M: buffer 0: there is no file \".\"");
}

TEST(GltfHostile, PositionsThatAreNotFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    Builder b;
    b.mesh(b.accessor<float>({0, 0, 0, 1, 0, 0, 0, bad, 0}, 3), -1);
    EXPECT_EQ(error_of(b.text()), "M: accessor 0: position 2 is not finite");
  }
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
}

TEST(GltfHostile, ManyInstancesOfALargeMesh) {
  Builder b;
  b.mesh(b.accessor<float>(std::vector<float>(3 * 30000, 1.0f), 3), -1);
  b.root["nodes"] = json::array();
  for (int i = 0; i < 5000; ++i) b.root["nodes"].push_back({{"mesh", 0}});
  EXPECT_NE(error_of(b.text()).find("repeated meshes have more than"), std::string::npos);
}

TEST(GltfHostile, BrokenJson) {
  EXPECT_EQ(error_of("{\n\"asset\": nothing}"), "M:2: JSON: broken at byte 13");
  EXPECT_EQ(error_of("{\"asset\": 1e999}"), "M:1: JSON: a number is too large");
  EXPECT_EQ(error_of("").substr(0, 9), "M:1: JSON");
  EXPECT_EQ(error_of("{\"a\": \"\xff\"}").substr(0, 9), "M:1: JSON");
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
