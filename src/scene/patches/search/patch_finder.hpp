#pragma once
/// Searches the facets of one object for surfaces. The steps are described at find_patches().

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "scene/patches/search/surface_search.hpp"

namespace ligne {

/// Makes patches of the surfaces that are found from the facets of an object. It is a search itself, for which it keeps the
/// patch of each facet, and has others for seeds that are tried at once.
class PatchFinder : SurfaceSearch {
 public:
  PatchFinder(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph);

  /// Fills `patches`. Returns the index of the patch of each facet, or kNone.
  std::vector<std::uint32_t> run(std::vector<Patch>& patches);

  /// Whether so few surfaces are found on some facets that an object of `count` facets, of which this one is a part, has
  /// none. Nearly all of them must be facets that may be curved.
  bool seems_free(std::span<const std::uint32_t> facets, std::size_t count);

 private:
  /// A facet from which surfaces are tried, and its longest diagonal: a maximum, not a sum, so it does not depend on the
  /// order of the corners.
  struct Seed {
    double length;
    std::uint32_t facet;
    bool operator<(const Seed& o) const { return length != o.length ? length > o.length : facet < o.facet; }
  };
  /// A seed that is tried together with others, and the facets that it excludes if it fails.
  struct Trial {
    std::size_t number = 0;              ///< index into the seeds
    std::vector<std::uint32_t> alike{};  ///< facets that are_alike() and were not excluded before
    bool is_done = false;                ///< whether the outcome is known
    Outcome outcome{};
  };

  using PatchFacets = std::vector<std::vector<std::uint32_t>>;  ///< per patch, its facets

  bool has_grown_enough() const;
  bool may_be_seed(std::uint32_t f) const { return may_curve(f) && !graph_.arcs_of(f).empty(); }
  bool goes_over(const Patch& patch, std::vector<std::uint32_t> facets);
  bool find_few(std::span<const Seed> samples, std::size_t count, std::vector<Patch>& patches);
  std::vector<Seed> seeds() const;
  static std::vector<Seed> every_seed(std::span<const Seed> seeds, std::size_t step);
  bool are_alike(const Seed& failed, std::uint32_t f) const;
  void search(std::span<const Seed> seeds, std::vector<Patch>& patches);
  std::vector<Trial> next_trials(std::span<const Seed> seeds, std::size_t from, std::size_t most);
  void try_all(std::span<const Seed> seeds, std::vector<Trial>& trials);
  void take_outcomes(std::vector<Trial>& trials);
  void keep_outcomes(std::span<Trial> trials);
  void join_bands(std::vector<Patch>& patches);
  PatchFacets facets_of(const std::vector<Patch>& patches) const;
  bool is_near_rounding(const std::vector<Patch>& patches, std::span<const std::uint32_t> facets);
  void find_roundings(std::span<const Seed> seeds, std::vector<Patch>& patches);
  void join_roundings(std::vector<Patch>& patches);
  bool is_tube(const PatchSurface& surface) const;
  bool is_rounding(std::uint32_t patch) const { return patch < is_rounding_.size() && is_rounding_[patch] != 0; }
  PatchCandidate whole_rounding(const Patch& patch, const PatchFacets& facets, std::uint32_t p, std::uint32_t q);
  PatchCandidate torus_through(const std::vector<Patch>& patches, const PatchFacets& facets, std::uint32_t p,
                               std::uint32_t q);
  bool is_cylinder_within(const PatchSurface& surface, std::span<const std::uint32_t> facets, double distance);
  Point3 middle_of(std::span<const std::uint32_t> facets) const;
  void join_borders(const std::vector<Patch>& patches);
  void join_facets(const std::vector<Patch>& patches, bool exact);
  std::vector<std::uint8_t> tube_pieces(const std::vector<Patch>& patches) const;
  bool is_along(const PatchSurface& surface, std::uint32_t edge) const;
  double distance_of(const PatchSurface& surface, std::uint32_t f) const;
  void trade_borders(const std::vector<Patch>& patches);
  bool lies_on_chords(const Patch& patch, std::uint32_t f) const;
  bool merge_patches(const std::vector<Patch>& patches, const std::vector<std::uint32_t>& found_by);

  std::vector<std::uint32_t> patch_of_;    ///< per facet: index of its patch, or kNone
  std::vector<std::uint8_t> is_rounding_;  ///< per patch so far: whether it is one that join_roundings() has looked at
  std::vector<double> tubes_;              ///< radii of the tubes that search() looks for, ascending; empty: any surface
  std::vector<std::uint8_t> has_failed_;   ///< per facet: whether no surface was found from it
  std::vector<std::uint8_t> at_border_;    ///< per facet of a part of an object: whether it is at a border; else empty
  std::vector<std::uint8_t> is_excluded_;  ///< per facet: whether it is no seed of search() any more
  std::deque<SurfaceSearch> others_;       ///< for seeds that are tried at once
  std::vector<Trial> kept_;                ///< seeds that search() has tried before their turn
  std::size_t all_grown_ = 0;              ///< number of facets that surfaces grew over from seeds that counted
};

}  // namespace ligne
