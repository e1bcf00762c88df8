#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/patches/search/surface_search.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Largest number of points of a patch to which a surface is fitted.
constexpr std::size_t kMostPoints = 96;
/// Fractional part of the golden ratio: its multiples are spread evenly over a unit, without a period.
constexpr double kGoldenPart = 0.6180339887498949;
/// Least number of vertices that are sorted by bits. For fewer, sorting by comparisons costs no more.
constexpr std::size_t kFewVertices = 64;

}  // namespace

/// Sets points_ to the corners of facets, each once, and at most about kMostPoints of them.
void SurfaceSearch::fetch_points(std::span<const std::uint32_t> facets) {
  vertices_.clear();
  for (const std::uint32_t f : facets) {
    vertices_.insert(vertices_.end(), graph_.vertices[f].begin(), graph_.vertices[f].end());
  }
  points_.clear();
  if (vertices_.empty()) return;
  const auto [low, high] = std::ranges::minmax(vertices_);
  if (vertices_.size() < kFewVertices || (high - low) / kWordBits > vertices_.size()) {
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  } else {
    sort_by_bits(low - object_.vertex_begin, high - object_.vertex_begin);
  }
  const std::size_t step = vertices_.size() / kMostPoints + 1;
  // One of every `step`, but not every step-th: where the two ends of strips alternate, all points would lie on one of them.
  double part = 0;
  for (std::size_t i = 0; i < vertices_.size(); i += step) {
    const std::size_t k = i + static_cast<std::size_t>(part * static_cast<double>(step));
    points_.push_back(scene_.vertices[vertices_[std::min(k, vertices_.size() - 1)]]);
    part += part < kGoldenPart ? 1 - kGoldenPart : -kGoldenPart;
  }
}

/// The middles of the edges between facets of a set, with the mean normal of both facets. Slanting triangles are tilted to
/// one side and to the other in turn, so the means are nearer to the normals of the surface.
std::vector<FacetFrame> SurfaceSearch::edge_frames(std::span<const std::uint32_t> facets) {
  std::vector<FacetFrame> frames;
  frames.reserve(2 * facets.size());
  ++round_;
  for (const std::uint32_t f : facets) stamp_[f] = round_;
  for (const std::uint32_t f : facets) {
    for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
      if (arc.facet <= f || stamp_[arc.facet] != round_) continue;
      const Edge& edge = topology_.edges[arc.edge];
      frames.push_back({(scene_.vertices[edge.v0] + scene_.vertices[edge.v1]) * 0.5,
                        glm::normalize(graph_.frames[f].normal + graph_.frames[arc.facet].normal)});
    }
  }
  return frames;
}

/// Fetches the corners and the normals of the facets of a sample, unless it has them.
void SurfaceSearch::complete(FitSample& sample) {
  SurfaceSample& shape = sample.shape;
  if (!shape.frames.empty()) return;
  fetch_points(sample.facets);
  shape.points = points_;
  for (const Point3& p : points_) shape.middle += p;
  shape.middle /= static_cast<double>(points_.size());
  if (sample.by_edges) {
    shape.frames = edge_frames(sample.facets);
  } else {
    shape.frames.reserve(sample.facets.size());
    for (const std::uint32_t f : sample.facets) shape.frames.push_back(graph_.frames[f]);
  }
  for (const FacetFrame& f : shape.frames) add_product(shape.squares, f.normal, f.normal);
}

/// Sorts vertices_ and removes duplicates, with one bit per vertex of the object. `low` and `high`: the least and the
/// largest of vertices_, counted from the first vertex of the object.
void SurfaceSearch::sort_by_bits(std::uint32_t low, std::uint32_t high) {
  for (const std::uint32_t v : vertices_) {
    const std::uint32_t i = v - object_.vertex_begin;
    is_fetched_[i / kWordBits] |= std::uint64_t{1} << i % kWordBits;
  }
  vertices_.clear();
  for (std::uint32_t w = low / kWordBits; w <= high / kWordBits; ++w) {
    for (std::uint64_t word = is_fetched_[w]; word != 0; word &= word - 1) {
      vertices_.push_back(object_.vertex_begin + w * kWordBits + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
    is_fetched_[w] = 0;
  }
}

/// Median distance of the facets' middles from the surface.
double SurfaceSearch::sag_of(const PatchSurface& surface, std::span<const std::uint32_t> facets) {
  numbers_.clear();
  for (const std::uint32_t f : facets) {
    if (!graph_.is_sliver[f]) numbers_.push_back(std::abs(surface.distance(graph_.frames[f].middle)));
  }
  if (numbers_.empty()) return 0;
  const auto middle = numbers_.begin() + static_cast<std::ptrdiff_t>((numbers_.size() - 1) / 2);
  std::nth_element(numbers_.begin(), middle, numbers_.end());
  return *middle;
}

/// Forgets the results of look_at(). Must precede calls of lies_on() with another surface or tolerance.
void SurfaceSearch::forget_looks() {
  ++look_round_;
  looks_.clear();
}

/// Tells whether a vertex lies on a surface. The result is kept, since about six facets share a vertex.
const SurfaceSearch::VertexLook& SurfaceSearch::look_at(const Patch& patch, std::uint32_t vertex, double tolerance) {
  auto& [round, number] = look_of_[vertex - object_.vertex_begin];
  if (round != look_round_) {
    round = look_round_;
    number = static_cast<std::uint32_t>(looks_.size());
    const Point3& p = scene_.vertices[vertex];
    const bool is_on = std::abs(patch.surface.distance(p)) <= tolerance;
    const bool is_tip = patch.surface.kind == SurfaceKind::cone && axis_place(patch.surface, p).radius <= tolerance;
    looks_.push_back({is_on, is_on && !is_tip ? patch.surface.normal(p) : Point3(0, 0, 0)});
  }
  return looks_[number];
}

/// Whether the middle of a facet is at most so far from the surface. A facet of many corners may have a hole in its
/// middle, so the middles of its faces count.
bool SurfaceSearch::is_near(const PatchSurface& surface, std::uint32_t f, double distance) const {
  if (graph_.vertices[f].size() <= 4) return std::abs(surface.distance(graph_.frames[f].middle)) <= distance;
  return std::ranges::all_of(graph_.faces[f], [&](std::uint32_t face) {
    const auto corners = scene_.faces.contour(face, 0);
    Point3 sum(0.0);
    for (const std::uint32_t v : corners) sum += scene_.vertices[v];
    return std::abs(surface.distance(sum / static_cast<double>(corners.size()))) <= distance;
  });
}

/// Whether the corners of a facet lie on the surface, and its middle is at most so many sags away. `least_cosine`: least
/// cosine between its normal and the normals of the surface at its corners.
bool SurfaceSearch::lies_on(const Patch& patch, std::uint32_t f, double tolerance, double least_cosine, double most_sags) {
  const bool has_normal = !graph_.is_sliver[f];
  const FacetFrame& frame = graph_.frames[f];
  if (has_normal && !is_near(patch.surface, f, most_sags * patch.sag + tolerance)) return false;
  const Point3 normal = patch.outward ? frame.normal : -frame.normal;
  for (const std::uint32_t v : graph_.vertices[f]) {
    const VertexLook& look = look_at(patch, v, tolerance);
    if (!look.is_on) return false;
    if (has_normal && look.normal != Point3(0.0) && !(glm::dot(look.normal, normal) >= least_cosine)) return false;
  }
  return !leaves_discs_ || !is_in_disc(patch, f);
}

}  // namespace ligne
