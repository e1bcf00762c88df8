#pragma once
/// Penetrations of facets: pairs are tested wherever two facets may meet, then collected, and only then cut.
///
/// The test of a pair uses the positions of the corners: above or below the other's plane, or on it within the depth
/// tolerance. "On" counts as above, so that a segment through a common corner of two facets is found once.

#include <array>
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

/// Common segment of two facets that penetrate each other.
struct Intersection {
  ProjectedVertex from, to;
  std::uint32_t face0 = kNone, face1 = kNone;  ///< faces of the scene, face0 <= face1
};

/// A point on the page, in lattice steps, with its depth.
struct PagePoint {
  double x, y, z;
};

struct PageSegment {
  PagePoint from, to;
  PagePoint at(double t) const {
    return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.z + t * (to.z - from.z)};
  }
};

/// The parameters of the part of a segment inside a convex region, if any. The region is given by linear functions E_i
/// >= 0, through their values at the ends of the segment.
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

/// The lattice point nearest to a point.
ProjectedVertex rounded(const PagePoint& p);

/// A facet with its corners and sides, gathered once for many tests.
struct PlacedFacet {
  std::uint32_t id, face;
  std::array<std::uint32_t, 3> v;
  double touch;                     ///< its depth tolerance
  std::array<double, 3> x, y, z;    ///< its corners: lattice points and depths
  std::array<double, 3> ex, ey, e;  ///< its sides E_i(x, y) = ex x + ey y + e, exact at lattice points

  /// E_i at a corner of another facet: orientation() of the side and the corner.
  double side(std::size_t i, const PlacedFacet& other, std::size_t corner) const {
    return ex[i] * other.x[corner] + ey[i] * other.y[corner] + e[i];
  }
  double area() const { return side(0, *this, 2); }
};

/// Whether the projections have inner points in common. They have none only if one facet lies outside a side of the other or
/// along it.
bool overlap_on_page(const PlacedFacet& a, const PlacedFacet& b);

/// The sides at which faces were cut into triangles, each shared by two facets of one face. The first call of has()
/// finds them, on any thread.
class CutSides {
 public:
  explicit CutSides(const std::vector<Facet>& facets) : facets_(&facets) {}

  /// Whether the face is cut at the side between these vertices.
  bool has(std::uint32_t face, std::uint32_t v, std::uint32_t w) const;

 private:
  struct Side {
    std::uint32_t face, low, high;
    friend auto operator<=>(const Side&, const Side&) = default;
  };
  void find() const;

  const std::vector<Facet>* facets_;
  mutable std::once_flag found_;
  mutable std::vector<Side> sides_;  ///< sorted
};

/// Collects pairs. They may come in any order and repeatedly; searches of several tasks can be merged.
class PenetrationSearch {
 public:
  PenetrationSearch(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices)
      : facets_(&facets), vertices_(&vertices), cut_sides_(std::make_shared<CutSides>(facets)) {}

  /// An empty search of the same facets.
  PenetrationSearch empty_copy() const { return PenetrationSearch(*facets_, *vertices_, cut_sides_); }

  PlacedFacet place(std::uint32_t facet) const;

  /// Tests two facets of different faces. Collects the pair if it has a common segment and `wanted(segment)`; a side of
  /// one facet in the plane of the other is always collected.
  template <class Wanted>
  void test(const PlacedFacet& a, const PlacedFacet& b, Wanted wanted) {
    const auto found = segment_of(a, b);
    if (found && wanted(found->segment)) pairs_.push_back(found->pair);
  }

  /// Removes repeated results if there are many: neighbouring leaves have common pairs.
  void forget_repeated();

  void add(PenetrationSearch&& other);

  /// All segments, each once, ordered by facets. Facets that only touch, within their tolerance, give none, nor do
  /// neighbours with a common side. A side of one facet in the plane of another gives a segment only if the surface
  /// continues across the plane. Isolated segments no longer than `least_steps` are left out.
  std::vector<Intersection> finish(double least_steps);

 private:
  PenetrationSearch(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices,
                    std::shared_ptr<const CutSides> cut_sides)
      : facets_(&facets), vertices_(&vertices), cut_sides_(std::move(cut_sides)) {}

  struct Pair {
    std::uint32_t a, b;  ///< facets: `a` gives the plane that cuts the boundary of `b`
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };
  struct Found {
    Pair pair;
    PageSegment segment;
  };
  /// A side of facet `side_of` in the plane of facet `plane`; the third corner is above the plane or below it.
  struct SideInPlane {
    std::uint32_t plane, v0, v1;
    bool above;
    std::uint32_t side_of;
    auto key() const { return std::tie(plane, v0, v1); }
    friend auto operator<=>(const SideInPlane&, const SideInPlane&) = default;
  };
  /// A side of facet `side_of` that lies in the plane of facet `plane`, on a side at which the plane's face was cut
  /// into triangles: the common line of two faces runs there.
  struct SideOnSide {
    std::uint32_t face, p0, p1;  ///< face of the plane, and the side of facet `plane`
    std::uint32_t v0, v1;        ///< the side of facet `side_of`
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
  template <class Side>
  void match(std::vector<Side>& sides);

  const std::vector<Facet>* facets_;
  const std::vector<ProjectedVertex>* vertices_;
  std::shared_ptr<const CutSides> cut_sides_;
  std::vector<Pair> pairs_;
  std::vector<SideInPlane> sides_;
  std::vector<SideOnSide> sides_on_sides_;
  std::size_t distinct_ = 0;  ///< number of results after the last forget_repeated()
};

}  // namespace ligne
