#pragma once
/// The horizons over a band of columns, in the two forms that the sweep over the grid works with.

#include <array>
#include <vector>

#include "visibility/horizon/coverage.hpp"
#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/plane_segment.hpp"

namespace ligne::horizon {

/// An upper and a lower horizon, functions of u: for surfaces without holes.
template <class Envelope>
class TwoHorizons {
 public:
  static constexpr bool kCovers = false;

  TwoHorizons(const Columns& columns, ColumnRange own) : upper_(columns, own), lower_(columns, own) {}

  /// Finds the visible parts of an edge over the band's own columns, as spans of its line, separately above the upper
  /// and below the lower horizon. For an upright line it returns whether a side is open: it has no horizon, or was not
  /// tested.
  bool find_seen(const HorizonEdge& edge, std::vector<Span>& above, std::vector<Span>& below) {
    const PlaneSegment& segment = edge.line;
    if (segment.upright()) return find_seen_upright(edge, above);
    if (edge.against != HorizonSide::lower) upper_.find_above(segment.line(), above);
    if (edge.against == HorizonSide::lower) lower_.find_above(segment.upside_down(), above);
    if (edge.against == HorizonSide::both) lower_.find_above(segment.upside_down(), below);
    return true;
  }

  /// Adds the edge to the horizons that it raises.
  void raise(const HorizonEdge& edge) {
    if (edge.line.upright()) return;
    raised_.clear();
    if (edge.upper) upper_.raise(edge.line.line(), raised_);
    if (edge.lower) lower_.raise(edge.line.upside_down(), raised_);
  }

  /// Largest gap over which spans of two bands are joined.
  double least() const { return upper_.least(); }

 private:
  bool find_seen_upright(const HorizonEdge& edge, std::vector<Span>& seen) {
    const Line& line = edge.line.line();
    const LineSides sides = edge.sides;
    // The surface passes through the line's nearer end on both sides.
    const double u = line.u0, nearest = edge.line.height_of_start();
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
    if (sides == LineSides::none && edge.against == HorizonSide::upper) low = kNothing;
    if (!(high >= low)) {  // there is no horizon here yet
      seen.push_back({line.v0, line.v1});
      return open;
    }
    if (line.v0 < low) seen.push_back({line.v0, std::min(low, line.v1)});
    if (high < line.v1) seen.push_back({std::max(high, line.v0), line.v1});
    return open;
  }

  Envelope upper_, lower_;
  std::vector<Span> raised_;  ///< scratch
};

/// A horizon that is not a function of u: for surfaces with holes.
class GeneralHorizon {
 public:
  static constexpr bool kCovers = true;

  GeneralHorizon(const Columns& columns, ColumnRange own) : coverage_(columns, own) {}

  bool find_seen(const HorizonEdge& edge, std::vector<Span>& seen, std::vector<Span>&) {
    const Line& line = edge.line.line();
    if (!edge.line.upright()) {
      coverage_.find_uncovered(line, seen);
    } else if (line.v0 < line.v1) {
      find_seen_upright(line, edge.sides, seen);
    }
    return true;
  }

  void cover(const PlaneTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    coverage_.cover({{{a.u(), a.v()}, {b.u(), b.v()}, {c.u(), c.v()}}});
  }

  double least() const { return coverage_.least(); }

 private:
  void find_seen_upright(const Line& line, LineSides sides, std::vector<Span>& seen) {
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
    Coverage::append_uncovered(line.v0, line.v1, coverage_.least(), hidden, seen);
  }

  Coverage coverage_;
};

}  // namespace ligne::horizon
