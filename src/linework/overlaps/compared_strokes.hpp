#pragma once
/// Strokes that are compared with each other, their precedence, and the steps that resolve their overlaps.

#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/segment_overlap.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {

/// Visible before seen through transparent faces before hidden; then by class. The lowest rank stays.
inline std::size_t rank(const Stroke& s) {
  const std::size_t group = !s.visible ? 2 : s.level > 0 ? 1 : 0;
  return group * kLineClassCount + static_cast<std::size_t>(s.line_class);
}

/// Depth at a fraction of the stroke's length.
inline double depth(const Stroke& s, double fraction) { return (1 - fraction) * s.z_from + fraction * s.z_to; }

/// The first key by which strokes on one line are sorted: their rank, and their depth at a fraction of their length. The
/// depth is in tolerances, rounded down, so that depths that are equal but for rounding mostly compare equal.
using PrecedenceKey = std::pair<std::size_t, double>;
inline PrecedenceKey precedence_key(const Stroke& s, double fraction, double tolerance_mm) {
  const double rounded = std::floor(depth(s, fraction) / tolerance_mm);
  return {rank(s), std::isfinite(rounded) ? rounded : 0};
}

/// Whether stroke a stays where it lies on stroke b: by rank, then by depth in the middle of the common interval, then by
/// source.
inline bool precedes(const Stroke& a, const Stroke& b, const SegmentOverlap& common, double tolerance_mm) {
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  const double z_a = depth(a, (common.a_from + common.a_to) / 2), z_b = depth(b, (common.b_from + common.b_to) / 2);
  if (std::abs(z_a - z_b) > tolerance_mm) return z_a < z_b;
  return std::tie(a.source, a.t_from, a.t_to) < std::tie(b.source, b.t_from, b.t_to);
}

/// The tolerance of coincidence, on the page and in depth.
struct OverlapTolerance {
  double steps, mm;
};

/// A part of a stroke on which another stroke lies. Where the part ends inside the stroke, the point of the cut is the end
/// of that other stroke. So what stays of the stroke meets it in one lattice point, and make_drawing.cpp joins them.
struct CoveredPart {
  StrokeCut from, to;
};

/// Returns what the covered parts leave of the stroke, in order along it. Rests up to the tolerance vanish. Sorts the
/// covered parts.
std::vector<Stroke> rests_of(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps);

/// A stroke, by its number, and what stays of it: parts of it, or all of it.
struct CutStroke {
  std::uint32_t number = 0;
  std::vector<Stroke> rests{};
};

/// Strokes by falling precedence, while overlaps are resolved. A stroke keeps its id as long as it is not cut; no two
/// strokes ever have the same.
struct ComparedStrokes {
  std::vector<Stroke> strokes;
  std::vector<std::uint32_t> ids;  ///< by stroke
  std::uint32_t first_new = 0;     ///< strokes with this id and higher ones were not yet compared with the others
  std::uint32_t next_id = 0;

  bool is_new(std::uint32_t stroke) const { return ids[stroke] >= first_new; }
  /// Appends strokes, which are new.
  void add(std::span<const Stroke> added);

  /// Puts rests in the place of their strokes. Then only the rests of strokes that were cut are new. `cut` is ascending.
  void replace(std::span<const CutStroke> cut);
};

/// Where many strokes of about the same length lie on one line in one place, only the parts stay that no other of these
/// strokes covers. So the number of pairs that remain to be resolved grows as n log n. Strokes that need no check
/// (Stroke::needs_overlap_check) take no part. `strokes` are sorted by precedence. Returns what stays of the crowded ones,
/// ascending.
std::vector<CutStroke> thin_crowded_lines(const std::vector<Stroke>& strokes, const OverlapTolerance& tolerance);

}  // namespace ligne
