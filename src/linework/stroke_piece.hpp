#pragma once
/// Cuts strokes into pieces.

#include <algorithm>

#include "linework/stroke.hpp"

namespace ligne {

/// A point at which a stroke is cut.
struct StrokeCut {
  double fraction;  ///< of the stroke's length on the page; beyond 0 to 1 the stroke is extended
  LatticePoint p;   ///< the point, rounded to the lattice
};

/// The piece of a stroke between two cuts, or its extension to them. Its parameters, depths and weights are interpolated.
inline Stroke stroke_piece(const Stroke& s, const StrokeCut& from, const StrokeCut& to) {
  const auto depth = [&](double fraction) { return static_cast<float>((1 - fraction) * s.z_from + fraction * s.z_to); };
  const auto weight = [&](double fraction) {
    const double u = (source_parameter(s, fraction) - s.t_from) / (s.t_to - s.t_from);
    return static_cast<float>((1 - u) * s.w_from + u * s.w_to);
  };
  Stroke part = s;
  if (from.fraction != 0) {
    part.t_from = source_parameter(s, from.fraction);
    part.z_from = depth(from.fraction);
    part.w_from = weight(from.fraction);
    part.from = from.p;
  }
  if (to.fraction != 1) {
    part.t_to = source_parameter(s, to.fraction);
    part.z_to = depth(to.fraction);
    part.w_to = weight(to.fraction);
    part.to = to.p;
  }
  return part;
}

/// Moves an end of a stroke along it, at most to the end of its source edge.
inline void move_end(Stroke& s, bool first, const StrokeCut& to) {
  s = first ? stroke_piece(s, to, {1, s.to}) : stroke_piece(s, {0, s.from}, to);
  s.t_from = std::max(s.t_from, 0.0);
  s.t_to = std::min(s.t_to, 1.0);
}

}  // namespace ligne
