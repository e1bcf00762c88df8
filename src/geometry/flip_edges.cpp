#include "geometry/flip_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;
constexpr Index kOutside = 0xffffffffu;

/// Largest number of flips: per triangle, and in all. Adjustable. A grid of holes needs flips in proportion to the side
/// of the grid (52 per triangle at a hundred thousand corners), and a square with its corners on the sides needs many
/// more. Most shapes need one flip per two triangles.
constexpr std::size_t kFlipsPerTriangle = 64, kMostFlips = 10'000'000;

/// Error bound of the in-circle determinant, relative to the sum of the sizes of its terms (Shewchuk 1997, section
/// 4.4). A smaller determinant decides nothing. So only edges that surely are not Delaunay are flipped, and no edge is
/// flipped back and forth.
constexpr double kCircleErrorBound =
    (10 + 48 * std::numeric_limits<double>::epsilon()) * (std::numeric_limits<double>::epsilon() / 2);

/// Whether d surely lies inside the circle through a, b, c, which turn counter-clockwise.
bool is_inside_circle(Point2 a, Point2 b, Point2 c, Point2 d) {
  a -= d, b -= d, c -= d;
  const double bc = b.x * c.y, cb = c.x * b.y, ca = c.x * a.y, ac = a.x * c.y, ab = a.x * b.y, ba = b.x * a.y;
  const double la = a.x * a.x + a.y * a.y, lb = b.x * b.x + b.y * b.y, lc = c.x * c.x + c.y * c.y;
  const double size =
      (std::abs(bc) + std::abs(cb)) * la + (std::abs(ca) + std::abs(ac)) * lb + (std::abs(ab) + std::abs(ba)) * lc;
  return la * (bc - cb) + lb * (ca - ac) + lc * (ab - ba) > kCircleErrorBound * size;
}

/// Flips edges. Side k of triangle t, from its corner k to the next one, has the number 3 t + k.
class Flipper {
 public:
  Flipper(const std::vector<Point2>& positions, std::vector<Triple>& triangles)
      : p_(positions), t_(triangles), across_(3 * triangles.size(), kOutside) {
    find_neighbours();
  }

  void run() {
    std::vector<Index> waiting;
    waiting.reserve(across_.size());
    for (Index side = static_cast<Index>(across_.size()); side-- > 0;) {
      if (across_[side] != kOutside && side < across_[side]) waiting.push_back(side);
    }
    std::size_t flips_left = std::min(kFlipsPerTriangle * t_.size(), kMostFlips);
    while (!waiting.empty() && flips_left > 0) {
      const Index side = waiting.back();
      waiting.pop_back();
      if (!is_to_be_flipped(side)) continue;
      --flips_left;
      const Index other = across_[side];
      flip(side);
      for (const Index s : {side, other, turned(side, 1), turned(other, 1), turned(side, 2), turned(other, 2)}) {
        if (across_[s] != kOutside) waiting.push_back(s);
      }
    }
  }

 private:
  static Index turned(Index side, Index by) { return side - side % 3 + (side + by) % 3; }
  Index from(Index side) const { return t_[side / 3][side % 3]; }

  void find_neighbours() {
    // Sides, sorted by the lower of their two positions.
    std::vector<Index> begin(p_.size() + 1, 0);
    const auto lower = [&](Index side) { return std::min(from(side), from(turned(side, 1))); };
    const auto sides = static_cast<Index>(across_.size());
    for (Index side = 0; side < sides; ++side) ++begin[lower(side) + 1];
    for (std::size_t i = 0; i < p_.size(); ++i) begin[i + 1] += begin[i];
    std::vector<std::pair<Index, Index>> filed(sides);  // the higher position and the side
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    for (Index side = 0; side < sides; ++side) {
      filed[next[lower(side)]++] = {std::max(from(side), from(turned(side, 1))), side};
    }
    for (std::size_t i = 0; i < p_.size(); ++i) {
      std::sort(filed.begin() + begin[i], filed.begin() + begin[i + 1]);
      for (Index k = begin[i]; k + 1 < begin[i + 1]; ++k) {
        if (filed[k].first != filed[k + 1].first) continue;
        across_[filed[k].second] = filed[k + 1].second;
        across_[filed[k + 1].second] = filed[k].second;
      }
    }
  }

  /// Whether the side a b of the triangles a b c and b a d is to become c d: it is not Delaunay, and the two triangles
  /// form a convex quadrilateral.
  bool is_to_be_flipped(Index side) const {
    const Index other = across_[side];
    if (other == kOutside) return false;
    const Point2 a = p_[from(side)], b = p_[from(other)], c = p_[from(turned(side, 2))], d = p_[from(turned(other, 2))];
    return is_inside_circle(a, b, c, d) && orientation_sign(a, d, c) > 0 && orientation_sign(b, c, d) > 0;
  }

  void join(Index side, Index other) {
    across_[side] = other;
    if (other != kOutside) across_[other] = side;
  }

  /// Replaces a b c and b a d by d c a (in the place of a b c) and c d b.
  void flip(Index side) {
    const Index other = across_[side];
    const Index a = from(side), b = from(other), c = from(turned(side, 2)), d = from(turned(other, 2));
    const Index bc = across_[turned(side, 1)], ca = across_[turned(side, 2)];
    const Index ad = across_[turned(other, 1)], db = across_[turned(other, 2)];
    const auto set = [&](Index first, Index u, Index v, Index w) {
      Triple& t = t_[first / 3];
      t[first % 3] = u, t[(first + 1) % 3] = v, t[(first + 2) % 3] = w;
    };
    set(side, d, c, a);
    set(other, c, d, b);
    join(side, other);
    join(turned(side, 1), ca);
    join(turned(side, 2), ad);
    join(turned(other, 1), db);
    join(turned(other, 2), bc);
  }

  const std::vector<Point2>& p_;
  std::vector<Triple>& t_;
  std::vector<Index> across_;  ///< per side: the coincident side of the neighbouring triangle
};

}  // namespace

void flip_to_delaunay(const std::vector<Point2>& positions, std::vector<Triple>& triangles) {
  Flipper(positions, triangles).run();
}

}  // namespace ligne
