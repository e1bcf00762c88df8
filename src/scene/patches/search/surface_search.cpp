#include "scene/patches/search/surface_search.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace ligne {
namespace {

// Adjustable parameters.
/// Largest distance of corners from a surface, if it is more than rounding: a fraction of the sag. The sag counts because
/// surfaces between free forms are approximated; spheres are not, so their fraction is small.
constexpr double kSagPart = 0.03, kExactSagPart = 0.002;
/// Largest distance, in sags, of a corner from the surface of the starting values. If one is farther away, the values
/// are rejected. Cylinders that may turn into cones, and those of irregular triangles, may be farther away. So may tori:
/// the normals of coarse triangles between two circles tell little of the axis.
constexpr double kWildGuess = 1.5, kWildCylinder = 3, kWildTorus = 6;
/// Largest distance of the corners of a facet that may join two others from the starting values of their cylinder, by the
/// distance of their own corners, or by the tolerance if that is more: two facets have hardly more corners than determine
/// it.
constexpr double kWideGuess = 6;
/// Least number of corners of a sample for a cone that the normals do not tell: twice that of its parameters.
constexpr std::size_t kFewestConePoints = 2 * parameter_count(SurfaceKind::cone);
/// Arcs from a seed to the facets of the larger sample around it, and largest number of these facets.
constexpr int kWideSteps = 10;
constexpr std::size_t kMostWide = 28;
/// Least ratio between the numbers of facets on a cone that has grown and of those to which it was fitted, if these do not
/// lie on it exactly and their normals tell little of it. Programs approximate the curves in which cones end, as they do
/// those of long strips, but only a cone goes on as one.
constexpr std::size_t kSpread = 3;
/// Largest ratio of a facet's sag to the median for a cone on which all corners lie exactly. Fans between two curves have
/// triangles of many widths, and no plane meets a cone in two of its rulings.
constexpr double kExactConeSags = 12;
/// Least turn, in radians, of a cylinder whose corners may lie within kLoosePrecisions: fillets turn by less, and so do the
/// pieces of free forms that lie on cylinders by accident. Half of it must lie within kPrecisions.
constexpr double kLeastLooseTurn = 200 * std::numbers::pi / 180;
/// Largest number of facets of a band from which a sphere is fitted.
constexpr std::size_t kMostBand = 24;
/// Least number of facets of a strip that is tried by itself. Fewer prove nothing at a tolerance of kStripSagPart.
constexpr std::size_t kFewestStrip = 8;
/// Factors by which the area of a surface must exceed the largest one so far: of a cylinder or a cone, and of a sphere
/// or a torus. The second is larger, since each band of a cylinder or a cone lies on spheres and tori too, on which a
/// band beside it often lies by accident.
constexpr double kSimilarArea = 1.05, kRoundArea = 1.3;
/// Range of the slopes of cones. Over a length of ten radii, a cone of the least slope differs from a cylinder by a
/// thousandth of the radius, an eighth of the sag at 24 facets per turn. A cone of the largest slope differs from a
/// plane by half a degree.
constexpr double kLeastSlope = 1e-4, kLargestSlope = 100;
/// Range of the ratio between the radii of the middle circle of a torus and of its tube. Below it, the torus differs
/// from a sphere by less than a fiftieth of the tube's radius. Above it, the torus bends away from a cylinder by less
/// than a fifteenth of the tube's radius over ten times that radius.
constexpr double kLeastRing = 0.02, kLargestRing = 200;

/// Largest distance, in sags, of a corner from the starting values of a surface that are tried.
double wildest_guess(SurfaceKind kind) {
  if (kind == SurfaceKind::torus) return kWildTorus;
  return kind == SurfaceKind::cylinder ? kWildCylinder : kWildGuess;
}

}  // namespace

bool is_plausible(const PatchSurface& s) {
  switch (s.kind) {
    case SurfaceKind::torus:
      return s.radius > kLeastRing * s.tube && s.radius < kLargestRing * s.tube;
    case SurfaceKind::cone:
      return std::abs(s.slope) > kLeastSlope && std::abs(s.slope) < kLargestSlope;
    default:
      return s.radius > 0;
  }
}

SurfaceSearch::SurfaceSearch(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph,
                             const std::vector<std::uint32_t>& taken_by)
    : scene_(scene),
      topology_(topology),
      object_(object),
      graph_(graph),
      taken_by_(taken_by),
      stamp_(graph.size(), 0),
      best_of_(graph.size(), kNone),
      ask_stamp_(graph.size(), 0),
      look_of_(object.vertex_end - object.vertex_begin),
      is_fetched_(look_of_.size() / kWordBits + 1, 0),
      sag_part_(kSagPart) {}

/// A facet with two of its neighbours, three times at most, or with the only one. Three facets of a strip determine a
/// cylinder or a cone exactly.
std::vector<SurfaceSearch::FitSample> SurfaceSearch::strip_samples(std::uint32_t seed, std::span<const std::uint32_t> near) {
  std::vector<FitSample> sets;
  if (near.size() == 1) sets.push_back({{seed, near[0]}});
  for (std::size_t i = 0; i < near.size(); ++i) {
    for (std::size_t j = i + 1; j < near.size() && sets.size() < 3; ++j) sets.push_back({{seed, near[i], near[j]}});
  }
  return sets;
}

/// Facets on all sides of a facet: nearby ones, and more of them.
std::vector<SurfaceSearch::FitSample> SurfaceSearch::round_samples(std::uint32_t seed) {
  static_assert(kMostRing <= kMostWide && kRingSteps <= kWideSteps);
  std::vector<FitSample> samples(1);
  samples.reserve(2);
  std::vector<std::uint32_t> wide = around(seed, kWideSteps, kMostWide);
  const std::size_t count = std::min(near_count_, kMostRing);  // those of around() with fewer steps come first
  samples.front().facets.assign(wide.begin(), wide.begin() + static_cast<std::ptrdiff_t>(count));
  if (wide.size() > count) samples.push_back({std::move(wide), true});
  return samples;
}

/// Whether a cylinder was fitted to the same two or three facets before. They begin with the seed.
bool SurfaceSearch::was_tried(std::span<const std::uint32_t> facets) {
  const std::array pair = {std::min(facets[1], facets.back()), std::max(facets[1], facets.back())};
  if (std::ranges::find(tried_, pair) != tried_.end()) return true;
  tried_.push_back(pair);
  return false;
}

/// Tries a surface through a sample, and keeps it if its area exceeds that of the best one so far by a factor.
void SurfaceSearch::consider_sample(SurfaceKind kind, std::uint32_t seed, FitSample& sample, double factor,
                                    PatchCandidate& best) {
  // Facets of the best surface so far lead to it again.
  const bool is_known = !best.facets.empty() && best.patch.surface.kind == kind &&
                        std::ranges::all_of(sample.facets, [&](std::uint32_t f) { return best_of_[f] == seed; });
  if (is_known) return;
  if (kind == SurfaceKind::cylinder && sample.facets.size() <= 3 && was_tried(sample.facets)) return;
  const double sag_part = sag_part_;
  PatchCandidate c = try_surface(kind, seed, sample);
  sag_part_ = sag_part;
  if (c.facets.empty() || c.area <= factor * best.area) return;
  for (const std::uint32_t f : best.facets) best_of_[f] = kNone;
  best = std::move(c);
  for (const std::uint32_t f : best.facets) best_of_[f] = seed;
}

SurfaceSearch::Outcome SurfaceSearch::search_from(std::uint32_t seed, std::span<const double> tubes) {
  ++ask_round_;
  asked_.clear();
  Outcome outcome;
  outcome.best = tubes.empty() ? best_at(seed) : best_tube_at(seed, tubes);
  for (const std::uint32_t f : outcome.best.facets) best_of_[f] = kNone;  // a later search from this seed begins anew
  outcome.asked = asked_;
  outcome.grown = take_grown();
  return outcome;
}

PatchCandidate SurfaceSearch::best_at(std::uint32_t seed) {
  PatchCandidate best;
  tried_.clear();
  const auto consider = [&](SurfaceKind kind, auto&& sample, double factor) {
    consider_sample(kind, seed, sample, factor, best);
  };
  std::vector<std::uint32_t> near = beside(seed);
  if (near.empty()) return best;
  if (graph_.vertices[seed].size() == 3 && near.size() > 2) near.clear();  // in no strip
  std::vector<FitSample> sets = strip_samples(seed, near);
  // A strip without curved facets beside it needs no comparison with other surfaces.
  const auto is_settled = [&] { return !best.facets.empty() && !goes_on(best); };
  for (FitSample& set : sets) consider(SurfaceKind::cylinder, set, kSimilarArea);
  const auto consider_pairs = [&] {
    for (std::size_t i = 0; i < std::min<std::size_t>(near.size(), 2) && best.facets.empty(); ++i)
      consider(SurfaceKind::cylinder, FitSample{{seed, near[i]}}, kSimilarArea);
  };
  consider_pairs();
  if (near.size() > 2 && best.facets.empty()) {
    sort_by_sides(seed, near);
    consider(SurfaceKind::cylinder, FitSample{{seed, near[0], near[1]}}, kSimilarArea);
    consider_pairs();
  }
  if (is_settled()) return best;
  // The corners of triangles between two curves share no rulings, so more triangles are needed.
  FitSample strip{strip_of(seed)};
  if (strip.facets.size() >= kFewestStrip && best.facets.size() < strip.facets.size()) {
    sag_part_ = kStripSagPart;
    consider(SurfaceKind::cylinder, strip, kSimilarArea);
    sag_part_ = kSagPart;
    if (is_settled()) return best;
  }
  // Where facets form no strips, more of them are needed.
  std::vector<FitSample> round = round_samples(seed);
  for (FitSample& sample : round) consider(SurfaceKind::cylinder, sample, kSimilarArea);
  if (is_settled()) return best;
  for (FitSample& set : sets) consider(SurfaceKind::cone, set, kSimilarArea);
  for (FitSample& sample : round) consider(SurfaceKind::cone, sample, kSimilarArea);
  if (is_settled()) return best;
  FitSample within;
  if (best.facets.empty()) within = {within_rims(round.back().facets, kWideSteps, kMostWide), true};
  const bool has_rims = within.facets.size() >= kFewestStrip;
  if (has_rims) consider(SurfaceKind::cylinder, within, kSimilarArea);
  if (has_rims && best.facets.empty()) consider(SurfaceKind::cone, within, kSimilarArea);
  // A band of a sphere also lies on a cylinder or a cone, and determines the sphere.
  FitSample band{best.facets};
  band.facets.resize(std::min(band.facets.size(), kMostBand));
  if (!band.facets.empty()) consider(SurfaceKind::sphere, band, kRoundArea);
  consider(SurfaceKind::sphere, round.front(), kRoundArea);
  for (FitSample& sample : round) consider(SurfaceKind::torus, sample, kRoundArea);
  if (has_rims && best.facets.empty()) consider(SurfaceKind::torus, within, kRoundArea);
  return best;
}

/// Fits a surface to a sample. Returns whether the sample lies on it, and sets the surface, the sag and the residual of `c`.
/// Lowers sag_part_ if the normals of the facets give no useful starting values: such facets lie on a surface exactly or by
/// accident.
bool SurfaceSearch::fit_sample(SurfaceKind kind, FitSample& sample, PatchCandidate& c) {
  if (sample.by_edges && kind != SurfaceKind::torus && !lies_on_quadric(sample)) return false;
  complete(sample);
  PatchSurface& surface = c.patch.surface;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // Largest distance of a corner beyond the precision, in sags
  const double wildest = wildest_guess(kind);
  double farthest = 0, loosest_sag = 0;  // set by wildness(): refine() hardly leads to a larger sag
  const auto wildness = [&] {
    const double sag = sag_of(surface, sample.facets), wild = wildest * sag + tolerance_for(kind, 0);
    farthest = 0;
    for (const Point3& p : sample.shape.points) {
      const double distance = std::abs(surface.distance(p));
      if (!(distance <= wild)) return kInfinity;
      farthest = std::max(farthest, distance);
    }
    loosest_sag = sag + farthest;
    const double beyond = farthest - tolerance_for(kind, 0);
    return beyond > 0 ? beyond / sag : 0;
  };
  const bool leads_to_cone = sample.shape.points.size() >= kFewestConePoints;
  const auto refine = [&] {
    double hopeless = 2 * tolerance_for(kind, loosest_sag);
    if (kind == SurfaceKind::cylinder && leads_to_cone) hopeless = std::max(hopeless, 2 * kWildCylinder * loosest_sag);
    c.residual = refine_surface(surface, sample.shape.points, hopeless);
    if (!(c.residual <= hopeless)) return false;
    c.patch.sag = sag_of(surface, sample.facets);
    return c.residual <= tolerance_for(kind, c.patch.sag);
  };
  const double guess_wildness = guess_surface(kind, sample.shape, surface) ? wildness() : kInfinity;
  // Two facets always lie on a cylinder.
  const auto may_grow = [&] {
    const double wide = kWideGuess * std::max(farthest, tolerance_for(kind, loosest_sag));
    return sample.facets.size() > 2 || may_go_on(surface, sample.facets, wide);
  };
  if (guess_wildness <= wildest && may_grow()) {
    const bool lies_on_it = refine();
    if (kind == SurfaceKind::cylinder && c.residual <= kWildCylinder * c.patch.sag) sample.cylinder = surface;
    const bool is_doubtful = guess_wildness > kWildGuess || sample.by_edges;
    if (lies_on_it && (!is_doubtful || may_lie_on(c))) return true;
  }
  if (kind != SurfaceKind::cone) return false;
  if (sample.cone) {
    surface = *sample.cone;
    if (wildness() <= kWildGuess && refine() && may_lie_on(c)) return true;
  }
  if (!sample.cylinder || !leads_to_cone) return false;
  // The normals of irregular triangles tell little of a cone, but it has the rulings and the curvature of a cylinder.
  sag_part_ = kExactSagPart;
  surface = cone_from_cylinder(*sample.cylinder, sample.shape.points);
  return wildness() <= kWildGuess && refine();
}

/// Whether the corners of a sample lie on a quadric. Sets the cone that this gives.
bool SurfaceSearch::lies_on_quadric(FitSample& sample) {
  if (sample.shape.frames.empty()) {
    complete(sample);
    sample.cone = cone_from_quadric(sample.shape);
  }
  return sample.cone.has_value();
}

/// Whether a candidate is worth growing though poor normals have led to it: its sample lies on the surface exactly, or the
/// surface is a cone, which must then spread. Sets sag_part_.
bool SurfaceSearch::may_lie_on(PatchCandidate& c) {
  const SurfaceKind kind = c.patch.surface.kind;
  sag_part_ = kExactSagPart;
  if (c.residual <= tolerance_for(kind, c.patch.sag)) return true;
  if (kind != SurfaceKind::cone) return false;
  sag_part_ = kStripSagPart;
  c.must_spread = true;
  return true;
}

/// Whether half of the corners of a candidate, which fetch_points() has fetched, lie as near to its surface as those of
/// other samples: the curves in which a cone ends may be approximated, but rows of a dome lie on none.
bool SurfaceSearch::is_mostly_near(const PatchCandidate& c) const {
  const double tolerance = std::max(kPrecisions * object_.precision, kSagPart * c.patch.sag);
  const auto is_near = [&](const Point3& p) { return std::abs(c.patch.surface.distance(p)) <= tolerance; };
  return 2 * std::ranges::count_if(points_, is_near) >= static_cast<std::ptrdiff_t>(points_.size());
}

/// Whether the facets that grew last are those of a sample.
bool SurfaceSearch::is_same(std::span<const std::uint32_t> grown, std::span<const std::uint32_t> sample) const {
  return grown.size() == sample.size() && std::ranges::all_of(sample, [&](std::uint32_t f) { return stamp_[f] == round_; });
}

/// Fits a surface to a few facets, and lets it grow from the seed. The result has no facets if this fails.
PatchCandidate SurfaceSearch::try_surface(SurfaceKind kind, std::uint32_t seed, FitSample& sample) {
  PatchCandidate c;
  return fit_sample(kind, sample, c) ? grow_candidate(std::move(c), seed, sample) : PatchCandidate{};
}

/// Lets the surface of a candidate, which was fitted to a sample, grow from the seed. The result has no facets if this
/// fails. A certain cylinder without a firm border is tried again with a larger tolerance: a single corner that a program
/// has misplaced ends it before its border.
PatchCandidate SurfaceSearch::grow_candidate(PatchCandidate c, std::uint32_t seed, const FitSample& sample) {
  if (!grow_certain(c, seed, sample)) return {};
  if (has_firm_border(c)) return c;
  // is_certain() has found the angles of a cylinder.
  if (c.patch.surface.kind != SurfaceKind::cylinder || !is_fine(c.patch)) return {};
  if (turn_of_angles() < kLeastLooseTurn / 2) return {};
  c.facets.clear();
  c.area = 0;
  precisions_ = kLoosePrecisions;
  const bool is_whole = grow_certain(c, seed, sample) && turn_of_angles() >= kLeastLooseTurn && has_firm_border(c);
  precisions_ = kPrecisions;
  if (!is_whole) return {};
  return c;
}

/// Lets the surface of a candidate grow from the seed. Returns whether it is certain then.
bool SurfaceSearch::grow_certain(PatchCandidate& c, std::uint32_t seed, const FitSample& sample) {
  PatchSurface& surface = c.patch.surface;
  const SurfaceKind kind = surface.kind;
  c.patch.outward = glm::dot(surface.normal(graph_.frames[seed].middle), graph_.frames[seed].normal) > 0;
  const auto most_sags = [&] {
    return kind == SurfaceKind::cone && c.residual <= kPrecisions * object_.precision ? kExactConeSags : kMostSags;
  };
  // Few fine facets tell little of a surface that goes far beyond them. Each round about doubles their extent.
  constexpr int kMostRounds = 3, kMostFineRounds = 12;
  for (int round = 0; round < (is_fine(c.patch) ? kMostFineRounds : kMostRounds); ++round) {
    std::vector<std::uint32_t> grown = grow(c.patch, seed, most_sags());
    if (grown.size() <= c.facets.size()) break;
    c.facets.swap(grown);
    if (round == 0 && is_same(c.facets, sample.facets)) {
      fetch_points(c.facets);
      break;
    }
    PatchSurface refined = surface;
    fetch_points(c.facets);
    const double next = refine_surface(refined, points_);
    const double sag = sag_of(refined, c.facets);
    if (!(next <= tolerance_for(kind, sag))) {
      if (round < kMostRounds) return false;
      c.facets.swap(grown);  // has_firm_border() decides whether the surface ends there
      fetch_points(c.facets);
      break;
    }
    surface = refined;
    c.patch.sag = sag;
    c.residual = next;
  }
  if (c.facets.empty() || !is_plausible(surface) || !is_certain(c)) return false;
  if (c.must_spread && (c.facets.size() < kSpread * sample.facets.size() || !is_mostly_near(c))) return false;
  for (const std::uint32_t f : c.facets) c.area += graph_.area[f];
  return true;
}

/// The facets on the surface that are connected to the seed; facets of other patches only if `over_patches`.
std::vector<std::uint32_t> SurfaceSearch::grow(const Patch& patch, std::uint32_t seed, double most_sags, bool over_patches) {
  const double tolerance = tolerance_for(patch.surface.kind, patch.sag);
  const bool over_planes = is_fine(patch);  // several fine facets may seem to be a plane
  std::vector<std::uint32_t> facets;
  forget_looks();
  if (!lies_on(patch, seed, tolerance)) return facets;
  ++round_;
  facets.push_back(seed);
  stamp_[seed] = round_;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[i])) {
      if (stamp_[arc.facet] == round_ || (graph_.is_plane[arc.facet] && !over_planes)) continue;
      if (!over_patches && !is_left(arc.facet)) continue;
      const double sags = graph_.vertices[arc.facet].size() <= 4 ? most_sags : kMostSags;
      if (!lies_on(patch, arc.facet, tolerance, kNormalCosine, sags)) continue;
      stamp_[arc.facet] = round_;
      facets.push_back(arc.facet);
    }
  }
  grown_ += facets.size();
  return facets;
}

double SurfaceSearch::tolerance_for(SurfaceKind kind, double sag) const {
  return std::max(precisions_ * object_.precision, (kind == SurfaceKind::sphere ? kExactSagPart : sag_part_) * sag);
}

}  // namespace ligne
