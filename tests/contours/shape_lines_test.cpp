// Suggestive contours, ridges and valleys against surfaces for which formulas say where they are.

#include "contours/shapes/shape_lines.hpp"
#include "contours/parametric_mesh.hpp"
#include "main/script.hpp"
#include "main/tier.hpp"
#include "scene/model/topology.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

LineClasses shape_classes() {
  LineClasses all;
  for (const LineClass c : kShapeClasses) all.add(c);
  return all;
}

struct Found {
  View view;
  std::vector<ShapeLine> lines;

  std::size_t count(LineClass c) const {
    return static_cast<std::size_t>(std::ranges::count(lines, c, &ShapeLine::line_class));
  }
};

Found find_lines(const Scene& scene, const Point3& direction) {
  const View view = view_along(scene, direction);
  return {view, find_shape_lines(scene, build_topology(scene), view, shape_classes(), {})};
}

/// An octahedron whose sides are cut into n, blown up to an ellipsoid. The places of its vertices are uneven by 0.3
/// cells.
Scene ellipsoid(const Point3& axes, int n) {
  std::mt19937 random(7);
  const auto uneven = [&] { return 0.3 * (2 * double(random()) / double(std::mt19937::max()) - 1) / n; };
  Scene scene;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](int x, int y, int z) {
    const auto [found, added] = numbers.try_emplace({x, y, z}, static_cast<std::uint32_t>(scene.vertices.size()));
    if (added) scene.vertices.push_back(axes * glm::normalize(Point3{x + n * uneven(), y + n * uneven(), z + n * uneven()}));
    return found->second;
  };
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      for (const int sz : {1, -1}) {
        const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
          if (sx * sy * sz < 0) std::swap(b, c);
          const auto at = [&](const std::array<int, 2>& p) { return vertex(sx * p[0], sy * p[1], sz * (n - p[0] - p[1])); };
          const std::uint32_t first = at(a), second = at(b), third = at(c);
          scene.faces.add_triangle(first, second, third);
        };
        for (int i = 0; i < n; ++i)
          for (int k = 0; i + k < n; ++k) {
            add({i, k}, {i + 1, k}, {i, k + 1});
            if (i + k + 2 <= n) add({i + 1, k}, {i + 1, k + 1}, {i, k + 1});
          }
      }
    }
  }
  return as_one_object(std::move(scene));
}

/// A tube about z, open or with flat ends, its vertices up to a third of a cell beside their places.
Scene cylinder(int sides, int rings, bool closed) {
  const std::string n = std::to_string(sides), m = std::to_string(rings),
                    angle = "(2*pi/" + n + "*(u+0.3*sin(97*u*u+71*v)))";
  return mesh_of("grid " + n + " x " + m + (closed ? " capped" : "") + " triangles round: 10*cos" + angle + "; 10*sin" +
                 angle + "; 40/" + m + "*(v+if(v*(" + m + "-v)>0,0.3*sin(53*u+37*v*v),0))\nexact")
      .scene();
}

const std::array<Point3, 3> kDirections{{{-1, 1, -1}, {-0.3, 1, -0.8}, {0.9, 0.5, -0.65}}};

TEST(ShapeLines, SpheresCylindersAndBoxesHaveNone) {
  for (const Point3& direction : kDirections) {
    for (const int n : {12, 40, 90}) EXPECT_TRUE(find_lines(ellipsoid({50, 50, 50}, n), direction).lines.empty()) << n;
    for (const bool closed : {false, true}) {
      EXPECT_TRUE(find_lines(cylinder(24, 1, closed), direction).lines.empty());
      EXPECT_TRUE(find_lines(cylinder(72, 60, closed), direction).lines.empty());
    }
    EXPECT_TRUE(find_lines(cylinder(4, 1, true), direction).lines.empty()) << "a prism";
  }
}

/// The largest distance of the points from a plane through the middle.
double farthest_from_plane(const ShapeLine& line, const Point3& normal) {
  double most = 0;
  for (const Point3& p : line.points) most = std::max(most, std::abs(glm::dot(p, normal)));
  return most;
}

double length_in_space(const ShapeLine& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) sum += glm::length(line.points[i + 1] - line.points[i]);
  return sum;
}

TEST(ShapeLines, TheRidgeOfAnEllipsoidIsItsLargestEllipse) {
  for (const int n : {30, 60, 120}) {
    for (const Point3& direction : chosen("ridges", 2, kDirections)) {
      const Found found = find_lines(ellipsoid({90, 60, 30}, n), direction);
      EXPECT_EQ(found.count(LineClass::valley), 0u);
      EXPECT_EQ(found.count(LineClass::suggestive), 0u) << "it is convex";
      ASSERT_EQ(found.count(LineClass::ridge), 1u) << n;
      const ShapeLine& ridge = found.lines.front();
      EXPECT_TRUE(ridge.closed);
      EXPECT_LT(farthest_from_plane(ridge, {0, 0, 1}), 90.0 / n);
      const double ellipse = kPi * (3 * (90 + 60) - std::sqrt((3 * 90 + 60.0) * (90 + 3 * 60.0)));  // Ramanujan
      EXPECT_NEAR(length_in_space(ridge), ellipse, 0.05 * ellipse);
    }
  }
}

/// Radial curvature of the torus of radii R and r about z at one of its points, times r; `eye` points to the eye.
double radial_of_torus(const Point3& p, double R, double r, const Point3& eye) {
  const double around = std::hypot(p.x, p.y);
  const Point3 middle = Point3{p.x, p.y, 0} * (R / around), normal = glm::normalize(p - middle);
  const Point3 along{-p.y / around, p.x / around, 0}, across = glm::cross(normal, along);
  const double u = glm::dot(eye, along), v = glm::dot(eye, across);
  const double cosine = glm::dot(normal, glm::normalize(Point3{p.x, p.y, 0}));
  return (v * v + r * cosine / (R + r * cosine) * u * u) / (u * u + v * v);
}

TEST(ShapeLines, SuggestiveContoursOfATorusAreWhereItsRadialCurvatureIsZero) {
  const ParametricSurface torus = test_surfaces()[0];
  for (const Point3& direction : kDirections) {
    for (const int size : {1, 2, 4}) {
      const Scene scene = uneven_mesh(torus, 60 * size, 30 * size, 0.3, static_cast<std::uint32_t>(size));
      const Found found = find_lines(scene, direction);
      ASSERT_GT(found.count(LineClass::suggestive), 0u) << size;
      double worst = 0;
      for (const ShapeLine& line : found.lines) {
        if (line.line_class != LineClass::suggestive) continue;
        for (const Point3& p : line.points) {
          worst = std::max(worst, std::abs(radial_of_torus(p, 65, 30, -glm::normalize(direction))));
          EXPECT_LT(std::hypot(p.x, p.y), 65 + 2) << "on the inner half, where the surface is a saddle";
        }
      }
      EXPECT_LT(worst, 0.15) << size;
    }
  }
}

TEST(ShapeLines, ABumpHasASuggestiveContourAndAWaveRidgesAndValleys) {
  const Scene bump = mesh_of("grid 80 x 80 triangles: u/40-1; v/40-1; 0.3*exp(-12*((u/40-1)^2+(v/40-1)^2))").scene();
  const Found seen = find_lines(bump, {0, 1, -0.9});
  EXPECT_GE(seen.count(LineClass::suggestive), 1u) << "behind its top, where it would become an outline";
  const Scene waves = mesh_of("grid 80 x 80 triangles: u/40-1; v/40-1; 0.15*cos(pi*u/20)").scene();
  for (const Point3& direction : kDirections) {
    const Found found = find_lines(waves, direction);
    for (const ShapeLine& line : found.lines) {
      if (line.line_class == LineClass::suggestive) continue;
      const double x = line.points[line.points.size() / 2].x;
      const double top = line.line_class == LineClass::ridge ? std::round(x) : std::floor(x) + 0.5;
      EXPECT_LT(std::abs(x - top), 0.02);
      EXPECT_GT(length_in_space(line), 1.8);
    }
    EXPECT_GE(found.count(LineClass::ridge), 1u);
    EXPECT_EQ(found.count(LineClass::valley), 2u);
  }
  // From below, tops are valleys.
  EXPECT_GE(find_lines(waves, {-1, 1, 1}).count(LineClass::valley), 1u);
  EXPECT_EQ(find_lines(waves, {-1, 1, 1}).count(LineClass::ridge), 2u);
}

TEST(ShapeLines, TurningFacesOfABodyInsideOutChangesNothing) {
  const Scene scene = ellipsoid({90, 60, 30}, 40);
  Scene turned = scene;
  turned.faces = {};
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const auto c = scene.faces.contour(f, 0);
    turned.faces.add_triangle(c[0], c[2], c[1]);
  }
  const Found a = find_lines(scene, kDirections[0]), b = find_lines(turned, kDirections[0]);
  ASSERT_EQ(a.lines.size(), b.lines.size());
  EXPECT_EQ(a.count(LineClass::ridge), b.count(LineClass::ridge));
}

}  // namespace
}  // namespace ligne::test
