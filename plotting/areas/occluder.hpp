#pragma once
/// Areas that hide the lines painted before them. Private to plotting.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "areas/clip.hpp"
#include "areas/coverage.hpp"
#include "areas/seen_parts.hpp"
#include "areas/side_counts.hpp"

namespace ligne::svg {

/// The visible part of an opaque area.
struct Occluder {
  Area area;
  std::shared_ptr<const Clip> clip;  ///< nullptr: the whole area is visible
  std::uint32_t painted = 0;         ///< place in the painting order; hides lines painted before it
  std::uint32_t since = 0;           ///< hides only lines painted after this: the start of its translucent group
  std::string layer{};               ///< layer of the document that contains it, or empty
  /// Width in mm of the line along its contours; 0: the width of the pen that draws borders of fills; nothing: no line.
  std::optional<double> rim_width{};
};

/// A filled area that lines represent: they were painted with it and represent its ink.
struct FilledArea {
  Polylines contours;
  FillRule rule = FillRule::nonzero;
  std::shared_ptr<const Clip> clip;
};
using FilledAreas = std::unordered_map<std::uint32_t, FilledArea>;  ///< by place in the painting order

/// A grid of occluders, which removes the hidden parts of lines.
///
/// A line is hidden where occluders painted later lie on both its sides. Along the rim of a single occluder half of its
/// ink is visible; between two occluders that abut, none is. A line that represents the ink of an area is hidden where
/// occluders lie on the sides on which the area lies. If an occluder draws a line along its rim, other lines there that
/// are no wider are dropped.
class Occluders {
 public:
  /// `occluders`, in painting order, and `filled` must outlive this object.
  Occluders(std::span<const Occluder> occluders, const FilledAreas& filled, ClipWork work);

  /// Reduces the lines to their visible parts, and `painted`, their places in the painting order, with them. `width_mm`
  /// is the width of the lines; 0: the width of the pen.
  void remove_hidden(Polylines& lines, std::vector<std::uint32_t>& painted, double width_mm);

 private:
  void drop_repeated();
  std::size_t cell(double at, int axis) const;
  void find_over(const Rect& box, std::uint32_t painted);
  void find_parts(const StepSegment& stroke, std::uint32_t painted, double width_mm, std::vector<SeenPart>& parts);
  const FilledArea* filled_at(std::uint32_t painted) const;

  std::span<const Occluder> occluders_;
  const FilledAreas& filled_;
  ClipWork work_;
  std::unordered_set<std::uint32_t> covered_;  ///< places in the painting order of areas that a later area covers
                                               ///< exactly
  std::vector<char> is_repeated_;              ///< per occluder: 1 if a later one hides all that it hides
  Rect box_;
  std::size_t side_ = 1;                           ///< cells along each axis
  std::vector<std::vector<std::uint32_t>> cells_;  ///< per cell: occluders that meet it, ascending
  std::vector<std::uint32_t> over_;                ///< occluders over the current segment, last painted first
  std::unordered_map<std::uint32_t, Area> own_{};  ///< areas of filled_, made on first use
  Coverage coverage_;
  SideTally tally_;
};

}  // namespace ligne::svg
