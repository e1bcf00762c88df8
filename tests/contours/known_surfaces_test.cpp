/// Contours of known surfaces, and their support by the outlines of the mesh.

#include "contours/surfaces/known_surfaces.hpp"
#include "base/no_index.hpp"
#include "contours/contour_chains.hpp"
#include "contours/contour_support.hpp"
#include "contours/surfaces/outline_probes.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"
#include "view/edge_classes.hpp"
#include "view/view.hpp"

namespace ligne::test {
namespace {

// How far contours may lie beside the outline of the mesh: to the last digit, on chains made by hand.

constexpr double kPenWidthMm = 0.35;

/// A chain of three nodes along the edge from (0, 0, 0) to (100, 0, 0), seen from the front. The middle one lies `away_mm`
/// above the edge on the page, the others on it.
struct BesideAnEdge {
  Scene scene;
  View view;
  SmoothPatch patch;
  ContourChain chain;

  BesideAnEdge(double away_mm, double sag_mm) {
    scene = mesh_of("face 0,0,0 100,0,0 50,0,-40\nexact").scene();
    CameraRequest camera;
    camera.named_view = "front";
    view = make_view(scene, make_camera(camera, scene), {{{10, 10}, {287, 200}}}, {{0, 0}, {297, 210}});
    patch.triangles = {{{0, 1, 2}, 0}};
    for (int i = 0; i < 3; ++i) {
      ContourNode node;
      node.on_mesh = {40.0 + 10 * i, 0, 0};
      node.on_surface = node.on_mesh + Point3(0, 0, i == 1 ? away_mm / view.scale : 0);
      node.sag = node.sag_ahead = sag_mm / view.scale;
      chain.nodes.push_back(node);
    }
    chain.triangles = {0, 0};
  }

  ContourSupport support() {
    const std::array<ContourChain*, 1> chains{&chain};
    const std::array<std::uint32_t, 1> sides{0};
    return {scene, view, patch, chains, sides, kPenWidthMm};
  }
};

TEST(ContourSupport, MovesNodesToWithinTheSagAndHalfAPen) {
  for (const double sag_mm : {0.0, 0.2, 1.0}) {
    const double most_mm = sag_mm + kPenWidthMm / 2;
    for (const double part : {0.5, 0.99, 1.01, 1.9}) {
      BesideAnEdge beside(part * most_mm, sag_mm);
      const ContourSupport support = beside.support();
      EXPECT_NEAR(support.astray(), part > 1 ? 0.5 : 0, 1e-9) << sag_mm << " " << part;
      const std::vector<ContourChain> supported = support.supported();
      ASSERT_EQ(supported.size(), 1u) << sag_mm << " " << part;
      ASSERT_EQ(supported[0].nodes.size(), 3u);
      const double edge_mm = page_point(beside.view, {50, 0, 0}).y;
      const double away_mm = edge_mm - page_point(beside.view, supported[0].nodes[1].on_surface).y;
      EXPECT_NEAR(away_mm, std::min(part, 1.0) * most_mm, 1e-9) << sag_mm << " " << part;
    }
  }
}

TEST(ContourSupport, EndsContoursWhereChordsLieFartherAway) {
  for (const double sag_mm : {0.0, 0.2, 1.0}) {
    BesideAnEdge beside(2.1 * (sag_mm + kPenWidthMm / 2), sag_mm);
    EXPECT_TRUE(beside.support().supported().empty()) << sag_mm;
  }
}

TEST(ContourSupport, RulingsAreStraight) {
  for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::cone, SurfaceKind::extruded, SurfaceKind::sphere}) {
    BesideAnEdge beside(0, 0.2);
    Patches surfaces{std::vector<Patch>(1), {0}, {}, {}, {}};
    surfaces.list[0].surface.kind = kind;
    beside.patch.surfaces = &surfaces;
    EXPECT_EQ(beside.support().supported()[0].nodes[0].bulge_mm > 0, kind == SurfaceKind::sphere);
  }
}

// A contour is near an edge of slender triangles only as far as they are wide and the surface rises, however long they are.
TEST(OutlineProbes, OfSlenderTrianglesStayNearTheirEdge) {
  struct Case {
    double height, turn, size;  // of the triangles; of the normals along the edge; expected, model units
  };
  for (const auto& [height, turn, size] : {Case{2, 0, 5 * 2}, Case{2, 0.08, 5 * (2 + 100 * 0.08 / 8)}, Case{80, 0, 100}}) {
    BesideAnEdge edge(0, 0);
    edge.scene.vertices[2] = {50, 0, -height};
    edge.scene.vertices.push_back({50, height / 2, -height / 2});
    edge.patch.triangles = {{{0, 1, 2}, 0}, {{1, 0, 3}, 1}};
    edge.patch.across = {3, kNone, kNone, 0, kNone, kNone};
    edge.patch.sector = {0, 1, 2, 1, 0, 3};
    edge.patch.normals.assign(4, {0, 0, 1});
    edge.patch.normals[1].x = turn;
    const double size_mm = size_on_page(edge.scene, edge.view, edge.patch, 0);
    EXPECT_NEAR(size_mm, size * edge.view.scale, 1e-9);
    const auto probe = outline_probe(edge.scene, edge.view, edge.patch, 0, {size_mm, 100, kPenWidthMm});
    for (const int end : {0, 1}) {
      const Point2 off = page_point(edge.view, probe[end]) - page_point(edge.view, edge.scene.vertices[end]);
      EXPECT_NEAR(glm::length(off), kPenWidthMm + 0.05 * size_mm, 1e-9);
    }
  }
}

// The probe of an edge of a coarse mesh is moved backwards only if a triangle near it comes back below it.
TEST(OutlineProbes, OfCoarseMeshesStayWhereNothingComesBack) {
  for (const auto& [above, size, is_back] : {std::tuple{-10.0, 1e3, false}, {40.0, 1e3, true}, {-10.0, 1e4, true}}) {
    BesideAnEdge edge(0, 0);
    edge.scene.vertices.insert(edge.scene.vertices.end(), {{50, 10, -20}, {50, 20, above}});
    edge.patch.triangles = {{{0, 1, 2}, 0}, {{1, 0, 3}, 1}, {{3, 0, 4}, 2}};
    edge.patch.across = {3, kNone, kNone, 0, 6, kNone, 4, kNone, kNone};
    const auto probe = outline_probe(edge.scene, edge.view, edge.patch, 0, {50, size, kPenWidthMm});
    EXPECT_EQ(probe[0].y > 1, is_back) << above << ' ' << size;
  }
}

/// A replaced edge whose probe is visible from `t_from` on.
struct LostEdge {
  Point3 from, to;
  double t_from = 0;
};

/// The strokes that are drawn for replaced edges beside one visible contour and the visible outlines of the mesh. All lie in
/// the plane y = 0 and are seen from the front; lengths are in mm of the page.
std::vector<Stroke> strokes_for(const std::vector<LostEdge>& edges, const std::vector<Point3>& contour,
                                const std::vector<LostEdge>& outlines) {
  const View view = BesideAnEdge(0, 0).view;
  StrokeModel model{page_lattice(view), {}, 0, {}};
  const auto mm = [&](const Point3& p) { return page_point(view, p / view.scale); };
  const auto stroke = [&](const LostEdge& e, std::uint32_t source) {
    Stroke s{e.t_from, 1, model.lattice.snap(mm(e.from + e.t_from * (e.to - e.from))), model.lattice.snap(mm(e.to))};
    s.source = source;
    s.line_class = LineClass::outline;
    return s;
  };
  SmoothContours contours;
  std::vector<Stroke> probes;
  for (const LostEdge& e : edges) {
    probes.push_back(stroke(e, static_cast<std::uint32_t>(contours.replaced.size())));
    contours.replaced.push_back({{e.from / view.scale, e.to / view.scale}, {0, 0}, false});
    contours.replaced_size_mm.push_back(20);
  }
  for (const LostEdge& e : outlines) model.strokes.push_back(stroke(e, kNone));
  SeenContour seen;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const double length = i > 0 ? seen.curve.length() + glm::length(contour[i] - contour[i - 1]) : 0;
    seen.curve.points.push_back({double(i), mm(contour[i]), 0, 1, length});
  }
  seen.runs = {{0, double(contour.size() - 1), 0}};
  add_missing_outlines(model, view, contours, probes, {seen}, {kPenWidthMm, 2 * kPenWidthMm});
  return {model.strokes.begin() + static_cast<std::ptrdiff_t>(outlines.size()), model.strokes.end()};
}

TEST(OutlineProbes, OutlinesLeadToTheLineThatHidesThem) {
  const LostEdge edge{{0, 0, 0}, {50, 0, 0}, 0.9}, hiding{{45.2, 0, -9}, {45.2, 0, 9}};
  const std::vector<Point3> contour{edge.to, {70, 0, 0}};
  EXPECT_TRUE(strokes_for({edge}, contour, {}).empty());
  const std::vector<Stroke> found = strokes_for({edge}, contour, {hiding});
  ASSERT_EQ(found.size(), 1u);
  const View view = BesideAnEdge(0, 0).view;
  EXPECT_NEAR(page_lattice(view).to_mm(found[0].from).x, page_point(view, hiding.from / view.scale).x, 1e-3);
}

TEST(OutlineProbes, OutlinesLeadFromContoursToOutlinesFarFromThem) {
  const LostEdge edge{{0, 0, 0}, {50, 0, 0}}, next{{50, 0, 0}, {50, 0, 20}};
  std::vector<Point3> there_and_back;
  for (int i = 0; i <= 86; ++i) there_and_back.push_back({std::min(i, 86 - i), 0, -i / 86.0});
  EXPECT_EQ(strokes_for({edge, next}, there_and_back, {}).size(), 2u);
  EXPECT_EQ(strokes_for({edge}, there_and_back, {}).size(), 0u);
}

// Contours on the surfaces that were found behind a mesh: they lie on the outline of the surface itself.

/// How far nodes of the contours lie beside the surface of their mesh, and how far its normals there are from square to the
/// sight.
struct Misses {
  std::size_t nodes = 0;
  double distance = 0, facing = 0;
};

Misses measure(const FoundPatches& found, const Camera& camera, bool with_surfaces) {
  View view;
  view.camera = camera;
  const std::vector<LineClass> classes = classify_edges(found.scene, found.topology, view, 30);
  std::vector<std::uint32_t> outlines;
  for (std::uint32_t e = 0; e < classes.size(); ++e)
    if (classes[e] == LineClass::outline) outlines.push_back(e);
  const std::vector<std::uint8_t> no_creases(classes.size(), 0);
  const RegionBorders borders{30, &no_creases, with_surfaces ? &found.patches : nullptr};
  const SmoothPatch patch = smooth_patch(found.scene, found.topology, camera, outlines, borders);
  Misses misses;
  for (const ContourChain& chain : trace_contours(found.scene, camera, patch))
    for (const ContourNode& node : chain.nodes) {
      if (node.is_cusp()) continue;
      ++misses.nodes;
      misses.distance = std::max(misses.distance, std::abs(found.only().distance(node.on_surface)));
      const Point3 normal = found.only().normal(node.on_surface);
      misses.facing = std::max(misses.facing, std::abs(glm::dot(normal, glm::normalize(to_eye(camera, node.on_surface)))));
    }
  return misses;
}

TEST(KnownSurfaces, NodesOfContoursLieOnTheOutlineOfTheSurface) {
  for (const char* name : {"grid 24 x 16 triangles round ring: (10+3*cos(pi*v/8))*cos(pi*u/12);"
                           "(10+3*cos(pi*v/8))*sin(pi*u/12); 3*sin(pi*v/8)",
                           "grid 24 x 4 triangles round: 5*cos(pi*u/12); 5*sin(pi*u/12); 3*v+cos(pi*u/12)"}) {
    const FoundPatches found(mesh_of(name).polygons());
    ASSERT_EQ(found.faces().size(), 1u) << name;
    for (const Point3& direction : {Point3(1, 0.3, -0.8), Point3(-0.4, 1, 0.2)}) {
      for (const bool perspective : {false, true}) {
        CameraRequest request;
        (perspective ? request.eye : request.direction) = perspective ? -40.0 * direction : direction;
        const Camera camera = make_camera(request, found.scene);
        const Misses with = measure(found, camera, true), without = measure(found, camera, false);
        ASSERT_GT(with.nodes, 3u) << name;
        EXPECT_LT(with.distance, 1e-5) << name;
        EXPECT_LT(with.facing, 1e-5) << name;
        EXPECT_GT(without.distance + without.facing, 1e-4) << name;  // otherwise nothing would be shown
      }
    }
  }
}

TEST(KnownSurfaces, TurnsAreTheDerivativesOfNormals) {
  for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::cone, SurfaceKind::sphere, SurfaceKind::torus}) {
    for (const bool outward : {true, false}) {
      Patch patch;
      patch.outward = outward;
      patch.surface = {kind, {1, 2, 3}, glm::normalize(Point3(1, -2, 2)), 5, kind == SurfaceKind::cone ? 0.4 : 0, 1.5};
      const Point3 p = nearest_point(patch, Point3(4, 6.5, 2));
      EXPECT_NEAR(patch.surface.distance(p), 0, 1e-9);
      const Point3 normal = facing_normal(patch, p);
      for (const Point3& way : frame_of(normal)) {
        constexpr double kStep = 1e-6;
        const Point3 change = (facing_normal(patch, p + kStep * way) - facing_normal(patch, p - kStep * way)) / (2 * kStep);
        EXPECT_LT(glm::length(change - ligne::turned(facing_turn(patch, p), way)), 1e-6)
            << static_cast<int>(kind) << outward;
      }
    }
  }
}

TEST(KnownSurfaces, BandsOfAFreeFormAreNoSurfacesOfTheirOwn) {
  // Three rings of a paraboloid are cones: too few for a revolved surface.
  FoundPatches dish(mesh_of("grid 48 x 3 round: (4+v)*cos(pi*u/24); (4+v)*sin(pi*u/24); (4+v)^2/20").polygons());
  mark_bands(dish.scene, dish.topology, dish.angles.normals, dish.edges, dish.patches);
  ASSERT_EQ(dish.faces().size(), 3u);
  for (const auto& [number, faces] : dish.faces()) EXPECT_TRUE(dish.patches.list[number].is_band) << number;
  FoundPatches box(test::rounded_box({6, 5, 4}, 4));
  mark_bands(box.scene, box.topology, box.angles.normals, box.edges, box.patches);
  ASSERT_GT(box.faces().size(), 12u);
  for (const auto& [number, faces] : box.faces()) EXPECT_FALSE(box.patches.list[number].is_band) << number;
}

TEST(KnownSurfaces, FilletsAtAMitreAreNoBands) {
  // Quarters of two cylinders whose axes meet at 11 degrees. On one side their normals are equal.
  FoundPatches fillets(mesh_of("grid 12 x 2: 4*cos(pi*u/24)*if(v<2,1,0.98006658)+3.9733866*(v==2); "
                               "if(v<1,-20,if(v<2,-0.10033467,-0.19866933)*4*cos(pi*u/24)+19.601332*(v==2)); 4*sin(pi*u/24)")
                           .polygons());
  mark_bands(fillets.scene, fillets.topology, fillets.angles.normals, fillets.edges, fillets.patches);
  ASSERT_EQ(fillets.faces().size(), 2u);
  for (const auto& [number, faces] : fillets.faces()) EXPECT_FALSE(fillets.patches.list[number].is_band) << number;
}

}  // namespace
}  // namespace ligne::test
