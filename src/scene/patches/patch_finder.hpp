#pragma once
/// Searches the facets of one object for surfaces.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// A surface with the facets that lie on it.
struct PatchCandidate {
  Patch patch;
  std::vector<std::uint32_t> facets;
  double area = 0;
  double residual = 0;  ///< largest distance of a corner from the surface
};

class PatchFinder {
 public:
  PatchFinder(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph);

  /// Fills `patches`, and the number of the patch per facet.
  std::vector<std::uint32_t> run(std::vector<Patch>& patches);

 private:
  static constexpr std::uint32_t kWordBits = 64;  ///< of is_fetched_

  struct VertexLook {
    bool is_on = false;      ///< the vertex lies on the surface
    Point3 normal{0, 0, 0};  ///< of the surface there, if so
  };
  struct LookPlace {
    std::uint32_t round = 0, number = 0;  ///< valid where the round is look_round_: the place in looks_
  };

  bool may_curve(std::uint32_t f) const { return !graph_.is_plane[f] && !graph_.is_sliver[f] && patch_of_[f] == kNone; }
  std::vector<std::uint32_t> seeds() const;
  void search(std::span<const std::uint32_t> seeds, std::vector<Patch>& patches);
  PatchCandidate best_at(std::uint32_t seed);
  PatchCandidate try_surface(SurfaceKind kind, std::uint32_t seed, std::span<const std::uint32_t> facets);
  std::vector<std::uint32_t> grow(const Patch& patch, std::uint32_t seed);
  std::vector<std::uint32_t> around(std::uint32_t seed, int rings, std::size_t most);
  void fetch_points(std::span<const std::uint32_t> facets);
  void sort_by_bits(std::uint32_t low, std::uint32_t high);
  double sag_of(const PatchSurface& surface, std::span<const std::uint32_t> facets);
  double tolerance_for(SurfaceKind kind, double sag) const;
  void forget_looks();
  const VertexLook& look_at(const Patch& patch, std::uint32_t vertex, double tolerance);
  bool lies_on(const Patch& patch, std::uint32_t f, double tolerance);
  bool is_certain(const PatchCandidate& c);
  std::size_t angles_of(const PatchSurface& surface, bool about_circle);
  bool is_tangent(const PatchCandidate& c, std::size_t rows);
  bool goes_on(const PatchCandidate& c);
  void join_borders(const std::vector<Patch>& patches);
  void merge_patches(const std::vector<Patch>& patches, const std::vector<std::uint32_t>& found_by);

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  const FacetGraph& graph_;
  std::vector<std::uint32_t> patch_of_;  ///< per facet
  std::vector<std::uint32_t> stamp_;     ///< per facet: the round in which it was met last
  std::uint32_t round_ = 0;
  std::vector<LookPlace> look_of_;         ///< per vertex of the object
  std::vector<VertexLook> looks_;          ///< of the vertices met since forget_looks()
  std::uint32_t look_round_ = 0;           ///< number of calls of forget_looks()
  std::vector<std::uint64_t> is_fetched_;  ///< per vertex of the object a bit, 0 but in sort_by_bits()
  std::vector<std::uint32_t> vertices_;    ///< of fetch_points()
  std::vector<Point3> points_;             ///< of fetch_points()
  std::vector<FacetFrame> frames_;
  std::vector<double> numbers_;
};

}  // namespace ligne
