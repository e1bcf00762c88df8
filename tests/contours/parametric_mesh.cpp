#include "contours/parametric_mesh.hpp"

#include "contours/contour_strokes.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

constexpr double kWholeTurn = 2 * 3.14159265358979323846;

/// A tube round a closed curve. `frame` gives the curve's point at u.
Point3 tube(const std::function<Point3(double)>& curve, double radius, double u, double v) {
  constexpr double kStep = 1e-4;
  const Point3 along = glm::normalize(curve(u + kStep) - curve(u - kStep));
  const Point3 side = glm::normalize(glm::cross(along, Point3{0, 0, 1}));
  const Point3 up = glm::cross(side, along);
  return curve(u) + radius * (std::cos(kWholeTurn * v) * side + std::sin(kWholeTurn * v) * up);
}

using Face = std::array<std::uint32_t, 3>;

/// Positive when p lies on the outer side of the face.
double height_over(const std::vector<Point3>& points, const Face& f, const Point3& p) {
  const Point3 a = points[f[0]];
  return glm::dot(glm::cross(points[f[1]] - a, points[f[2]] - a), p - a);
}

}  // namespace

Scene as_one_object(Scene scene) {
  Object object;
  object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  object.face_end = static_cast<std::uint32_t>(scene.faces.size());
  object.precision = 1e-12;
  scene.objects.push_back(object);
  return scene;
}

View view_along(const Scene& scene, const Point3& direction) {
  CameraRequest request;
  request.direction = direction;
  return make_view(scene, make_camera(request, scene), {{{10, 10}, {287, 200}}}, {{0, 0}, {297, 210}});
}

Point3 ParametricSurface::normal(double u, double v) const {
  constexpr double kStep = 1e-5;
  return glm::cross(at(u + kStep, v) - at(u - kStep, v), at(u, v + kStep) - at(u, v - kStep));
}

std::vector<ParametricSurface> test_surfaces() {
  const auto ring = [](double a, double b, double height, int waves) {
    return [=](double u) {
      return Point3{a * std::cos(kWholeTurn * u), b * std::sin(kWholeTurn * u), height * std::sin(waves * kWholeTurn * u)};
    };
  };
  return {
      {"torus", [=](double u, double v) { return tube(ring(65, 65, 0, 1), 30, u, v); }},
      {"swelling",
       [=](double u, double v) { return tube(ring(65, 65, 0, 1), 24 + 6 * std::sin(3 * kWholeTurn * u), u, v); }},
      {"saddle", [=](double u, double v) { return tube(ring(65, 65, 15, 2), 22, u, v); }},
      {"oval", [=](double u, double v) { return tube(ring(80, 50, 0, 1), 25, u, v); }},
      {"tilted", [=](double u, double v) { return tube(ring(70, 60, 20, 1), 22 + 4 * std::cos(kWholeTurn * u), u, v); }},
  };
}

Scene uneven_mesh(const ParametricSurface& surface, int columns, int rows, double jitter, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  std::vector<Point2> places;
  Scene scene;
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k) {
      const double du = (2 * unit() - 1) * jitter, dv = (2 * unit() - 1) * jitter;
      places.push_back({i + du, k + dv});
      scene.vertices.push_back(surface.at((i + du) / columns, (k + dv) / rows));
    }
  const auto area = [&](std::array<int, 3> t, std::array<Point2, 3> shift) {
    std::array<Point2, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = places[static_cast<std::size_t>(t[c])] + shift[c];
    return (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  };
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const int right = (i + 1) % columns, above = (k + 1) % rows;
      const int a = i * rows + k, b = right * rows + k, c = right * rows + above, d = i * rows + above;
      const Point2 over_x{right == 0 ? columns : 0, 0}, over_y{0, above == 0 ? rows : 0}, none{0, 0};
      // The diagonal that keeps both triangles broad; either where both do.
      const double ac =
          std::min(area({a, b, c}, {none, over_x, over_x + over_y}), area({a, c, d}, {none, over_x + over_y, over_y}));
      const double bd =
          std::min(area({a, b, d}, {none, over_x, over_y}), area({b, c, d}, {over_x, over_x + over_y, over_y}));
      constexpr double kBroad = 0.3;
      const bool by_ac = std::min(ac, bd) > kBroad ? unit() < 0.5 : ac > bd;
      const auto add = [&](int x, int y, int z) {
        scene.faces.add_triangle(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                 static_cast<std::uint32_t>(z));
      };
      if (by_ac) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  }
  return as_one_object(std::move(scene));
}

Polylines true_contours(const ParametricSurface& surface, const View& view, int columns, int rows) {
  std::vector<double> g(static_cast<std::size_t>((columns + 1) * (rows + 1)));
  const auto place = [&](int i, int k) { return Point2{double(i) / columns, double(k) / rows}; };
  const auto value = [&](int i, int k) -> double& { return g[static_cast<std::size_t>(i * (rows + 1) + k)]; };
  for (int i = 0; i <= columns; ++i)
    for (int k = 0; k <= rows; ++k) {
      const Point2 p = place(i, k);
      value(i, k) = glm::dot(glm::normalize(surface.normal(p.x, p.y)), view.camera.forward);
    }
  Polylines lines;
  const auto add_triangle = [&](std::array<std::array<int, 2>, 3> t) {
    std::vector<Point2> ends;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto &a = t[c], &b = t[(c + 1) % 3];
      const double ga = value(a[0], a[1]), gb = value(b[0], b[1]);
      if ((ga >= 0) == (gb >= 0)) continue;
      const Point2 p = place(a[0], a[1]) + ga / (ga - gb) * (place(b[0], b[1]) - place(a[0], a[1]));
      ends.push_back(page_point(view, surface.at(p.x, p.y)));
    }
    if (ends.size() == 2) lines.add(ends);
  };
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k) {
      add_triangle({{{i, k}, {i + 1, k}, {i + 1, k + 1}}});
      add_triangle({{{i, k}, {i + 1, k + 1}, {i, k + 1}}});
    }
  return lines;
}

DrawnOutlines draw_outlines(const Scene& scene, const Point3& direction, bool smooth, bool by_angle) {
  const View view = view_along(scene, direction);
  const Topology topology = build_topology(scene);
  ProjectedScene projected = project(scene, topology, view, {classes("outline")});
  SmoothContours contours;
  const std::vector<std::uint8_t> no_creases(topology.edges.size(), 0);
  if (smooth) contours = replace_outlines(scene, topology, projected, {{30, by_angle ? nullptr : &no_creases}});
  VisibilityResult result = find_method("auto")->compute_visibility(projected, {});
  draw_contours(*result.strokes, scene, view, contours, false, {});
  remove_coincident_strokes(*result.strokes, coincidence_mm(projected));
  DrawnOutlines drawn{view, {}};
  for (const Layer& layer : make_drawing(*result.strokes).layers) append(drawn.lines, layer.lines);
  return drawn;
}

Scene convex_hull(const std::vector<Point3>& points) {
  std::vector<Face> faces{{0, 1, 2}, {0, 2, 1}};
  for (std::uint32_t i = 3; i < points.size(); ++i) {
    // The faces that see the point give way to a cone over their rim, whose sides occur in one direction only.
    std::set<std::pair<std::uint32_t, std::uint32_t>> rim;
    std::vector<Face> kept;
    for (const Face& f : faces) {
      if (height_over(points, f, points[i]) <= 0) {
        kept.push_back(f);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = f[k], b = f[(k + 1) % 3];
        if (rim.erase({b, a}) == 0) rim.insert({a, b});
      }
    }
    for (const auto& [a, b] : rim) kept.push_back({a, b, i});
    faces = std::move(kept);
  }
  Scene scene;
  std::vector<std::uint32_t> number(points.size(), kNone);
  for (const Face& f : faces) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : f) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(scene.vertices.size());
        scene.vertices.push_back(points[v]);
      }
      corners.push_back(number[v]);
    }
    scene.faces.add_face(corners);
  }
  return as_one_object(std::move(scene));
}

Scene rounded_hull(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
  const Point3 half{5 + 25 * unit(), 5 + 25 * unit(), 5 + 25 * unit()};
  const double radius = 4 + 11 * unit();
  std::vector<Point3> points;
  while (points.size() < std::size_t(count)) {
    const double x = 2 * unit() - 1, y = 2 * unit() - 1, z = 2 * unit() - 1;
    const Point3 d{x, y, z};
    if (glm::dot(d, d) > 1 || glm::dot(d, d) < 0.01) continue;
    Point3 p = radius * glm::normalize(d);
    for (int axis = 0; axis < 3; ++axis) p[axis] += d[axis] > 0 ? half[axis] : -half[axis];
    p.x *= 1 - 0.2 * (p.z / half.z + 1);
    points.push_back(p);
  }
  return convex_hull(points);
}

}  // namespace ligne::test
