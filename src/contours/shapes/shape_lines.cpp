#include "contours/shapes/shape_lines.hpp"

#include <algorithm>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/curve_writer.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Shortest visible part of a tangent line that is drawn, in pen widths.
constexpr double kShortestTangentInPens = 3;
/// Number of smoothing passes over the points of a line, which zigzags because it crosses triangles.
constexpr int kEvenings = 8;
/// Shortest run of one visibility that counts, and shortest visible part that is drawn, in pen widths.
constexpr double kShortestChangeInPens = 2, kShortestSeenInPens = 14;

/// The points, each repeatedly moved to a weighted mean of itself and its neighbours. The ends of an open line stay.
std::vector<Point3> evened_points(const ShapeLine& line) {
  std::vector<Point3> points = line.points, before;
  const std::size_t n = points.size();
  for (int round = 0; round < kEvenings; ++round) {
    before = points;
    for (std::size_t i = 1; i + 1 < n; ++i) points[i] = (before[i - 1] + 2.0 * before[i] + before[i + 1]) / 4.0;
    if (line.closed) points[0] = points[n - 1] = (before[n - 2] + 2.0 * before[0] + before[1]) / 4.0;
  }
  return points;
}

double length_of(const ContourRun& run, const ContourCurve& curve) {
  return curve.point_at(run.to).length - curve.point_at(run.from).length;
}

/// Hides visible runs shorter than `shortest_mm`. In a closed line the last run continues in the first.
void hide_short_runs(std::vector<ContourRun>& runs, const ContourCurve& curve, double shortest_mm) {
  const bool round = curve.closed && runs.size() > 1 && runs.front().state == runs.back().state;
  const double seam = round ? length_of(runs.front(), curve) + length_of(runs.back(), curve) : 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool at_seam = round && (i == 0 || i + 1 == runs.size());
    if (runs[i].state >= 0 && (at_seam ? seam : length_of(runs[i], curve)) < shortest_mm) runs[i].state = kHiddenState;
  }
}

}  // namespace

bool has_shape_lines(LineClasses classes) {
  return std::ranges::any_of(kShapeClasses, [&](LineClass c) { return classes.has(c); });
}

ShapeLines add_shape_lines(ProjectedScene& projected, std::vector<ShapeLine> lines) {
  ShapeLines found;
  found.lines = std::move(lines);
  std::vector<std::array<Point3, 2>> segments;
  for (const ShapeLine& line : found.lines) {
    found.first_source.push_back(projected.source_count);
    segments.clear();
    for (std::size_t i = 0; i < line.size(); ++i) segments.push_back({line.points[i], line.points[i + 1]});
    add_lines(projected, segments, line.line_class);
  }
  return found;
}

void draw_shape_lines(StrokeModel& model, const View& view, const ShapeLines& lines, bool hidden_too,
                      const ContourOptions& options) {
  if (lines.lines.empty()) return;
  const std::uint32_t first = lines.first_source.front();
  const std::size_t n = lines.lines.size(), count = lines.first_source.back() - first + lines.lines.back().size();
  const std::vector<Stroke> strokes = take_strokes(model, first, count);
  std::vector<ContourCurve> curves(n);
  std::vector<std::vector<ContourRun>> runs(n);
  constexpr std::size_t kLinesPerTask = 8;
  parallel_blocks(n, kLinesPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ShapeLine& line = lines.lines[i];
      const bool is_tangent = line.line_class == LineClass::tangent;
      curves[i] = smooth_curve(view, is_tangent ? line.points : evened_points(line), line.closed, kCurveFlatnessMm);
      runs[i] = runs_of(strokes, lines.first_source[i], line.size(), hidden_too);
      drop_short_runs(runs[i], curves[i], kShortestChangeInPens * options.pen_width_mm);
      const double shortest = is_tangent ? kShortestTangentInPens : kShortestSeenInPens;
      hide_short_runs(runs[i], curves[i], shortest * options.pen_width_mm);
    }
  });
  CurveWriter writer(model, view, hidden_too, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const ShapeLine& line = lines.lines[i];
    writer.add(line.line_class, line.size(), lines.first_source[i], curves[i], runs[i], [&](std::size_t k) {
      return SourceEdge{{line.points[k], line.points[k + 1]}, {line.faces[k], kNone}, false};
    });
  }
}

}  // namespace ligne
