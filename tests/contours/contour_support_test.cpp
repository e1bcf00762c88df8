// How far contours may lie beside the outline of the mesh: to the last digit, on chains made by hand.

#include "contours/contour_support.hpp"

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "contours/surfaces/outline_probes.hpp"
#include "support/test.hpp"
#include "view/view.hpp"

namespace ligne::test {
namespace {

constexpr double kPenWidthMm = 0.35;

/// A chain of three nodes along the edge from (0, 0, 0) to (100, 0, 0), seen from the front. The middle one lies `away_mm`
/// above the edge on the page, the others on it.
struct BesideAnEdge {
  Scene scene;
  View view;
  SmoothPatch patch;
  ContourChain chain;

  BesideAnEdge(double away_mm, double sag_mm) {
    scene.vertices = {{0, 0, 0}, {100, 0, 0}, {50, 0, -40}};
    scene.faces.add_face(std::array{0u, 1u, 2u});
    scene.objects.push_back({});
    scene.objects.back().vertex_end = 3;
    scene.objects.back().face_end = 1;
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

}  // namespace
}  // namespace ligne::test
