#include "scene/creases/scan_meshes.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "base/uninitialized_vector.hpp"
#include "geometry/degrees.hpp"

namespace ligne {
namespace {

// Limits for scans and remeshed surfaces. Adjustable.
constexpr double kEvenPart = 3.0 / 4;    ///< smallest part of the edges between half and twice the median length
constexpr double kEvenLength = 1.0 / 2;  ///< and of their total length; few long edges mean a constructed shape
constexpr double kBentPart = 1.0 / 8;    ///< largest part of the edges that bend by more than the crease angle
constexpr double kFlatPart = 1.0 / 4;    ///< largest part that is flat; planes mean a constructed shape
/// Limits of the largest angle of a flat edge. Between them it is that by which roundings of both corners beyond the edge
/// turn faces as wide as an edge is long. Fine scans bend by less than a degree at most edges, and planes by rounding alone.
constexpr double kLeastFlatDegrees = 0.1, kMostFlatDegrees = 1;
constexpr double kFlatRoundings = 4;
/// Largest part of the edges that may have more than two faces, or faces with opposite windings. Scanners leave stray
/// triangles, which spoil their neighbourhood but not the whole scan.
constexpr double kDefectPart = 1.0 / 32;

/// Cosine of the largest angle of a flat edge of an object, from the mean length of some of its edges.
double least_flat_cosine(const Scene& scene, const Topology& topology, const ScanObject& object, double precision) {
  constexpr std::size_t kSamples = 256;
  const std::size_t step = std::max<std::size_t>(1, (object.edge_end - object.edge_begin) / kSamples);
  double length = 0, count = 0;
  for (std::size_t e = object.edge_begin; e < object.edge_end; e += step, ++count)
    length += glm::distance(scene.vertices[topology.edges[e].v0], scene.vertices[topology.edges[e].v1]);
  const double turn = kFlatRoundings * precision * count / std::max(length, precision);
  return std::clamp(std::cos(turn), sine_cosine_degrees(kMostFlatDegrees).cosine,
                    sine_cosine_degrees(kLeastFlatDegrees).cosine);
}

UninitializedVector<double> edge_lengths(const Scene& scene, const Topology& topology, const ScanObject& object) {
  UninitializedVector<double> lengths(object.edge_end - object.edge_begin);
  parallel_blocks(object.edge_end - object.edge_begin, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Edge& edge = topology.edges[object.edge_begin + k];
      lengths[k] = glm::distance(scene.vertices[edge.v0], scene.vertices[edge.v1]);
    }
  });
  return lengths;
}

/// The median of lengths: of two in the middle, the greater.
double median_of(std::span<const double> lengths) {
  // Such numbers have the order of their bits. The upper ones tell which lengths are near the median.
  constexpr int kLowBits = 48;
  const auto bin_of = [](double length) { return std::bit_cast<std::uint64_t>(length) >> kLowBits; };
  std::vector<std::uint32_t> counts(std::size_t{1} << (64 - kLowBits));
  for (const double length : lengths) ++counts[bin_of(length)];
  std::size_t rank = lengths.size() / 2, bin = 0;
  while (rank >= counts[bin]) rank -= counts[bin++];
  std::vector<double> near;
  near.reserve(counts[bin]);
  for (const double length : lengths) {
    if (bin_of(length) == bin) near.push_back(length);
  }
  const auto middle = near.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(near.begin(), middle, near.end());
  return *middle;
}

}  // namespace

bool is_scan(const Scene& scene, const Topology& topology, const std::vector<glm::vec3>& normals,
             const std::vector<Bend>& bends, const ScanObject& object, double precision) {
  const auto is_bent = [](Bend bend) { return bend >= Bend::strong; };
  const auto first = bends.begin() + static_cast<std::ptrdiff_t>(object.edge_begin);
  if (std::none_of(first, bends.begin() + static_cast<std::ptrdiff_t>(object.edge_end), is_bent)) return false;
  constexpr std::uint16_t kSpoken = kEdgeSmooth | kEdgeSharp | kEdgeInner, kDefect = kEdgeUnlikeWound | kEdgeManyFaces;
  const auto count = static_cast<double>(object.edge_end - object.edge_begin);
  struct Counts {
    std::size_t spoken = 0, defect = 0, bent = 0;
    Counts operator+(const Counts& o) const { return {spoken + o.spoken, defect + o.defect, bent + o.bent}; }
  };
  const auto least = static_cast<float>(least_flat_cosine(scene, topology, object, precision));
  // Lets the count stop early, when too many edges are flat.
  std::atomic<std::size_t> all_flat{0};
  const auto too_flat = [&] { return static_cast<double>(all_flat) > kFlatPart * count; };
  const auto count_edges = [&](std::size_t begin, std::size_t end) {
    Counts sum;
    if (too_flat()) return sum;
    std::size_t flat = 0;
    for (std::size_t e = object.edge_begin + begin; e < object.edge_begin + end && sum.spoken == 0; ++e) {
      prefetch_faces(normals, topology.edges, e);
      const Edge& edge = topology.edges[e];
      sum.spoken += (topology.edge_flags[e] & kSpoken) != 0;
      sum.defect += (topology.edge_flags[e] & kDefect) != 0;
      sum.bent += is_bent(bends[e]);
      flat += edge.face1 != kNone && glm::dot(normals[edge.face0], normals[edge.face1]) > least;
    }
    all_flat += flat;
    return sum;
  };
  const Counts edges = parallel_reduce(object.edge_end - object.edge_begin, kShortWorkBlock, Counts{}, count_edges);
  const auto more_than = [&](std::size_t n, double part) { return static_cast<double>(n) > part * count; };
  if (edges.spoken > 0 || more_than(edges.defect, kDefectPart)) return false;
  if (more_than(edges.bent, kBentPart) || too_flat()) return false;
  for (std::uint32_t f = object.face_begin; f < object.face_end && !scene.faces.all_triangles(); ++f) {
    if (scene.faces.contour_count(f) != 1 || scene.faces.contour(f, 0).size() != 3) return false;
  }
  const UninitializedVector<double> all = edge_lengths(scene, topology, object);
  const std::span lengths(all.data(), object.edge_end - object.edge_begin);
  const double median = median_of(lengths);
  double even = 0, even_length = 0, all_length = 0;
  for (const double length : lengths) {
    all_length += length;
    if (length < median / 2 || length > 2 * median) continue;
    ++even;
    even_length += length;
  }
  return even >= kEvenPart * count && even_length >= kEvenLength * all_length;
}

}  // namespace ligne
