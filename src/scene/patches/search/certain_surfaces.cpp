#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>

#include "geometry/small_matrices.hpp"
#include "scene/patches/search/surface_search.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Largest probability that the corners lie on the surface by accident. Each corner beyond the number of the surface's
/// parameters does so with a probability of twice the largest distance divided by the sag.
constexpr double kLargestChance = 1e-7;
/// Precisions of the coordinates that count as no distance at all. It is less than the tolerance of corners on a surface, so
/// that small fillets far from the origin, whose sag is a few of these, are certain when their corners are as exact as may
/// be.
constexpr double kToldPrecisions = 4;
/// Largest such probability for a cylinder that its neighbours on both sides continue smoothly.
constexpr double kLikelyChance = 1e-3;
/// Part of the sag from which on the tolerance of rounding hides it. Surfaces are found by accident then, in any free form.
constexpr double kFinePart = 0.1;
/// Factor of the tolerance at which a surface grows once more, and the largest factor by which its area grows then. Where a
/// free form leaves a surface, the distance grows with the second to fourth power of the way, so a piece of it becomes
/// larger by 1.4 to 2.
constexpr double kWider = 4, kMostGrowth = 1.25;
/// Least turn, in radians, of a cylinder of two or three facets that its neighbours continue: a little less than the least
/// angle of planes that have an edge between them. Nearly flat facets of a free form lie on cylinders by accident.
constexpr double kLeastTurn = 8 * std::numbers::pi / 180;
/// Least ratio of the square of the longest diagonal of a long facet to its area; it is 2 for a square.
constexpr double kLongInRow = 20;
/// Largest part of the area of a row that facets at the ends of its long ones may have.
constexpr double kMostWidePart = 1.0 / 16;
/// Facets in a row around a cone from which on these are no polygon.
constexpr std::size_t kMostPolygon = 12;
/// Least distance of corners on two circles from the plane halfway between these, by that of the circles.
constexpr double kCircleHeight = 0.99;
/// Angles about an axis that differ by no more, in radians, are one.
constexpr double kSameAngle = 2 * std::numbers::pi / 1000;
/// Largest relative difference between the turns of the facets of an evenly divided cylinder.
constexpr double kEqualSteps = 0.01;
/// Largest sag of a torus, as a fraction of its outer radius: that of eight facets around the axis. Near the top of its tube
/// the normals tell nothing of the turn about the axis: the four upper strips of a rounded box would lie on one.
constexpr double kLargestRingSag = 0.08;
/// Largest ratio between the radii of the middle circle and of the tube of a torus that is nearly a sphere.
constexpr double kNearSphere = 0.5;

}  // namespace

/// Distance of corners from a surface up to which they count as exactly on it, model units.
double SurfaceSearch::least_distance() const { return kToldPrecisions * object_.precision; }

/// Whether the facets of a candidate, whose corners fetch_points() has fetched, can not lie on its surface by accident.
bool SurfaceSearch::is_certain(const PatchCandidate& c) {
  const PatchSurface& surface = c.patch.surface;
  const double spare = static_cast<double>(points_.size()) - static_cast<double>(parameter_count(surface.kind));
  const double chance = std::min(1.0, std::max(c.residual * 2, least_distance()) / c.patch.sag);
  const double all = spare >= 2 ? std::pow(chance, spare) : 1;
  const bool no_accident = all <= kLargestChance;
  // Symmetry must be ruled out too: a flat side between two equal chamfers lies on a cylinder. Four facets in a row are
  // a surface, and fewer are if their neighbours on both sides continue in its direction.
  switch (surface.kind) {
    case SurfaceKind::cylinder: {
      const std::size_t n = angles_of(surface, false);
      if (n >= 5 && (no_accident || explains_rise(c))) return true;
      if (n == 4 && no_accident && has_equal_steps()) return turn_of_angles() >= kLeastTurn;
      if (n < 3 || c.facets.size() < 2 || (n < 5 ? turn_of_angles() < kLeastTurn : all > kLikelyChance)) return false;
      return is_tangent(c, n - 2);
    }
    case SurfaceKind::cone: {
      const std::size_t n = angles_of(surface, false);
      if (n < 4 || is_polygon(c, n)) return false;
      return n >= 5 ? no_accident || explains_rise(c) : is_tangent(c, 2);
    }
    case SurfaceKind::sphere:
      return no_accident && c.facets.size() >= 6 && !is_fan(c) && !is_ring_of_polygon(c) && !is_row_by_accident(c);
    case SurfaceKind::torus: {
      if (c.patch.sag > kLargestRingSag * (surface.radius + surface.tube)) return false;
      if (!no_accident || c.facets.size() < 6 || is_row_by_accident(c) || angles_of(surface, false) < 4) return false;
      // A sector of what is nearly a sphere must hold as exactly as one.
      const bool is_sphere = surface.radius < kNearSphere * surface.tube && turn_of_angles() < std::numbers::pi;
      if (is_sphere && c.residual > tolerance_for(SurfaceKind::sphere, c.patch.sag)) return false;
      // Four circles lie on a torus by symmetry too, as those of a cylinder between two equal chamfers do.
      const std::size_t n = angles_of(surface, true);
      return n >= 5 || (n == 4 && (has_equal_steps() || is_tangent(c, 2))) || (n == 3 && is_tangent(c, 1));
    }
    case SurfaceKind::extruded:
    case SurfaceKind::revolved:
      break;
  }
  return false;
}

/// Whether the facets of a cone, whose corners lie at so many angles about its axis, turn by so much that they are those of
/// a polygon. The angles at which they meet are smaller. A file that calls the edges between them smooth is believed up to a
/// larger turn.
bool SurfaceSearch::is_polygon(const PatchCandidate& c, std::size_t angles) {
  constexpr double kDegree = std::numbers::pi / 180;
  const double turn = turn_of_angles() / static_cast<double>(angles - 1);
  if (turn <= kLargestBend * kDegree) return false;
  if (turn > kLargestSmoothBend * kDegree) return true;
  ++round_;
  for (const std::uint32_t f : c.facets) stamp_[f] = round_;
  return std::ranges::any_of(c.facets, [&](std::uint32_t f) {
    return std::ranges::any_of(graph_.arcs_of(f), [&](const FacetGraph::Arc& arc) {
      return stamp_[arc.facet] == round_ && !(topology_.edge_flags[arc.edge] & kEdgeSmooth);
    });
  });
}

/// Whether the facets of a sphere, whose corners fetch_points() has fetched, lie in one row between two circles about an
/// axis and are those of a polygon.
bool SurfaceSearch::is_ring_of_polygon(const PatchCandidate& c) {
  if (c.facets.size() >= kMostPolygon) return false;
  Point3 mean(0, 0, 0);
  for (const std::uint32_t f : c.facets) mean += graph_.frames[f].normal / static_cast<double>(c.facets.size());
  Matrix3 spread{};
  for (const std::uint32_t f : c.facets) add_product(spread, graph_.frames[f].normal - mean, graph_.frames[f].normal - mean);
  PatchSurface ring = c.patch.surface;
  ring.axis = symmetric_eigen(spread).vectors[0];
  const auto height = [&](const Point3& p) { return glm::dot(p - ring.at, ring.axis); };
  const auto [low, high] = std::ranges::minmax(points_, {}, height);
  const double middle = (height(low) + height(high)) / 2, half = height(high) - middle;
  if (std::ranges::any_of(points_, [&](const Point3& p) { return std::abs(height(p) - middle) < kCircleHeight * half; }))
    return false;
  const std::size_t angles = angles_of(ring, false);
  return angles >= 4 && is_polygon(c, angles);
}

/// Whether the facets of a sphere, whose corners fetch_points() has fetched, have one corner in common, and all others lie
/// in a plane: a sphere goes through any circle and point beside it.
bool SurfaceSearch::is_fan(const PatchCandidate& c) const {
  const auto is_common = [&](std::uint32_t v) {
    return std::ranges::all_of(c.facets, [&](std::uint32_t f) { return std::ranges::count(graph_.vertices[f], v) > 0; });
  };
  const std::span<const std::uint32_t> first = graph_.vertices[c.facets.front()];
  const auto tip = std::ranges::find_if(first, is_common);
  if (tip == first.end()) return false;
  std::vector<Point3> rim;
  std::ranges::copy_if(points_, std::back_inserter(rim), [&](const Point3& p) { return p != scene_.vertices[*tip]; });
  Point3 middle(0, 0, 0);
  for (const Point3& p : rim) middle += p / static_cast<double>(rim.size());
  Matrix3 spread{};
  for (const Point3& p : rim) add_product(spread, p - middle, p - middle);
  const Point3 across = symmetric_eigen(spread).vectors[0];
  const double most = tolerance_for(SurfaceKind::sphere, 0);
  return std::ranges::all_of(rim, [&](const Point3& p) { return std::abs(glm::dot(p - middle, across)) <= most; });
}

/// Whether the facets of a candidate, whose corners fetch_points() has fetched, are long but for small ones at their ends,
/// and in one row: those in more rows have corners inside their border, by Euler's formula more than two if they are a disc.
/// The corners of such a row between two curves lie on spheres and tori whose sags are large, but not exactly.
bool SurfaceSearch::is_row_by_accident(const PatchCandidate& c) const {
  if (c.residual <= tolerance_for(c.patch.surface.kind, 0)) return false;
  std::size_t triangles = 0;
  double all = 0, wide = 0;
  for (const std::uint32_t f : c.facets) {
    const double longest = longest_diagonal(f);
    all += graph_.area[f];
    if (longest * longest < kLongInRow * graph_.area[f]) {
      wide += graph_.area[f];
    } else {
      triangles += graph_.vertices[f].size() - 2;
    }
  }
  return wide <= kMostWidePart * all && triangles <= vertices_.size();
}

/// Whether the facets of a patch are so fine that rounding hides kFinePart of their sag or more.
bool SurfaceSearch::is_fine(const Patch& patch) const {
  const double least = tolerance_for(patch.surface.kind, 0);
  return tolerance_for(patch.surface.kind, patch.sag) <= least && least >= kFinePart * patch.sag;
}

/// is_certain() for facets whose sag rounding hides, after angles_of(): as if each half turn were divided into fewer steps,
/// whose sag is a larger fraction of its rise. Each ruling between steps has two corners.
bool SurfaceSearch::explains_rise(const PatchCandidate& c) const {
  if (!is_fine(c.patch)) return false;
  const PatchSurface& surface = c.patch.surface;
  const double turn = turn_of_angles(), half_turns = std::max(1.0, turn / std::numbers::pi);
  const double rise = surface.radius * (1 - std::cos(std::min(turn, std::numbers::pi) / 2));
  const double tolerance = std::max(c.residual * 2, least_distance());
  const std::size_t rulings = points_.size() / 2;
  for (double steps = 4; steps * half_turns < rulings; ++steps) {
    const double chance = tolerance * steps * steps / rise;
    if (!(chance < 1)) return false;
    const double spare = 2 * (steps * half_turns + 1) - static_cast<double>(parameter_count(surface.kind));
    if (std::pow(chance, spare) <= kLargestChance) return true;
  }
  return false;
}

/// Number of angles, different by more than a thousandth of a turn, at which points_ lie about the axis, or about the middle
/// circle of a torus.
std::size_t SurfaceSearch::angles_of(const PatchSurface& surface, bool about_circle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Point3 u = frame_of(surface.axis)[0];
  const Point3 v = frame_of(surface.axis)[1];
  numbers_.clear();
  for (const Point3& p : points_) {
    const AxisPlace place = axis_place(surface, p);
    numbers_.push_back(about_circle ? std::atan2(place.along, place.radius - surface.radius)
                                    : std::atan2(glm::dot(place.out, v), glm::dot(place.out, u)));
  }
  std::ranges::sort(numbers_);
  std::size_t count = numbers_.front() + kTurn - numbers_.back() > kSameAngle;
  for (std::size_t i = 1; i < numbers_.size(); ++i) count += numbers_[i] - numbers_[i - 1] > kSameAngle;
  return count;
}

/// The smallest angle about the axis that contains all angles that angles_of() found.
double SurfaceSearch::turn_of_angles() const {
  constexpr double kTurn = 2 * std::numbers::pi;
  double gap = numbers_.front() + kTurn - numbers_.back();
  for (std::size_t i = 1; i < numbers_.size(); ++i) gap = std::max(gap, numbers_[i] - numbers_[i - 1]);
  return kTurn - gap;
}

/// Whether the facets between the angles that angles_of() found all turn alike.
bool SurfaceSearch::has_equal_steps() const {
  const double turn = turn_of_angles(), gap = 2 * std::numbers::pi - turn;
  std::vector<double> steps;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const double step = i > 0 ? numbers_[i] - numbers_[i - 1] : numbers_.front() + 2 * std::numbers::pi - numbers_.back();
    if (step > kSameAngle && step < gap) steps.push_back(step);
  }
  if (steps.empty()) return false;
  const auto [least, most] = std::ranges::minmax(steps);
  return most - least <= kEqualSteps * most;
}

/// Whether the neighbours of a strip continue in the direction of its surface, along kSidesToInner times the length of
/// a row of inner edges. `rows`: the number of these rows.
bool SurfaceSearch::is_tangent(const PatchCandidate& c, std::size_t rows) {
  constexpr double kSidesToInner = 1.6, kTangentPart = 0.15, kLeastTurn = 0.01;
  ++round_;
  for (const std::uint32_t f : c.facets) stamp_[f] = round_;
  const auto angle = [](const Point3& l, const Point3& r) { return std::acos(std::min(1.0, std::abs(glm::dot(l, r)))); };
  double tangent = 0, inner = 0;
  for (const std::uint32_t f : c.facets) {
    for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
      const Edge& edge = topology_.edges[arc.edge];
      const Point3 &a = scene_.vertices[edge.v0], &b = scene_.vertices[edge.v1];
      const Point3& beyond = graph_.frames[arc.facet].normal;
      const double turn = angle(graph_.frames[f].normal, beyond);
      if (stamp_[arc.facet] == round_) {
        if (turn > kLeastTurn) inner += glm::distance(a, b) / 2;
      } else if (angle(c.patch.surface.normal((a + b) * 0.5), beyond) < kTangentPart * turn) {
        tangent += glm::distance(a, b);
      }
    }
  }
  return tangent * static_cast<double>(rows) >= kSidesToInner * inner;
}

/// Whether a facet beside others may lie on their surface, or go on in its direction at the edge between them. If none does,
/// two facets are no surface, whatever their fit.
bool SurfaceSearch::may_go_on(const PatchSurface& surface, std::span<const std::uint32_t> facets, double tolerance) const {
  constexpr double kLooseTangent = 0.3;  // twice that of is_tangent(), and chords in place of angles
  const FacetFrame& first = graph_.frames[facets.front()];
  const double side = glm::dot(surface.normal(first.middle), first.normal) < 0 ? -1 : 1;
  const auto square = [](const Point3& p) { return glm::dot(p, p); };
  const auto is_on = [&](std::uint32_t v) { return std::abs(surface.distance(scene_.vertices[v])) <= tolerance; };
  for (const std::uint32_t f : facets) {
    const Point3& here = graph_.frames[f].normal;
    for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
      if (std::ranges::find(facets, arc.facet) != facets.end()) continue;
      const Edge& edge = topology_.edges[arc.edge];
      const Point3 normal = side * surface.normal((scene_.vertices[edge.v0] + scene_.vertices[edge.v1]) * 0.5);
      const Point3& there = graph_.frames[arc.facet].normal;
      if (square(normal - there) <= kLooseTangent * kLooseTangent * square(here - there)) return true;
      if (std::ranges::all_of(graph_.vertices[arc.facet], is_on)) return true;
    }
  }
  return false;
}

/// Whether facets that may be curved lie beside the facets of a candidate.
bool SurfaceSearch::goes_on(const PatchCandidate& c) {
  ++round_;
  for (const std::uint32_t f : c.facets) stamp_[f] = round_;
  return std::ranges::any_of(c.facets, [&](std::uint32_t f) {
    const auto arcs = graph_.arcs_of(f);
    return std::ranges::any_of(
        arcs, [&](const FacetGraph::Arc& arc) { return stamp_[arc.facet] != round_ && is_left_and_may_curve(arc.facet); });
  });
}

/// Whether a candidate ends where its corners leave the surface by more than rounding: where the tolerance is due to the
/// rounding, it hardly grows when this is larger. A piece of a free form leaves the surface slowly.
bool SurfaceSearch::has_firm_border(const PatchCandidate& c) {
  const double tolerance = tolerance_for(c.patch.surface.kind, c.patch.sag);
  // One row of facets of a cone lies on spheres, whose sag is large then.
  const bool may_be_row = c.patch.surface.kind == SurfaceKind::sphere && tolerance <= tolerance_for(SurfaceKind::sphere, 0);
  return (!is_fine(c.patch) && !may_be_row) || ends_within(c, kWider * tolerance);
}

/// Whether a candidate hardly grows when its corners may be as far from the surface as `tolerance`.
bool SurfaceSearch::ends_within(const PatchCandidate& c, double tolerance) {
  const double most = (kMostGrowth - 1) * c.area;
  forget_looks();
  ++round_;
  std::vector<std::uint32_t> facets = c.facets;
  for (const std::uint32_t f : facets) stamp_[f] = round_;
  double added = 0;
  for (std::size_t i = 0; i < facets.size() && added <= most; ++i) {
    for (const FacetGraph::Arc& arc : graph_.arcs_of(facets[i])) {
      if (stamp_[arc.facet] == round_) continue;
      stamp_[arc.facet] = round_;
      if (!lies_on(c.patch, arc.facet, tolerance)) continue;
      facets.push_back(arc.facet);
      added += graph_.area[arc.facet];
    }
  }
  return added <= most;
}

}  // namespace ligne
