// Every method on random scenes, against the oracle: triangles at random, corners on a small grid of whole numbers
// (everything degenerate at once), prisms with holes, boxes that penetrate, boxes that touch. LIGNE_RANDOM_SCENES=N makes N
// of them. A scene that fails is made small and written to a file that `ligne` reads.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <span>
#include <sstream>
#include <utility>

#include "scene/clean/clean.hpp"
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
  const auto indices = [&](std::span<const std::uint32_t> contour, std::uint32_t first) {
    out << '[';
    for (const std::uint32_t& v : contour) out << (&v == contour.data() ? "" : ", ") << v - first;
    out << ']';
  };
  for (const Object& o : scene.objects) {
    out << (&o == scene.objects.data() ? "\n" : ",\n") << "{\"vertices\": [";
    for (std::uint32_t v = o.vertex_begin; v < o.vertex_end; ++v) {
      const Point3& p = scene.vertices[v];
      out << (v == o.vertex_begin ? "" : ", ") << '[' << p.x << ", " << p.y << ", " << p.z << ']';
    }
    out << "],\n\"faces\": [";
    for (std::uint32_t f = o.face_begin; f < o.face_end; ++f) {
      out << (f == o.face_begin ? "" : ", ") << "{\"outer\": ";
      indices(scene.faces.contour(f, 0), o.vertex_begin);
      for (std::size_t hole = 1; hole < scene.faces.contour_count(f); ++hole) {
        out << (hole == 1 ? ", \"holes\": [" : ", ");
        indices(scene.faces.contour(f, hole), o.vertex_begin);
      }
      out << (scene.faces.contour_count(f) > 1 ? "]}" : "}");
    }
    out << "]}";
  }
  out << "]}\n";
  return out.str();
}

/// What the methods do wrong in one of the standard views of the scene, in words; empty when nothing.
std::string faults_in(Scene scene, const std::string& name, std::size_t view) {
  Warnings warnings;
  finish_scene(scene, warnings);
  if (scene.faces.size() == 0) return "";
  const auto views = standard_views(scene);
  const JudgedView judged(scene, name, views[view % views.size()]);
  std::string faults;
  // Every method, and one by one the ways that its options let it work.
  const std::vector<Variant> all = variants();
  for (const Variant& variant : all) {
    if (!variant.is_default && &variant != &all[view % all.size()]) continue;
    for (const char* edges : {"all", "feature"}) {
      const std::string of_variant = judged.judge(*variant.method, edges, variant.settings).faults;
      if (!of_variant.empty()) faults += variant.name + '\n' + of_variant;
    }
  }
  return faults;
}

Scene without_face(const Scene& scene, std::uint32_t left_out) {
  Scene rest;
  rest.vertices = scene.vertices;
  rest.objects = scene.objects;
  for (Object& o : rest.objects) {
    const std::uint32_t begin = o.face_begin, end = o.face_end;
    o.face_begin = static_cast<std::uint32_t>(rest.faces.size());
    for (std::uint32_t f = begin; f < end; ++f) {
      if (f == left_out) continue;
      rest.faces.add_face(scene.faces.contour(f, 0));
      for (std::size_t hole = 1; hole < scene.faces.contour_count(f); ++hole)
        rest.faces.add_hole(scene.faces.contour(f, hole));
    }
    o.face_end = static_cast<std::uint32_t>(rest.faces.size());
  }
  return rest;
}

/// Judges the scene in one of the standard views after the other. A scene that fails loses the faces that it fails without,
/// and is written down.
void expect_agreement(Scene scene, const std::string& name, std::size_t view) {
  std::string faults = faults_in(scene, name, view);
  if (faults.empty()) return;
  for (std::uint32_t f = 0; f < scene.faces.size();) {
    const Scene smaller = without_face(scene, f);
    const std::string still = faults_in(smaller, name, view);
    if (still.empty()) {
      ++f;
    } else {
      scene = smaller;
      faults = still;
    }
  }
  const std::string file = testing::TempDir() + name + ".json";
  std::ofstream(file) << json_of(scene);
  ADD_FAILURE() << faults << "\nThe scene, made as small as it fails, is in " << file;
}

/// Scenes in all: LIGNE_RANDOM_SCENES, or 2000.
unsigned scene_count() {
  const char* wanted = std::getenv("LIGNE_RANDOM_SCENES");
  return wanted ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : 2000;
}

constexpr unsigned kShares = 16;
constexpr unsigned kKinds = 6;

/// Runs build(random, scene) for all seeds of a share of the work, and judges.
class RandomScenes : public testing::TestWithParam<unsigned> {
 protected:
  template <class Build>
  void run(const std::string& kind, Build build) {
    const unsigned share = scene_count() / (kShares * kKinds) + 1;
    for (unsigned seed = GetParam() * share; seed < (GetParam() + 1) * share && !HasFailure(); ++seed) {
      std::mt19937 random(seed);
      Scene scene;
      build(random, seed, scene);
      expect_agreement(std::move(scene), kind + "_" + std::to_string(seed), seed);
    }
  }
};

TEST_P(RandomScenes, Triangles) {
  run("triangles", [](std::mt19937& random, unsigned, Scene& scene) {
    std::uniform_real_distribution<double> u(-10, 10);
    for (int i = 0; i < 12; ++i) {
      const Point3 c{u(random), u(random), u(random)};
      const auto near = [&] { return c + Point3{u(random), u(random), u(random)} * 0.6; };
      add_face(scene, {{near(), near(), near()}});
    }
  });
}

TEST_P(RandomScenes, TrianglesOnWholeNumbers) {
  run("whole_numbers", [](std::mt19937& random, unsigned, Scene& scene) {
    std::uniform_int_distribution<int> u(0, 3);
    for (int i = 0; i < 10; ++i) {
      const auto corner = [&] { return Point3{double(u(random)), double(u(random)), double(u(random))}; };
      const Point3 a = corner(), b = corner(), c = corner();
      if (a == b || b == c || a == c) continue;
      add_face(scene, {{a, b, c}});
    }
  });
}

TEST_P(RandomScenes, MeshOnWholeNumbers) {
  run("mesh", [](std::mt19937& random, unsigned, Scene& scene) {
    std::uniform_int_distribution<int> u(0, 2);
    for (int o = 0; o < 2; ++o) {
      begin_object(scene);
      for (int v = 0; v < 8; ++v) scene.vertices.push_back({double(u(random)), double(u(random)), double(u(random) + o)});
      std::uniform_int_distribution<std::uint32_t> corner(static_cast<std::uint32_t>(scene.vertices.size()) - 8,
                                                          static_cast<std::uint32_t>(scene.vertices.size()) - 1);
      for (int f = 0; f < 7; ++f) scene.faces.add_triangle(corner(random), corner(random), corner(random));
      end_object(scene);
    }
  });
}

/// Upright prisms over squares with square holes in them, on whole numbers or turned.
TEST_P(RandomScenes, PrismsWithHoles) {
  run("prisms", [](std::mt19937& random, unsigned seed, Scene& scene) {
    std::uniform_int_distribution<int> place(0, 4), side(2, 4);
    std::uniform_real_distribution<double> angle(-3, 3);
    for (int i = 0; i < 2; ++i) {
      const Basis basis = seed % 2 == 0 ? kUpright : rotation(angle(random), angle(random), angle(random));
      const Point3 corner{double(place(random)), double(place(random)), double(place(random))};
      const double a = side(random), h = side(random);
      const auto at = [&](double x, double y, double z) {
        const Point3 local = corner + Point3{x, y, z};
        return basis[0] * local.x + basis[1] * local.y + basis[2] * local.z;
      };
      const auto square = [&](double from, double to, double z) {
        return std::vector<Point3>{at(from, from, z), at(to, from, z), at(to, to, z), at(from, to, z)};
      };
      for (const double z : {0.0, h}) add_face(scene, {square(0, a, z), square(a / 4, a * 3 / 4, z)});
      for (const auto& [from, to] : {std::pair(0.0, a), std::pair(a / 4, a * 3 / 4)}) {
        const auto low = square(from, to, 0), high = square(from, to, h);
        for (int k = 0; k < 4; ++k) add_face(scene, {{low[k], low[(k + 1) % 4], high[(k + 1) % 4], high[k]}});
      }
    }
  });
}

TEST_P(RandomScenes, PenetratingBoxes) {
  run("penetrating", [](std::mt19937& random, unsigned, Scene& scene) {
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < 6; ++i) {
      add_box(scene, Point3{u(random), u(random), u(random)} * 4.0, {3, 2, 2.5},
              rotation(u(random) * 3, u(random) * 3, u(random) * 3));
    }
  });
}

TEST_P(RandomScenes, BoxesThatTouch) {
  run("touching", [](std::mt19937& random, unsigned seed, Scene& scene) {
    std::uniform_int_distribution<int> place(0, 3), size(1, 2);
    std::uniform_real_distribution<double> angle(-3, 3);
    // Every other scene is turned: then what touched does so but for the last digits.
    const Basis basis = seed % 2 == 0 ? kUpright : rotation(angle(random), angle(random), angle(random));
    for (int i = 0; i < 5; ++i) {
      const auto whole = [&](auto& d) { return Point3{double(d(random)), double(d(random)), double(d(random))}; };
      const Point3 corner = whole(place);
      add_box(scene, corner, whole(size), basis);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Range(0u, kShares));

}  // namespace
}  // namespace ligne::test
