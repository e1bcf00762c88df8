// Every method on random scenes, against the oracle: triangles at random, corners on a small grid of whole numbers
// (everything degenerate at once), boxes that penetrate, boxes that touch. A scene that fails is written to a file that
// `ligne` reads.

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "scene/clean.hpp"
#include "support/judge.hpp"
#include "support/scene_parts.hpp"
#include "support/variants.hpp"

namespace ligne::test {
namespace {

/// The scene as ligne-scene JSON.
std::string json_of(const Scene& scene) {
  std::ostringstream out;
  out.precision(17);
  out << "{\"format\": \"ligne-scene\", \"version\": 1, \"objects\": [";
  for (const Object& o : scene.objects) {
    out << (&o == scene.objects.data() ? "\n" : ",\n") << "{\"vertices\": [";
    for (std::uint32_t v = o.vertex_begin; v < o.vertex_end; ++v) {
      const Point3& p = scene.vertices[v];
      out << (v == o.vertex_begin ? "" : ", ") << '[' << p.x << ", " << p.y << ", " << p.z << ']';
    }
    out << "],\n\"faces\": [";
    for (std::uint32_t f = o.face_begin; f < o.face_end; ++f) {
      out << (f == o.face_begin ? "" : ", ") << "{\"outer\": [";
      const auto outer = scene.faces.contour(f, 0);
      for (const std::uint32_t& v : outer) out << (&v == outer.data() ? "" : ", ") << v - o.vertex_begin;
      out << "]}";
    }
    out << "]}";
  }
  out << "]}\n";
  return out.str();
}

/// Judges the scene in one of the standard views after the other.
void expect_agreement(Scene scene, const std::string& name, std::size_t view) {
  Warnings warnings;
  finish_scene(scene, warnings);
  if (scene.faces.size() == 0) return;
  const auto views = standard_views(scene);
  const JudgedView judged(scene, name, views[view % views.size()]);
  bool failed = false;
  for (const Variant& variant : variants()) {
    for (const char* edges : {"all", "feature"}) {
      const Verdict verdict = judged.judge(*variant.method, edges, variant.settings);
      EXPECT_TRUE(verdict.passes()) << variant.name << '\n' << verdict.faults;
      failed = failed || !verdict.passes();
    }
  }
  if (!failed) return;
  const std::string file = testing::TempDir() + name + ".json";
  std::ofstream(file) << json_of(scene);
  std::cout << "the scene is in " << file << '\n';
}

/// Runs f(random, seed) for all seeds of a share of the work.
class RandomScenes : public testing::TestWithParam<unsigned> {};

constexpr unsigned kShare = 20;  ///< scenes by test

TEST_P(RandomScenes, Triangles) {
  for (unsigned seed = GetParam() * kShare; seed < (GetParam() + 1) * kShare; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-10, 10);
    Scene scene;
    for (int i = 0; i < 12; ++i) {
      const Point3 c{u(random), u(random), u(random)};
      const auto near = [&] { return c + Point3{u(random), u(random), u(random)} * 0.6; };
      add_face(scene, {{near(), near(), near()}});
    }
    expect_agreement(scene, "triangles_" + std::to_string(seed), seed);
  }
}

TEST_P(RandomScenes, TrianglesOnWholeNumbers) {
  for (unsigned seed = GetParam() * kShare; seed < (GetParam() + 1) * kShare; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> u(0, 3);
    Scene scene;
    for (int i = 0; i < 10; ++i) {
      const auto corner = [&] { return Point3{double(u(random)), double(u(random)), double(u(random))}; };
      const Point3 a = corner(), b = corner(), c = corner();
      if (a == b || b == c || a == c) continue;
      add_face(scene, {{a, b, c}});
    }
    expect_agreement(scene, "whole_numbers_" + std::to_string(seed), seed);
  }
}

TEST_P(RandomScenes, MeshOnWholeNumbers) {
  for (unsigned seed = GetParam() * kShare; seed < (GetParam() + 1) * kShare; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> u(0, 2);
    Scene scene;
    for (int o = 0; o < 2; ++o) {
      begin_object(scene);
      for (int v = 0; v < 8; ++v) scene.vertices.push_back({double(u(random)), double(u(random)), double(u(random) + o)});
      std::uniform_int_distribution<std::uint32_t> corner(static_cast<std::uint32_t>(scene.vertices.size()) - 8,
                                                          static_cast<std::uint32_t>(scene.vertices.size()) - 1);
      for (int f = 0; f < 7; ++f) scene.faces.add_triangle(corner(random), corner(random), corner(random));
      end_object(scene);
    }
    expect_agreement(scene, "mesh_" + std::to_string(seed), seed);
  }
}

TEST_P(RandomScenes, PenetratingBoxes) {
  for (unsigned seed = GetParam() * kShare; seed < (GetParam() + 1) * kShare; seed += 4) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    Scene scene;
    for (int i = 0; i < 6; ++i) {
      add_box(scene, Point3{u(random), u(random), u(random)} * 4.0, {3, 2, 2.5},
              rotation(u(random) * 3, u(random) * 3, u(random) * 3));
    }
    expect_agreement(scene, "penetrating_" + std::to_string(seed), seed / 4);
  }
}

TEST_P(RandomScenes, BoxesThatTouch) {
  for (unsigned seed = GetParam() * kShare; seed < (GetParam() + 1) * kShare; seed += 4) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> place(0, 3), size(1, 2);
    std::uniform_real_distribution<double> angle(-3, 3);
    // Every other scene is turned: then what touched does so but for the last digits.
    const Basis basis = seed % 8 == 0 ? kUpright : rotation(angle(random), angle(random), angle(random));
    Scene scene;
    for (int i = 0; i < 5; ++i) {
      const auto whole = [&](auto& d) { return Point3{double(d(random)), double(d(random)), double(d(random))}; };
      const Point3 corner = whole(place);
      add_box(scene, corner, whole(size), basis);
    }
    expect_agreement(scene, "touching_" + std::to_string(seed), seed / 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Range(0u, 7u));

}  // namespace
}  // namespace ligne::test
