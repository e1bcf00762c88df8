#pragma once
/// One rule of cleaning, applied to strokes.

#include "linework/map/line_map.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {

inline SourceEdge no_source(const Stroke&) { return {}; }

inline bool is_no_mesh(const Stroke& s) { return s.line_class != LineClass::mesh; }

/// Makes the map of the strokes, with contacts within `reach_mm`, applies the rule, and writes the map back, with hidden
/// strokes in the ink cleared.
template <class Rule>
std::size_t apply_rule(StrokeModel& m, double reach_mm, const Rule& rule, double ink_mm = 0) {
  const double step = m.lattice.step_mm;
  LineMap map(m, is_no_mesh, {.reach = reach_mm / step}, std::max(4.0, 4 * reach_mm / step));
  const std::size_t changes = rule(map);
  map.commit(ink_mm / step);
  return changes;
}

}  // namespace ligne
