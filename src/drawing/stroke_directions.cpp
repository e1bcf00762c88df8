#include "drawing/stroke_directions.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/stroke_overlap.hpp"

namespace ligne::stroke_directions {

bool are_crossing(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of) {
  constexpr double kEndsApart = 4;  // adjustable: so many mean distances of ends is a stroke long
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
  return sum / n > kEndsApart * std::sqrt(area / (2 * n));
}

}  // namespace ligne::stroke_directions
