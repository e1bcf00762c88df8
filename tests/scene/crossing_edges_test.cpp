/// Edges along which surfaces pass through each other.

#include "scene/clean/crossing_edges.hpp"
#include "even_positions.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "scene/model/topology.hpp"
#include "scene/surfaces/surface_mesh.hpp"

namespace ligne {
namespace {

/// Number of edges that are marked, over all objects.
int crossing_edges(Scene scene) {
  double precision = 0;
  for (const Object& object : scene.objects) precision = std::max(precision, object.precision);
  mark_crossing_edges(scene, precision);
  const Topology topology = build_topology(scene);
  int count = 0;
  for (const std::uint16_t flags : topology.edge_flags) count += (flags & kEdgeCrossing) != 0;
  return count;
}

/// Of surfaces over [-1, 1] x [-1, 1] with four cells along each side.
int of_formulas(const std::vector<std::string>& formulas) {
  std::vector<SurfaceMesh> meshes;
  for (const std::string& formula : formulas) {
    SurfacePoints points = points_of(*formula_heights(formula, evenly(-1, 1, 4), evenly(-1, 1, 4)));
    points.from_formula = true;
    meshes.push_back(make_surface_mesh(points));
  }
  return crossing_edges(surface_scene(meshes, {1, 1, 1}, {}));
}

int of_parametric(const std::array<std::string, 3>& formulas, const std::vector<double>& u, const std::vector<double>& v) {
  const SurfaceMesh mesh = make_surface_mesh(parametric_points(formulas, u, v));
  return crossing_edges(surface_scene(std::span(&mesh, 1), {1, 1, 1}, {}));
}

TEST(CrossingEdges, PlanesThatCrossAlongAColumn) {
  EXPECT_EQ(of_formulas({"x", "0-x"}), 2 * 4);
  EXPECT_EQ(of_formulas({"x", "2*x"}), 2 * 4) << "at a small angle";
  EXPECT_EQ(of_formulas({"x", "1e-9-x"}), 0) << "not where the edges are";
  EXPECT_EQ(of_formulas({"x+1e-14", "0-x"}), 2 * 4) << "within the rounding";
  EXPECT_EQ(of_formulas({"x", "0-x", "0"}), 3 * 4);
}

TEST(CrossingEdges, RowsColumnsAndDiagonals) {
  // Two triangles at the origin lie in the plane.
  EXPECT_EQ(of_formulas({"x*y", "0"}), 2 * 4);
  EXPECT_EQ(of_formulas({"x+y", "0"}), 2 * 4) << "along the diagonals of the cells";
  EXPECT_EQ(of_formulas({"x-y", "0"}), 0) << "across them: there faces penetrate";
}

TEST(CrossingEdges, WhatTouchesDoesNotCross) {
  EXPECT_EQ(of_formulas({"abs(x)", "0-abs(x)"}), 0) << "folds";
  EXPECT_EQ(of_formulas({"abs(x)", "0"}), 0);
  EXPECT_EQ(of_formulas({"max(x,0)", "0"}), 0) << "one on one side";
  EXPECT_EQ(of_formulas({"x*y", "x*y"}), 0) << "one everywhere";
  EXPECT_EQ(of_formulas({"abs(x)", "2*abs(x)"}), 0) << "one fold in another";
}

TEST(CrossingEdges, SurfacesThatCrossThemselves) {
  const auto full = evenly(0, 2 * std::numbers::pi, 12);
  const std::array<std::string, 3> klein{"(3+cos(u/2)*sin(v)-sin(u/2)*sin(2*v))*cos(u)",
                                         "(3+cos(u/2)*sin(v)-sin(u/2)*sin(2*v))*sin(u)",
                                         "sin(u/2)*sin(v)+cos(u/2)*sin(2*v)"};
  EXPECT_EQ(of_parametric(klein, full, full), 12) << "the circle in the middle of the eight";
  EXPECT_EQ(of_parametric({"sin(u)*cos(v)", "sin(u)*sin(v)", "cos(u)"}, evenly(0, std::numbers::pi, 6), full), 0) << "poles";
  EXPECT_EQ(of_parametric({"(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)"}, evenly(0, 4 * std::numbers::pi, 24), full),
            0)
      << "twice round";
}

}  // namespace
}  // namespace ligne
