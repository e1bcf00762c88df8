#include "linework/overlaps/stroke_directions.hpp"

#include <algorithm>
#include <cmath>

#include "linework/overlaps/stroke_overlap.hpp"

namespace ligne::stroke_directions {
namespace {

/// Whether, in a sample, one in kOneIn strokes has kDenseEnds ends in the square around it. The mean distance of all ends
/// does not show a dense place on a large page.
bool are_dense(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of) {
  // Adjustable.
  constexpr std::size_t kSampleQueries = 256, kEnds = 8192, kOneIn = 4;
  constexpr double kDenseEnds = 64, kLeastSampled = 4;
  const auto sampled = [&](std::size_t k, std::size_t count) -> const Stroke& {
    return strokes[of[of.size() < count ? k : k * of.size() / count]];
  };
  std::vector<LatticePoint> ends;
  for (std::size_t k = 0; k < std::min(of.size(), kEnds); ++k) ends.push_back(sampled(k, kEnds).from);
  std::sort(ends.begin(), ends.end());
  const double each = static_cast<double>(2 * of.size()) / static_cast<double>(ends.size());
  const double least = std::max(kDenseEnds / each, kLeastSampled);
  const std::size_t queries = std::min(of.size(), kSampleQueries);
  std::size_t dense = 0;
  for (std::size_t k = 0; k < queries; ++k) {
    const Stroke& s = sampled(k, kSampleQueries);
    const double x = (double(s.from.x) + s.to.x) / 2, y = (double(s.from.y) + s.to.y) / 2;
    const double half = length(s.from, s.to) / 2;
    const auto first = std::partition_point(ends.begin(), ends.end(), [&](LatticePoint p) { return p.x - x < -half; });
    const auto last = std::partition_point(first, ends.end(), [&](LatticePoint p) { return p.x - x <= half; });
    const auto inside = [&](LatticePoint p) { return std::abs(p.y - y) <= half; };
    if (static_cast<double>(std::count_if(first, last, inside)) >= least) ++dense;
  }
  return kOneIn * dense >= queries;
}

}  // namespace

bool are_crossing(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of) {
  // Adjustable: strokes cross if their mean length exceeds this many mean distances of ends.
  constexpr double kEndsApart = 4;
  LatticePoint low{kLatticeLimit, kLatticeLimit}, high{-kLatticeLimit, -kLatticeLimit};
  double sum = 0;
  for (const std::uint32_t i : of) {
    const Stroke& s = strokes[i];
    sum += length(s.from, s.to);
    low = {std::min({low.x, s.from.x, s.to.x}), std::min({low.y, s.from.y, s.to.y})};
    high = {std::max({high.x, s.from.x, s.to.x}), std::max({high.y, s.from.y, s.to.y})};
  }
  const double n = static_cast<double>(of.size());
  const double area = (double(high.x) - low.x + 1) * (double(high.y) - low.y + 1);
  return sum / n > kEndsApart * std::sqrt(area / (2 * n)) || are_dense(strokes, of);
}

}  // namespace ligne::stroke_directions
