#include "picture/raster/span_areas.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Largest distance of span ends from a straight side, in mm: the accuracy of strokes.
constexpr double kStraightMm = 0.001;

/// One side of an area: the begins or the ends of its spans, line by line.
struct AreaSide {
  const SpanLines& lines;
  std::uint32_t first_line;
  const std::vector<double>& x;

  Point2 at(std::size_t i) const { return {x[i], lines.y_mm(first_line + static_cast<std::uint32_t>(i))}; }
};

/// A straight piece of a side, through the points [first, last].
struct StraightRun {
  std::size_t first = 0, last = 0;
  double x = 0, y = 0, slope = 0;  ///< x + slope (height - y); vertical if it has one point

  double at(double height) const { return x + slope * (height - y); }
};

/// Splits a side into runs. A run goes on while one line through its first point stays within the tolerance of all
/// others.
std::vector<StraightRun> straight_runs(const AreaSide& side) {
  std::vector<StraightRun> runs;
  for (std::size_t i = 0; i < side.x.size();) {
    const Point2 begin = side.at(i);
    double least = -std::numeric_limits<double>::infinity(), most = -least;
    std::size_t k = i + 1;
    for (; k < side.x.size(); ++k) {
      const Point2 p = side.at(k);
      const double dy = p.y - begin.y, slope = (p.x - begin.x) / dy;
      if (slope < least || slope > most) break;
      least = std::max(least, slope - kStraightMm / dy);
      most = std::min(most, slope + kStraightMm / dy);
    }
    const Point2 end = side.at(k - 1);
    runs.push_back({i, k - 1, begin.x, begin.y, k - 1 > i ? (end.x - begin.x) / (end.y - begin.y) : 0});
    i = k;
  }
  return runs;
}

/// The height at which two runs meet, if it lies between two heights.
std::optional<double> meeting(const StraightRun& a, const StraightRun& b, double from, double to) {
  if (a.slope == b.slope) return std::nullopt;
  const double y = a.y + (b.at(a.y) - a.x) / (a.slope - b.slope);
  return y >= from && y <= to ? std::optional(y) : std::nullopt;
}

/// The corners of a side, from top to bottom.
std::vector<Point2> corners_of(const AreaSide& side, const std::vector<StraightRun>& runs) {
  std::vector<Point2> corners{side.at(0)};
  for (std::size_t r = 1; r < runs.size(); ++r) {
    const Point2 above = side.at(runs[r].first - 1), below = side.at(runs[r].first);
    if (const auto y = meeting(runs[r - 1], runs[r], above.y, below.y)) {
      corners.push_back({runs[r].at(*y), *y});
    } else {
      corners.push_back(above);
      corners.push_back(below);
    }
  }
  corners.push_back(side.at(side.x.size() - 1));
  return corners;
}

/// Ends the area above its first span (`down` -1) or below its last one (1). If its sides meet before the next scan
/// line, the end is that point; otherwise two points half way to the line. A nearly horizontal side is extended
/// sideways by at most that distance.
std::vector<Point2> end_of(const StraightRun& left, const StraightRun& right, double y, double spacing, double down) {
  const double next = y + down * spacing, half = spacing / 2;
  const double x_left = left.at(y), x_right = right.at(y);
  if (const auto meet = meeting(left, right, std::min(y, next), std::max(y, next))) {
    const double x = left.at(*meet);
    if (x > x_left - spacing && x < x_right + spacing) return {{x, *meet}};
  }
  const double between = y + down * half;
  const auto across = [&](const StraightRun& run, double x) { return std::clamp(run.at(between), x - half, x + half); };
  const double a = across(left, x_left), b = across(right, x_right);
  if (a >= b) return {{(a + b) / 2, between}};
  return {{a, between}, {b, between}};
}

/// An area that is not finished on the current scan line.
struct OpenArea {
  std::uint32_t face = 0, in_front = 0, first_line = 0;
  std::vector<double> left, right;

  Region closed(const SpanLines& lines) const {
    const AreaSide begins{lines, first_line, left}, ends{lines, first_line, right};
    const std::vector<StraightRun> left_runs = straight_runs(begins), right_runs = straight_runs(ends);
    std::vector<Point2> contour =
        end_of(left_runs.front(), right_runs.front(), begins.at(0).y, lines.spacing_mm, -1);  // from left to right
    const std::vector<Point2> down = corners_of(ends, right_runs), up = corners_of(begins, left_runs);
    const std::vector<Point2> foot =
        end_of(left_runs.back(), right_runs.back(), begins.at(left.size() - 1).y, lines.spacing_mm, 1);
    contour.insert(contour.end(), down.begin(), down.end());
    contour.insert(contour.end(), foot.rbegin(), foot.rend());
    contour.insert(contour.end(), up.rbegin(), up.rend());
    Region region{.face = face, .in_front = in_front};
    region.contours.push_back(std::move(contour));
    return region;
  }
};

/// For each span of a line, the area above it if each continues only the other; otherwise `none`. Areas and spans run
/// from left to right.
std::vector<std::size_t> continued(const std::vector<OpenArea>& above, const Span* spans, std::size_t count,
                                   std::size_t none) {
  std::vector<std::size_t> area_of(count, none);
  std::vector<std::uint32_t> of_span(count), of_area(above.size());
  for (std::size_t a = 0, s = 0; a < above.size() && s < count;) {
    const double left = above[a].left.back(), right = above[a].right.back();
    const bool alike = above[a].face == spans[s].face && above[a].in_front == spans[s].in_front;
    if (alike && std::max(left, spans[s].x_from) < std::min(right, spans[s].x_to)) {
      area_of[s] = a;
      ++of_span[s];
      ++of_area[a];
    }
    right < spans[s].x_to ? ++a : ++s;
  }
  for (std::size_t s = 0; s < count; ++s) {
    if (area_of[s] != none && (of_span[s] != 1 || of_area[area_of[s]] != 1)) area_of[s] = none;
  }
  return area_of;
}

}  // namespace

SpanModel spans_of_pixels(const PixelModel& pixels) {
  SpanModel model{.lines = {pixels.corner_mm.y + pixels.pixel_mm / 2, pixels.pixel_mm, pixels.height},
                  .layers = pixels.layers};
  for (std::uint32_t row = 0; row < pixels.height; ++row) {
    const std::size_t begin = std::size_t{row} * pixels.width;
    const auto shown = [&](std::uint32_t column) {
      const std::size_t i = begin + column;
      return std::pair(pixels.face[i], pixels.in_front.empty() ? TransparentLayers::kEmptyList : pixels.in_front[i]);
    };
    const auto edge = [&](std::uint32_t column) { return pixels.corner_mm.x + column * pixels.pixel_mm; };
    for (std::uint32_t from = 0, to = 0; from < pixels.width; from = to) {
      const auto [face, in_front] = shown(from);
      while (to < pixels.width && shown(to) == std::pair(face, in_front)) ++to;
      if (face != kNone || in_front != TransparentLayers::kEmptyList) {
        model.spans.push_back({row, edge(from), edge(to), face, in_front});
      }
    }
  }
  return model;
}

std::vector<Region> areas_of_spans(const SpanModel& model) {
  constexpr std::size_t kNoArea = std::numeric_limits<std::size_t>::max();
  std::vector<Region> areas;
  std::vector<OpenArea> open;
  const auto close = [&](const OpenArea& area) {
    if (!area.left.empty()) areas.push_back(area.closed(model.lines));
  };
  const std::vector<Span>& spans = model.spans;
  for (std::size_t i = 0; i < spans.size();) {
    const std::size_t begin = i;
    while (i < spans.size() && spans[i].line == spans[begin].line) ++i;
    if (begin > 0 && spans[begin - 1].line + 1 != spans[begin].line) {
      for (const OpenArea& area : open) close(area);
      open.clear();
    }
    const std::vector<std::size_t> area_of = continued(open, &spans[begin], i - begin, kNoArea);
    std::vector<OpenArea> next(i - begin);
    for (std::size_t s = 0; s < next.size(); ++s) {
      const Span& span = spans[begin + s];
      next[s] = area_of[s] == kNoArea ? OpenArea{span.face, span.in_front, span.line, {}, {}}
                                      : std::exchange(open[area_of[s]], {});
      next[s].left.push_back(span.x_from);
      next[s].right.push_back(span.x_to);
    }
    for (const OpenArea& area : open) close(area);  // areas that were continued are empty here
    open = std::move(next);
  }
  for (const OpenArea& area : open) close(area);
  return areas;
}

}  // namespace ligne
