#include "report/stroke_difference.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "geometry/search/line_cells.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

paper::Segment segment_of(const StrokeModel& model, const Stroke& s) {
  return {model.lattice.to_mm(s.from), model.lattice.to_mm(s.to)};
}

/// A grid over the visible strokes of a drawing. Each cell lists the strokes that pass through it.
class StrokesByCell {
 public:
  StrokesByCell(const StrokeModel& model, double tolerance_mm)
      : tolerance_steps_(tolerance_mm / model.lattice.step_mm), cells_(cell_of(model, tolerance_steps_)) {
    for (std::uint32_t i = 0; i < model.strokes.size(); ++i) {
      if (model.strokes[i].visible) cells_.insert(i, model.strokes[i].from, model.strokes[i].to);
    }
  }

  /// Returns all strokes that may lie along this one, each once, in ascending order.
  const std::vector<std::uint32_t>& near(const Stroke& stroke) {
    found_.clear();
    cells_.near(stroke.from, stroke.to, 2 * tolerance_steps_, [&](std::uint32_t i) {
      found_.push_back(i);
      return false;
    });
    std::ranges::sort(found_);
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return found_;
  }

 private:
  /// About the mean length of a stroke, or the mean distance of strokes if that is smaller.
  static double cell_of(const StrokeModel& model, double tolerance_steps) {
    constexpr double kLeastInTolerances = 8;  // keeps the reach of the tolerance small against the cell
    LatticePoint low{kLatticeLimit, kLatticeLimit}, high{-kLatticeLimit, -kLatticeLimit};
    for (const Stroke& s : model.strokes) {
      low = {std::min({low.x, s.from.x, s.to.x}), std::min({low.y, s.from.y, s.to.y})};
      high = {std::max({high.x, s.from.x, s.to.x}), std::max({high.y, s.from.y, s.to.y})};
    }
    const double side = std::max(double(high.x) - low.x, double(high.y) - low.y);
    const double apart = side / std::sqrt(static_cast<double>(model.strokes.size()));
    return walked_cell(model.strokes, std::max(apart, kLeastInTolerances * tolerance_steps));
  }

  double tolerance_steps_;
  LineCells cells_;
  std::vector<std::uint32_t> found_;
};

/// The visible strokes of a drawing, looked up by their two ends. Most strokes are equal in two drawings of one scene.
/// So few strokes need a comparison with all strokes near them, even where thousands run side by side or through one
/// point.
class StrokesByEnds {
 public:
  /// Drawings on different lattices share no stroke.
  StrokesByEnds(const StrokeModel& model, const Lattice& lattice, bool by_level) : by_level_(by_level) {
    if (model.lattice.step_mm != lattice.step_mm || model.lattice.origin_mm != lattice.origin_mm) return;
    for (const Stroke& s : model.strokes) {
      if (s.visible) known_.push_back(key(s));
    }
    std::sort(known_.begin(), known_.end());
  }
  bool hold(const Stroke& s) const { return std::binary_search(known_.begin(), known_.end(), key(s)); }

 private:
  using Key = std::array<std::int32_t, 5>;
  Key key(const Stroke& s) const {
    const std::array<std::int32_t, 2> from{s.from.x, s.from.y}, to{s.to.x, s.to.y};
    const auto& [first, second] = std::minmax(from, to);
    return {first[0], first[1], second[0], second[1], by_level_ ? s.level : 0};
  }

  bool by_level_;
  std::vector<Key> known_;
};

}  // namespace

std::vector<paper::Segment> parts_missing(const StrokeModel& of, const StrokeModel& in, double tolerance_mm,
                                          bool same_level) {
  const StrokesByEnds same(in, of.lattice, same_level);
  std::optional<StrokesByCell> others;
  std::vector<paper::Segment> missing;
  for (const Stroke& stroke : of.strokes) {
    if (!stroke.visible || same.hold(stroke)) continue;
    if (!others) others.emplace(in, tolerance_mm);
    const paper::Segment segment = segment_of(of, stroke);
    if (segment.length() <= tolerance_mm) continue;
    std::vector<paper::Range> covered;
    for (const std::uint32_t i : others->near(stroke)) {
      const Stroke& other = in.strokes[i];
      if (same_level && other.level != stroke.level) continue;
      if (const auto range = paper::along(segment, segment_of(in, other), tolerance_mm)) covered.push_back(*range);
    }
    for (const paper::Range& gap : paper::gaps(std::move(covered), 0, segment.length())) {
      if (gap.length() > tolerance_mm) missing.push_back({segment.at(gap.from), segment.at(gap.to)});
    }
  }
  return missing;
}

StrokeDifference difference_of(const StrokeModel& first, const StrokeModel& second, double tolerance_mm) {
  StrokeDifference difference{parts_missing(first, second, tolerance_mm), parts_missing(second, first, tolerance_mm)};
  for (const auto* parts : {&difference.only_first, &difference.only_second}) {
    for (const paper::Segment& part : *parts) {
      difference.length_mm += part.length();
      difference.longest_mm = std::max(difference.longest_mm, part.length());
    }
  }
  return difference;
}

}  // namespace ligne
