#pragma once
/// Facets that may lie on one extruded or revolved surface, with their places in its profile.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "scene/patches/swept/profile_pieces.hpp"
#include "scene/patches/swept/swept_surfaces.hpp"

namespace ligne {

/// A facet, and the two points of the profile between which it lies.
struct SweptFacet {
  std::uint32_t facet = 0;
  std::array<Point2, 2> ends{};
};

/// The profile of facets.
struct FacetProfile {
  std::vector<Point2> points;                      ///< ends that lie within the tolerance are one point
  std::vector<ProfileSide> sides;                  ///< each pair of points once
  std::vector<std::vector<std::uint32_t>> facets;  ///< per side: its facets, ascending
};

/// Collects the profile. O(n log n).
FacetProfile profile_of(std::vector<SweptFacet> facets, const FacetPatches& surfaces, double tolerance);

/// Largest distance of corners from their ruling or circle: 8 precisions of the coordinates, as for other surfaces.
inline double swept_tolerance(const Object& object) { return 8 * object.precision; }

/// Largest distance of corners from the straight side of a facet: strips that bend by kFlatBend are one facet.
inline double largest_offset(double tolerance, double width) {
  return std::max(2 * tolerance, width * kFlatBend * std::numbers::pi / 180 / 2);
}

/// Makes patches of swept facets.
class SweptPatches {
 public:
  SweptPatches(const FacetObject& object, const FacetPatches& surfaces) : object_(object), surfaces_(surfaces) {}

  /// Makes a patch of the facets of each piece of a profile, and of those facets of patches with sides of it that lie in no
  /// piece. Facets of swept patches stay there. `frame`: a surface without its profile, with the vectors `x` and `y` of the
  /// profile (SweptProfile).
  void add(const PatchSurface& frame, const std::array<Point3, 2>& xy, const FacetProfile& profile,
           std::span<const ProfilePiece> pieces);

 private:
  void list_facets();
  std::vector<std::vector<std::uint32_t>> facets_of(const FacetProfile& profile, std::span<const ProfilePiece> pieces) const;
  void add_patch(const PatchSurface& frame, const std::array<Point3, 2>& xy, std::vector<Point2> points, bool is_closed,
                 std::span<const std::uint32_t> facets);

  const FacetObject& object_;
  const FacetPatches& surfaces_;
  std::vector<std::vector<std::uint32_t>> facets_;  ///< per patch that was found before, if is_listed_
  bool is_listed_ = false;
};

/// Finds extruded surfaces.
void find_extruded(const FacetObject& object, const FacetPatches& surfaces, SweptPatches& swept);
/// Finds revolved surfaces.
void find_revolved(const FacetObject& object, const FacetPatches& surfaces, SweptPatches& swept);

}  // namespace ligne
