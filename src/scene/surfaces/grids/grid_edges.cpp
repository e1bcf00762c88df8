#include "scene/surfaces/grids/grid_edges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Largest difference between a step of samples and the mean of the steps beside it, relative to the larger of these.
/// Beyond it the formula is examined.
constexpr double kOutOfStep = 0.25;
/// Differences below this fraction of the range of heights are not examined: they would show on no page.
constexpr double kLeastStep = 0x1p-20;

/// Largest number of halvings of the pieces of broken edges, and largest number of their points per sample in a block
/// of rows. If so many edges are broken that the points would exceed this, pieces are halved less often: with a pole
/// between all samples, the drawing is arbitrary anyway.
constexpr int kMostPieceHalvings = 6;
constexpr std::size_t kPointsForSample = 4;

int halvings_of(std::size_t broken, std::size_t samples) {
  int halvings = kMostPieceHalvings;
  while (halvings > 0 && broken << halvings > kPointsForSample * samples) --halvings;
  return halvings;
}

/// Six consecutive samples, the middle two being the ends of the edge; NaN where no sample counts.
using Neighbours = std::array<double, 6>;

bool is_out_of_step(const Neighbours& z, double least) {
  std::array<double, 5> step{};
  for (std::size_t k = 0; k < step.size(); ++k) step[k] = z[k + 1] - z[k];
  const double here = step[2];
  double before = step[1], behind = step[3];
  if (std::isnan(before)) before = behind;
  if (std::isnan(behind)) behind = before;
  if (std::isnan(before)) return true;
  const double larger = std::max(std::abs(before), std::abs(behind));
  if (std::abs(here - (before + behind) / 2) > kOutOfStep * larger + least) return true;
  // Heights rise and fall more steeply than farther out, so a pole may lie between the samples.
  if (!((before > 0) != (behind > 0)) || std::isnan(step[0]) || std::isnan(step[4])) return false;
  return std::abs(before - behind) > std::abs(step[0]) + std::abs(step[4]) + least;
}

/// A quick test of many edges: true wherever is_out_of_step() is true, and for few others. `step` holds the steps of an
/// edge and of those beside it.
inline bool may_be_out_of_step(const std::array<double, 5>& step, double least) {
  const double larger = std::max(std::abs(step[1]), std::abs(step[3]));
  const double off = std::abs(2 * step[2] - step[1] - step[3]) - 2 * kOutOfStep * larger;
  const double peak = std::abs(step[1] - step[3]) - std::abs(step[0]) - std::abs(step[4]);
  return !(off <= least && peak <= least);  // also true if one of them is not a number
}

/// Number of rows read at a time, and of rows before and behind them that are needed to judge their edges.
constexpr std::size_t kRowsAtATime = 32, kRowsBefore = 2, kRowsBehind = 3;

/// Finds the broken edges that begin in a block of rows.
class EdgeFinder {
 public:
  EdgeFinder(const HeightSource& heights, const HeightWindow& window, double range, bool may_jump, std::size_t begin,
             std::size_t end)
      : heights_(heights),
        may_jump_(may_jump),
        window_(window),
        range_(range),
        columns_(heights.x().size()),
        rows_(heights.y().size()),
        begin_(begin),
        end_(end),
        first_(begin - std::min(begin, kRowsBefore)) {
    const std::size_t last = std::min(rows_, end + kRowsBehind);
    raw_.resize((last - first_) * columns_);
    for (std::size_t j = first_; j < last; ++j) {
      heights.read_row(j, std::span(raw_).subspan((j - first_) * columns_, columns_));
    }
    if (std::any_of(raw_.begin(), raw_.end(), [&](double z) { return !window.holds(z); })) {
      counted_ = raw_;
      for (double& z : counted_) z = window.holds(z) ? z : NAN;
    }
    z_ = counted_.empty() ? raw_.data() : counted_.data();
    up_.resize(raw_.size() - columns_);
    for (std::size_t k = 0; k < up_.size(); ++k) up_[k] = z_[k + columns_] - z_[k];
  }

  void find(LineBreaks& breaks, std::vector<BrokenEdge>& found) const {
    const double least = kLeastStep * range_;
    for (std::size_t j = begin_; j < end_; ++j) {
      const double* z = &z_[(j - first_) * columns_];
      for (std::size_t i = 0; i + 1 < columns_; ++i) {
        if (i < kRowsBefore || i + kRowsBehind >= columns_ ||
            may_be_out_of_step(
                {z[i - 1] - z[i - 2], z[i] - z[i - 1], z[i + 1] - z[i], z[i + 2] - z[i + 1], z[i + 3] - z[i + 2]}, least))
          look_at(i, j, false, breaks, found);
      }
      if (j + 1 == rows_) break;
      const bool in_middle = j >= kRowsBefore && j + kRowsBehind < rows_;
      const double* up = in_middle ? &up_[(j - first_) * columns_] : nullptr;
      const auto n = static_cast<std::ptrdiff_t>(columns_);
      for (std::size_t i = 0; i < columns_; ++i, up += in_middle ? 1 : 0) {
        if (!in_middle || may_be_out_of_step({up[-2 * n], up[-n], up[0], up[n], up[2 * n]}, least))
          look_at(i, j, true, breaks, found);
      }
    }
    const int halvings = halvings_of(found.size(), (end_ - begin_) * columns_);
    for (BrokenEdge& edge : found) {
      const auto [a, b] = ends_of(edge.edge.sample % columns_, edge.edge.sample / columns_, edge.edge.along_column);
      breaks.refine(a, b, kLeastHeightPart * range_, halvings, edge.pieces);
    }
  }

 private:
  std::pair<Point3, Point3> ends_of(std::size_t i, std::size_t j, bool along_column) const {
    const std::size_t at = (j - first_) * columns_ + i;
    return {{heights_.x()[i], heights_.y()[j], raw_[at]},
            {heights_.x()[along_column ? i : i + 1], heights_.y()[along_column ? j + 1 : j],
             raw_[at + (along_column ? columns_ : 1)]}};
  }
  void look_at(std::size_t i, std::size_t j, bool along_column, LineBreaks& breaks, std::vector<BrokenEdge>& found) const {
    const std::size_t step = along_column ? columns_ : 1, at = (j - first_) * columns_ + i;
    const auto [a, b] = ends_of(i, j, along_column);
    const bool start = window_.holds(a.z), end = window_.holds(b.z);
    bool may_jump = may_jump_;
    if (start && end && !may_jump_) return;
    if (start && end) {
      const std::size_t place = along_column ? j : i, count = along_column ? rows_ : columns_;
      Neighbours z;
      for (std::size_t k = 0; k < z.size(); ++k) {
        const bool inside = place + k >= kRowsBefore && place + k < count + kRowsBefore;
        z[k] = inside ? z_[at + k * step - kRowsBefore * step] : NAN;
      }
      may_jump = is_out_of_step(z, kLeastStep * range_);
      if (!may_jump) return;
    } else if (!start && !end && !(std::isfinite(a.z) && std::isfinite(b.z) && (a.z < window_.low) != (b.z < window_.low))) {
      return;
    }
    std::vector<LinePiece> pieces = breaks.pieces(a, b, may_jump, kLeastHeightPart * range_);
    const bool is_whole = pieces.size() == 1 && pieces[0].from_start && pieces[0].to_end;
    if (!is_whole) found.push_back({{j * columns_ + i, along_column}, std::move(pieces)});
  }

  const HeightSource& heights_;
  bool may_jump_;
  HeightWindow window_;
  double range_;
  std::size_t columns_, rows_, begin_, end_, first_;
  std::vector<double> raw_;      ///< from row `first_` on
  std::vector<double> counted_;  ///< NaN for samples that do not count; empty if all do
  const double* z_ = nullptr;    ///< counted_, or raw_ if all count
  std::vector<double> up_;       ///< steps of z_ to the next row
};

}  // namespace

SampleSpan span_of_samples(const HeightSource& heights, const HeightWindow& window) {
  const auto of_rows = [&](std::size_t begin, std::size_t end) {
    SampleSpan span;
    std::vector<double> z(heights.x().size());
    for (std::size_t j = begin; j < end; ++j) {
      heights.read_row(j, z);
      for (std::size_t i = 0; i < z.size(); ++i) {
        if (!window.holds(z[i])) {
          span.all = false;
          continue;
        }
        const Point2 at{heights.x()[i], heights.y()[j]};
        if (!span.any || z[i] < span.low) span.low = z[i], span.lowest = at;
        if (!span.any || z[i] > span.high) span.high = z[i], span.highest = at;
        span.any = true;
      }
    }
    return span;
  };
  const auto joined = [](SampleSpan a, const SampleSpan& b) {
    a.all = a.all && b.all;
    if (b.any && (!a.any || b.low < a.low)) a.low = b.low, a.lowest = b.lowest;
    if (b.any && (!a.any || b.high > a.high)) a.high = b.high, a.highest = b.highest;
    a.any = a.any || b.any;
    return a;
  };
  return parallel_reduce(heights.y().size(), kRowsAtATime, SampleSpan{}, of_rows, joined);
}

BrokenEdges find_broken_edges(const HeightSource& heights, const HeightFunction& function, const HeightWindow& window,
                              double range) {
  const std::size_t rows = heights.y().size();
  std::vector<std::vector<BrokenEdge>> found(block_count(rows, kRowsAtATime));
  std::vector<HeightWindow> poles(found.size());
  parallel_blocks(rows, kRowsAtATime, [&](std::size_t begin, std::size_t end) {
    const EdgeFinder finder(heights, window, range, !function.is_continuous(), begin, end);
    function.use([&](HeightFunction::At& at) {
      LineBreaks breaks(at, window);
      finder.find(breaks, found[begin / kRowsAtATime]);
      poles[begin / kRowsAtATime] = breaks.poles();
    });
  });
  BrokenEdges all;
  for (std::size_t block = 0; block < found.size(); ++block) {
    std::move(found[block].begin(), found[block].end(), std::back_inserter(all.edges));
    all.poles = {std::min(all.poles.low, poles[block].low), std::max(all.poles.high, poles[block].high)};
  }
  return all;
}

}  // namespace ligne
