/// Hatches in the frame of the strokes:
///
/// 1. Joins runs that touch, line by line. The result is the area, sampled on lines that are at most a sixth of the pen
/// apart.
/// 2. Makes the area narrower by half a pen: a point stays if a shape around it that contains the pen's tip stays
/// inside on all lines that it meets. The stroke can come nearer to a corner that points along the lines and ends
/// between two of them, by half their distance. A slit narrower than that goes unnoticed.
/// 3. Takes every n-th line (SurfaceHatch::every) as a row, and the parts of it that stayed as strokes.
/// 4. Ties strokes of neighbouring rows together where both end at the rim, along the ends of the parts that stayed on
/// the lines between.
///
/// A surface with n rows has row k if the four bits of k mod 16, in reverse order, are less than n. So any number of
/// rows is spread evenly, and contains the rows of every smaller number.

#include "plotting/hatching/hatch_rim.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "geometry/simplify.hpp"

namespace ligne {
namespace {

/// Largest distance of runs that are joined, mm: the micrometre to which drawings are right.
constexpr double kTouchMm = 1e-3;

// Adjustable: lines per pen width, the pen below which lines become no finer, limits of strokes and ties.
constexpr double kLinesPerPen = 6, kFinestPenMm = 0.1;
constexpr double kShortestPens = 1;  ///< shortest stroke, in pen widths: shorter ones are blots
constexpr double kLongestTie = 4;    ///< longest tie, in distances of its rows

using Interval = HatchInterval;
using Line = std::vector<Interval>;

/// Half the width, mm, that must be free on each line, from the middle of the pen outwards. Each value is the half
/// width of the tip one line nearer to the middle, so that a corner that ends between two lines is not missed.
std::vector<double> pen_profile(double radius, double line_mm) {
  std::vector<double> half{radius};
  for (double y = 0; y < radius; y += line_mm) half.push_back(std::sqrt(radius * radius - y * y));
  return half;
}

/// Intersects `kept` with the intervals of `line`, each made shorter by `half` at both ends.
void keep_within(Line& kept, const Line& line, double half, Line& scratch) {
  scratch.clear();
  std::size_t i = 0, k = 0;
  while (i < kept.size() && k < line.size()) {
    const double from = std::max(kept[i].from, line[k].from + half), to = std::min(kept[i].to, line[k].to - half);
    if (from < to) scratch.push_back({from, to});
    kept[i].to < line[k].to - half ? ++i : ++k;
  }
  kept.swap(scratch);
}

/// A run of a group of surfaces that are hatched together.
struct GroupRun {
  std::int32_t line;
  double from, to;
  std::uint32_t rows, layer;
};

/// The rank of a row in its cycle: surfaces with more rows than its rank have it.
std::uint32_t rank_of(std::int64_t row) {
  static_assert(kRowCycle == 16);
  const auto k = static_cast<std::uint32_t>((row % kRowCycle + kRowCycle) % kRowCycle);
  return (k & 1) << 3 | (k & 2) << 1 | (k & 4) >> 1 | (k & 8) >> 3;
}

class Hatcher {
 public:
  /// The runs are ordered by line and beginning.
  Hatcher(const HatchFrame& frame, double line_mm, std::uint32_t every, double pen_mm, std::span<const GroupRun> runs);

  void run(std::uint32_t layer, Polylines& out);
  void rim(Polylines& out) const { trace_rim(free_, first_, frame_, line_mm_, out); }

 private:
  /// A stroke that may be continued.
  struct Open {
    std::vector<Point2> points;  ///< frame
    std::int32_t line;
    bool at_left = false;  ///< it ended at the left end of its row
    bool used = false;
    double u() const { return points.back().x; }
  };

  static constexpr std::int64_t kAll = -1;
  std::size_t index(std::int32_t line) const { return static_cast<std::size_t>(std::int64_t{line} - first_); }
  /// The parts of a line covered by surfaces with more rows than `rank`; kAll: by any surface.
  Line covered(std::int64_t rank, std::int32_t line, std::optional<std::uint32_t> layer = {}) const;
  Line inside(std::int64_t rank, std::int32_t line) const;
  /// Whether the end of a stroke at `u` lies at the rim.
  bool at_rim(std::int32_t line, double u) const;
  bool route(Point2 from, std::int32_t from_line, double to, std::int32_t to_line, bool at_left,
             std::vector<Point2>& way) const;
  bool tie(Open& stroke, const Interval& span, std::int32_t line, std::vector<Open>& open) const;
  void finish(const Open& stroke, Polylines& out) const;

  const HatchFrame& frame_;
  double line_mm_, shortest_mm_;
  std::int64_t every_;
  std::span<const GroupRun> runs_;
  std::int32_t first_ = 0;
  std::vector<std::size_t> begin_;  ///< per line: its first run
  std::vector<Line> free_;          ///< per line: the parts that stay of the whole area
  std::vector<double> profile_;
  std::int64_t longest_ = 0;  ///< lines between two rows of the surface with the fewest rows
  bool layers_ = false;       ///< whether there are several layers
};

Hatcher::Hatcher(const HatchFrame& frame, double line_mm, std::uint32_t every, double pen_mm, std::span<const GroupRun> runs)
    : frame_(frame),
      line_mm_(line_mm),
      shortest_mm_(kShortestPens * pen_mm),
      every_(every),
      runs_(runs),
      profile_(pen_profile(pen_mm / 2, line_mm)) {
  if (runs.empty()) return;
  first_ = runs.front().line;
  const std::size_t lines = index(runs.back().line) + 1;
  begin_.assign(lines + 1, 0);
  std::uint32_t fewest = kRowCycle;
  for (const GroupRun& run : runs) {
    ++begin_[index(run.line) + 1];
    if (run.rows > 0) fewest = std::min(fewest, run.rows);
    layers_ = layers_ || run.layer != runs.front().layer;
  }
  longest_ = every_ * ((kRowCycle + fewest - 1) / fewest);
  for (std::size_t i = 0; i < lines; ++i) begin_[i + 1] += begin_[i];
  free_.resize(lines);
  parallel_for(lines, [&](std::size_t i) { free_[i] = inside(kAll, first_ + static_cast<std::int32_t>(i)); });
}

Line Hatcher::covered(std::int64_t rank, std::int32_t line, std::optional<std::uint32_t> layer) const {
  Line cover;
  if (line < first_ || index(line) + 1 >= begin_.size()) return cover;
  for (std::size_t i = begin_[index(line)]; i < begin_[index(line) + 1]; ++i) {
    const GroupRun& run = runs_[i];
    if (std::int64_t{run.rows} <= rank || (layer && run.layer != *layer)) continue;
    if (!cover.empty() && run.from <= cover.back().to + kTouchMm) {
      cover.back().to = std::max(cover.back().to, run.to);
    } else {
      cover.push_back({run.from, run.to});
    }
  }
  return cover;
}

/// The parts of a line that stay when the area is made narrower by half a pen.
Line Hatcher::inside(std::int64_t rank, std::int32_t line) const {
  Line kept, scratch;
  for (const Interval& run : covered(rank, line)) {
    if (run.from + profile_[0] < run.to - profile_[0]) kept.push_back({run.from + profile_[0], run.to - profile_[0]});
  }
  for (std::size_t i = 1; i < profile_.size() && !kept.empty(); ++i) {
    for (const std::int32_t side : {-1, 1})
      keep_within(kept, covered(rank, line + side * static_cast<std::int32_t>(i)), profile_[i], scratch);
  }
  return kept;
}

bool Hatcher::at_rim(std::int32_t line, double u) const {
  const Line& free = free_[index(line)];
  return std::ranges::any_of(
      free, [u](const Interval& run) { return std::abs(run.from - u) <= kTouchMm || std::abs(run.to - u) <= kTouchMm; });
}

/// The way of a tie between the ends of two rows, along the rim. False if the rim leads elsewhere, or runs too flat.
bool Hatcher::route(Point2 from, std::int32_t from_line, double to, std::int32_t to_line, bool at_left,
                    std::vector<Point2>& way) const {
  way.clear();
  double before = from.x;
  const double step = kLongestTie * line_mm_;
  for (std::int32_t line = from_line + 1; line <= to_line; ++line) {
    double u = 1e300;
    for (const Interval& run : free_[index(line)]) {
      const double end = at_left ? run.from : run.to;
      if (std::abs(end - before) < std::abs(u - before)) u = end;
    }
    if (!(std::abs(u - before) <= step)) return false;
    before = u;
    if (line < to_line) way.push_back({u, line * line_mm_});
  }
  if (std::abs(before - to) > kTouchMm) return false;
  if (way.empty()) return true;
  way.insert(way.begin(), from);
  way.push_back({to, to_line * line_mm_});
  const std::vector<std::uint32_t> kept = simplified(way, kTouchMm);
  for (std::size_t i = 1; i + 1 < kept.size(); ++i) way[i - 1] = way[kept[i]];
  way.resize(kept.size() - 2);
  return true;
}

/// Continues into `span` a stroke that ended at the same end of an earlier row, the nearest first; `stroke` receives
/// it. `open` is sorted by u. False if there is none.
bool Hatcher::tie(Open& stroke, const Interval& span, std::int32_t line, std::vector<Open>& open) const {
  struct Candidate {
    double length;
    Open* before;
    bool from_left;
  };
  std::vector<Candidate> candidates;
  const double reach = kLongestTie * static_cast<double>(longest_) * line_mm_;
  for (const bool from_left : {true, false}) {
    const double u = from_left ? span.from : span.to;
    if (!at_rim(line, u)) continue;
    auto before = std::lower_bound(open.begin(), open.end(), u - reach, [](const Open& o, double v) { return o.u() < v; });
    for (; before != open.end() && before->u() <= u + reach; ++before) {
      const double rows_mm = (line - before->line) * line_mm_, length = std::hypot(before->u() - u, rows_mm);
      if (!before->used && before->at_left == from_left && length <= kLongestTie * rows_mm &&
          at_rim(before->line, before->u()))
        candidates.push_back({length, &*before, from_left});
    }
  }
  std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  std::vector<Point2> way;
  for (const Candidate& c : candidates) {
    const double u = c.from_left ? span.from : span.to;
    if (!route(c.before->points.back(), c.before->line, u, line, c.from_left, way)) continue;
    c.before->used = true;
    stroke.points = std::move(c.before->points);
    c.before->points = {{u, 0}};  // keeps its place in the order
    stroke.points.insert(stroke.points.end(), way.begin(), way.end());
    stroke.points.push_back({u, line * line_mm_});
    stroke.points.push_back({c.from_left ? span.to : span.from, line * line_mm_});
    stroke.at_left = !c.from_left;
    return true;
  }
  return false;
}

void Hatcher::finish(const Open& stroke, Polylines& out) const {
  for (const Point2 p : stroke.points) out.points.push_back(frame_.to_page(p));
  out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
}

void Hatcher::run(std::uint32_t layer, Polylines& out) {
  const std::int64_t last = std::int64_t{first_} + static_cast<std::int64_t>(free_.size()) - 1;
  auto row = static_cast<std::int64_t>(std::ceil(static_cast<double>(first_) / static_cast<double>(every_)));
  std::vector<Open> open, next;
  Line scratch;
  for (; row * every_ <= last; ++row) {
    const auto line = static_cast<std::int32_t>(row * every_);
    next.clear();
    const std::uint32_t rank = rank_of(row);
    Line spans = inside(rank, line);
    if (layers_) keep_within(spans, covered(rank, line, layer), 0, scratch);
    for (const Interval& span : spans) {
      if (span.to - span.from < shortest_mm_) continue;
      Open stroke{{}, line};
      if (!tie(stroke, span, line, open)) {
        stroke.points = {{span.from, line * line_mm_}, {span.to, line * line_mm_}};
        stroke.at_left = row % 2 != 0;
        if (stroke.at_left) std::swap(stroke.points[0], stroke.points[1]);
      }
      next.push_back(std::move(stroke));
    }
    for (Open& before : open) {
      if (before.used) continue;
      if (line + every_ - before.line > longest_) {
        finish(before, out);
      } else {
        next.push_back(std::move(before));
      }
    }
    open.swap(next);
    std::ranges::stable_sort(open, [](const Open& a, const Open& b) { return a.u() < b.u(); });
  }
  for (const Open& stroke : open) finish(stroke, out);
}

}  // namespace

HatchFrame::HatchFrame(Point2 origin, double angle_degrees) : origin_(origin) {
  const double angle = angle_degrees * std::numbers::pi / 180;
  // Page y points down: counter-clockwise as seen.
  along_ = {std::cos(angle), -std::sin(angle)};
  across_ = {-along_.y, along_.x};
}

Point2 HatchFrame::to_frame(Point2 page) const {
  return {glm::dot(page - origin_, along_), glm::dot(page - origin_, across_)};
}
Point2 HatchFrame::to_page(Point2 frame) const { return origin_ + along_ * frame.x + across_ * frame.y; }

double hatch_line_mm(double spacing_mm, double pen_mm) {
  if (!(spacing_mm > 0) || !(pen_mm > 0)) throw std::invalid_argument("spacing and pen width of a hatch are above zero");
  const double wanted = std::max(pen_mm, kFinestPenMm) / kLinesPerPen;
  return spacing_mm / std::max(1.0, std::ceil(spacing_mm / wanted));
}

double hatch_line_mm(const HatchOptions& options) {
  return hatch_line_mm(options.spacing_mm, options.rim ? options.pen_width_mm / 2 : options.pen_width_mm);
}

void add_runs(std::span<const std::vector<Point2>> contours, std::uint32_t surface, const HatchFrame& frame, double line_mm,
              std::vector<SurfaceRun>& runs, bool even_odd) {
  Rect box;
  std::vector<std::vector<Point2>> turned(contours.size());
  for (std::size_t c = 0; c < contours.size(); ++c) {
    for (const Point2 p : contours[c]) box.extend(turned[c].emplace_back(frame.to_frame(p)));
  }
  const double first = std::ceil(box.min.y / line_mm), last = std::floor(box.max.y / line_mm);
  if (!(first <= last)) return;
  if (!(std::abs(first) < 2e9 && std::abs(last) < 2e9)) throw std::invalid_argument("a hatch has too many lines");
  // Crossings of the contours with the lines, by line.
  struct Crossing {
    std::int32_t line;
    double u;
    int turn;
  };
  std::vector<Crossing> crossings;
  for (const std::vector<Point2>& contour : turned) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      Point2 a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
      const int turn = even_odd || a.y <= b.y ? 1 : -1;
      if (a.y > b.y || (a.y == b.y && a.x > b.x))
        std::swap(a, b);  // so that two areas get the same crossing with their common edge
      for (double line = std::ceil(a.y / line_mm); line * line_mm < b.y; ++line) {
        crossings.push_back(
            {static_cast<std::int32_t>(line), a.x + (b.x - a.x) * ((line * line_mm - a.y) / (b.y - a.y)), turn});
      }
    }
  }
  std::ranges::sort(crossings, [](const Crossing& a, const Crossing& b) {
    return std::tie(a.line, a.u, a.turn) < std::tie(b.line, b.u, b.turn);
  });
  int winding = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding = i > 0 && crossings[i - 1].line != crossings[i].line ? crossings[i].turn : winding + crossings[i].turn;
    if (crossings[i].line != crossings[i + 1].line || !(crossings[i].u < crossings[i + 1].u)) continue;
    if (even_odd ? winding % 2 != 0 : winding != 0)
      runs.push_back({crossings[i].line, crossings[i].u, crossings[i + 1].u, surface});
  }
}

void hatch_runs(const HatchFrame& frame, double line_mm, std::span<const SurfaceRun> runs,
                std::span<const SurfaceHatch> surfaces, std::span<const double> pen_mm, std::span<Polylines> layers) {
  if (!(line_mm > 0) || std::ranges::any_of(pen_mm, [](double pen) { return !(pen > 0); })) {
    throw std::invalid_argument("spacing and pen width of a hatch are above zero");
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<GroupRun>> groups;
  std::set<std::pair<std::uint32_t, std::uint32_t>> rims;
  for (const SurfaceRun& run : runs) {
    const SurfaceHatch& how = surfaces[run.surface];
    if (how.rim) rims.insert({how.group, how.every});
    if (how.every > 0) groups[{how.group, how.every}].push_back({run.line, run.from, run.to, how.rows, how.layer});
  }
  for (auto& [group, runs] : groups) {
    std::ranges::sort(runs, [](const GroupRun& a, const GroupRun& b) {
      return std::tie(a.line, a.from, a.to) < std::tie(b.line, b.from, b.to);
    });
    for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
      if (std::ranges::none_of(runs, [&](const GroupRun& run) { return run.layer == layer; })) continue;
      Hatcher hatcher(frame, line_mm, group.second, pen_mm[layer], runs);
      if (rims.contains(group)) hatcher.rim(layers[layer]);
      hatcher.run(layer, layers[layer]);
    }
  }
}

Polylines hatch(std::span<const std::vector<Point2>> contours, const HatchOptions& options) {
  const double line_mm = hatch_line_mm(options);
  Polylines out;
  for (const double turn : {0.0, 90.0}) {
    if (turn > 0 && !options.cross) break;
    const HatchFrame frame(options.origin, options.angle_degrees + turn);
    Rect box;
    for (const std::vector<Point2>& contour : contours) {
      for (const Point2 p : contour) box.extend(frame.to_frame(p));
    }
    if (box.height() > kMostHatchRows * options.spacing_mm)
      throw std::invalid_argument("a hatch has more than a million rows");
    std::vector<SurfaceRun> runs;
    add_runs(contours, 0, frame, line_mm, runs, options.even_odd);
    const SurfaceHatch how{static_cast<std::uint32_t>(std::lround(options.spacing_mm / line_mm)), kRowCycle, 0, 0,
                           options.rim && turn == 0};
    hatch_runs(frame, line_mm, runs, {&how, 1}, {&options.pen_width_mm, 1}, {&out, 1});
  }
  return out;
}

}  // namespace ligne
