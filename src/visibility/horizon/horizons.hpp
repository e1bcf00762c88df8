#pragma once
/// What hides, in the two forms that the sweep over the grid works with.

#include <array>
#include <cstddef>
#include <vector>

#include "visibility/horizon/coverage.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/sight_line.hpp"
#include "visibility/horizon/upright_lines.hpp"

namespace ligne::horizon {

/// A segment is upright on the drawing plane when its ends are no farther apart across it than this part of the picture.
inline constexpr double kUprightPart = 0x1p-42;

/// Where a segment can be seen: above all that is nearer, below it, or either. A surface that rises in the picture behind
/// the line of sight shows itself above its nearer parts only.
enum class Against : std::uint8_t { upper, lower, both };

/// Which sides of an upright line are looked at. It is hidden where all of them are covered; curves that hide have no sides.
enum class LineSides : std::uint8_t { left, right, both, none };

/// What is seen of an upright line up to an end but for a rounding is seen to the very end, so that it goes on in the next
/// line.
inline void reach_ends(const Line& line, double least, std::vector<Span>& seen) {
  if (seen.empty()) return;
  if (seen.front().from - line.v0 <= least) seen.front().from = line.v0;
  if (line.v1 - seen.back().to <= least) seen.back().to = line.v1;
}

/// An upper and a lower horizon, functions of u: for surfaces without holes.
template <class Envelope>
class TwoHorizons {
 public:
  static constexpr bool kCovers = false;

  TwoHorizons(double u_min, double u_max, std::size_t cells)
      : upright_(kUprightPart * (u_max - u_min)),
        upper_(u_min, u_max, cells),
        lower_(u_min, u_max, cells),
        upright_lines_(u_min, u_max, cells, upright_) {}

  /// The fractions in space of a segment that are seen, and that are to be drawn: of an upright one those on which nothing
  /// has been drawn yet. Valid until the next call.
  const std::vector<Span>& seen(const SightPoint& a, const SightPoint& b, Against against, LineSides sides) {
    const SightLine sight(a, b, upright_);
    seen_.clear();
    if (sight.upright()) {
      // Between two closed sides the horizons rise and fall with what is seen, and nothing is seen twice.
      const bool open = seen_upright(sight.line(), a.v(), sides);
      if (open) upright_lines_.draw(sight.line().u0, seen_);
      reach_ends(sight.line(), upright_, seen_);
    } else if (against == Against::upper) {
      upper_.find_above(sight.line(), seen_);
    } else if (against == Against::lower) {
      lower_.find_above(sight.upside_down(), seen_);
    } else {
      above_.clear();
      below_.clear();
      upper_.find_above(sight.line(), above_);
      lower_.find_above(sight.upside_down(), below_);
      join();
    }
    sight.to_space(seen_);
    return seen_;
  }

  /// From now on the segment is part of the upper, of the lower horizon.
  void raise(const SightPoint& a, const SightPoint& b, bool upper, bool lower) {
    const SightLine sight(a, b, upright_);
    if (sight.upright()) return;
    above_.clear();
    if (upper) upper_.raise(sight.line(), above_);
    if (lower) lower_.raise(sight.upside_down(), above_);
  }

  UprightLines& upright_lines() { return upright_lines_; }

 private:
  /// What is above or below, the two put together.
  void join() {
    std::vector<Span>& all = above_;
    all.insert(all.end(), below_.begin(), below_.end());
    std::sort(all.begin(), all.end(), [](const Span& s, const Span& t) { return s.from < t.from; });
    for (const Span& s : all) {
      if (!seen_.empty() && s.from <= seen_.back().to) {
        seen_.back().to = std::max(seen_.back().to, s.to);
      } else {
        seen_.push_back(s);
      }
    }
  }

  /// `nearest`: the height of the line's nearer end, through which the surface passes on both sides. Whether a side is open:
  /// there is no horizon, or nobody has looked.
  bool seen_upright(const Line& line, double nearest, LineSides sides) {
    const double u = line.u0;
    double high = upper_.height(u), low = -lower_.height(u);
    bool open = true;
    if (sides == LineSides::both) {
      high = std::min(upper_.height_beside(u, -1), upper_.height_beside(u, 1));
      low = -std::min(lower_.height_beside(u, -1), lower_.height_beside(u, 1));
      open = high == kNothing || low == -kNothing;
    } else if (sides != LineSides::none) {
      const int side = sides == LineSides::left ? -1 : 1;
      high = upper_.height_beside(u, side);
      low = -lower_.height_beside(u, side);
    }
    if (sides != LineSides::none) {
      high = std::max(high, nearest);
      low = std::min(low, nearest);
    }
    if (!(line.v0 < line.v1)) return open;
    if (!(high >= low)) {  // there is no horizon here yet
      seen_.push_back({line.v0, line.v1});
      return open;
    }
    if (line.v0 < low) seen_.push_back({line.v0, std::min(low, line.v1)});
    if (high < line.v1) seen_.push_back({std::max(high, line.v0), line.v1});
    return open;
  }

  double upright_;
  Envelope upper_, lower_;
  UprightLines upright_lines_;
  std::vector<Span> above_, below_, seen_;
};

/// A horizon that is no function of u: for surfaces with holes.
class GeneralHorizon {
 public:
  static constexpr bool kCovers = true;

  GeneralHorizon(double u_min, double u_max, std::size_t cells)
      : upright_(kUprightPart * (u_max - u_min)),
        coverage_(u_min, u_max, cells),
        upright_lines_(u_min, u_max, cells, upright_) {}

  const std::vector<Span>& seen(const SightPoint& a, const SightPoint& b, Against, LineSides sides) {
    const SightLine sight(a, b, upright_);
    const Line& line = sight.line();
    seen_.clear();
    if (!sight.upright()) {
      coverage_.find_uncovered(line, seen_);
    } else if (line.v0 < line.v1) {
      seen_upright(line, sides);
      upright_lines_.draw(line.u0, seen_);
      reach_ends(line, upright_, seen_);
    }
    sight.to_space(seen_);
    return seen_;
  }

  void cover(const SightPoint& a, const SightPoint& b, const SightPoint& c) {
    coverage_.cover({{{a.u(), a.v()}, {b.u(), b.v()}, {c.u(), c.v()}}});
  }

  UprightLines& upright_lines() { return upright_lines_; }

 private:
  void seen_upright(const Line& line, LineSides sides) {
    std::array<std::vector<Span>, 2> covered;  // left, right
    for (const int k : {0, 1}) {
      if (sides != (k == 0 ? LineSides::right : LineSides::left))
        coverage_.find_covered_beside(line.u0, line.v0, line.v1, k == 0 ? -1 : 1, covered[k]);
    }
    std::vector<Span> hidden;
    if (sides == LineSides::left || sides == LineSides::right) {
      hidden = covered[sides == LineSides::left ? 0 : 1];
    } else {
      for (const Span& a : covered[0]) {
        for (const Span& b : covered[1]) {
          const Span both{std::max(a.from, b.from), std::min(a.to, b.to)};
          if (both.from < both.to) hidden.push_back(both);
        }
      }
    }
    Coverage::append_uncovered(line.v0, line.v1, coverage_.least(), hidden, seen_);
  }

  double upright_;
  Coverage coverage_;
  UprightLines upright_lines_;
  std::vector<Span> seen_;
};

}  // namespace ligne::horizon
