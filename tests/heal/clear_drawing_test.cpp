/// Clear drawings of meshes with defects against those of the shapes that they stand for.

#include "main/tier.hpp"
#include "picture/models/models.hpp"
#include "picture/scene_visibility.hpp"
#include "scene/heal/border_edges.hpp"
#include "scene/heal/duplicate_faces.hpp"
#include "scene/heal/heal.hpp"
#include "scene/readers/reader.hpp"
#include "support/mesh_text.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

/// Drawn length of each class, mm.
using Lengths = std::array<double, kLineClassCount>;

double length_of_all(const Lengths& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

std::string corpus_file(const std::string& name) { return LIGNE_SOURCE_DIR "/tests/corpus/" + name + ".json"; }

Lengths lengths(const Scene& scene, Quality quality, const std::string& view, double crease_degrees = 30) {
  PictureRequest request;
  request.lines.quality = quality;
  request.lines.crease_degrees = crease_degrees;
  request.view.named_view = view;
  RunReport run;
  PreparedScene prepared = prepare(scene, request, std::nullopt, run);
  SceneVisibility found = compute_visibility(prepared, std::nullopt, false, run);
  finish_lines(found, prepared, run);
  const StrokeModel& model = *found.result.strokes;
  Lengths sum{};
  for (const Stroke& s : model.strokes)
    if (s.visible)
      sum[static_cast<std::size_t>(s.line_class)] += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
  return sum;
}

Lengths drawn(const std::string& file, Quality quality, const std::string& view, double crease_degrees = 30) {
  ModelRequest models{.files = {file}};
  models.quality = quality;
  return lengths(load_models(models).scene, quality, view, crease_degrees);
}

class Defect : public testing::TestWithParam<const char*> {};

/// The crack is an eight-thousandth of a unit, 6 micrometres on the page: so much the lines may differ at each of their
/// ends.
TEST_P(Defect, DrawsAsTheCube) {
  for (const char* view : {"iso", "front", "top", "dimetric", "right", "back"}) {
    const Lengths expected = drawn(corpus_file("cube"), Quality::exact, view);
    const Lengths clear = drawn(corpus_file(GetParam()), Quality::clear, view);
    for (std::size_t c = 0; c < kLineClassCount; ++c)
      EXPECT_NEAR(clear[c], expected[c], 0.1) << view << ", " << kLineClassNames[c];
  }
}

INSTANTIATE_TEST_SUITE_P(Clear, Defect,
                         testing::Values("cube_stored_twice", "cube_with_crack", "cube_with_loose_lid", "duplicate_objects"),
                         [](const auto& info) { return std::string(info.param); });

/// Scenes of the corpus that clear lines draw otherwise, by the rule of docs/clear-lines.md that they are there for.
const std::set<std::string> kHealed{"cube_stored_twice",   "duplicate_faces", "cube_with_crack",
                                    "cube_with_loose_lid", "t_junction",      "crumpled_ball"};
const std::set<std::string> kSmooth{"height_field", "low_sphere", "torus"};
/// Scenes with lines shorter than the pen: at most a hundredth of their lines.
const std::set<std::string> kShortBits{"grazing_penetration", "mixed_sizes",    "nearly_edge_on_iso",
                                       "needle_pyramids",     "sizes_in_a_row", "thin_slivers"};

TEST(ClearDrawing, KeepsTheLinesOfTheCorpus) {
  for (const fs::directory_entry& entry : fs::directory_iterator(LIGNE_SOURCE_DIR "/tests/corpus")) {
    const fs::path& file = entry.path();
    const std::string name = file.stem().string();
    if (file.extension() != ".json" || kHealed.contains(name) || kSmooth.contains(name)) continue;
    for (const char* view : test::chosen("clear, " + name, 3, {"iso", "front", "dimetric"})) {
      const Lengths exact = drawn(file.string(), Quality::exact, view), clear = drawn(file.string(), Quality::clear, view);
      // Planes that meet at less than 30 degrees have a crease from 10 degrees on.
      const Lengths more = drawn(file.string(), Quality::exact, view, kSurfaceCreaseDegrees);
      for (std::size_t c = 0; c < kLineClassCount; ++c) {
        const double all = length_of_all(exact);
        const double tolerance = kShortBits.contains(name) ? all / 100 : 1e-3;
        const double most = static_cast<LineClass>(c) == LineClass::crease ? more[c] : exact[c];
        EXPECT_GE(clear[c], exact[c] - tolerance) << name << " " << view << ", " << kLineClassNames[c];
        EXPECT_LE(clear[c], most + tolerance) << name << " " << view << ", " << kLineClassNames[c];
      }
    }
  }
}

/// The ball cuts itself at tips of narrow faces. What lies near both rims of a tip goes no detour round it: where pieces of
/// intersections are drawn on rims instead, they are as long as before, but for their way to the rim.
TEST(ClearDrawing, DrawsNothingRoundTheTipsOfFaces) {
  for (const char* view : {"iso", "front"}) {
    const Lengths exact = drawn(corpus_file("crumpled_ball"), Quality::exact, view),
                  clear = drawn(corpus_file("crumpled_ball"), Quality::clear, view);
    EXPECT_NEAR(length_of_all(clear), length_of_all(exact), 2) << view;
  }
}

/// A bar leaves a coarse body within the error of its facets, near the edges of the bar.
TEST(ClearDrawing, DrawsWholeLinesWhereABarLeavesACoarseBody) {
  const Scene scene = test::mesh_of(
                          "grid 16 x 8 triangles round capped: (10+0.9*sin(pi*u/4+1)*sin(pi*(v+0.5)/9))*sin(pi*(v+0.5)/9)"
                          "*cos(pi*u/8); (7+0.8*sin(pi*(v+0.5)/3))*sin(pi*(v+0.5)/9)*sin(pi*u/8); "
                          "8*cos(pi*(v+0.5)/9)+0.6*sin(pi*u/8)*sin(pi*(v+0.5)/9)\nobject\n"
                          "box 3,-1.4,0.3 13,1.5,1.5\nmap: x; y-0.3*(x-10); z+3*(x-10)")
                          .scene();
  const auto of_intersections = [&](Quality quality) {
    return lengths(scene, quality, "iso")[static_cast<std::size_t>(LineClass::intersection)];
  };
  EXPECT_NEAR(of_intersections(Quality::clear), of_intersections(Quality::exact), 0.5);
}

/// The faces of every object in another order.
Scene shuffled(const Scene& scene, unsigned seed) {
  Scene out = scene;
  out.faces = {};
  std::mt19937 random(seed);
  for (const Object& object : scene.objects) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) order.push_back(f);
    std::shuffle(order.begin(), order.end(), random);
    for (const std::uint32_t f : order)
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        if (c == 0)
          out.faces.add_face(scene.faces.contour(f, c));
        else
          out.faces.add_hole(scene.faces.contour(f, c));
      }
  }
  return out;
}

TEST(ClearDrawing, TheOrderOfFacesDoesNotMatter) {
  std::vector<std::string> files{corpus_file("cube_stored_twice"), corpus_file("cube_with_crack"),
                                 corpus_file("t_junction")};
  const fs::path chair = fs::path(LIGNE_MODELS_DIR) / "chair_model.obj";
  if (fs::exists(chair)) files.push_back(chair.string());
  for (const std::string& file : files) {
    Warnings warnings;
    Scene scene = read_scene(file, {}, warnings);
    scene.face_material.clear(), scene.corner_flags.clear();
    Scene other = shuffled(scene, 5);
    for (Scene* s : {&scene, &other}) {
      Topology topology = build_topology(*s);
      heal(*s, topology, {});
    }
    const Lengths a = lengths(scene, Quality::clear, "iso"), b = lengths(other, Quality::clear, "iso");
    // Sums over the corners of a surface depend on their order in the last bits, and outlines on these surfaces with them.
    for (std::size_t c = 0; c < kLineClassCount; ++c)
      EXPECT_NEAR(a[c], b[c], 2e-6 * std::max(500.0, a[c])) << file << ", " << kLineClassNames[c];
  }
}

// Meshes so large that their topology is built first: what is mended in them, and what their topology is.

struct HealedSheet {
  Scene scene;
  Topology topology;
  HealReport report;
};

HealOptions with_topology_first_from(std::size_t triangles) { return {std::nullopt, triangles}; }

void expect_own_topology(const HealedSheet& sheet) {
  const Topology own = build_topology(sheet.scene);
  const auto same_edge = [](const Edge& a, const Edge& b) {
    return a.v0 == b.v0 && a.v1 == b.v1 && a.face0 == b.face0 && a.face1 == b.face1;
  };
  EXPECT_TRUE(std::ranges::equal(sheet.topology.edges, own.edges, same_edge));
  EXPECT_EQ(sheet.topology.edge_flags, own.edge_flags);
  EXPECT_EQ(sheet.topology.triangles.size(), own.triangles.size());
}

enum class Faults { none, cracks, all };

/// A sheet with random holes, cracks and T-junctions, and where all faults are asked for third faces on edges and triangles
/// stored twice.
Scene faulty_sheet(Faults faults, std::mt19937& random) {
  constexpr std::uint32_t kCells = 7;
  const auto happens = [&](Faults least, std::uint32_t one_in) { return faults >= least && random() % one_in == 0; };
  Scene scene;
  test::begin_object(scene);
  const auto add_vertex = [&](const Point3& p) {
    scene.vertices.push_back(p);
    return static_cast<std::uint32_t>(scene.vertices.size() - 1);
  };
  for (std::uint32_t i = 0; i <= kCells; ++i)
    for (std::uint32_t j = 0; j <= kCells; ++j) add_vertex(Point3(i, j, 0.1 * ((i * 3 + j * 5) % 4)));
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t j = 0; j < kCells; ++j) {
      if (happens(Faults::cracks, 12)) continue;
      const std::uint32_t first = i * (kCells + 1) + j, next = first + kCells + 1;
      std::array<std::uint32_t, 4> corner{first, next, next + 1, first + 1};
      for (std::uint32_t& v : corner)
        if (happens(Faults::cracks, 6)) v = add_vertex(scene.vertices[v] + Point3(1e-4, -1e-4, 2e-5));
      if (happens(Faults::cracks, 4)) {
        const std::uint32_t middle = add_vertex(0.5 * (scene.vertices[corner[0]] + scene.vertices[corner[1]]));
        scene.faces.add_triangle(corner[0], middle, corner[3]);
        scene.faces.add_triangle(middle, corner[2], corner[3]);
        scene.faces.add_triangle(middle, corner[1], corner[2]);
      } else {
        scene.faces.add_triangle(corner[0], corner[1], corner[2]);
        scene.faces.add_triangle(corner[0], corner[2], corner[3]);
      }
      if (happens(Faults::all, 16)) scene.faces.add_triangle(corner[1], corner[2], add_vertex(Point3(i, j, 1.5)));
      if (happens(Faults::all, 10)) scene.faces.add_triangle(corner[0], corner[3], corner[2]);
    }
  }
  test::end_object(scene);
  return scene;
}

/// Large meshes heal as small ones do: on each sheet both ways are forced.
TEST(HealLargeMesh, HealsAsSmallOnes) {
  std::mt19937 random(5);
  std::size_t clean = 0, sewn = 0, split = 0, twice = 0, many = 0;
  for (int round = 0; round < 300; ++round) {
    const HealedSheet start{faulty_sheet(static_cast<Faults>(round % 3), random), {}, {}};
    HealedSheet small = start, large = start;
    small.report = heal(small.scene, small.topology, with_topology_first_from(small.scene.faces.size() + 1));
    large.report = heal(large.scene, large.topology, with_topology_first_from(0));
    if (round % 3 != 2) {  // no edge of three faces, of which a topology names two
      EXPECT_EQ(ends_of_odd_edges(start.scene, build_topology(start.scene)), ends_of_odd_edges(start.scene)) << round;
    }
    EXPECT_EQ(large.scene.vertices, small.scene.vertices) << round;
    EXPECT_TRUE(std::ranges::equal(std::as_const(large.scene).faces.corners(), std::as_const(small.scene).faces.corners()))
        << round;
    EXPECT_EQ(large.scene.corner_flags, small.scene.corner_flags) << round;
    expect_own_topology(small);
    expect_own_topology(large);
    const auto counts = [](const HealReport& r) {
      return std::array<std::size_t, 6>{r.faces_twice,  r.vertices_moved, r.edges_split,
                                        r.faces_turned, r.border_edges,   r.edges_sewn()};
    };
    EXPECT_EQ(counts(large.report), counts(small.report)) << round;
    clean += small.report.nothing();
    sewn += small.report.edges_sewn() > 0;
    split += small.report.edges_split > 0;
    twice += small.report.faces_twice > 0;
    many += std::ranges::any_of(small.topology.edge_flags, [](std::uint16_t f) { return (f & kEdgeManyFaces) != 0; });
  }
  for (const std::size_t seen : {clean, sewn, split, twice, many}) EXPECT_GE(seen, 20u);
}

/// Against all pairs of triangles, in meshes so small that they often repeat one.
TEST(HealLargeMesh, RepeatedTrianglesShowInTheTopology) {
  std::mt19937 random(17);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  int repeating = 0, certain = 0;
  for (int round = 0; round < 2000; ++round) {
    Scene scene;
    test::begin_object(scene);
    for (std::uint32_t v = 0; v < 9; ++v) scene.vertices.emplace_back(v, v * v, v * v * v);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int k = 0; k < 6; ++k) {
      std::array<std::uint32_t, 3> t{below(9), below(9), below(9)};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      if (k == 5 && round % 2 == 0 && !triangles.empty()) t = {triangles[0][2], triangles[0][1], triangles[0][0]};
      scene.faces.add_triangle(t[0], t[1], t[2]);
      std::ranges::sort(t);
      triangles.push_back(t);
    }
    test::end_object(scene);
    std::ranges::sort(triangles);
    const bool repeats = std::ranges::adjacent_find(triangles) != triangles.end();
    const bool may = may_repeat_triangles(build_topology(scene));
    EXPECT_TRUE(may || !repeats) << round;
    repeating += repeats;
    certain += !may;
  }
  EXPECT_GT(repeating, 500);
  EXPECT_GT(certain, 200);
}

/// At the poles of a globe in steps of its coordinates, rounding folds triangles over each other. No fold is drawn.
TEST(FineMeshes, AGlobeIsACircle) {
  Scene globe = test::mesh_of(
                    "grid 300 x 150 triangles round: 4*sin(pi*v/150)*cos(pi*u/150); 4*sin(pi*v/150)*sin(pi*u/150); "
                    "4*cos(pi*v/150)\nmap: floor(x/0.01+0.5)*0.01; floor(y/0.01+0.5)*0.01; floor(z/0.01+0.5)*0.01\n"
                    "without doubled\nprecision 0.005")
                    .scene();
  Topology topology;
  EXPECT_GT(heal(globe, topology, {}).vertices_collapsed, 10'000);
  EXPECT_NEAR(length_of_all(lengths(globe, Quality::clear, "iso")), std::numbers::pi * 190, 6);
}

}  // namespace
}  // namespace ligne
