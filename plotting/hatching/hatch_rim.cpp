/// Overlapping intervals of neighbouring lines are parts of one area. Each interval has a stroke at its left end and
/// one at its right end, which continue to the next line where one interval meets one. Where an area begins or ends,
/// the two strokes are joined across the interval. Where an area forks, or two parts come together, strokes are joined
/// across the gap, on the line that is inside.

#include "plotting/hatching/hatch_rim.hpp"

#include <utility>

namespace ligne {
namespace {

using Line = std::vector<HatchInterval>;

/// Per interval of a line: the first and the last interval of the other line that overlaps it; none if last < first.
struct Range {
  std::int32_t first = 0, last = -1;
};

std::vector<Range> overlaps(const Line& line, const Line& other) {
  std::vector<Range> ranges(line.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    while (k < other.size() && other[k].to < line[i].from) ++k;
    ranges[i].first = static_cast<std::int32_t>(k);
    std::size_t end = k;
    while (end < other.size() && other[end].from <= line[i].to) ++end;
    ranges[i].last = static_cast<std::int32_t>(end) - 1;
  }
  return ranges;
}

class Rim {
 public:
  Rim(const HatchFrame& frame, Polylines& out) : frame_(frame), out_(out) {}

  void step(const Line& before, double v_before, const Line& line, double v);

 private:
  using Stroke = std::vector<Point2>;  ///< frame

  void finish(Stroke& stroke) {
    if (stroke.size() > 1) {
      for (Point2& p : stroke) p = frame_.to_page(p);
      out_.add(stroke);
    }
    stroke.clear();
  }

  const HatchFrame& frame_;
  Polylines& out_;
  std::vector<Stroke> left_, right_;  ///< per interval of the line before
};

void Rim::step(const Line& before, double v_before, const Line& line, double v) {
  const std::vector<Range> below = overlaps(before, line), above = overlaps(line, before);
  std::vector<Stroke> left(line.size()), right(line.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Range& parts = below[i];
    if (parts.last < parts.first) {  // the area ends
      right_[i].push_back({before[i].from, v_before});
      finish(right_[i]);
      finish(left_[i]);
      continue;
    }
    const auto head = static_cast<std::size_t>(parts.first), tail = static_cast<std::size_t>(parts.last);
    if (above[head].first == static_cast<std::int32_t>(i)) left[head] = std::move(left_[i]);
    if (above[tail].last == static_cast<std::int32_t>(i)) right[tail] = std::move(right_[i]);
    for (std::size_t k = head; k < tail; ++k) {  // it forks
      left[k + 1] = {{line[k].to, v}, {line[k].to, v_before}, {line[k + 1].from, v_before}};
    }
  }
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Range& parts = above[k];
    if (parts.last < parts.first) left[k] = {{line[k].to, v}};  // an area begins
    for (std::int32_t i = parts.first; i < parts.last; ++i) {   // two come together
      Stroke& stroke = right_[static_cast<std::size_t>(i)];
      const HatchInterval &one = before[static_cast<std::size_t>(i)], &other = before[static_cast<std::size_t>(i) + 1];
      stroke.insert(stroke.end(), {{one.to, v}, {other.from, v}, {other.from, v_before}});
      finish(stroke);
      finish(left_[static_cast<std::size_t>(i) + 1]);
    }
    left[k].push_back({line[k].from, v});
    right[k].push_back({line[k].to, v});
  }
  left_ = std::move(left);
  right_ = std::move(right);
}

}  // namespace

void trace_rim(std::span<const std::vector<HatchInterval>> lines, std::int32_t first, const HatchFrame& frame,
               double line_mm, Polylines& out) {
  Rim rim(frame, out);
  static const Line kNone;
  for (std::size_t i = 0; i <= lines.size(); ++i) {
    const double v = (static_cast<double>(first) + static_cast<double>(i)) * line_mm;
    rim.step(i == 0 ? kNone : lines[i - 1], v - line_mm, i == lines.size() ? kNone : lines[i], v);
  }
}

}  // namespace ligne
