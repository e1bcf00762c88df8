#pragma once
/// Areas that hide what was painted before them. Private to plotting.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "plotting/svg/clip.hpp"

namespace ligne::svg {

/// An opaque area, as far as it shows.
struct Occluder {
  Area area;
  std::shared_ptr<const Clip> clip;  ///< nullptr: all of it
  std::uint32_t painted = 0;         ///< it hides what was painted before that
  std::string layer{};               ///< the document's that it is in, or empty
};

/// Which occluders lie where.
class Occluders {
 public:
  explicit Occluders(std::span<const Occluder> occluders);

  /// What of the lines is seen, with the times at which they were painted. A line on the rim of a occluder is seen.
  void remove_hidden(Polylines& lines, std::vector<std::uint32_t>& painted);

 private:
  std::size_t cell(double at, int axis) const;
  void find_over(Point2 a, Point2 b, std::uint32_t painted);

  std::span<const Occluder> occluders_;
  Rect box_;
  std::size_t side_ = 1;                           ///< cells along each axis
  std::vector<std::vector<std::uint32_t>> cells_;  ///< occluders that meet each, ascending
  std::vector<std::uint32_t> over_;                ///< those over the segment at hand
};

}  // namespace ligne::svg
