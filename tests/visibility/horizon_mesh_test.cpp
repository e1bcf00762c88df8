// The horizon against the default method on the same surface as a mesh: two triangles a cell, one diagonal. Nothing is
// shared but the heights.

#include "height_functions.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "main/tier.hpp"
#include "scene/model/topology.hpp"
#include "support/test.hpp"
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
  for (std::size_t j = 0; j + 1 < ny; ++j)
    for (std::size_t i = 0; i + 1 < nx; ++i) {
      const std::uint32_t a = number[j * nx + i], b = number[j * nx + i + 1], c = number[(j + 1) * nx + i],
                          d = number[(j + 1) * nx + i + 1];
      if (std::max({a, b, c, d}) == 0xffffffffu) continue;
      scene.faces.add_triangle(a, b, c);
      scene.faces.add_triangle(b, d, c);
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
  VisibilityResult result = find_method("appel")->compute_visibility(projected, {});
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
  const View view = view_of(heights, request);
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
    for (const double elevation : chosen("elevations", 2, {-35.0, 3.0, 28.0, 71.0}))
      for (double azimuth = 11; azimuth < 360; azimuth += 51)
        compare(surface, along_angles(azimuth, elevation), 30,
                "azimuth " + std::to_string(azimuth) + ", elevation " + std::to_string(elevation));
  }
}

TEST(HorizonAndMesh, AgreeInPerspective) {
  for (const Surface& surface : surfaces())
    for (const Point3& eye : {Point3{-3, -2.5, 2}, Point3{2.2, 3.1, 0.4}, Point3{2.5, -2.8, -1.5}})
      compare(surface, from_eye(eye, {0, 0, 0}, 100), 30, "eye " + std::to_string(eye.x));
}

// Where the eye stands over the ground or beside it the cells in its row and column are cut differently, and of an edge
// straight before it one bank is looked at.
TEST(HorizonAndMesh, AgreeNearlyWithTheEyeOverTheGround) {
  for (const Surface& surface : surfaces())
    for (const Point3& eye :
         {Point3{-4, 0.5 / 3, 1}, Point3{-3, 0.11, 1}, Point3{0.21, 2.7, 1.2}, Point3{0.33, -0.12, 2.5}}) {
      compare(surface, from_eye(eye, {0.05, 0, 0}, 100), 60, "eye " + std::to_string(eye.x), 0.01);
    }
}

TEST(HorizonAndMesh, AgreeAlongTheAxes) {
  for (const Surface& surface : surfaces()) {
    for (const Point3& direction :
         {Point3{0, 1, -0.4}, Point3{-1, 0, -0.4}, Point3{0, 0, -1}, Point3{1, 1, -1}, Point3{1, -1, -0.5}}) {
      // Upright curves fold on the page; the horizon draws none twice.
      const bool upright = direction.x == 0 || direction.y == 0;
      compare(surface, along(direction), 24, "direction " + std::to_string(direction.x) + " " + std::to_string(direction.y),
              1e-5, upright);
    }
  }
}

// Lines that the horizon draws beside curves, point by point against rays to the viewer: contour lines, lines on the base,
// lines behind the surface.

double holed(double x, double y) { return std::hypot(x - 0.1, y + 0.2) < 0.4 ? kNaN : waves(x, y); }

struct Triangle3 {
  Point3 a, b, c;
};

std::vector<Triangle3> triangles_of(const FunctionHeights& h) {
  std::vector<Triangle3> all;
  const auto p = [&](std::size_t i, std::size_t j) { return Point3{h.x()[i], h.y()[j], h.at(i, j)}; };
  for (std::size_t j = 0; j + 1 < h.y().size(); ++j)
    for (std::size_t i = 0; i + 1 < h.x().size(); ++i) {
      const Point3 a = p(i, j), b = p(i + 1, j), c = p(i, j + 1), d = p(i + 1, j + 1);
      if (!std::isfinite(a.z + b.z + c.z + d.z)) continue;
      all.push_back({a, b, c});
      all.push_back({b, d, c});
    }
  return all;
}

/// Whether a triangle stands between the point and the viewer, who is at `point` + t `to_viewer`, t <= end.
bool hidden(const std::vector<Triangle3>& triangles, const Point3& point, const Point3& to_viewer, double end) {
  for (const Triangle3& t : triangles) {
    const Point3 e1 = t.b - t.a, e2 = t.c - t.a, h = glm::cross(to_viewer, e2);
    const double det = glm::dot(e1, h);
    if (det == 0) continue;
    const Point3 s = point - t.a, q = glm::cross(s, e1);
    const double u = glm::dot(s, h) / det, v = glm::dot(to_viewer, q) / det, at = glm::dot(e2, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && at > 1e-7 && at < end) return true;
  }
  return false;
}

class Scenery {
 public:
  Scenery(const FunctionHeights& heights, const CameraRequest& request) : triangles_(triangles_of(heights)) {
    view_ = view_of(heights, request, 1, {{-500, -500}, {800, 800}});
  }
  const View& view() const { return view_; }
  Point2 page(const Point3& p) const { return page_point(view_, p); }
  /// Length on the page of what is seen of a segment, by rays from many points.
  double seen_length(const Point3& a, const Point3& b, int points) const {
    double sum = 0;
    for (int k = 0; k < points; ++k) {
      const Point3 p = a + (b - a) * ((k + 0.5) / points);
      const Camera& camera = view_.camera;
      const bool is_hidden =
          camera.perspective ? hidden(triangles_, p, camera.eye - p, 1) : hidden(triangles_, p, -camera.forward, 1e9);
      if (is_hidden) continue;
      const Point2 from = page(a + (b - a) * (double(k) / points)), to = page(a + (b - a) * ((k + 1.0) / points));
      sum += std::hypot(to.x - from.x, to.y - from.y);
    }
    return sum;
  }
  /// Length seen of the contour lines at a level, on the surface or dropped to a base.
  double contour_length(double level, std::optional<double> base) const {
    double sum = 0;
    for (const Triangle3& t : triangles_) {
      std::vector<Point3> ends;
      for (const auto& [p, q] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)})
        if ((p.z < level) != (q.z < level)) ends.push_back(p + (q - p) * ((level - p.z) / (q.z - p.z)));
      if (ends.size() != 2) continue;
      if (base) ends[0].z = ends[1].z = *base;
      sum += seen_length(ends[0], ends[1], 3);
    }
    return sum;
  }

 private:
  std::vector<Triangle3> triangles_;
  View view_;
};

std::vector<CameraRequest> cameras() {
  std::vector<CameraRequest> all;
  for (const Point3& direction :
       {Point3{1, 0.7, -0.5}, Point3{-0.8, 0.5, -0.3}, Point3{0.9, -0.4, 0.35}, Point3{-0.3, -1, -1.1}}) {
    all.push_back(along(direction));
  }
  for (const Point3& eye : {Point3{-2.6, -2.3, 1.4}, Point3{2.7, -1.9, 0.8}}) all.push_back(from_eye(eye, {0, 0, 0}, 100));
  return all;
}

TEST(HorizonLines, ContoursAreSeenWhereRaysAreFree) {
  for (const auto& f : {waves, holed}) {
    const FunctionHeights heights(f, positions(26), positions(31));
    for (const CameraRequest& request : cameras()) {
      const Scenery scenery(heights, request);
      HorizonOptions options;
      options.contours = {-0.21, 0.003, 0.17, 0.26};
      options.contour_base = -0.7;
      Statistics statistics;
      const HorizonLines lines = horizon_lines(heights, scenery.view(), options, statistics);
      double on_surface = 0, on_base = 0;
      for (const double level : options.contours) {
        on_surface += scenery.contour_length(level, {});
        on_base += scenery.contour_length(level, options.contour_base);
      }
      const std::string where = f == waves ? "waves" : "holed";
      // The rays are as coarse as a third of a piece where a line goes under.
      EXPECT_NEAR(length_of(lines.contours), on_surface, 0.01 * on_surface) << where;
      EXPECT_NEAR(length_of(lines.base_contours), on_base, 0.015 * on_base) << where;
      EXPECT_GT(length_of(lines.base_contours), 0) << where;
    }
  }
}

TEST(HorizonLines, LinesBehindAreSeenWhereRaysAreFree) {
  for (const auto& f : {waves, holed}) {
    const FunctionHeights heights(f, positions(26), positions(31));
    for (const CameraRequest& request : cameras()) {
      const Scenery scenery(heights, request);
      const Camera& camera = scenery.view().camera;
      // The far corner's upright, and the sides of a box there.
      const auto far = [&](int axis) {
        return (camera.perspective ? camera.eye[axis] < 0 : camera.forward[axis] > 0) ? 1.0 : -1.0;
      };
      const double x = far(0), y = far(1);
      HorizonOptions options;
      for (const double z : {-0.6, -0.1, 0.35}) {
        options.back_lines.push_back({Point3{x, -y, z}, Point3{x, y, z}});
        options.back_lines.push_back({Point3{-x, y, z}, Point3{x, y, z}});
      }
      options.back_lines.push_back({Point3{x, y, -0.6}, Point3{x, y, 0.6}});
      options.back_lines.push_back({Point3{-0.3 * x, y, 0.6}, Point3{-0.3 * x, y, -0.6}});
      Statistics statistics;
      const HorizonLines lines = horizon_lines(heights, scenery.view(), options, statistics);
      for (std::size_t i = 0; i < options.back_lines.size(); ++i) {
        const auto& [a, b] = options.back_lines[i];
        double seen = 0;
        for (const auto& span : lines.back_lines[i]) {
          const Point2 p = scenery.page(a + (b - a) * span.from), q = scenery.page(a + (b - a) * span.to);
          seen += std::hypot(q.x - p.x, q.y - p.y);
        }
        EXPECT_NEAR(seen, scenery.seen_length(a, b, 800), 1.5)
            << "line " << i << ", surface " << (f == waves ? "waves" : "holed");
      }
    }
  }
}

TEST(HorizonLines, SidesApartAreTheWhole) {
  const FunctionHeights heights(waves, positions(26), positions(31));
  for (const CameraRequest& request : cameras()) {
    const Scenery scenery(heights, request);
    HorizonOptions options;
    Statistics statistics;
    const double all = length_of(horizon_lines(heights, scenery.view(), options, statistics).curves);
    options.underside = Underside::apart;
    const HorizonLines apart = horizon_lines(heights, scenery.view(), options, statistics);
    EXPECT_NEAR(length_of(apart.curves) + length_of(apart.underside), all, 1e-3);
    options.underside = Underside::none;
    const HorizonLines upper = horizon_lines(heights, scenery.view(), options, statistics);
    EXPECT_NEAR(length_of(upper.curves), length_of(apart.curves), 1e-9);
    EXPECT_EQ(upper.underside.size(), 0u);
  }
  // From below a plate shows nothing but its lower side.
  const FunctionHeights plate([](double, double) { return 0.0; }, positions(5), positions(5));
  HorizonOptions options;
  options.underside = Underside::apart;
  Statistics statistics;
  const HorizonLines lines = horizon_lines(plate, Scenery(plate, along({0.3, 0.4, 1})).view(), options, statistics);
  EXPECT_EQ(lines.curves.size(), 0u);
  EXPECT_EQ(lines.underside.size(), 10u);
}

TEST(HorizonLines, RimsOfHolesAreBorders) {
  // One sample in the middle is missing: four cells are gone, and around them runs a square of two cells' side.
  const FunctionHeights heights([](double x, double y) { return std::abs(x) < 0.1 && std::abs(y) < 0.1 ? kNaN : 0.0; },
                                positions(9), positions(9));
  HorizonOptions options;
  options.x_stride = options.y_stride = 0;
  options.outline = true;
  Statistics statistics;
  const Scenery scenery(heights, along({0, 0, -1}));
  const HorizonLines lines = horizon_lines(heights, scenery.view(), options, statistics);
  EXPECT_EQ(lines.border.size(), 2u);
  EXPECT_EQ(lines.curves.size(), 0u);
  EXPECT_NEAR(length_of(lines.border), 4 * 190 + 8 * 190 / 8.0, 1e-3);
}

}  // namespace
}  // namespace ligne::test
