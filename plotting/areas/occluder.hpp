#pragma once
/// Areas that hide what was painted before them. Private to plotting.

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

/// An opaque area, as far as it shows.
struct Occluder {
  Area area;
  std::shared_ptr<const Clip> clip;  ///< nullptr: all of it
  std::uint32_t painted = 0;         ///< it hides what was painted before that
  std::uint32_t since = 0;           ///< and after that: in a translucent group nothing else is hidden
  std::string layer{};               ///< the document's that it is in, or empty
  /// Width in mm of the line along its contours; 0: that of the pen that draws the borders of fills; nothing: no line.
  std::optional<double> rim_width{};
};

/// An area whose ink the lines that were painted with it stand for.
struct FilledArea {
  Polylines contours;
  FillRule rule = FillRule::nonzero;
  std::shared_ptr<const Clip> clip;
};
using FilledAreas = std::unordered_map<std::uint32_t, FilledArea>;  ///< by when they were painted

/// Which occluders lie where.
///
/// A line is hidden where occluders painted later lie on both its sides: along the rim of one of them half of its ink is
/// seen, between two that abut none. Lines that stand for the ink of an area are hidden where occluders lie on those sides
/// on which the area lies. Along the rim of an occluder that draws a line there at least as wide, no other line is drawn.
class Occluders {
 public:
  /// `occluders` from the first painted to the last, and `filled`, must outlive it.
  Occluders(std::span<const Occluder> occluders, const FilledAreas& filled, ClipWork work);

  /// The parts of the lines that are seen, and when they were painted. `width_mm`: of the lines, 0 the pen's.
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
  std::unordered_set<std::uint32_t> covered_;  ///< when areas were painted that a later one covers exactly
  std::vector<char> is_repeated_;              ///< of occluders: a later one hides all that they hide
  Rect box_;
  std::size_t side_ = 1;                           ///< cells along each axis
  std::vector<std::vector<std::uint32_t>> cells_;  ///< occluders that meet each, ascending
  std::vector<std::uint32_t> over_;                ///< those over the segment at hand, the last painted first
  std::unordered_map<std::uint32_t, Area> own_{};  ///< areas of filled_ that were needed
  Coverage coverage_;
  SideTally tally_;
};

}  // namespace ligne::svg
