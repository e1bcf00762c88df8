#pragma once
/// The smooth pieces of a profile that facets of an extruded or a revolved surface have.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Some facets between two rulings, or between two circles about an axis, as a side of the profile.
struct ProfileSide {
  std::uint32_t from = 0, to = 0;  ///< points of the profile
  std::uint32_t owner = 0;         ///< the patch of the facets, kNone if they have none
  bool is_plane = false;           ///< the facets count as planes, as two strips in one plane near an inflection do
};

/// The patches that have sides of a profile.
struct ProfileOwners {
  std::span<const std::uint8_t> is_arc;  ///< per patch: its profile is an arc, and not a straight line
  /// Per patch: it is a cylinder about the axis of a revolved surface; empty for extruded ones.
  std::span<const std::uint8_t> is_cylinder;
  double tolerance = 0;  ///< largest distance of points from a straight line
};

/// Consecutive sides of one smooth curve.
struct ProfilePiece {
  std::vector<std::uint32_t> points;  ///< in order; of a closed one each once
  std::vector<std::uint32_t> sides;   ///< from point to point
  bool is_closed = false;
};

/// Divides the sides, of which no two join the same points, at their corners and at ends of patches that are no accident:
/// - a corner bends by kSurfaceCreaseDegrees or more, and by kCornerBends times as much as the joints beside it or to the
///   other side than both;
/// - a patch with three sides or more on one line is a surface of its own, and one that is kPlaneDepths times as long as the
///   side beside it. Sides that do not lie on one line are those near an inflection;
/// - a patch on an arc ends there, unless the curvature goes on gradually; with one side only at a cylinder;
/// - a plane may lie between two other sides that are not much shorter.
/// Returns the pieces of kFewestSides sides or more that bend by kLeastTurn or more and are not all of one patch. O(n).
std::vector<ProfilePiece> smooth_pieces(std::span<const Point2> points, std::span<const ProfileSide> sides,
                                        const ProfileOwners& owners);

}  // namespace ligne
