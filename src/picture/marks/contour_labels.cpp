// Labels lines from the longest to the shortest. Divides each into stretches of equal length, and gives each stretch
// the best free place, tried at distances of half a capital. The cost of a place grows with the bend of the line, the
// steepness of the text and the length of the thinner lines that it cuts.

#include "picture/marks/contour_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "picture/marks/box_grid.hpp"
#include "picture/marks/halos.hpp"
#include "view/axes/ticks.hpp"

namespace ligne {
namespace {

// Adjustable, in heights of capitals.
constexpr double kGapBeside = 0.5, kGapAbove = 0.3;  ///< white around a label
constexpr double kMostBend = 0.3;                    ///< largest distance of the line from the middle of its label
constexpr double kTrials = 0.5;                      ///< distance of successive trials
constexpr double kLeastLine = 3;                     ///< shortest line with a label, in lengths of the label
/// Largest error of a label, as part of the step between heights: a fiftieth of what the eye distinguishes.
constexpr double kLabelError = 0.005;
/// Heights with more decimals than this, or larger than kLongestPlainHeight, are written with a power of ten.
constexpr int kMostLabelDigits = 9;
constexpr double kLongestPlainHeight = 1e10;
/// Neighbouring labels that are nearly parallel are read in one direction, so long as none is upside down. The
/// constants are the largest distance of neighbours in heights of capitals, the largest angle between them, and the
/// angle by which steep labels may lean beyond upright, both in degrees.
constexpr double kNeighbourReach = 20, kAlongDegrees = 40, kBeyondUpright = 25;
// Costs, in bends.
constexpr double kSteepCost = 0.15, kOffMiddleCost = 0.1, kCrossedCost = 1;
constexpr double kFrameCost = 10;  ///< for a line that stays, such as a line of the box, instead of kCrossedCost

Rect bounds(const TextBox& box) {
  Rect rect;
  for (const Point2 p : box.corners()) rect.extend(p);
  return rect;
}

Rect bounds(Point2 a, Point2 b) { return {glm::min(a, b), glm::max(a, b)}; }

/// The part of the segment that is inside the box, as fractions.
std::optional<std::array<double, 2>> inside(const TextBox& box, Point2 a, Point2 b) {
  double from = 0, to = 1;
  const auto axes = box.axes();
  for (int k = 0; k < 2; ++k) {
    const double half = k == 0 ? box.half.x : box.half.y;
    const double pa = glm::dot(a - box.center, axes[k]), pb = glm::dot(b - box.center, axes[k]);
    if (std::max(pa, pb) <= -half || std::min(pa, pb) >= half) return std::nullopt;
    if (pa == pb) continue;
    const double s = (-half - pa) / (pb - pa), t = (half - pa) / (pb - pa);
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  if (!(from < to)) return std::nullopt;
  return std::array<double, 2>{from, to};
}

/// Whether labels cut gaps into the layer. The shape itself and the marks around the picture stay.
bool is_subordinate(const Layer& layer) {
  constexpr std::string_view kStay[] = {"outline", "border", "intersection", "axes", "text"};
  return std::find(std::begin(kStay), std::end(kStay), layer.name) == std::end(kStay);
}

/// A contour line, or one that stays, with its arc length at each point.
struct Line {
  std::span<const Point2> points;
  std::vector<double> at;
  double height = 0;
  bool labelled = false;
  bool stays = false;  ///< it makes no gap for labels

  double length() const { return at.back(); }
  Point2 point(double s) const {
    const auto next = std::upper_bound(at.begin() + 1, at.end() - 1, s);
    const auto i = static_cast<std::size_t>(next - at.begin());
    const double extent = at[i] - at[i - 1];
    return extent > 0 ? points[i - 1] + (points[i] - points[i - 1]) * ((s - at[i - 1]) / extent) : points[i];
  }
};

struct Place {
  TextItem label;
  TextBox box;
  double cost = 0;
};

class Labelling {
 public:
  Labelling(const Drawing& drawing, const ContourLabelOptions& options, std::span<const TextItem> others)
      : options_(options), segments_(kCellHeights * options.height_mm), label_grid_(kCellHeights * options.height_mm) {
    collect(drawing);
    for (const TextItem& item : others) {
      add_box(text_box(item, text_extent(item.text, item.height_mm, options.style)));
    }
  }

  std::vector<TextItem> run() {
    std::vector<std::uint32_t> order = indices_where(lines_.size(), [&](std::size_t i) { return lines_[i].labelled; });
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::uint32_t i) { return lines_[i].length(); });
    for (const std::uint32_t i : order) label(i);
    agree_directions();
    return std::move(labels_);
  }

 private:
  static constexpr double kCellHeights = 4;

  void collect(const Drawing& drawing);
  void collect_line(std::span<const Point2> points, Line line);
  void label(std::uint32_t number);
  void agree_directions();
  std::optional<Place> place(std::uint32_t number, double s, const std::string& text, double width) const;
  std::optional<double> cost_of_crossing(std::uint32_t number, double s, const Place& place) const;
  void add_box(const TextBox& box) {
    label_grid_.add(bounds(box), static_cast<std::uint32_t>(boxes_.size()));
    boxes_.push_back(box);
  }

  const ContourLabelOptions& options_;
  std::vector<Line> lines_;
  double step_ = 0;  ///< smallest difference of two heights
  struct Segment {
    std::uint32_t line, index;
  };
  std::vector<Segment> all_segments_;
  BoxGrid segments_, label_grid_;
  std::vector<TextBox> boxes_;
  std::vector<TextItem> labels_;
};

void Labelling::collect(const Drawing& drawing) {
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(drawing.layers, [&](const Layer& layer) { return layer.height && layer.name == name; });
  };
  const bool index_only = options_.index_only && has("contour-index"), on_surface = has("contour") || has("contour-index");
  std::vector<double> heights;
  for (const Layer& layer : drawing.layers) {
    const bool stays = !is_subordinate(layer);
    if (!stays && (!layer.height || on_surface == (layer.name == "contour-base"))) continue;
    if (!stays) heights.push_back(*layer.height);
    const bool labelled = !stays && (!index_only || layer.name == "contour-index");
    for (std::size_t i = 0; i < layer.lines.size(); ++i)
      collect_line(layer.lines[i], {layer.lines[i], {0}, layer.height.value_or(0), labelled, stays});
  }
  std::ranges::sort(heights);
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const double step = heights[i] - heights[i - 1];
    if (step > 0 && (step_ == 0 || step < step_)) step_ = step;
  }
}

void Labelling::collect_line(std::span<const Point2> points, Line line) {
  if (points.size() < 2) return;
  for (std::size_t k = 1; k < points.size(); ++k) {
    line.at.push_back(line.at.back() + glm::distance(points[k - 1], points[k]));
    segments_.add(bounds(points[k - 1], points[k]), static_cast<std::uint32_t>(all_segments_.size()));
    all_segments_.push_back({static_cast<std::uint32_t>(lines_.size()), static_cast<std::uint32_t>(k - 1)});
  }
  lines_.push_back(std::move(line));
}

/// Begins with the labels nearest to horizontal, which are upright. Each steeper one follows its nearest neighbour.
void Labelling::agree_directions() {
  std::vector<std::size_t> order(labels_.size());
  std::iota(order.begin(), order.end(), 0);
  const auto steepness = [&](std::size_t i) { return std::abs(labels_[i].rotation_degrees); };
  std::ranges::stable_sort(order, {}, steepness);
  const double reach = kNeighbourReach * options_.height_mm;
  BoxGrid done(reach);
  for (const std::size_t k : order) {
    const Point2 at = labels_[k].at;
    double& degrees = labels_[k].rotation_degrees;
    if (std::abs(degrees) >= 90 - kBeyondUpright) {
      double nearest = reach, followed = 90;  // without neighbours, a label is read upwards
      done.any_near({at - Point2{reach, reach}, at + Point2{reach, reach}}, [&](std::uint32_t n) {
        const double apart = glm::distance(labels_[n].at, at), other = labels_[n].rotation_degrees;
        if (apart < nearest && std::abs(std::remainder(other - degrees, 180)) <= kAlongDegrees) {
          nearest = apart;
          followed = other;
        }
        return false;
      });
      if (std::abs(std::remainder(degrees - followed, 360)) > 90) degrees += degrees > 0 ? -180 : 180;
    }
    done.add({at, at}, static_cast<std::uint32_t>(k));
  }
}

void Labelling::label(std::uint32_t number) {
  const Line& line = lines_[number];
  const std::string text = height_text(line.height, step_, options_.decades);
  const double width = text_extent(text, options_.height_mm, options_.style).width + 2 * kGapBeside * options_.height_mm;
  if (line.length() < kLeastLine * width) return;
  const double stretches = std::max(1.0, std::floor(line.length() / options_.distance_mm));
  const double stretch = line.length() / stretches;
  for (double k = 0; k < stretches; ++k) {
    std::optional<Place> best;
    const double middle = (k + 0.5) * stretch;
    const double from = std::max(k * stretch, width / 2), to = std::min((k + 1) * stretch, line.length() - width / 2);
    for (double s = from; s <= to; s += kTrials * options_.height_mm) {
      std::optional<Place> found = place(number, s, text, width);
      if (!found) continue;
      found->cost += kOffMiddleCost * std::abs(s - middle) / stretch;
      if (!best || found->cost < best->cost) best = std::move(found);
    }
    if (!best) continue;
    labels_.push_back(best->label);
    add_box(best->box);
  }
}

/// Makes a label centred at the arc length `s` of the line; none if it is not allowed there.
std::optional<Place> Labelling::place(std::uint32_t number, double s, const std::string& text, double width) const {
  const Line& line = lines_[number];
  const Point2 a = line.point(s - width / 2), b = line.point(s + width / 2), middle = line.point(s);
  const double chord = glm::distance(a, b), height = options_.height_mm;
  if (!(chord > 0)) return std::nullopt;
  const Point2 along = (b - a) / chord, across{-along.y, along.x};
  double bend = std::max(std::abs(glm::dot(a - middle, across)), std::abs(glm::dot(b - middle, across)));
  const auto first = std::upper_bound(line.at.begin(), line.at.end(), s - width / 2),
             last = std::lower_bound(line.at.begin(), line.at.end(), s + width / 2);
  for (auto p = first; p < last; ++p) {
    bend = std::max(bend, std::abs(glm::dot(line.points[static_cast<std::size_t>(p - line.at.begin())] - middle, across)));
  }
  if (bend > kMostBend * height) return std::nullopt;
  double degrees = std::atan2(-along.y, along.x) * 180 / std::numbers::pi;
  if (degrees > 90) degrees -= 180;
  if (degrees <= -90) degrees += 180;
  Place place{{text, middle, height, TextAcross::center, TextUp::middle, degrees}, {}, bend / (kMostBend * height)};
  place.box = label_box(place.label, options_.style);
  for (const Point2 p : place.box.corners()) {
    if (p.x < options_.page.min.x || p.x > options_.page.max.x || p.y < options_.page.min.y || p.y > options_.page.max.y)
      return std::nullopt;
  }
  if (label_grid_.any_near(bounds(place.box), [&](std::uint32_t i) { return overlap(boxes_[i], place.box); }))
    return std::nullopt;
  const std::optional<double> crossed = cost_of_crossing(number, s, place);
  if (!crossed) return std::nullopt;
  place.cost += *crossed + kSteepCost * std::abs(std::sin(degrees * std::numbers::pi / 180));
  return place;
}

/// The cost of the lines that cross the box; none if one of them has labels too, or is this line on its way back.
std::optional<double> Labelling::cost_of_crossing(std::uint32_t number, double s, const Place& place) const {
  const double reach = place.box.half.x * 1.5;
  double crossed = 0;
  const bool refused = segments_.any_near(bounds(place.box), [&](std::uint32_t i) {
    const auto [other, index] = all_segments_[i];
    const Line& o = lines_[other];
    if (other == number && o.at[index] < s + reach && o.at[index + 1] > s - reach) return false;
    const auto part = inside(place.box, o.points[index], o.points[index + 1]);
    if (!part) return false;
    crossed += (o.stays ? kFrameCost : 1) * ((*part)[1] - (*part)[0]) * (o.at[index + 1] - o.at[index]);
    return o.labelled || other == number;
  });
  if (refused) return std::nullopt;
  return kCrossedCost * crossed / options_.height_mm;
}

}  // namespace

std::string height_text(double height, double step, bool decades) {
  if (decades) {
    const std::vector<Tick> ticks = round_ticks(TickScale::decades, height, height, 1);
    if (!ticks.empty() && std::abs(height - std::round(height)) < 0x1p-40) return ticks.front().label;
    height = std::pow(10.0, height);
    step = 0;
  }
  char text[64];
  int digits = 0;
  const auto is_reported = [&] {
    std::snprintf(text, sizeof text, "%.*f", digits, height);
    return std::abs(std::strtod(text, nullptr) - height) <= kLabelError * step;
  };
  while (digits <= kMostLabelDigits && !is_reported()) ++digits;
  if (step <= 0 || digits > kMostLabelDigits || std::abs(height) >= kLongestPlainHeight) {
    std::snprintf(text, sizeof text, "%.10g", height == 0 ? 0 : height);
    constexpr std::size_t kShort = 6;
    if (std::string_view(text).size() > kShort) std::snprintf(text, sizeof text, "%.5g", height);
  }
  // Labels are written as the numbers of an axis are.
  const double shown = std::strtod(text, nullptr);
  const std::vector<Tick> number = round_ticks(TickScale::linear, shown, shown, 1);
  return number.empty() ? text : number.front().label;
}

TextBox label_box(const TextItem& label, TextStyle style) {
  TextBox box = text_box(label, text_extent(label.text, label.height_mm, style));
  // The box is centred on the point of the line, so that the line leaves it through the short sides.
  box.half.x += kGapBeside * label.height_mm;
  box.half.y = std::max(box.half.y, label.height_mm / 2) + kGapAbove * label.height_mm;
  return box;
}

Polylines without_boxes(const Polylines& lines, std::span<const TextBox> boxes) {
  if (boxes.empty()) return lines;
  // Cells have the mean size of the boxes: among the marks of many points, one long label must not make them large.
  double size = 0;
  for (const TextBox& box : boxes) size += (bounds(box).width() + bounds(box).height()) / 2;
  BoxGrid grid(size / static_cast<double>(boxes.size()));
  for (std::uint32_t i = 0; i < boxes.size(); ++i) grid.add(bounds(boxes[i]), i);
  Polylines kept;
  std::vector<Point2> piece;
  std::vector<std::array<double, 2>> cuts;
  const auto flush = [&] {
    if (piece.size() > 1) kept.add(piece);
    piece.clear();
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::span<const Point2> line = lines[i];
    const bool closed = line.size() > 2 && line.front() == line.back();
    const std::size_t first_kept = kept.size();
    bool cut = false;
    if (!line.empty()) piece.push_back(line.front());
    bool whole_start = true;
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Point2 a = line[k - 1], b = line[k];
      cuts.clear();
      grid.any_near(bounds(a, b), [&](std::uint32_t n) {
        const auto part = inside(boxes[n], a, b);
        if (part) cuts.push_back(*part);
        return false;
      });
      std::ranges::sort(cuts);
      cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
      for (const auto& [from, to] : cuts) {
        cut = true;
        if (k == 1 && from <= 0) whole_start = false;
        if (from > 0 && !piece.empty()) piece.push_back(a + (b - a) * from);
        flush();
        if (to < 1) piece.push_back(a + (b - a) * to);
      }
      if (cuts.empty() || cuts.back()[1] < 1) piece.push_back(b);
    }
    // The two ends of a ring that is cut elsewhere form one piece.
    if (closed && cut && whole_start && piece.size() > 1 && kept.size() > first_kept) {
      Polylines joined;
      const std::span<const Point2> start = kept[first_kept];
      piece.insert(piece.end(), start.begin() + 1, start.end());
      for (std::size_t k = 0; k < kept.size(); ++k) {
        if (k != first_kept) joined.add(kept[k]);
      }
      kept = std::move(joined);
    }
    flush();
  }
  return kept;
}

void make_gaps(Drawing& drawing, std::span<const TextBox> boxes) {
  for (Layer& layer : drawing.layers) {
    if (is_subordinate(layer)) layer.lines = without_boxes(layer.lines, boxes);
  }
  std::erase_if(drawing.layers, [](const Layer& layer) { return layer.lines.size() == 0; });
}

std::vector<TextItem> label_contours(Drawing& drawing, const ContourLabelOptions& options,
                                     std::span<const TextItem> others) {
  std::vector<TextItem> labels = Labelling(drawing, options, others).run();
  std::vector<TextBox> boxes;
  boxes.reserve(labels.size());
  for (const TextItem& label : labels) boxes.push_back(label_box(label, options.style));
  make_gaps(drawing, boxes);
  set_off_from_fills(drawing, labels, options.style);
  return labels;
}

}  // namespace ligne
