/// Lines that become arcs and lines that do not, and how far curves are from points.

#include "plotting/curves/fit_curves.hpp"
#include "main/script.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

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

/// "SETTINGS: LINE", and what becomes of it.
struct Fitting {
  std::vector<Point2> line;
  CurveLimits limits;
  std::optional<KnownEllipses> known;

  explicit Fitting(const std::string& text) : line(test::line_of_text(text.substr(text.find(": ") + 2))) {
    std::vector<Ellipse> ellipses;
    for (const std::string& word : test::words_of(text.substr(0, text.find(": ")))) {
      std::vector<double> n;
      for (const std::string& part : test::parts_of(word.substr(word.find('=') + 1), ','))
        n.push_back(std::atof(part.c_str()));
      if (word.starts_with("known=")) ellipses.push_back({{n.at(0), n.at(1)}, {n.at(2), n.at(3)}, n.at(4)});
      if (word.starts_with("rise=")) limits.most_rise_mm = n.at(0);
      if (word == "starts") limits.start_stays = true;
      if (word == "tenths")  // of a micrometre
        for (Point2& p : line) p = glm::round(p * 1e4) / 1e4;
      if (word.starts_with("turned=")) {
        line.pop_back();
        std::ranges::rotate(line, line.begin() + std::lround(n.at(0)));
        line.push_back(line.front());
      }
    }
    if (ellipses.empty()) return;
    known.emplace(ellipses, Rect{{0, 0}, {210, 297}});
    limits.known = &*known;
  }
  Fitting(const Fitting&) = delete;
};

/// The pieces in their order: "2l 1a" are two lines and an arc.
std::string pieces_of(const CurvedPath& path) {
  std::string text;
  for (std::size_t i = 0, end; i < path.pieces.size(); i = end) {
    for (end = i + 1; end < path.pieces.size() && !path.pieces[end].arc == !path.pieces[i].arc;) ++end;
    text += (i == 0 ? "" : " ") + std::to_string(end - i) + (path.pieces[i].arc ? "a" : "l");
  }
  return text;
}

std::string fitted_pieces(const std::string& text) {
  const Fitting given(text);
  const CurvedPath path = fitted(given.line, given.limits);
  EXPECT_TRUE(!given.limits.start_stays || path.start == given.line.front());
  return pieces_of(path);
}

/// Centres and radii of the arcs.
std::string ellipses_of(const std::string& text) {
  const Fitting given(text);
  std::string all;
  for (const PathPiece& piece : fitted(given.line, given.limits).pieces)
    if (piece.arc)
      for (const Point2 p : {piece.arc->ellipse.centre, piece.arc->ellipse.radii})
        all += (all.empty() ? "" : " ") + as_decimal(p.x, 3) + "," + as_decimal(p.y, 3);
  return all;
}

/// Where the path has a corner at this point of the line: "yes" or "no".
std::string is_cut_at(const std::string& text) {
  std::string_view rest = text;
  const std::size_t corner = std::stoul(test::take_word(rest));
  const Fitting given{std::string(rest)};
  const CurvedPath path = fitted(given.line, given.limits);
  return std::ranges::count(path.pieces, given.line.at(corner), &PathPiece::to) == 1 ? "yes" : "no";
}

/// Whether the line became at most so many arcs, and nothing else.
std::string is_arcs(const std::string& text) {
  std::string_view rest = text;
  const std::size_t most = std::stoul(test::take_word(rest));
  const std::string pieces = fitted_pieces(std::string(rest));
  return pieces.ends_with('a') && pieces.find(' ') == pieces.npos && std::stoul(pieces) <= most ? "yes" : pieces;
}

[[maybe_unused]] const bool curves_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/plotting/curves",
                               {{"fit", fitted_pieces},
                                {"fit-anything", [](auto& t) { return pieces_of(fit_curves(test::line_of_text(t), {})); }},
                                {"arcs", is_arcs},
                                {"ellipses", ellipses_of},
                                {"cut-at", is_cut_at}});

TEST(FitCurves, NoiseBelowAndAboveTheTolerance) {
  std::mt19937 random(1);
  for (const int steps : {24, 36, 60}) {
    for (const double noise : {0.002, 0.03}) {
      std::uniform_real_distribution<double> move(-noise, noise);
      std::vector<Point2> line = closed({{60, 60}, {12, 7}, 0.4}, steps);
      for (Point2& p : line) p += Point2{move(random), move(random)};
      line.back() = line.front();
      const CurvedPath path = fitted(line);
      if (noise < kCurveToleranceMm) {
        EXPECT_EQ(pieces_of(path), std::to_string(path.pieces.size()) + "a") << steps;
      } else {
        // Six corners in a row may lie on an ellipse by chance.
        EXPECT_GT(path.pieces.size(), static_cast<std::size_t>(steps) / 2) << steps;
      }
    }
  }
}

TEST(FitCurves, OtherSmoothCurvesStayWithinTheTolerance) {
  for (const char* line : {"0..400:k/4,20+10*sin(k/20)", "0..400:60+cos(k/20)*(2+k/10),60+sin(k/20)*(2+k/10)"}) {
    const CurvedPath path = fitted(test::line_of_text(line));
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
