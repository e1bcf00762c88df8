// Every method on random scenes, against the oracle: triangles at random, corners on a small grid of whole numbers
// (everything degenerate at once), prisms with holes, boxes that penetrate, boxes that touch. LIGNE_RANDOM_SCENES=N makes N
// of them. A scene that fails is made small and written to a file that `ligne` reads.

#include "main/tier.hpp"
#include "scene/surfaces/mesh_writer.hpp"
#include "support/judge.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"
#include "support/variants.hpp"

namespace ligne::test {
namespace {

/// The first tier takes one scene of so many, beginning where the seed says. A prime, so that it meets all views and
/// variants, which the number of a scene chooses by their counts.
constexpr std::size_t kOneSceneIn = 11;

/// The view of a scene, which may lose faces.
using ViewOf = std::function<StandardView(const Scene&)>;

/// One of the standard views or of those with vertices on the border.
ViewOf standard_view(std::size_t number) {
  return [number](const Scene& scene) {
    auto views = standard_views(scene);
    for (StandardView& view : border_views(scene)) views.push_back(std::move(view));
    return views[number % views.size()];
  };
}

/// Describes the faults of all methods in the view; empty if there are none. One further variant of each is asked, too. In
/// the first tier a method draws all edges of one scene and the features of the next.
std::string faults_in(Scene scene, const std::string& name, const ViewOf& view, std::size_t number) {
  finish(scene);
  if (scene.faces.size() == 0) return "";
  const JudgedView judged(scene, name, view(scene));
  std::string faults;
  // Every method, and one by one the ways that its options let it work.
  const std::vector<Variant> all = variants();
  for (const Variant& variant : all) {
    const auto place = static_cast<std::size_t>(&variant - all.data());
    if (!variant.is_default && place != number % all.size()) continue;
    for (const char* edges : {"all", "feature"}) {
      if (!runs_all() && ((number / kOneSceneIn + place) % 2 == 0) != (std::string_view(edges) == "all")) continue;
      const std::string of_variant = judged.judge(*variant.method, edges, variant.settings).faults;
      if (!of_variant.empty()) faults += variant.name + '\n' + of_variant;
    }
  }
  // Limited methods at their own resolution.
  constexpr std::size_t kOneIn = 8;
  if (number % kOneIn != 0) return faults;
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    if (traits.exact || !(traits.products & kStrokes)) continue;
    const JudgedView limited(scene, name, view(scene), traits.tolerance_mm);
    for (const char* edges : {"all", "feature"}) faults += limited.judge(*method, edges).faults;
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

/// Judges the scene. One that fails loses the faces that it fails without, and is written down.
void expect_agreement(Scene scene, const std::string& name, const ViewOf& view, std::size_t number) {
  std::string faults = faults_in(scene, name, view, number);
  if (faults.empty()) return;
  for (std::uint32_t f = 0; f < scene.faces.size();) {
    const Scene smaller = without_face(scene, f);
    const std::string still = faults_in(smaller, name, view, number);
    if (still.empty()) {
      ++f;
    } else {
      scene = smaller;
      faults = still;
    }
  }
  const std::string file = testing::TempDir() + name + ".json";
  std::ofstream(file) << write_ligne_scene(scene);
  ADD_FAILURE() << faults << "\nThe scene, made as small as it fails, is in " << file;
}

/// LIGNE_RANDOM_SCENES, or nullptr.
const char* wanted_scenes() { return std::getenv("LIGNE_RANDOM_SCENES"); }

/// Scenes in all: as many as are wanted, or 3000.
unsigned scene_count() { return wanted_scenes() ? static_cast<unsigned>(std::strtoul(wanted_scenes(), nullptr, 10)) : 3000; }

constexpr unsigned kShares = 16;
constexpr unsigned kKinds = 10;

/// Runs build(random, seed, scene) for all seeds of a share of the work, and judges.
class RandomScenes : public testing::TestWithParam<unsigned> {
 protected:
  template <class Build>
  void run(const std::string& kind, Build build) {
    run_with_views(kind, [&](std::mt19937& random, unsigned seed, Scene& scene) {
      build(random, seed, scene);
      return standard_view(seed);
    });
  }

  /// Like run(), but build gives the view too.
  template <class Build>
  void run_with_views(const std::string& kind, Build build) {
    const unsigned share = scene_count() / (kShares * kKinds) + 1;
    for (unsigned seed = GetParam() * share; seed < (GetParam() + 1) * share && !HasFailure(); ++seed) {
      if (!wanted_scenes() && !is_chosen("random, " + kind, seed, kOneSceneIn)) continue;
      std::mt19937 random(seed);
      Scene scene;
      const ViewOf view = build(random, seed, scene);
      expect_agreement(std::move(scene), kind + "_" + std::to_string(seed), view, seed);
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
    for (int i = 0; i < 6; ++i)
      add_box(scene, Point3{u(random), u(random), u(random)} * 4.0, {3, 2, 2.5},
              rotation(u(random) * 3, u(random) * 3, u(random) * 3));
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

/// Boxes and plates on whole numbers, whole or turned.
void add_boxes_and_plates(std::mt19937& random, Scene& scene, const Basis& basis) {
  std::uniform_int_distribution<int> place(0, 3), size(1, 3);
  const auto whole = [&](auto& d) {
    const double x = d(random), y = d(random), z = d(random);
    return Point3{x, y, z};
  };
  for (int i = 0; i < 3; ++i) {
    const Point3 corner = whole(place);
    add_box(scene, corner, whole(size), basis);
  }
  for (int i = 0; i < 3; ++i) {
    const Point3 corner = whole(place), sides = whole(size);
    const auto at = [&](double x, double y) {
      Point3 p = corner;
      p[i] += x * sides.x;
      p[(i + 1) % 3] += y * sides.y;
      return basis[0] * p.x + basis[1] * p.y + basis[2] * p.z;
    };
    add_face(scene, {{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}});
  }
}

constexpr std::array kFieldsOfView{90, 120, 150, 170};

/// The eye on a vertex, on an edge, on a face, and inside a box.
TEST_P(RandomScenes, EyesOnTheScene) {
  run_with_views("eye_on_scene", [](std::mt19937& random, unsigned seed, Scene& scene) -> ViewOf {
    std::uniform_real_distribution<double> angle(-3, 3), part(0.1, 0.9);
    const double a = angle(random), b = angle(random), c = angle(random);
    add_boxes_and_plates(random, scene, seed % 2 == 0 ? kUpright : rotation(a, b, c));
    std::uniform_int_distribution<std::uint32_t> face(0, static_cast<std::uint32_t>(scene.faces.size()) - 1);
    std::uniform_int_distribution<std::size_t> vertex(0, scene.vertices.size() - 1);
    const auto contour = scene.faces.contour(face(random), 0);
    const Point3 p = scene.vertices[contour[0]], q = scene.vertices[contour[1]], r = scene.vertices[contour[3]];
    const double s = part(random), t = part(random);
    const Object& box = scene.objects[seed % 3];
    const Point3 low = scene.vertices[box.vertex_begin], high = scene.vertices[box.vertex_end - 1];
    const std::array<Point3, 4> eyes{p, p + s * (q - p), p + s * (q - p) + t * (r - p), low + s * (high - low)};
    const Point3 eye = eyes[seed / 2 % eyes.size()];
    Point3 target = scene.vertices[vertex(random)];
    if (target == eye) target.x += 1;
    return [view = perspective_view("eye_on_scene", scene, eye, target, kFieldsOfView[seed / 8 % kFieldsOfView.size()])](
               const Scene&) { return view; };
  });
}

/// Leaves that have one edge in common, turned, with the eye on one of them: it is seen edge on, and the common edge is its
/// own.
TEST_P(RandomScenes, EyesOnTheLeavesOfABook) {
  run_with_views("book", [](std::mt19937& random, unsigned seed, Scene& scene) -> ViewOf {
    std::uniform_real_distribution<double> angle(-3, 3), part(0.1, 0.9), width(1, 3);
    const double a = angle(random), b = angle(random), c = angle(random);
    const Basis basis = seed % 2 == 0 ? kUpright : rotation(a, b, c);
    const auto at = [&](double x, double y, double z) { return basis[0] * x + basis[1] * y + basis[2] * z; };
    const std::uint32_t leaves = 3 + seed / 2 % 3;
    begin_object(scene);
    scene.vertices = {at(0, 0, 0), at(0, 0, 3)};
    for (std::uint32_t i = 0; i < leaves; ++i) {
      const double direction = angle(random), w = width(random);
      const auto v = static_cast<std::uint32_t>(scene.vertices.size());
      scene.vertices.push_back(at(w * std::cos(direction), w * std::sin(direction), 3));
      scene.vertices.push_back(at(w * std::cos(direction), w * std::sin(direction), 0));
      scene.faces.add_face(std::array<std::uint32_t, 4>{0, 1, v, v + 1});
    }
    end_object(scene);
    std::uniform_int_distribution<std::uint32_t> leaf(0, leaves - 1);
    const Point3 bottom = scene.vertices[0], top = scene.vertices[1], outer = scene.vertices[3 + 2 * leaf(random)];
    const double s = part(random), t = part(random);
    const Point3 eye = bottom + s * (top - bottom) + t * (outer - bottom);
    const Point3 target = scene.vertices[2 + 2 * leaf(random)];
    return [view = perspective_view("book", scene, eye, target, kFieldsOfView[seed / 6 % kFieldsOfView.size()])](
               const Scene&) { return view; };
  });
}

/// Eyes and targets on whole numbers, many along an axis: with 90 degrees the border of the field of view goes through
/// vertices and along edges.
TEST_P(RandomScenes, WholeNumbersInAFieldOf90Degrees) {
  run_with_views("fov_90", [](std::mt19937& random, unsigned seed, Scene& scene) -> ViewOf {
    add_boxes_and_plates(random, scene, kUpright);
    std::uniform_int_distribution<int> place(-2, 8), distance(1, 8), axis(0, 2);
    const double x = place(random), y = place(random), z = place(random);
    const Point3 eye{x, y, z};
    Point3 target = eye;
    target[axis(random)] += seed % 3 == 0 ? -distance(random) : distance(random);
    if (seed % 4 == 3) target[axis(random)] += distance(random);
    if (target == eye) target.y += 1;
    return [view = perspective_view("fov_90", scene, eye, target, 90)](const Scene&) { return view; };
  });
}

/// The sheet, or the field of view, ends at edges and vertices.
TEST_P(RandomScenes, Borders) {
  run_with_views("borders", [](std::mt19937& random, unsigned seed, Scene& scene) -> ViewOf {
    add_boxes_and_plates(random, scene, kUpright);
    return [seed](const Scene& s) { return border_views(s)[seed % 3]; };
  });
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Range(0u, kShares));

}  // namespace
}  // namespace ligne::test
