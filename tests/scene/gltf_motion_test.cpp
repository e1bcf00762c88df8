// Instances, morph targets, skins and moments of animations of glTF files.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gltf_builder.hpp"
#include "reader_tools.hpp"
#include "scene/readers/gltf/gltf_reader.hpp"

namespace ligne {
namespace {

using gltf_test::Builder;
using gltf_test::json;
using Points = std::vector<Point3>;

reader_test::Result read_posed(const std::string& text, const std::optional<ScenePose>& pose = {}) {
  reader_test::Result r;
  r.scene = read_gltf({std::as_bytes(std::span(text)), "M"}, false, r.report, r.warnings, nullptr, pose);
  return r;
}

std::string posed_error(Builder& b, const std::optional<ScenePose>& pose = {}) {
  try {
    read_posed(b.text(), pose);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

void expect_points(const Scene& scene, const Points& expected) {
  ASSERT_EQ(scene.vertices.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(scene.vertices[i][k], expected[i][k], 1e-12) << "vertex " << i << " axis " << k;
  }
}

/// A triangle: accessor 0.
Builder triangle() {
  Builder b;
  b.mesh(b.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3), -1);
  return b;
}

/// An accessor of vectors of four, or of matrices.
template <class T>
int wide(Builder& b, const std::vector<T>& values, int components, bool normalized = false) {
  const int accessor = b.accessor(values, 1);
  json& entry = b.root["accessors"][accessor];
  entry["type"] = components == 4 ? "VEC4" : "MAT4";
  entry["count"] = values.size() / static_cast<std::size_t>(components);
  if (normalized) entry["normalized"] = true;
  return accessor;
}

TEST(GltfInstancing, IsReadThoughTheFileOnlyUsesIt) {
  Builder b = triangle();
  const int moves = b.accessor<float>({0, 0, 0, 2, 0, 0, 4, 0, 0}, 3),
            sizes = b.accessor<float>({1, 1, 1, 2, 2, 2, 1, 1, 1}, 3);
  b.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  b.root["nodes"][0]["translation"] = {0, 0, 10};
  b.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", moves}, {"SCALE", sizes}};
  b.root["nodes"].push_back({{"children", {0}}, {"scale", {1, 3, 1}}});
  const auto r = read_posed(b.text());
  EXPECT_EQ(r.scene.objects.size(), 3u);
  expect_points(
      r.scene, {{0, 0, 10}, {1, 0, 10}, {0, 3, 10}, {2, 0, 10}, {4, 0, 10}, {2, 6, 10}, {4, 0, 10}, {5, 0, 10}, {4, 3, 10}});
  EXPECT_TRUE(r.warnings.lines().empty());
}

/// A quarter turn about z as normalized 16-bit integers turns x into y.
TEST(GltfInstancing, RotationsMayBeQuantised) {
  Builder b = triangle();
  const auto half = static_cast<std::int16_t>(std::lround(32767 * std::sqrt(0.5)));
  const int turns = wide<std::int16_t>(b, {0, 0, half, half}, 4, true);
  b.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"ROTATION", turns}};
  expect_points(read_posed(b.text()).scene, {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}});
}

TEST(GltfInstancing, LengthsMustAgree) {
  Builder b = triangle();
  const int two = b.accessor<float>({0, 0, 0, 2, 0, 0}, 3);
  b.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", two}, {"SCALE", 0}};
  EXPECT_EQ(posed_error(b), "M: node 0: its instances' attributes have different lengths");
}

TEST(GltfMorph, WeightsOfTheMeshAndOfTheNode) {
  Builder b = triangle();
  const int up = b.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 3}, 3);
  b.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}}};
  expect_points(read_posed(b.text()).scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  b.root["meshes"][0]["weights"] = {0.5};
  expect_points(read_posed(b.text()).scene, {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 1.5}});
  b.root["nodes"][0]["weights"] = {-1};
  b.root["nodes"][0]["translation"] = {0, 0, 10};
  expect_points(read_posed(b.text()).scene, {{0, 0, 9}, {1, 0, 9}, {0, 1, 7}});
}

TEST(GltfMorph, TargetsOfAnotherLengthAreRefused) {
  Builder b = triangle();
  const int short_one = b.accessor<float>({0, 0, 1}, 3);
  b.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", short_one}}};
  b.root["meshes"][0]["weights"] = {1};
  EXPECT_EQ(posed_error(b), "M: accessor 1: does not have a difference for each of the 3 vertices");
}

/// The triangle with two joints, both bound where they stand, one of them 5 to the right: the second vertex belongs to it,
/// the third to both by halves. Nodes 1 and 2 are the joints.
Builder skinned() {
  Builder b = triangle();
  const int joints = wide<std::uint8_t>(b, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 4);
  const int weights = wide<float>(b, {1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, 4);
  const int inverse =
      wide<float>(b, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1}, 16);
  json& attributes = b.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = joints;
  attributes["WEIGHTS_0"] = weights;
  b.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
  b.root["nodes"][0]["skin"] = 0;
  b.root["nodes"][0]["translation"] = {100, 100, 100};
  b.root["nodes"].push_back({{"children", {2}}});
  b.root["nodes"].push_back({{"translation", {5, 0, 0}}});
  return b;
}

/// The node of a skinned mesh does not move it (glTF 2.0, 3.7.3.3).
TEST(GltfSkin, BindPoseIsTheMeshAsModelled) {
  Builder b = skinned();
  const auto r = read_posed(b.text());
  expect_points(r.scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(r.warnings.lines().empty());
  EXPECT_GT(r.scene.objects[0].precision, 0);
}

TEST(GltfSkin, JointsMoveTheirVertices) {
  Builder b = skinned();
  b.root["nodes"][2]["translation"] = {5, 0, 2};
  expect_points(read_posed(b.text()).scene, {{0, 0, 0}, {1, 0, 2}, {0, 1, 1}});
}

TEST(GltfSkin, JointsThatAreNotThereAreRefused) {
  Builder b = skinned();
  b.root["skins"][0]["joints"] = {1};
  EXPECT_EQ(posed_error(b), "M: skin: a vertex names joint 1 of 1");
  Builder few = skinned();
  few.root["skins"][0]["inverseBindMatrices"] = 0;
  EXPECT_EQ(posed_error(few), "M: accessor 0: has 3 numbers in an element, not 16");
  Builder none = skinned();
  none.root["nodes"][0]["skin"] = 1;
  EXPECT_EQ(posed_error(none), "M: node 0: skin names number 1 of 1");
}

/// Gives the file an animation "walk" of one channel.
void animate(Builder& b, int node, const char* path, int times, int values, const char* interpolation) {
  b.root["animations"] = {{{"name", "walk"},
                           {"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}}};
}

Point3 first_vertex(Builder& b, double seconds, const std::string& animation = "walk") {
  return read_posed(b.text(), ScenePose{animation, seconds}).scene.vertices[0];
}

TEST(GltfPose, LinearAndStep) {
  for (const bool step : {false, true}) {
    Builder b = triangle();
    const int times = b.accessor<float>({1, 2, 4}, 1), values = b.accessor<float>({0, 0, 0, 2, 0, 0, 2, 4, 0}, 3);
    animate(b, 0, "translation", times, values, step ? "STEP" : "LINEAR");
    EXPECT_EQ(first_vertex(b, 0), Point3(0, 0, 0));
    EXPECT_EQ(first_vertex(b, 1.5), step ? Point3(0, 0, 0) : Point3(1, 0, 0));
    EXPECT_EQ(first_vertex(b, 2), Point3(2, 0, 0));
    EXPECT_EQ(first_vertex(b, 3, "0"), step ? Point3(2, 0, 0) : Point3(2, 2, 0));
    EXPECT_EQ(first_vertex(b, 9), Point3(2, 4, 0));
  }
}

/// Hermite's curve from 0 to 1 in two seconds, with tangents of 0 and 1 a second: at its middle 0.5 - 2/8.
TEST(GltfPose, CubicSpline) {
  Builder b = triangle();
  const int times = b.accessor<float>({0, 2}, 1);
  const int values = b.accessor<float>({9, 9, 9, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 9, 9, 9}, 3);
  animate(b, 0, "translation", times, values, "CUBICSPLINE");
  EXPECT_NEAR(first_vertex(b, 1).x, 0.25, 1e-15);
  EXPECT_EQ(first_vertex(b, 2).x, 1);
}

TEST(GltfPose, RotationsGoAlongTheSphere) {
  Builder b = triangle();
  const auto half = static_cast<float>(std::sqrt(0.5));
  const int times = b.accessor<float>({0, 3}, 1), values = wide<float>(b, {0, 0, 0, 1, 0, 0, -half, -half}, 4);
  animate(b, 0, "rotation", times, values, "LINEAR");
  // The quaternions stand for a turn of 90 degrees, of which a third is made.
  const Point3 p = read_posed(b.text(), ScenePose{"walk", 1}).scene.vertices[1];
  EXPECT_NEAR(p.x, std::cos(M_PI / 6), 1e-7);
  EXPECT_NEAR(p.y, std::sin(M_PI / 6), 1e-7);
}

TEST(GltfPose, WeightsAndJoints) {
  Builder b = triangle();
  const int up = b.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 3}, 3);
  b.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}}, {{"POSITION", up}}};
  const int times = b.accessor<float>({0, 1}, 1), values = b.accessor<float>({0, 0, 1, 3}, 1);
  animate(b, 0, "weights", times, values, "LINEAR");
  EXPECT_EQ(first_vertex(b, 0.5).z, 2);
  Builder s = skinned();
  animate(s, 2, "translation", s.accessor<float>({0, 1}, 1), s.accessor<float>({5, 0, 0, 5, 0, 4}, 3), "LINEAR");
  expect_points(read_posed(s.text(), ScenePose{"walk", 0.5}).scene, {{0, 0, 0}, {1, 0, 2}, {0, 1, 1}});
}

TEST(GltfPose, ErrorsNameTheAnimations) {
  Builder b = triangle();
  EXPECT_EQ(posed_error(b, ScenePose{"walk", 0}), "M: has no animation \"walk\": it has none at all");
  b = triangle();
  const int times = b.accessor<float>({0, 1}, 1), values = b.accessor<float>({0, 0, 0}, 3);
  animate(b, 0, "translation", times, values, "LINEAR");
  EXPECT_EQ(posed_error(b, ScenePose{"run", 0}), "M: has no animation \"run\"; there are 0 walk");
  EXPECT_EQ(posed_error(b, ScenePose{"1", 0}), "M: has no animation \"1\"; there are 0 walk");
  EXPECT_EQ(posed_error(b, ScenePose{"walk", 0}), "M: animation 0, channel 0: has 3 numbers for its keys, needs 6");
  b.root["animations"][0]["channels"][0]["target"]["path"] = "pointer";
  EXPECT_EQ(read_posed(b.text(), ScenePose{"walk", 0}).warnings.left_out().text(),
            "left out: 1 channels of animations of pointer");
  EXPECT_TRUE(read_posed(b.text()).warnings.lines().empty());
  b.root["animations"][0]["channels"][0]["sampler"] = 7;
  EXPECT_TRUE(read_posed(b.text()).warnings.lines().empty()) << "how it moves is no reason to refuse it as it stands";
  EXPECT_EQ(posed_error(b, ScenePose{"walk", 0}), "M: animation 0, channel 0: sampler names number 7 of 1");
}

}  // namespace
}  // namespace ligne
