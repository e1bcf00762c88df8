// The horizon against the default method on the same surface as a mesh: two triangles a cell, one diagonal. Nothing is
// shared but the heights.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "height_functions.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/horizon/horizon.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

Scene mesh_of(const HeightSource& heights) {
  Scene scene;
  const std::size_t nx = heights.x().size(), ny = heights.y().size();
  std::vector<double> z(nx);
  std::vector<std::uint32_t> number(nx * ny, 0xffffffffu);
  for (std::size_t j = 0; j < ny; ++j) {
    heights.read_row(j, z);
    for (std::size_t i = 0; i < nx; ++i) {
      if (!std::isfinite(z[i])) continue;
      number[j * nx + i] = static_cast<std::uint32_t>(scene.vertices.size());
      scene.vertices.push_back({heights.x()[i], heights.y()[j], z[i]});
    }
  }
  for (std::size_t j = 0; j + 1 < ny; ++j) {
    for (std::size_t i = 0; i + 1 < nx; ++i) {
      const std::uint32_t a = number[j * nx + i], b = number[j * nx + i + 1], c = number[(j + 1) * nx + i],
                          d = number[(j + 1) * nx + i + 1];
      if (std::max({a, b, c, d}) == 0xffffffffu) continue;
      scene.faces.add_triangle(a, b, c);
      scene.faces.add_triangle(b, d, c);
    }
  }
  scene.objects.push_back({"surface", 0, static_cast<std::uint32_t>(scene.vertices.size()), 0,
                           static_cast<std::uint32_t>(scene.faces.size()), 0});
  return scene;
}

struct Lengths {
  double curves = 0, outline = 0;
};

/// `lines_once`: with lines that lie on each other drawn as one.
Lengths by_mesh(const Scene& scene, const View& view, bool lines_once) {
  const Topology topology = build_topology(scene);
  EdgeSelection selection;
  for (std::size_t k = 0; k < kLineClassCount; ++k) selection.classes.add(static_cast<LineClass>(k));
  ProjectedScene projected = project(scene, topology, view, selection);
  projected.with_intersections = false;
  VisibilityResult result = find_method("appel")->study(projected, {});
  if (lines_once) remove_coincident_strokes(*result.strokes, coincidence_mm(projected));
  Lengths found;
  // A mesh counts faces within a micrometre of edge on as turned neither way; the horizon goes by the sign alone.
  const auto looks_up = [&](std::uint32_t face) {
    const Point3 on_face = scene.vertices[scene.faces.contour(face, 0)[0]];
    return glm::dot(face_normal(scene, face), view.camera.perspective ? on_face - view.camera.eye : view.camera.forward) < 0;
  };
  for (const Stroke& s : result.strokes->strokes) {
    const Edge& edge = topology.edges[s.source];
    const Point3 &a = scene.vertices[edge.v0], &b = scene.vertices[edge.v1];
    const Point2 p = projected.lattice.to_mm(s.from), q = projected.lattice.to_mm(s.to);
    const double along = std::hypot(q.x - p.x, q.y - p.y);
    if (a.x == b.x || a.y == b.y) {
      found.curves += along;
    } else if (s.line_class == LineClass::outline && looks_up(edge.face0) != looks_up(edge.face1)) {
      found.outline += along;
    }
  }
  return found;
}

double rough(double x, double y) {
  return 0.15 * std::sin(917.3 * x + 1.3) * std::sin(631.7 * y + 0.4) + 0.1 * std::sin(4 * x);
}

struct Surface {
  const char* name;
  Function f;
};

const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> all{
      {"waves", waves},
      {"sombrero", sombrero},
      {"rough", rough},
      {"waves with a hole", [](double x, double y) { return std::hypot(x - 0.1, y + 0.2) < 0.35 ? kNaN : waves(x, y); }},
      {"round sombrero", [](double x, double y) { return std::hypot(x, y) > 0.93 ? kNaN : sombrero(x, y); }},
      {"rough with many holes",
       [](double x, double y) { return std::sin(411.7 * x) * std::sin(523.1 * y) > 0.7 ? kNaN : rough(x, y); }},
      {"strips", [](double x, double y) { return std::sin(20 * x) > 0.6 ? kNaN : waves(x, y) + 0.2 * x; }}};
  return all;
}

void compare(const Surface& surface, const CameraRequest& request, std::size_t n, const std::string& place,
             double tolerance = 1e-5, bool lines_once = false) {
  const FunctionHeights heights(surface.f, positions(n), positions(n + 7));
  const Camera camera = make_camera(request, box_of(heights, survey(heights), 1));
  const View view = make_view(extent_scene(heights, 1, camera), camera, {{{10, 10}, {287, 200}}}, {{0, 0}, {297, 210}});
  HorizonOptions options;
  options.outline = true;
  Statistics statistics;
  const HorizonLines lines = horizon_lines(heights, view, options, statistics);
  const Lengths mesh = by_mesh(mesh_of(heights), view, lines_once);
  const std::string where = std::string(surface.name) + ", " + place;
  // Pieces shorter than a quarter micrometre are dropped by each in its own way; the mesh lies on a lattice of 8 nm.
  EXPECT_NEAR(length_of(lines.curves), mesh.curves, tolerance * mesh.curves) << where;
  EXPECT_NEAR(length_of(lines.outline), mesh.outline, 1e-3 + 0.1 * tolerance * mesh.curves + 10 * tolerance * mesh.outline)
      << where;
}

TEST(HorizonAndMesh, AgreeFromAllSides) {
  for (const Surface& surface : surfaces()) {
    for (const double elevation : {-35.0, 3.0, 28.0, 71.0}) {
      for (double azimuth = 11; azimuth < 360; azimuth += 51) {
        const double a = azimuth * std::acos(-1.0) / 180, e = elevation * std::acos(-1.0) / 180;
        CameraRequest request;
        request.direction = Point3{-std::cos(a) * std::cos(e), -std::sin(a) * std::cos(e), -std::sin(e)};
        compare(surface, request, 30, "azimuth " + std::to_string(azimuth) + ", elevation " + std::to_string(elevation));
      }
    }
  }
}

TEST(HorizonAndMesh, AgreeInPerspective) {
  for (const Surface& surface : surfaces()) {
    for (const Point3& eye : {Point3{-3, -2.5, 2}, Point3{2.2, 3.1, 0.4}, Point3{2.5, -2.8, -1.5}}) {
      CameraRequest request;
      request.eye = eye;
      request.target = Point3{0, 0, 0};
      request.fov_degrees = 100;
      compare(surface, request, 30, "eye " + std::to_string(eye.x));
    }
  }
}

// Where the eye stands over the ground or beside it the cells in its row and column are cut differently, and of an edge
// straight before it one bank is looked at.
TEST(HorizonAndMesh, AgreeNearlyWithTheEyeOverTheGround) {
  for (const Surface& surface : surfaces()) {
    for (const Point3& eye :
         {Point3{-4, 0.5 / 3, 1}, Point3{-3, 0.11, 1}, Point3{0.21, 2.7, 1.2}, Point3{0.33, -0.12, 2.5}}) {
      CameraRequest request;
      request.eye = eye;
      request.target = Point3{0.05, 0, 0};
      request.fov_degrees = 100;
      compare(surface, request, 60, "eye " + std::to_string(eye.x), 0.01);
    }
  }
}

TEST(HorizonAndMesh, AgreeAlongTheAxes) {
  for (const Surface& surface : surfaces()) {
    for (const Point3& direction :
         {Point3{0, 1, -0.4}, Point3{-1, 0, -0.4}, Point3{0, 0, -1}, Point3{1, 1, -1}, Point3{1, -1, -0.5}}) {
      CameraRequest request;
      request.direction = direction;
      // Upright curves fold on the page; the horizon draws none twice.
      const bool upright = direction.x == 0 || direction.y == 0;
      compare(surface, request, 24, "direction " + std::to_string(direction.x) + " " + std::to_string(direction.y), 1e-5,
              upright);
    }
  }
}

}  // namespace
}  // namespace ligne::test
