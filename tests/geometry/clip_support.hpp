#pragma once
/// Common parts of the tests of the clip: faces at random, and checks that every result must pass.

#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "main/script.hpp"
#include "support/line_text.hpp"
#include "support/test.hpp"

namespace ligne::test {

using Faces = std::vector<ContourFace>;

/// Length of all contours in steps: what the rounding of corners to the fine lattice can change an area by follows from it.
inline double contour_length(const Faces& faces) {
  double length = 0;
  for (const ContourFace& face : faces)
    for (const EdgeLoop& loop : face.contours)
      for (const ContourEdge& e : loop) length += std::hypot(e.dx(), e.dy());
  return length;
}

/// A corner moves by half a part in x and in y; twice the area of a triangle over an edge changes by at most the edge's
/// length times twice that, and the last rounding of a sum is relative.
inline double area_tolerance(const Faces& faces) {
  return std::ldexp(2 * contour_length(faces), -kFineBits) + std::abs(twice_area(faces)) * 0x1p-50;
}

inline bool inside(const Faces& faces, FinePoint p) {
  return std::any_of(faces.begin(), faces.end(), [&](const ContourFace& f) { return position_in_face(f, p) > 0; });
}
inline bool on_contour(const Faces& faces, FinePoint p) {
  return std::any_of(faces.begin(), faces.end(), [&](const ContourFace& f) { return position_in_face(f, p) == 0; });
}

/// Closed contours, corners once in each, outer ones positive and holes negative, areas by face not negative.
inline void expect_well_formed(const Faces& faces) {
  for (const ContourFace& face : faces) {
    ASSERT_FALSE(face.contours.empty());
    EXPECT_GT(twice_area(face), 0);
    for (const EdgeLoop& loop : face.contours) {
      ASSERT_GE(loop.size(), 2u);
      EXPECT_EQ(twice_area(loop) > 0, &loop == &face.contours.front());
      std::vector<FinePoint> corners;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        EXPECT_EQ(loop[i].end(), loop[(i + 1) % loop.size()].begin());
        EXPECT_LT(compare(loop[i].from, loop[i].to), 0);
        corners.push_back(loop[i].begin());
      }
      std::sort(corners.begin(), corners.end());
      EXPECT_EQ(std::adjacent_find(corners.begin(), corners.end()), corners.end());
    }
  }
}

/// The convex hull of points; points on its sides are kept as corners if `straight`. Empty without area.
inline std::vector<LatticePoint> hull(std::vector<LatticePoint> points, bool straight) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<LatticePoint> chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = chain.size();
    for (const LatticePoint p : points) {
      const auto turns = [&] { return orientation(chain[chain.size() - 2], chain.back(), p); };
      while (chain.size() >= base + 2 && (straight ? turns() < 0 : turns() <= 0)) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  double area = 0;
  for (std::size_t i = 2; i < chain.size(); ++i) area += orientation(chain[0], chain[i - 1], chain[i]);
  return area > 0 ? chain : std::vector<LatticePoint>{};
}

/// Faces of contours as text, with "/" between them.
inline std::vector<ContourFace> faces_of_text(const std::string& text) {
  std::vector<ContourFace> faces;
  for (const std::string& part : parts_of(text, '/')) {
    std::vector<std::vector<LatticePoint>> contours;
    for (const std::vector<Point2>& contour : contours_of_text(part)) {
      contours.emplace_back();
      for (const Point2 p : contour) contours.back().push_back({static_cast<int>(p.x), static_cast<int>(p.y)});
    }
    faces.push_back(make_contour_face(contours));
  }
  return faces;
}

/// A face of a random star about the centre, with up to two holes that touch nothing or a corner of the outer contour.
inline ContourFace random_star(std::mt19937& random, LatticePoint centre, double radius, bool with_holes) {
  std::uniform_int_distribution<int> count(3, 12);
  std::uniform_real_distribution<double> part(0.3, 1);
  const auto star = [&](LatticePoint c, double r, int n) {
    std::vector<LatticePoint> points;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * 3.14159265358979 * i / n, d = r * part(random);
      points.push_back({c.x + static_cast<std::int32_t>(std::lround(d * std::cos(angle))),
                        c.y + static_cast<std::int32_t>(std::lround(d * std::sin(angle)))});
    }
    return points;
  };
  std::vector<std::vector<LatticePoint>> contours{star(centre, radius, count(random))};
  // Within the circle of the innermost corner of a star of that many corners, half of it for safety.
  if (with_holes && contours[0].size() > 4) contours.push_back(star(centre, 0.3 * 0.3 * radius, count(random)));
  return make_contour_face(contours);
}

}  // namespace ligne::test
