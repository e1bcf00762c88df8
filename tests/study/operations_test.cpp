// The elementary operations of [Boulle1980] 3 against exact arithmetic.

#include "geometry/clip_support.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "studies/operations/contour_clipping.hpp"
#include "studies/operations/point_in_contour.hpp"
#include "studies/operations/segment_clipping.hpp"
#include "studies/operations/segment_sweep.hpp"
#include "studies/operations/segment_tests.hpp"
#include "studies/operations/sorts.hpp"
#include "studies/operations/thesis_spans.hpp"

namespace ligne::studies {
namespace {

int sign(double v) { return (v > 0) - (v < 0); }

/// Small coordinates, so that everything singular happens often, or those of the whole lattice.
LatticePoint random_point(std::mt19937& random, int limit) {
  std::uniform_int_distribution<int> u(-limit, limit);
  return {u(random), u(random)};
}

template <class N>
PlanePoint<N> as(LatticePoint p) {
  return {static_cast<N>(p.x), static_cast<N>(p.y)};
}

TEST(Operations, FourSegmentTestsAreExact) {
  std::mt19937 random(1);
  for (int i = 0; i < 40000; ++i) {
    const int limit = i % 2 == 0 ? 4 : kLatticeLimit;
    const LatticePoint a = random_point(random, limit), b = random_point(random, limit), c = random_point(random, limit),
                       d = random_point(random, limit);
    if (a == b || c == d) continue;
    const int ab = sign(orientation(a, b, c)) * sign(orientation(a, b, d)),
              cd = sign(orientation(c, d, a)) * sign(orientation(c, d, b));
    const bool cross = ab < 0 && cd < 0;
    const bool parallel = ligne::cross(LatticeSegment{a, b}, LatticeSegment{c, d}) == 0;
    const auto ask = [&](auto test) { return test(as<Int128>(a), as<Int128>(b), as<Int128>(c), as<Int128>(d)); };
    EXPECT_EQ(ask(cross_analytic<Int128>), cross);
    EXPECT_EQ(ask(cross_vector<Int128>), cross);
    EXPECT_EQ(ask(cross_parametric<Int128>), cross);
    EXPECT_EQ(ask(meet_min_max<Int128>), !parallel && ab <= 0 && cd <= 0);
    EXPECT_EQ(cross_vector(as<double>(a), as<double>(b), as<double>(c), as<double>(d)), cross);
    EXPECT_EQ(cross_parametric(as<double>(a), as<double>(b), as<double>(c), as<double>(d)), cross);
    // Exchanged segments and ends.
    EXPECT_EQ(cross_parametric(as<Int128>(d), as<Int128>(c), as<Int128>(a), as<Int128>(b)), cross);
    EXPECT_EQ(meet_min_max(as<Int128>(d), as<Int128>(c), as<Int128>(b), as<Int128>(a)), ask(meet_min_max<Int128>));
  }
}

TEST(Operations, SweepFindsWhatAllPairsFind) {
  std::mt19937 random(2);
  for (int round = 0; round < 400; ++round) {
    // From a handful of points, where all is singular, to general position.
    const int limit = round % 4 == 0 ? 3 : round % 4 == 1 ? 10 : round % 4 == 2 ? 100 : kSweepLimit;
    std::vector<LatticeSegment> segments;
    while (segments.size() < 2u + static_cast<std::size_t>(round % 30)) {
      const LatticeSegment s{random_point(random, limit), random_point(random, limit)};
      if (!(s.a == s.b)) segments.push_back(s);
    }
    SweepWork sweep, pairs;
    const auto found = meetings_by_sweep(segments, sweep), wanted = meetings_by_pairs(segments, pairs);
    ASSERT_EQ(found.size(), wanted.size()) << "round " << round;
    EXPECT_TRUE(std::equal(found.begin(), found.end(), wanted.begin())) << "round " << round;
  }
}

/// A convex contour of points on a circle, positively turned; empty where rounding leaves no area.
std::vector<LatticePoint> convex_contour(std::mt19937& random, int n, double radius) {
  std::uniform_real_distribution<double> u(0, 2 * 3.14159265358979);
  std::vector<LatticePoint> points;
  for (int i = 0; i < n; ++i) {
    const double a = u(random);
    points.push_back({static_cast<std::int32_t>(std::lround(radius * std::cos(a))),
                      static_cast<std::int32_t>(std::lround(radius * std::sin(a)))});
  }
  return test::hull(points, false);
}

/// Inside, outside or on the contour, by winding numbers of exact signs.
int place_by_winding(const std::vector<LatticePoint>& contour, LatticePoint p) {
  return position_in_face(make_contour_face(std::span(&contour, 1)), fine(p));
}

int as_sign(Place place) { return place == Place::inside ? 1 : place == Place::outside ? -1 : 0; }

TEST(Operations, PointsInConvexContours) {
  std::mt19937 random(3);
  std::uint64_t spared = 0;
  for (int round = 0; round < 300; ++round) {
    const int limit = round % 2 == 0 ? 6 : 1000;
    const auto contour = convex_contour(random, 3 + round % 12, limit);
    if (contour.empty()) continue;
    const Sectors sectors(contour);
    for (int i = 0; i < 60; ++i) {
      const LatticePoint p = i < 3 ? contour[static_cast<std::size_t>(i)] : random_point(random, limit + 1);
      const int truth = place_by_winding(contour, p);
      ContourCounts counts;
      EXPECT_EQ(as_sign(by_crossings(contour, p, counts)), truth);
      EXPECT_EQ(as_sign(by_half_planes(contour, p, counts)), truth);
      EXPECT_EQ(as_sign(by_triangles(contour, p, counts)), truth);
      EXPECT_EQ(as_sign(sectors.by_signs(p, counts)), truth);
      EXPECT_EQ(as_sign(by_codes(contour, p, true, counts)), truth);
      ContourCounts early, all;
      EXPECT_EQ(as_sign(by_crossings(contour, p, early, ContourKind::convex)), truth);
      by_crossings(contour, p, all);
      EXPECT_LE(early.sides, all.sides);
      spared += all.sides - early.sides;
      EXPECT_EQ(as_sign(by_unoriented_half_planes(contour, p, counts)), truth);
      std::vector<LatticePoint> turned(contour.rbegin(), contour.rend());
      EXPECT_EQ(as_sign(by_unoriented_half_planes(turned, p, counts)), truth);
      if (truth != 0) {
        EXPECT_EQ(as_sign(by_angles(contour, p, counts, ContourKind::convex)), truth);
        EXPECT_EQ(as_sign(by_angles(contour, p, counts)), truth);
      }
    }
  }
  EXPECT_GT(spared, 1000u);
}

TEST(Operations, PointsInAnyContours) {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    // A star: simple, not convex.
    const int limit = 200;
    std::uniform_real_distribution<double> part(0.2, 1);
    std::vector<LatticePoint> contour;
    const int n = 5 + round % 9;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * 3.14159265358979 * i / n, r = limit * part(random);
      contour.push_back({static_cast<std::int32_t>(std::lround(r * std::cos(a))),
                         static_cast<std::int32_t>(std::lround(r * std::sin(a)))});
    }
    for (int i = 0; i < 60; ++i) {
      const LatticePoint p = i < 3 ? contour[static_cast<std::size_t>(i)] : random_point(random, limit);
      const int truth = place_by_winding(contour, p);
      ContourCounts counts;
      EXPECT_EQ(as_sign(by_crossings(contour, p, counts)), truth);
      EXPECT_EQ(as_sign(by_codes(contour, p, true, counts)), truth);
      if (truth != 0) {
        EXPECT_EQ(as_sign(by_angles(contour, p, counts)), truth);
      }
    }
  }
}

// A side from one domain to the opposite one, on the far side of the point: as printed the codes turn it round.
TEST(Operations, CodesAsPrintedErr) {
  const std::vector<LatticePoint> contour{{-10, -20}, {20, 10}, {-20, 30}};
  const LatticePoint p{0, 0};
  ContourCounts counts;
  EXPECT_EQ(by_crossings(contour, p, counts), Place::inside);
  EXPECT_EQ(by_codes(contour, p, true, counts), Place::inside);
  EXPECT_EQ(by_codes({{LatticePoint{-10, -20}, LatticePoint{20, 30}, LatticePoint{-20, 30}}}, p, true, counts),
            by_crossings({{LatticePoint{-10, -20}, LatticePoint{20, 30}, LatticePoint{-20, 30}}}, p, counts));
}

// By codes of n bits: what the parameters of the entry and of the exit say (Cyrus and Beck).
TEST(Operations, SegmentsClippedByConvexContours) {
  std::mt19937 random(6);
  std::size_t parts = 0;
  for (int round = 0; round < 200; ++round) {
    const auto corners = convex_contour(random, 3 + round % 40, 1000);
    if (corners.empty()) continue;
    ClipContour contour;
    for (const LatticePoint c : corners) contour.corners.emplace_back(c.x, c.y);
    for (int i = 0; i < 60; ++i) {
      const LatticePoint a = random_point(random, 1500), b = random_point(random, 1500);
      const Point2 p(a.x, a.y), q(b.x, b.y);
      double enters = 0, leaves = 1;
      for (std::size_t side = 0; side < corners.size(); ++side) {
        const double at_p = contour.height(side, p), at_q = contour.height(side, q);
        if (at_p < 0 && at_q < 0) enters = 2;
        if (at_p < 0 && at_q >= 0) enters = std::max(enters, at_p / (at_p - at_q));
        if (at_p >= 0 && at_q < 0) leaves = std::min(leaves, at_p / (at_p - at_q));
      }
      ClipCounts counts;
      const ClippedSegment part = clip_by_codes(p, q, contour, counts);
      EXPECT_LE(counts.crossings, corners.size());
      if (std::abs(leaves - enters) < 1e-9) continue;
      ASSERT_EQ(part.has_value(), enters < leaves);
      if (!part) continue;
      ++parts;
      for (const Point2 d : {part->first - (p + (q - p) * enters), part->second - (p + (q - p) * leaves)})
        EXPECT_LT(std::abs(d.x) + std::abs(d.y), 1e-6);
    }
  }
  EXPECT_GT(parts, 1000u);
}

TEST(Operations, ClippedSegments) {
  std::mt19937 random(5);
  const ClipRectangle r{-50, 50, -30, 30};
  const LatticePoint corners[] = {{-50, -30}, {50, -30}, {50, 30}, {-50, 30}};
  const std::vector<LatticePoint> rectangle(std::begin(corners), std::end(corners));
  for (int i = 0; i < 20000; ++i) {
    const LatticePoint a = random_point(random, 120), b = random_point(random, 120);
    if (a == b) continue;
    const Point2 p(a.x, a.y), q(b.x, b.y);
    ClipCounts codes, halving;
    const ClippedSegment by_code = clip_by_codes(p, q, r, codes), by_half = clip_by_halving(p, q, r, halving);
    // Exactly: it meets the rectangle when a corner is on the other side of it than another, or on it, and the boxes meet.
    int least = 1, most = -1;
    for (const LatticePoint c : corners) {
      least = std::min(least, sign(orientation(a, b, c)));
      most = std::max(most, sign(orientation(a, b, c)));
    }
    const bool boxes =
        std::min(a.x, b.x) <= 50 && std::max(a.x, b.x) >= -50 && std::min(a.y, b.y) <= 30 && std::max(a.y, b.y) >= -30;
    if (least < 0 && most > 0 && boxes) {
      EXPECT_TRUE(by_code.has_value());
    }
    if (!boxes || least > 0 || most < 0) {
      EXPECT_FALSE(by_code && (r.code(by_code->first) | r.code(by_code->second)) != 0);
    }
    EXPECT_LE(codes.crossings, 4u);
    if (!by_half) continue;
    // In the rectangle, and within two steps of the segment.
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    for (const Point2 end : {by_half->first, by_half->second}) {
      EXPECT_EQ(r.code(end), 0u);
      EXPECT_LE(std::abs((q.x - p.x) * (end.y - p.y) - (q.y - p.y) * (end.x - p.x)), 2 * std::sqrt(2) * length);
    }
  }
}

Contour as_points(const std::vector<LatticePoint>& contour) {
  Contour out;
  for (const LatticePoint p : contour) out.emplace_back(p.x, p.y);
  return out;
}

/// Two contours, one moved by as much as its radius, and twice the area that they have in common by the exact clip; none
/// where rounding has left one of them without area.
struct ContourPair {
  Contour subject, clip;
  double common;
};
std::optional<ContourPair> random_pair(std::mt19937& random, int corners, int clip_corners, int radius) {
  auto subject = convex_contour(random, corners, radius), clip = convex_contour(random, clip_corners, radius);
  const LatticePoint shift = random_point(random, radius);
  for (LatticePoint& p : clip) p = {p.x + shift.x, p.y + shift.y};
  if (subject.empty() || clip.empty()) return {};
  const Contour s = as_points(subject), c = as_points(clip);
  const auto faces =
      clip_contour_by_contour(make_contour_face(std::span(&subject, 1)), make_contour_face(std::span(&clip, 1)));
  return ContourPair{s, c, twice_area(faces.inside)};
}

/// Large contours; and small ones, whose corners lie on sides, on corners, and in line with each other, and the inner point
/// on sides. The exact clip gives its corners rounded to the fine lattice: half a part in x and y each, along all sides.
TEST(Operations, ClippedContoursHaveTheExactArea) {
  std::mt19937 random(16);
  int common = 0;
  for (int round = 0; round < 20000; ++round) {
    const bool is_large = round < 300;
    const int radius = is_large ? 1 << 20 : 2 + round % 9;
    const auto pair = random_pair(random, 3 + round % (is_large ? 20 : 11), 3 + round % 7, radius);
    if (!pair) continue;
    const auto& [s, c, truth] = *pair;
    const double tolerance = std::ldexp((is_large ? 25.6 : 16.0) * radius, -kFineBits);
    common += truth > 0;
    ContourClipCounts counts, sides;
    EXPECT_NEAR(twice_area_of(clip_convex(s, c, counts)), truth, tolerance) << round;
    EXPECT_NEAR(twice_area_of(clip_convex(c, s, counts)), truth, tolerance) << round;
    EXPECT_LE(counts.signs, 2 * (6 * (s.size() + c.size()) + 40)) << round;
    if (!is_large) continue;
    EXPECT_NEAR(twice_area_of(clip_side_by_side(s, c, sides)), truth, tolerance) << round;
  }
  EXPECT_GT(common, 1000);
}

TEST(Operations, SortsSort) {
  std::mt19937 random(7);
  for (int n = 0; n < 200; ++n) {
    std::vector<int> list;
    for (int i = 0; i < n; ++i) list.push_back(static_cast<int>(random() % 50));
    std::vector<int> wanted = list;
    std::sort(wanted.begin(), wanted.end());
    for (const auto sort : {quick_sort<int>, bubble_sort<int>, tree_sort<int>, shell_sort<int>}) {
      std::vector<int> sorted = list;
      SortCounts counts;
      sort(sorted, counts);
      EXPECT_EQ(sorted, wanted) << n;
    }
  }
}

// Merge and box as the thesis has them find what a plain search finds; on segments that do not touch.
TEST(Operations, SpansAsInTheThesis) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> x(0, 1000), z(0, 100);
  for (int round = 0; round < 100; ++round) {
    std::vector<watkins::ScanSegment<double>> segments;
    for (std::uint32_t i = 0; i < 2u + static_cast<unsigned>(round % 10); ++i) {
      double a = std::floor(x(random)), b = std::floor(x(random));
      if (a > b) std::swap(a, b);
      if (a < b) segments.push_back({a, b, z(random), z(random), i});
    }
    std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) { return watkins::comes_before(a, b); });
    if (segments.empty()) continue;
    std::vector<watkins::VisibleSpan> truth;
    watkins::make_span_method<double>(watkins::SpanMethodKind::merge)->study(segments, truth);
    ThesisSpans spans(segments);
    EXPECT_NEAR(difference_of(spans.merge().spans, truth), 0, 1e-9 * 1000) << round;
    // Box shows one segment on the last column of a division: a column for each part.
    const SpanRun box = spans.box(true);
    EXPECT_LE(difference_of(box.spans, truth), static_cast<double>(box.boxes)) << round;
  }
}

}  // namespace
}  // namespace ligne::studies
