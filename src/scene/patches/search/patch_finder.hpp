#pragma once
/// Searches the facets of one object for surfaces. The steps are described at find_patches().

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "scene/patches/search/surface_search.hpp"

namespace ligne {

/// Makes patches of the surfaces that are found from the facets of an object. The base class is the search of the calling
/// thread; other threads have their own.
class PatchFinder : SurfaceSearch {
 public:
  PatchFinder(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph);

  /// Fills `patches`. Returns the index of the patch of each facet, or kNone.
  std::vector<std::uint32_t> run(std::vector<Patch>& patches);

  /// Whether a sample of facets yields so few surfaces that an object with `count` facets, of which this object is a part,
  /// counts as free-form. False unless nearly all sampled facets may be curved.
  bool seems_freeform(std::span<const std::uint32_t> facets, std::size_t count);

 private:
  /// A facet from which surfaces are tried, and its longest diagonal, which does not depend on the order of the corners.
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
  bool continues_smoothly(const Patch& patch, std::vector<std::uint32_t> facets);
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
  bool is_approximate_fillet(const std::vector<Patch>& patches, std::span<const std::uint32_t> facets);
  void find_fillets(std::span<const Seed> seeds, std::vector<Patch>& patches);
  void join_fillets(std::vector<Patch>& patches);
  bool is_tube(const PatchSurface& surface) const;
  bool is_fillet(std::uint32_t patch) const { return patch < is_fillet_.size() && is_fillet_[patch] != 0; }
  PatchCandidate whole_fillet(const Patch& patch, const PatchFacets& facets, std::uint32_t p, std::uint32_t q);
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
  std::vector<std::uint8_t> is_fillet_;    ///< per patch, set by join_fillets()
  std::vector<double> tubes_;              ///< tube radii that search() looks for, ascending; empty: any surface
  std::vector<std::uint8_t> has_failed_;   ///< per facet: 1 if no surface was found from it
  std::vector<std::uint8_t> at_border_;    ///< per facet: 1 at a border; empty if the object is whole
  std::vector<std::uint8_t> is_excluded_;  ///< per facet: 1 if search() no longer tries it as a seed
  std::deque<SurfaceSearch> others_;       ///< searches of the other threads
  std::vector<Trial> kept_;                ///< outcomes of seeds tried before their turn
  std::size_t all_grown_ = 0;              ///< number of facets over which surfaces grew from seeds that counted
};

}  // namespace ligne
