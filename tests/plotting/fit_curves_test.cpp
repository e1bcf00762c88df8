/// Lines that become arcs and lines that do not, and how far curves are from points.

#include "plotting/paths/fit_curves.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

constexpr double kTenthMicrometre = 1e-4;

std::vector<Point2> in_tenths(std::vector<Point2> points) {
  for (Point2& p : points)
    p = {std::round(p.x / kTenthMicrometre) * kTenthMicrometre, std::round(p.y / kTenthMicrometre) * kTenthMicrometre};
  return points;
}

std::size_t arcs_of(const CurvedPath& path) {
  std::size_t count = 0;
  for (const PathPiece& piece : path.pieces) count += piece.arc.has_value();
  return count;
}

/// The path as points so near to each other that chords are as good as the curve.
std::vector<Point2> sampled(const CurvedPath& path) {
  std::vector<Point2> points{path.start};
  constexpr int kSamples = 2000;
  for (const PathPiece& piece : path.pieces) {
    if (piece.arc)
      for (int i = 1; i < kSamples; ++i)
        points.push_back(point_at(piece.arc->ellipse, piece.arc->from + piece.arc->sweep * i / kSamples));
    points.push_back(piece.to);
  }
  return points;
}

/// The largest distance of a point of the line from the path.
double off(std::span<const Point2> line, const CurvedPath& path) {
  const Polylines curve = polylines_of({sampled(path)});
  double largest = 0;
  for (const Point2 p : line) largest = std::max(largest, test::distance_to_lines(p, curve));
  return largest;
}

/// The path of a line. It begins and ends at points of the line, pieces follow each other, and arcs end within the tolerance
/// of where they say.
CurvedPath fitted(std::span<const Point2> line, const CurveLimits& limits = {}) {
  const CurvedPath path = fit_curves(line, limits);
  const auto of_line = [&](Point2 p) { return std::find(line.begin(), line.end(), p) != line.end(); };
  EXPECT_TRUE(of_line(path.start));
  Point2 at = path.start;
  for (const PathPiece& piece : path.pieces) {
    EXPECT_TRUE(of_line(piece.to));
    if (piece.arc) {
      const EllipticArc& arc = *piece.arc;
      EXPECT_LT(glm::length(point_at(arc.ellipse, arc.from) - at), kCurveToleranceMm + 1e-9);
      EXPECT_LT(glm::length(point_at(arc.ellipse, arc.from + arc.sweep) - piece.to), kCurveToleranceMm + 1e-9);
      EXPECT_LT(std::abs(arc.sweep), 2 * kPi + 0.01);
    }
    at = piece.to;
  }
  if (path.closed) {
    EXPECT_EQ(at, path.start);
  } else {
    EXPECT_EQ(path.start, line.front());
    EXPECT_EQ(at, line.back());
  }
  EXPECT_LE(off(line, path), kCurveToleranceMm + 1e-9);
  return path;
}

TEST(FitCurves, CirclesOfManySizes) {
  for (const int steps : {12, 16, 24, 31, 48, 64, 100, 200}) {
    for (const double radius : {0.4, 2.0, 5.0, 37.5}) {
      if (radius * (1 - std::cos(kPi / steps)) > CurveLimits{}.most_rise_mm) continue;
      const std::vector<Point2> line = in_tenths(closed({{100.3, 50.7}, {radius, radius}}, steps));
      const CurvedPath path = fitted(line);
      EXPECT_EQ(path.pieces.size(), arcs_of(path)) << steps << " corners, radius " << radius;
      EXPECT_LE(path.pieces.size(), 1u) << steps << " corners, radius " << radius;
    }
  }
}

TEST(FitCurves, AnArcThatRisesTooMuchStaysAPolygon) {
  const Ellipse large{{100, 100}, {80, 80}};
  EXPECT_EQ(arcs_of(fit_curves(closed(large, 12), {})), 0u);
  EXPECT_EQ(arcs_of(fit_curves(closed(large, 96), {})), 1u);
  EXPECT_EQ(arcs_of(fit_curves(closed(large, 96), {kCurveToleranceMm, 0.02})), 0u);
}

/// Limits of curves with ellipses that are known.
struct Known {
  KnownEllipses ellipses;
  CurveLimits limits;
  explicit Known(std::vector<Ellipse> list) : ellipses(std::move(list), Rect{{0, 0}, {210, 297}}) {
    limits.known = &ellipses;
  }
  Known(const Known&) = delete;
};

/// So many corners of an ellipse, from one eccentric angle over equal steps.
std::vector<Point2> corners_on(const Ellipse& ellipse, double from, double step, int count) {
  std::vector<Point2> line;
  for (int k = 0; k < count; ++k) line.push_back(point_at(ellipse, from + k * step));
  return line;
}

TEST(FitCurves, AFewCornersOfAKnownEllipseAreAnArc) {
  const Ellipse other{{60, 70}, {30, 20}, 0.4}, ellipse{{100, 80}, {12, 5}, 0.3};
  const Known known({other, ellipse});
  for (const double step : {0.1, 0.3, -0.3}) {
    const std::vector<Point2> line = corners_on(ellipse, 0.7, step, 4);
    EXPECT_EQ(arcs_of(fit_curves(line, {})), 0u);
    const CurvedPath path = fitted(line, known.limits);
    ASSERT_EQ(path.pieces.size(), 1u);
    ASSERT_TRUE(path.pieces[0].arc);
    EXPECT_LE(glm::distance(path.pieces[0].arc->ellipse.centre, ellipse.centre), 0.01);
  }
}

TEST(FitCurves, AKnownEllipseBendsNoOtherLines) {
  const Ellipse ellipse{{100, 80}, {12, 5}, 0.3};
  const Known known({ellipse});
  // A chord of it, a polygon of eight corners on it, and corners beside it.
  std::vector<Point2> beside = corners_on(ellipse, 0.7, 0.3, 4);
  for (Point2& p : beside) p = ellipse.centre + 1.005 * (p - ellipse.centre);
  for (const std::vector<Point2>& line : {corners_on(ellipse, 0.7, 0.3, 2), corners_on(ellipse, 0.7, kPi / 4, 9), beside})
    EXPECT_EQ(arcs_of(fit_curves(line, known.limits)), 0u);
}

TEST(FitCurves, AKnownEllipseMakesArcsOfParts) {
  // Lines lead to the arc and on from it.
  const Ellipse circle{{100, 80}, {5, 5}};
  const Known known({circle});
  std::vector<Point2> line = corners_on(circle, 0, kPi / 8, 5);
  line.insert(line.begin(), Point2(105, 60));
  line.emplace_back(80, 85);
  const CurvedPath path = fitted(line, known.limits);
  ASSERT_EQ(path.pieces.size(), 3u);
  EXPECT_TRUE(!path.pieces[0].arc && path.pieces[1].arc && !path.pieces[2].arc);
}

TEST(FitCurves, AStartThatStays) {
  std::vector<Point2> line = in_tenths(closed({{100, 100}, {20, 20}}, 96));
  line.pop_back();
  std::rotate(line.begin(), line.begin() + 17, line.end());
  line.push_back(line.front());
  CurveLimits limits;
  limits.start_stays = true;
  const CurvedPath path = fitted(line, limits);
  EXPECT_EQ(path.start, line.front());
  EXPECT_EQ(path.pieces.back().to, line.back());
  EXPECT_EQ(arcs_of(path), path.pieces.size());
  EXPECT_LE(path.pieces.size(), 2u);
}

TEST(FitCurves, EllipsesAtManyTilts) {
  std::size_t whole = 0, all = 0;
  for (int tilt = 5; tilt <= 85; tilt += 10) {
    for (int turn = -90; turn <= 90; turn += 15) {
      for (const int steps : {16, 36, 72, 180}) {
        const Ellipse ellipse{{90.123, 77.7}, {9, 9 * std::cos(tilt * kDegree)}, turn * kDegree};
        const std::vector<Point2> line = in_tenths(closed(ellipse, steps));
        const CurvedPath path = fitted(line);
        ++all;
        whole += path.pieces.size() <= 4 && arcs_of(path) == path.pieces.size();
      }
    }
  }
  EXPECT_EQ(whole, all);
}

TEST(FitCurves, CirclesInPerspective) {
  for (const double distance : {25.0, 60.0, 300.0}) {
    std::vector<Point2> line;
    for (int i = 0; i <= 48; ++i) {
      const double t = 2 * kPi * (i % 48) / 48, depth = distance + 8 * std::sin(t);
      line.push_back(Point2{100, 100} + Point2{10 * std::cos(t), 5 * std::sin(t)} * (distance / depth));
    }
    const CurvedPath path = fitted(line);
    EXPECT_LE(path.pieces.size(), 4u);
    EXPECT_EQ(arcs_of(path), path.pieces.size()) << distance;
  }
}

TEST(FitCurves, PolygonsAndStarsStay) {
  for (const int corners : {3, 4, 5, 6, 7, 8, 9, 10}) {
    for (const double radius : {0.1, 1.0, 20.0}) {
      const CurvedPath path = fit_curves(closed({{50, 50}, {radius, radius * 0.8}, 0.3}, corners), {});
      EXPECT_EQ(arcs_of(path), 0u) << corners;
      EXPECT_EQ(path.pieces.size(), static_cast<std::size_t>(corners));
    }
  }
  std::vector<Point2> star, zigzag;
  for (int i = 0; i <= 40; ++i) {
    star.push_back(point_at({{50, 50}, Point2{1, 1} * (i % 2 ? 10.0 : 9.5)}, 2 * kPi * (i % 40) / 40));
    zigzag.push_back({i * 0.5, i % 2 * 0.1});
  }
  EXPECT_EQ(arcs_of(fit_curves(star, {})), 0u);
  EXPECT_EQ(fit_curves(star, {}).pieces.size(), 40u);
  EXPECT_EQ(fit_curves(zigzag, {}).pieces.size(), 40u);
  // A rectangle with cut corners has eight corners on an ellipse.
  const std::vector<Point2> cut{{1, 0}, {19, 0}, {20, 1}, {20, 9}, {19, 10}, {1, 10}, {0, 9}, {0, 1}, {1, 0}};
  EXPECT_EQ(arcs_of(fit_curves(cut, {})), 0u);
  std::vector<Point2> straight;
  for (int i = 0; i <= 100; ++i) straight.push_back({i * 1.0, i % 2 * 0.002});
  straight.push_back({100, 30});
  fitted(straight);
  EXPECT_EQ(fit_curves(straight, {}).pieces.size(), 2u);
}

TEST(FitCurves, NoiseBelowAndAboveTheTolerance) {
  std::mt19937 random(1);
  for (const int steps : {24, 36, 60}) {
    for (const double noise : {0.002, 0.03}) {
      std::uniform_real_distribution<double> move(-noise, noise);
      std::vector<Point2> line = closed({{60, 60}, {12, 7}, 0.4}, steps);
      for (std::size_t i = 0; i + 1 < line.size(); ++i) line[i] += Point2{move(random), move(random)};
      line.back() = line.front();
      const CurvedPath path = fitted(line);
      if (noise < kCurveToleranceMm) {
        EXPECT_EQ(arcs_of(path), path.pieces.size()) << steps;
      } else {
        // Six corners in a row may lie on an ellipse by chance.
        EXPECT_GT(path.pieces.size(), static_cast<std::size_t>(steps) / 2) << steps;
      }
    }
  }
}

TEST(FitCurves, ArcsBetweenTangentLines) {
  // A slot: two half circles, two straight sides of many segments.
  for (const int steps : {6, 12, 40}) {
    std::vector<Point2> line;
    for (const Point2 p : tessellated({{30, 10}, {5, 5}}, -kPi / 2, kPi, steps)) line.push_back(p);
    line.push_back({20, 15});
    line.push_back({15, 15});
    for (const Point2 p : tessellated({{10, 10}, {5, 5}}, kPi / 2, kPi, steps)) line.push_back(p);
    line.push_back(line.front());
    const CurvedPath path = fitted(line);
    EXPECT_EQ(arcs_of(path), 2u) << steps;
    EXPECT_EQ(path.pieces.size(), 4u) << steps;
    for (const PathPiece& piece : path.pieces) {
      if (!piece.arc) continue;
      EXPECT_NEAR(piece.arc->ellipse.radii.x, 5, 2 * kTenthMicrometre);
    }
  }
}

TEST(FitCurves, ACutChordAtAnEndBendsNoArc) {
  // The visible part of a circle begins in the middle of a chord.
  std::vector<Point2> line = tessellated({{40, 40}, {10, 10}}, 0, 3, 24);
  line.front() = (line[0] + line[1]) / 2.0;
  const CurvedPath path = fitted(line);
  ASSERT_EQ(path.pieces.size(), 2u);
  EXPECT_FALSE(path.pieces[0].arc);
  EXPECT_NEAR(path.pieces[1].arc.value().ellipse.radii.y, 10, 2 * kTenthMicrometre);
  // And where the line was cut and joined again inside a chord nothing is seen.
  line = tessellated({{40, 40}, {10, 10}}, 0, 3, 24);
  line.insert(line.begin() + 5, 0.3 * line[4] + 0.7 * line[5]);
  EXPECT_EQ(arcs_of(fit_curves(line, {})), fit_curves(line, {}).pieces.size());
}

TEST(FitCurves, CornersAreKept) {
  // Two arcs that meet at a corner, and one closed shape of an arc and its chord.
  std::vector<Point2> line = tessellated({{10, 10}, {5, 5}}, 0, kPi, 18);
  const Point2 corner = line.back();
  for (const Point2 p : tessellated({{0, 10}, {5, 5}}, 0, kPi, 18)) line.push_back(p);
  const CurvedPath path = fitted(line);
  EXPECT_EQ(std::count_if(path.pieces.begin(), path.pieces.end(),
                          [&](const PathPiece& p) { return glm::length(p.to - corner) < 1e-9; }),
            1);
  EXPECT_EQ(arcs_of(path), path.pieces.size());
  std::vector<Point2> half = tessellated({{10, 10}, {5, 5}}, 0, kPi, 18);
  std::rotate(half.begin(), half.begin() + 7, half.end());
  half.push_back(half.front());
  const CurvedPath shape = fitted(half);
  EXPECT_EQ(arcs_of(shape), 1u);
  EXPECT_EQ(shape.pieces.size(), 2u);
}

TEST(FitCurves, OtherSmoothCurvesStayWithinTheTolerance) {
  std::vector<Point2> wave, spiral;
  for (int i = 0; i <= 400; ++i) {
    wave.push_back({i * 0.25, 20 + 10 * std::sin(i * 0.05)});
    const double t = i * 0.05;
    spiral.push_back(Point2{60, 60} + Point2{std::cos(t), std::sin(t)} * (2 + 2 * t));
  }
  for (const auto& line : {wave, spiral}) {
    const CurvedPath path = fitted(line);
    // No bumps: where pieces meet they turn no more than the line itself does over two steps.
    for (std::size_t i = 1; i < path.pieces.size(); ++i) {
      const PathPiece &before = path.pieces[i - 1], &after = path.pieces[i];
      if (!before.arc || !after.arc) continue;
      const auto direction = [](const EllipticArc& arc, double t) {
        return glm::normalize(EllipseFrame(arc.ellipse).tangent_at(t)) * (arc.sweep > 0 ? 1.0 : -1.0);
      };
      const Point2 in = direction(*before.arc, before.arc->from + before.arc->sweep),
                   out = direction(*after.arc, after.arc->from);
      EXPECT_GT(glm::dot(in, out), std::cos(3 * kDegree));
    }
  }
}

TEST(FitCurves, DegenerateLines) {
  EXPECT_TRUE(fit_curves({}, {}).pieces.empty());
  const std::vector<Point2> one{{3, 3}}, dot{{3, 3}, {3, 3}}, back{{0, 0}, {5, 0}, {0, 0}}, many(50, {7, 7});
  EXPECT_TRUE(fit_curves(one, {}).pieces.empty());
  EXPECT_EQ(fit_curves(dot, {}).pieces.size(), 1u);
  EXPECT_EQ(fit_curves(back, {}).pieces.size(), 2u);
  EXPECT_EQ(fit_curves(many, {}).pieces.size(), 1u);
  std::vector<Point2> repeated;
  for (const Point2 p : closed({{50, 50}, {10, 10}}, 48)) repeated.insert(repeated.end(), 3, p);
  EXPECT_EQ(arcs_of(fit_curves(repeated, {})), 1u);
  // An ellipse seen edge on, and a circle run through twice.
  fitted(closed({{50, 50}, {10, 1e-4}, 0.2}, 48));
  std::vector<Point2> twice = closed({{50, 50}, {10, 10}}, 48);
  twice.insert(twice.end(), twice.begin() + 1, twice.end());
  fitted(twice);
}

TEST(FitCurves, RandomLinesStaySound) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 2), angle(-0.6, 0.6);
  for (int round = 0; round < 200; ++round) {
    std::vector<Point2> line{{100, 100}};
    double direction = 0, length = place(random);
    for (int i = 0; i < 60; ++i) {
      direction += angle(random);
      if (i % 7 == 0) length = place(random);
      line.push_back(line.back() + length * Point2{std::cos(direction), std::sin(direction)});
    }
    fitted(line);
  }
}

TEST(FitCurves, BezierCurvesKeepToTheArc) {
  for (const double radius : {0.5, 10.0, 200.0}) {
    const EllipticArc arc{{{0, 0}, {radius, radius}}, 0.3, -2.0};
    const std::vector<Point2> points = bezier_points(arc, 1e-4);
    Point2 at = point_at(arc.ellipse, arc.from);
    for (std::size_t i = 0; i < points.size(); i += 3) {
      for (double t = 0; t <= 1; t += 1.0 / 64) {
        const double s = 1 - t;
        const Point2 p =
            s * s * s * at + 3 * s * s * t * points[i] + 3 * s * t * t * points[i + 1] + t * t * t * points[i + 2];
        EXPECT_LE(std::abs(glm::length(p) - radius), 1e-4);
      }
      at = points[i + 2];
    }
    EXPECT_LT(glm::length(at - point_at(arc.ellipse, arc.from + arc.sweep)), 1e-9);
  }
}

}  // namespace
}  // namespace ligne
