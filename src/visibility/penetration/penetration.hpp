#pragma once
/// Where facets pass through each other: pairs are tested wherever two facets may meet, put together, and only then cut.
///
/// A pair is tested by the sides of its corners: above or below the other's plane, or on it within the depth tolerance.
/// "On" counts as above, so that a segment through a common corner of two facets is found once.

#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

/// Common segment of two facets that pass through each other.
struct Intersection {
  ProjectedVertex from, to;
  std::uint32_t face0 = kNone, face1 = kNone;  ///< faces of the scene, face0 <= face1
};

/// A place on the page, in lattice steps, with its depth.
struct PagePoint {
  double x, y, z;
};

struct PageSegment {
  PagePoint from, to;
  PagePoint at(double t) const {
    return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.z + t * (to.z - from.z)};
  }
};

/// The part of a segment in a convex region given by linear functions E_i >= 0, with their values at its two ends:
/// parameters, or nothing.
template <std::size_t N>
std::optional<std::array<double, 2>> clip_parameters(const std::array<double, N>& e0, const std::array<double, N>& e1) {
  double from = 0, to = 1;
  for (std::size_t i = 0; i < N; ++i) {
    if (e0[i] < 0 && e1[i] < 0) return std::nullopt;
    if (e0[i] < 0) from = from > e0[i] / (e0[i] - e1[i]) ? from : e0[i] / (e0[i] - e1[i]);
    if (e1[i] < 0) to = to < e0[i] / (e0[i] - e1[i]) ? to : e0[i] / (e0[i] - e1[i]);
  }
  if (!(from < to)) return std::nullopt;
  return std::array<double, 2>{from, to};
}

/// The place of the lattice next to a point.
ProjectedVertex rounded(const PagePoint& p);

/// A facet's places, gathered once for many tests.
struct PlacedFacet {
  std::uint32_t id, face;
  std::array<std::uint32_t, 3> v;
  std::array<LatticePoint, 3> p;
};

/// The sides at which faces were cut into triangles: those of two facets of one face. Found when first asked for, from any
/// thread.
class CutSides {
 public:
  explicit CutSides(const std::vector<Facet>& facets) : facets_(&facets) {}

  /// True where the face has a side between these vertices.
  bool has(std::uint32_t face, std::uint32_t v, std::uint32_t w) const;

 private:
  struct Side {
    std::uint32_t face, low, high;
    friend auto operator<=>(const Side&, const Side&) = default;
  };
  void find() const;

  const std::vector<Facet>* facets_;
  mutable std::once_flag found_;
  mutable std::vector<Side> sides_;  ///< in order
};

/// Collects pairs. Facets may be given in any order and as often as one likes; searches of several tasks are put together.
class PenetrationSearch {
 public:
  PenetrationSearch(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices)
      : facets_(&facets), vertices_(&vertices), cut_sides_(std::make_shared<CutSides>(facets)) {}

  /// A search of the same facets that has found nothing yet.
  PenetrationSearch empty_copy() const { return PenetrationSearch(*facets_, *vertices_, cut_sides_); }

  PlacedFacet place(std::uint32_t facet) const;

  /// Tests two facets of different faces. A pair whose common segment `wanted(segment)` says is not wanted is left out; a
  /// side of one that lies in the plane of the other is always remembered. Returns whether there is such a segment.
  template <class Wanted>
  bool test(const PlacedFacet& a, const PlacedFacet& b, Wanted wanted) {
    return overlap(a, b) && test_overlapping(a, b, wanted);
  }

  /// Whether the two have a common inside on the page and no common side: without that nothing is found. On the lattice, and
  /// much cheaper than the rest.
  static bool overlap(const PlacedFacet& a, const PlacedFacet& b);

  /// The rest of test(), for facets that overlap.
  template <class Wanted>
  bool test_overlapping(const PlacedFacet& a, const PlacedFacet& b, Wanted wanted) {
    const auto found = segment_of(a, b);
    if (found && wanted(found->segment)) pairs_.push_back(found->pair);
    return found.has_value();
  }

  /// Frees the memory of what was found several times, when there is much of it: neighbouring leaves have pairs in common.
  void forget_repeated();

  void add(PenetrationSearch&& other);

  /// All segments, each once, ordered by facets. Facets that only touch, within their tolerance, give none: neither do
  /// neighbours with a common side. Where a side of one facet lies in the plane of another there is a segment only if the
  /// surface goes on on the other side. Segments no longer than `least_steps` that stand alone are left out.
  std::vector<Intersection> finish(double least_steps);

 private:
  PenetrationSearch(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices,
                    std::shared_ptr<const CutSides> cut_sides)
      : facets_(&facets), vertices_(&vertices), cut_sides_(std::move(cut_sides)) {}

  struct Pair {
    std::uint32_t a, b;  ///< facets: the plane, and the one whose boundary is cut by it
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };
  struct Found {
    Pair pair;
    PageSegment segment;
  };
  /// A side of facet `side_of` that lies in the plane of facet `plane`, its third corner above or below.
  struct SideInPlane {
    std::uint32_t plane, v0, v1, side_of;
    bool above;
    auto key() const { return std::tie(plane, v0, v1); }
    friend auto operator<=>(const SideInPlane&, const SideInPlane&) = default;
  };
  /// A side of facet `side_of` that lies on a side of facet `plane` at which the face was cut into triangles, and in its
  /// plane: the common line of two faces runs there.
  struct SideOnSide {
    std::uint32_t face, p0, p1;  ///< face of the plane, and its side
    std::uint32_t v0, v1;        ///< the side that lies on it
    bool above;                  ///< the third corner of `side_of` is above the plane
    std::uint32_t plane, side_of;
    auto key() const { return std::tie(face, p0, p1, v0, v1); }
    friend auto operator<=>(const SideOnSide&, const SideOnSide&) = default;
  };
  struct Heights;

  std::optional<Found> segment_of(const PlacedFacet& a, const PlacedFacet& b);
  void add_side(const PlacedFacet& plane, const PlacedFacet& other, const Heights& heights);
  void add_side_on_side(const PlacedFacet& plane, const Heights& plane_heights, const PlacedFacet& other,
                        const Heights& heights);
  void match_sides();
  void match_sides_on_sides();

  const std::vector<Facet>* facets_;
  const std::vector<ProjectedVertex>* vertices_;
  std::shared_ptr<const CutSides> cut_sides_;
  std::vector<Pair> pairs_;
  std::vector<SideInPlane> sides_;
  std::vector<SideOnSide> sides_on_sides_;
  std::size_t distinct_ = 0;  ///< how many there were after the last forget_repeated()
};

}  // namespace ligne
