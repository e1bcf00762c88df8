#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "base/no_index.hpp"
#include "scene/patches/search/patch_finder.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Largest relative difference between the radii of tubes that count as one.
constexpr double kSameTube = 0.005;
/// Largest sine of the angle between the axes of a fillet and of its boss: the top of a boss may slant.
constexpr double kSlantSine = 0.1;
/// Largest distance between these axes, and between the radii at which both surfaces end, as a fraction of the boss's
/// radius.
constexpr double kBesideBoss = 0.03;

/// Whether a torus begins where a cylinder ends, about nearly the same axis.
bool is_fillet_of(const PatchSurface& torus, const PatchSurface& boss) {
  if (boss.kind != SurfaceKind::cylinder || glm::length(glm::cross(torus.axis, boss.axis)) > kSlantSine) return false;
  const double inner = std::abs(torus.radius - torus.tube), outer = torus.radius + torus.tube;
  const double apart = std::min(std::abs(inner - boss.radius), std::abs(outer - boss.radius));
  return std::max(apart, axis_place(boss, torus.at).radius) <= kBesideBoss * boss.radius;
}

/// Whether one of the radii, which are ascending, equals `tube`.
bool is_among(double tube, std::span<const double> tubes) {
  const auto next = std::ranges::lower_bound(tubes, tube * (1 - kSameTube));
  return next != tubes.end() && *next <= tube * (1 + kSameTube);
}

}  // namespace

PatchCandidate SurfaceSearch::best_tube_at(std::uint32_t seed, std::span<const double> tubes) {
  PatchCandidate best;
  const ApproximateTori approximate(*this);
  for (FitSample& sample : round_samples(seed)) {
    complete(sample);
    PatchCandidate c;
    PatchSurface& surface = c.patch.surface;
    if (!guess_surface(SurfaceKind::torus, sample.shape, surface)) continue;
    c.residual = refine_surface(surface, sample.shape.points);
    c.patch.sag = sag_of(surface, sample.facets);
    if (!is_among(surface.tube, tubes) || !(c.residual <= tolerance_for(surface.kind, c.patch.sag))) continue;
    c = grow_candidate(std::move(c), seed, sample);
    if (c.area > best.area && is_among(c.patch.surface.tube, tubes)) best = std::move(c);
  }
  return best;
}

/// Whether the corners of a facet lie on one circle about the axis of a torus, within the tolerance of a fillet. Then it is
/// a piece of the disc in this circle, such as the top of a boss.
bool SurfaceSearch::is_in_disc(const Patch& torus, std::uint32_t f) const {
  if (graph_.is_sliver[f]) return false;
  const AxisPlace first = axis_place(torus.surface, scene_.vertices[graph_.vertices[f].front()]);
  return std::ranges::all_of(graph_.vertices[f], [&](std::uint32_t v) {
    const AxisPlace place = axis_place(torus.surface, scene_.vertices[v]);
    return std::hypot(place.radius - first.radius, place.along - first.along) <= 2 * kStripSagPart * torus.sag;
  });
}

/// Whether facets lie on a torus that begins at a boss or bore beside them, but not exactly.
bool PatchFinder::is_approximate_fillet(const std::vector<Patch>& patches, std::span<const std::uint32_t> facets) {
  const PatchSurface& torus = patches[patch_of_[facets.front()]].surface;
  const auto is_beside_boss = [&](std::uint32_t f) {
    return std::ranges::any_of(graph_.arcs_of(f), [&](const FacetGraph::Arc& arc) {
      const std::uint32_t q = patch_of_[arc.facet];
      return q != kNone && is_fillet_of(torus, patches[q].surface);
    });
  };
  if (torus.kind != SurfaceKind::torus || std::ranges::none_of(facets, is_beside_boss)) return false;
  fetch_points(facets);
  const double rounding = tolerance_for(torus.kind, 0);
  return std::ranges::any_of(points_, [&](const Point3& p) { return std::abs(torus.distance(p)) > rounding; });
}

/// Finds the fillets of bosses and bores that are alike. Where the top of a boss slants or bends, its fillet is only nearly
/// a torus, and is found in pieces or not at all. So tubes with the radii found are searched beside all bosses at the
/// tolerance of strips, and the pieces of one torus are joined.
void PatchFinder::find_fillets(std::span<const Seed> seeds, std::vector<Patch>& patches) {
  const PatchFacets facets = facets_of(patches);
  for (const std::vector<std::uint32_t>& of_patch : facets) {
    if (!of_patch.empty() && is_approximate_fillet(patches, of_patch))
      tubes_.push_back(patches[patch_of_[of_patch.front()]].surface.tube);
  }
  if (tubes_.empty()) return;
  std::ranges::sort(tubes_);
  join_fillets(patches);
  std::vector<Seed> beside;
  const auto is_boss = [&](const FacetGraph::Arc& arc) {
    const std::uint32_t p = patch_of_[arc.facet];
    return p != kNone && patches[p].surface.kind == SurfaceKind::cylinder;
  };
  for (const Seed& seed : seeds) {
    if (patch_of_[seed.facet] != kNone || std::ranges::none_of(graph_.arcs_of(seed.facet), is_boss)) continue;
    has_failed_[seed.facet] = 0;
    beside.push_back(seed);
  }
  search(beside, patches);
  join_fillets(patches);
}

bool PatchFinder::is_tube(const PatchSurface& surface) const {
  return surface.kind == SurfaceKind::torus && is_among(surface.tube, tubes_);
}

/// Joins the pieces of each fillet, and the facets without a surface that lie on it, to one torus. Sets is_fillet_.
void PatchFinder::join_fillets(std::vector<Patch>& patches) {
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    std::uint32_t& p = patch_of_[f];
    if (p != kNone && is_tube(patches[p].surface) && is_in_disc(patches[p], f)) p = kNone;
  }
  PatchFacets facets = facets_of(patches);
  const auto join = [&](std::uint32_t p, std::uint32_t q) {
    all_grown_ += take_grown();
    if (facets[q].empty() || has_grown_enough()) return;
    const PatchCandidate whole = whole_fillet(patches[p], facets, p, q);
    if (whole.facets.empty()) return;
    for (const std::uint32_t f : whole.facets) {
      if (patch_of_[f] != kNone) facets[patch_of_[f]].clear();
      patch_of_[f] = p;
    }
    patches[p] = whole.patch;
    facets[p] = whole.facets;
  };
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::uint32_t p) { return facets[p].size(); });
  is_fillet_.resize(patches.size());
  for (const std::uint32_t p : order) {
    if (facets[p].empty() || !is_tube(patches[p].surface) || !is_approximate_fillet(patches, facets[p])) continue;
    is_fillet_[p] = 1;
    join(p, p);
    std::vector<std::uint32_t> beside;
    for (const std::uint32_t f : facets[p]) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
        const std::uint32_t q = patch_of_[arc.facet];
        if (q != kNone && q != p && is_tube(patches[q].surface) && patches[q].outward == patches[p].outward)
          beside.push_back(q);
      }
    }
    std::ranges::sort(beside);
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    for (const std::uint32_t q : beside) join(p, q);
  }
}

/// The torus through the pieces p and q of a fillet (which may be equal), with all free facets and other patches on it.
/// Without facets if no torus fits or if it gains none.
PatchCandidate PatchFinder::whole_fillet(const Patch& patch, const PatchFacets& facets, std::uint32_t p, std::uint32_t q) {
  const ApproximateTori approximate(*this);
  const auto fit = [&](PatchCandidate& c) {
    fetch_points(c.facets);
    c.residual = refine_surface(c.patch.surface, points_);
    c.patch.sag = sag_of(c.patch.surface, c.facets);
    return c.residual <= tolerance_for(SurfaceKind::torus, c.patch.sag) && is_among(c.patch.surface.tube, tubes_) &&
           is_certain(c);
  };
  PatchCandidate whole{.patch = patch, .facets = facets[p]};
  if (q != p) {
    whole.facets.insert(whole.facets.end(), facets[q].begin(), facets[q].end());
    if (!fit(whole)) return {};
  }
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    PatchCandidate next = whole;
    next.facets = grow(whole.patch, facets[p].front(), kMostSags, true);
    std::map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t f : next.facets) ++counts[patch_of_[f]];
    std::erase_if(next.facets, [&](std::uint32_t f) {
      const std::uint32_t other = patch_of_[f];
      return other != kNone && counts[other] < facets[other].size();
    });
    if (counts[p] < facets[p].size() || counts[q] < facets[q].size()) return {};
    if (next.facets.size() <= whole.facets.size() || !fit(next)) break;
    whole = std::move(next);
  }
  return whole.facets.size() > facets[p].size() ? whole : PatchCandidate{};
}

/// Per patch, its facets.
PatchFinder::PatchFacets PatchFinder::facets_of(const std::vector<Patch>& patches) const {
  PatchFacets facets(patches.size());
  for (std::uint32_t f = 0; f < graph_.size(); ++f) {
    if (patch_of_[f] != kNone) facets[patch_of_[f]].push_back(f);
  }
  return facets;
}

}  // namespace ligne
