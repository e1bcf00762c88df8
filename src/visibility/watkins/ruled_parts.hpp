#pragma once
/// Ruled surfaces between the sides of skew faces: their parts, and the parts of lines behind them. Notation: x and y in
/// lattice steps, z in mm.

#include <array>
#include <span>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne::watkins {

/// A side of a skew face from top to bottom: top.p.y < bottom.p.y.
struct RuledSide {
  ProjectedVertex top, bottom;

  double x(double y) const { return at(y, top.p.x, bottom.p.x); }
  double z(double y) const { return at(y, top.z, bottom.z); }

 private:
  double at(double y, double first, double last) const {
    return first + (last - first) * ((y - top.p.y) / (double(bottom.p.y) - top.p.y));
  }
};

/// A part of a skew face: between two neighbouring sides, and between two heights between which no side of the face
/// begins, ends or crosses another. Its depth is linear along each side and along each horizontal ruling.
struct RuledPart {
  RuledSide left, right;
  double y_top, y_bottom;  ///< lattice steps
};

/// Faces with more sides than this stay triangles: their parts are found by comparing all pairs of sides.
inline constexpr std::size_t kMostSkewSides = 64;

/// Divides a face into parts. `sides`: its sides without horizontal ones, at most kMostSkewSides, in any order.
std::vector<RuledPart> ruled_parts(std::span<const RuledSide> sides);

/// The parts of a line that are farther than the ruled surface: at most two. The others have sides `none`. `tolerance`:
/// depth difference at which surfaces touch, mm. Ends are exact but for the rounding of doubles.
std::array<HiddenInterval, 2> behind_ruled_part(const PageLine& line, const RuledPart& part, double tolerance);

}  // namespace ligne::watkins
