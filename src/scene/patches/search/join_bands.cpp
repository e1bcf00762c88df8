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

// Adjustable.
/// Largest sine of the angle between the axes of two bands of one torus, and largest distance of the axes divided by
/// the larger radius. The axis of a band of few facets is not known more precisely.
constexpr double kAxisSine = 0.03, kAxisDistance = 0.03;
/// A torus is rejected if this part of the corners of a cylinder in it is nearer to that by this factor: a torus goes
/// through any three circles about one axis, such as those of the wall of a boss and of the first row of its fillet.
constexpr double kMostCorners = 0.75, kFarBetter = 0.1;

bool has_axis(const PatchSurface& s) { return s.kind == SurfaceKind::cylinder || s.kind == SurfaceKind::cone; }

/// Whether the second surface, which may be a sphere, is round about the axis of the first.
bool is_coaxial(const PatchSurface& s, const PatchSurface& other) {
  if (other.kind == SurfaceKind::torus) return false;
  if (has_axis(other) && glm::length(glm::cross(s.axis, other.axis)) > kAxisSine) return false;
  return axis_place(s, other.at).radius <= kAxisDistance * std::max(s.radius, other.radius);
}

/// Computes starting values of a torus from two pieces of its tube and the middles of these pieces.
bool guess_from_pieces(const PatchSurface& s, const Point3& middle, const PatchSurface& other, const Point3& other_middle,
                       PatchSurface& torus) {
  const Point3 here = s.at + glm::dot(middle - s.at, s.axis) * s.axis;
  const Point3 there = other.at + glm::dot(other_middle - other.at, other.axis) * other.axis;
  torus = PatchSurface{};
  torus.kind = SurfaceKind::torus;
  torus.axis = glm::normalize(glm::cross(s.axis, other.axis));
  // The centre lies in the planes across both pieces.
  const Point3 inwards = glm::cross(torus.axis, s.axis);
  const double way = glm::dot(there - here, other.axis) / glm::dot(inwards, other.axis);
  torus.at = here + way * inwards + glm::dot(there - here, torus.axis) / 2 * torus.axis;
  torus.radius = std::abs(way);
  torus.tube = (s.radius + other.radius) / 2;
  return std::isfinite(way);
}

}  // namespace

/// Joins bands on cones, cylinders and spheres to one torus if all facets of each band lie on it. Also joins pieces of
/// a tube on cylinders.
void PatchFinder::join_bands(std::vector<Patch>& patches) {
  PatchFacets facets = facets_of(patches);
  std::vector<std::uint32_t> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  const auto size_of = [&](std::uint32_t p) { return facets[p].size(); };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) { return size_of(l) > size_of(r); });
  for (const std::uint32_t p : order) {
    if (facets[p].empty() || !has_axis(patches[p].surface)) continue;
    std::vector<std::uint32_t> beside;
    for (const std::uint32_t f : facets[p]) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
        const std::uint32_t q = patch_of_[arc.facet];
        if (q == kNone || q == p) continue;
        const PatchSurface &here = patches[p].surface, &there = patches[q].surface;
        if (is_coaxial(here, there) || are_tube_pieces(here, there)) beside.push_back(q);
      }
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    for (const std::uint32_t q : beside) {
      const PatchCandidate torus = torus_through(patches, facets, p, q);
      if (torus.facets.empty()) continue;
      const auto number = static_cast<std::uint32_t>(patches.size());
      for (const std::uint32_t f : torus.facets) {
        if (patch_of_[f] != kNone) facets[patch_of_[f]].clear();
        patch_of_[f] = number;
      }
      patches.push_back(torus.patch);
      facets.push_back(torus.facets);
      break;
    }
  }
}

/// The torus through two bands or pieces, with the other patches that lie on it. It has no facets if there is no such
/// torus.
PatchCandidate PatchFinder::torus_through(const std::vector<Patch>& patches, const PatchFacets& facets, std::uint32_t p,
                                          std::uint32_t q) {
  PatchCandidate c;
  PatchSurface& surface = c.patch.surface;
  std::vector<std::uint32_t> both = facets[p];
  both.insert(both.end(), facets[q].begin(), facets[q].end());
  fetch_points(both);
  const PatchSurface &here = patches[p].surface, &there = patches[q].surface;
  const bool are_pieces = are_tube_pieces(here, there);
  const bool is_guessed = are_pieces ? guess_from_pieces(here, middle_of(facets[p]), there, middle_of(facets[q]), surface)
                                     : guess_torus_about(here, points_, surface);
  if (!is_guessed) return {};
  const std::uint32_t seed = facets[p].front();
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    c.residual = refine_surface(surface, points_);
    c.patch.sag = sag_of(surface, both);
    if (!is_plausible(surface) || !(c.residual <= tolerance_for(SurfaceKind::torus, c.patch.sag))) return {};
    c.patch.outward = glm::dot(surface.normal(graph_.frames[seed].middle), graph_.frames[seed].normal) > 0;
    both = grow(c.patch, seed, kMostSags, true);
    std::map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t f : both) ++counts[patch_of_[f]];
    std::erase_if(both, [&](std::uint32_t f) {
      const std::uint32_t patch = patch_of_[f];
      return patch != kNone && counts[patch] < facets[patch].size();
    });
    if (counts[p] < facets[p].size() || counts[q] < facets[q].size()) return {};
    fetch_points(both);
  }
  c.facets = std::move(both);
  if (!are_pieces && c.residual > tolerance_for(SurfaceKind::torus, 0)) {
    const double most = kFarBetter * c.residual;
    if (is_cylinder_within(here, facets[p], most) || is_cylinder_within(there, facets[q], most)) return {};
  }
  fetch_points(c.facets);
  return is_certain(c) ? c : PatchCandidate{};
}

/// Whether a surface is a cylinder, and most corners of these facets lie at most so far from it.
bool PatchFinder::is_cylinder_within(const PatchSurface& surface, std::span<const std::uint32_t> facets, double distance) {
  if (surface.kind != SurfaceKind::cylinder) return false;
  fetch_points(facets);
  const auto is_near = [&](const Point3& p) { return std::abs(surface.distance(p)) <= distance; };
  return static_cast<double>(std::ranges::count_if(points_, is_near)) >= kMostCorners * static_cast<double>(points_.size());
}

Point3 PatchFinder::middle_of(std::span<const std::uint32_t> facets) const {
  Point3 sum(0, 0, 0);
  for (const std::uint32_t f : facets) sum += graph_.frames[f].middle;
  return sum / static_cast<double>(facets.size());
}

}  // namespace ligne
