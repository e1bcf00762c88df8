// Lines beside curves, point by point against rays to the viewer: contours, lines on the base, lines behind the surface.

#include "height_functions.hpp"

namespace ligne::test {
namespace {

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
