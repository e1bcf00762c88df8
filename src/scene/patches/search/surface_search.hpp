#pragma once
/// The search for one surface from a facet of an object. The steps are described at find_patches().

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// A fitted surface with the facets that lie on it.
struct PatchCandidate {
  Patch patch{};
  std::vector<std::uint32_t> facets{};
  double area = 0;           ///< of the facets
  bool must_spread = false;  ///< whether it needs kSpread times as many facets as its sample
  double residual = 0;       ///< largest distance of a corner of the facets from the surface, model units
};

/// Whether the proportions of a torus, or the slope of a cone, are in the usual range. Other tori are spheres or
/// cylinders within any tolerance, and other cones are cylinders or planes.
bool is_plausible(const PatchSurface& s);

/// Finds the surface through a facet. Its memory serves one search at a time; searches of one object with memory of their
/// own may run at once.
class SurfaceSearch {
 public:
  /// `taken_by`: per facet the patch to which it belongs, or kNone, kept by the caller. A search changes nothing in it.
  SurfaceSearch(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
                const std::vector<std::uint32_t>& taken_by);

  /// The result of a search from one facet.
  struct Outcome {
    PatchCandidate best;               ///< without facets if there is no surface
    std::vector<std::uint32_t> asked;  ///< facets without a patch that might have been part of it; no others matter
    std::size_t grown = 0;             ///< number of facets that surfaces grew over
  };
  /// best_at(), or best_tube_at() if `tubes` has radii.
  Outcome search_from(std::uint32_t seed, std::span<const double> tubes);

  /// The surface of the largest area through a facet, from several sets of facets beside it. It has no facets if there is
  /// none.
  PatchCandidate best_at(std::uint32_t seed);

  /// The largest torus through a facet whose tube has one of these radii, ascending, at the tolerance of long strips. It has
  /// no facets if there is none.
  PatchCandidate best_tube_at(std::uint32_t seed, std::span<const double> tubes);

  /// Number of facets that surfaces grew over since the last call.
  std::size_t take_grown() { return std::exchange(grown_, 0); }

 protected:
  /// Adjustable. Largest distance, in precisions of the coordinates, of corners that lie on a surface exactly.
  static constexpr double kPrecisions = 8;
  /// Adjustable. Largest distance of corners from a cylinder whose border kPrecisions does not find, as kPrecisions.
  static constexpr double kLoosePrecisions = 32;
  static constexpr std::uint32_t kWordBits = 64;  ///< bits of a word of is_fetched_
  /// Adjustable. A facet on which no surface was found excludes its neighbours of at least this part of its area as seeds;
  /// smaller ones may belong to a fillet beside a plane. A neighbour of less than this part of a facet's area is not in one
  /// strip with it.
  static constexpr double kLikeArea = 0.25;
  /// Arcs from a seed to the facets of the sample around it, and largest number of these facets.
  static constexpr int kRingSteps = 2;
  static constexpr std::size_t kMostRing = 24;
  /// Largest ratio of a facet's sag to the median. Tessellators keep to one sag; a flat side between fillets exceeds
  /// it.
  static constexpr double kMostSags = 4;
  /// Adjustable. Least cosine between the normals of a facet and of its surface at its corners. It admits half of the
  /// diagonal of a square facet on a surface with twelve facets per turn.
  static constexpr double kNormalCosine = 0.92;

  /// Largest distance of corners from a surface, as a fraction of the sag, for long strips and fillets: many corners are
  /// evidence all the same. Programs approximate the curves at which fillets end to a thousandth of a millimetre or worse.
  static constexpr double kStripSagPart = 0.25;

  /// Lets tori be approximate while it exists: gives them the tolerance of strips, and keeps them off the discs in their
  /// circles, which are as near to them.
  class ApproximateTori {
   public:
    explicit ApproximateTori(SurfaceSearch& search) : search_(search) {
      std::swap(search_.sag_part_, sag_part_);
      search_.leaves_discs_ = true;
    }
    ~ApproximateTori() {
      std::swap(search_.sag_part_, sag_part_);
      search_.leaves_discs_ = false;
    }
    ApproximateTori(const ApproximateTori&) = delete;
    ApproximateTori& operator=(const ApproximateTori&) = delete;

   private:
    SurfaceSearch& search_;
    double sag_part_ = kStripSagPart;
  };

  /// Whether a vertex lies on the surface that is tried, remembered because several facets share it.
  struct VertexLook {
    bool is_on = false;
    Point3 normal{0, 0, 0};  ///< normal of the surface there, if is_on; 0 at the tip of a cone, which has none
  };
  /// Facets to which surfaces of several kinds are fitted.
  struct FitSample {
    std::vector<std::uint32_t> facets;
    bool by_edges = false;                   ///< whether edge_frames() tell its normals, else those of the facets
    SurfaceSample shape{};                   ///< empty until complete()
    std::optional<PatchSurface> cylinder{};  ///< the cylinder of least squares, once it was fitted
    std::optional<PatchSurface> cone{};      ///< cone_from_quadric(), of the larger sample around a seed
  };
  struct LookPlace {
    std::uint32_t round = 0, number = 0;  ///< index into looks_, valid only if round equals look_round_
  };

  bool may_curve(std::uint32_t f) const { return !graph_.is_plane[f] && !graph_.is_sliver[f] && taken_by_[f] == kNone; }
  /// Whether a facet has no patch. Remembers that this was asked, since it ends when a patch takes the facet.
  bool is_left(std::uint32_t f) {
    if (taken_by_[f] != kNone) return false;
    if (std::exchange(ask_stamp_[f], ask_round_) != ask_round_) asked_.push_back(f);
    return true;
  }
  bool is_left_and_may_curve(std::uint32_t f) { return !graph_.is_plane[f] && !graph_.is_sliver[f] && is_left(f); }
  double longest_diagonal(std::uint32_t f) const;
  bool was_tried(std::span<const std::uint32_t> facets);
  std::vector<FacetFrame> edge_frames(std::span<const std::uint32_t> facets);
  void complete(FitSample& sample);
  bool fit_sample(SurfaceKind kind, FitSample& sample, PatchCandidate& c);
  void consider_sample(SurfaceKind kind, std::uint32_t seed, FitSample& sample, double factor, PatchCandidate& best);
  PatchCandidate try_surface(SurfaceKind kind, std::uint32_t seed, FitSample& sample);
  PatchCandidate grow_candidate(PatchCandidate c, std::uint32_t seed, const FitSample& sample);
  bool grow_certain(PatchCandidate& c, std::uint32_t seed, const FitSample& sample);
  std::vector<std::uint32_t> grow(const Patch& patch, std::uint32_t seed, double most_sags = kMostSags,
                                  bool over_patches = false);
  bool lies_on_quadric(FitSample& sample);
  bool may_lie_on(PatchCandidate& c);
  bool may_go_on(const PatchSurface& surface, std::span<const std::uint32_t> facets, double tolerance) const;
  bool is_mostly_near(const PatchCandidate& c) const;
  bool is_same(std::span<const std::uint32_t> grown, std::span<const std::uint32_t> sample) const;
  template <class MayCross>
  std::vector<std::uint32_t> reach(std::uint32_t seed, int rings, std::size_t most, MayCross may_cross);
  std::vector<std::uint32_t> around(std::uint32_t seed, int rings, std::size_t most);
  std::vector<std::uint32_t> within_rims(std::span<const std::uint32_t> near, int rings, std::size_t most);
  std::vector<FitSample> round_samples(std::uint32_t seed);
  std::vector<std::uint32_t> strip_of(std::uint32_t seed);
  std::vector<std::uint32_t> beside(std::uint32_t seed);
  static std::vector<FitSample> strip_samples(std::uint32_t seed, std::span<const std::uint32_t> near);
  void sort_by_sides(std::uint32_t seed, std::vector<std::uint32_t>& near) const;
  void fetch_points(std::span<const std::uint32_t> facets);
  void sort_by_bits(std::uint32_t low, std::uint32_t high);
  double sag_of(const PatchSurface& surface, std::span<const std::uint32_t> facets);
  bool has_firm_border(const PatchCandidate& c);
  bool ends_within(const PatchCandidate& c, double tolerance);
  double tolerance_for(SurfaceKind kind, double sag) const;
  void forget_looks();
  const VertexLook& look_at(const Patch& patch, std::uint32_t vertex, double tolerance);
  bool is_near(const PatchSurface& surface, std::uint32_t f, double distance) const;
  bool lies_on(const Patch& patch, std::uint32_t f, double tolerance, double least_cosine = kNormalCosine,
               double most_sags = kMostSags);
  bool is_in_disc(const Patch& torus, std::uint32_t f) const;
  double least_distance() const;
  bool is_certain(const PatchCandidate& c);
  bool is_polygon(const PatchCandidate& c, std::size_t angles);
  bool is_ring_of_polygon(const PatchCandidate& c);
  bool is_fan(const PatchCandidate& c) const;
  bool is_row_by_accident(const PatchCandidate& c) const;
  bool is_fine(const Patch& patch) const;
  bool explains_rise(const PatchCandidate& c) const;
  std::size_t angles_of(const PatchSurface& surface, bool about_circle);
  double turn_of_angles() const;
  bool has_equal_steps() const;
  bool is_tangent(const PatchCandidate& c, std::size_t rows);
  bool goes_on(const PatchCandidate& c);

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  const FacetGraph& graph_;
  const std::vector<std::uint32_t>& taken_by_;  ///< per facet: a patch, or kNone
  std::vector<std::uint32_t> stamp_;            ///< per facet: the value of round_ when a search visited it last
  std::vector<std::uint32_t> best_of_;  ///< per facet: a seed, if it lies on the best surface so far of best_at(seed)
  std::vector<std::array<std::uint32_t, 2>> tried_;  ///< pairs of facets to which, with the seed, cylinders were fitted
  std::vector<std::uint32_t> ask_stamp_;  ///< per facet: the value of ask_round_ when is_left() told that it is left
  std::vector<std::uint32_t> asked_;      ///< facets that is_left() told to be left in the latest round
  std::uint32_t round_ = 0, ask_round_ = 0;
  std::size_t near_count_ = 0;             ///< number of facets within kRingSteps arcs that reach() found last
  std::vector<LookPlace> look_of_;         ///< per vertex of the object
  std::vector<VertexLook> looks_;          ///< of the vertices visited since forget_looks()
  std::uint32_t look_round_ = 0;           ///< number of calls of forget_looks()
  std::vector<std::uint64_t> is_fetched_;  ///< one bit per vertex of the object; all 0 outside sort_by_bits()
  std::vector<std::uint32_t> vertices_;    ///< result of fetch_points(): vertices of the facets
  std::vector<Point3> points_;             ///< result of fetch_points(): their positions
  std::vector<double> numbers_;
  std::size_t grown_ = 0;            ///< number of facets that surfaces grew over since take_grown()
  bool leaves_discs_ = false;        ///< whether facets that are is_in_disc() of a torus do not lie on it
  double precisions_ = kPrecisions;  ///< largest distance of corners from the surface, in precisions of the coordinates
  double sag_part_;                  ///< largest distance of corners from the surface, as a fraction of the sag
};

}  // namespace ligne
