#include "scene/creases/scan_meshes.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

// Limits for scans and remeshed surfaces. Adjustable.
constexpr double kEvenPart = 3.0 / 4;    ///< smallest part of the edges between half and twice the median length
constexpr double kEvenLength = 1.0 / 2;  ///< and of their total length; few long edges mean a constructed shape
constexpr double kBentPart = 1.0 / 8;    ///< largest part of the edges that bend by more than the crease angle
constexpr double kFlatPart = 1.0 / 4;    ///< largest part that is flat; planes mean a constructed shape
/// Number of edges from which on some stand for all: they tell each part to a hundredth.
constexpr std::size_t kMostLengths = 50'000;
/// Limits of the largest angle of a flat edge. Between them it is that by which roundings of both corners beyond the edge
/// turn faces as wide as an edge is long. Fine scans bend by less than a degree at most edges, and planes by rounding alone.
constexpr double kLeastFlatDegrees = 0.1, kMostFlatDegrees = 1;
constexpr double kFlatRoundings = 4;
/// Largest part of the edges inside recognised surfaces: scanners place no points on spheres within rounding.
constexpr double kRecognisedPart = 1.0 / 4;
/// Largest part of the edges that may have more than two faces, or faces with opposite windings. Scanners leave stray
/// triangles, which spoil their neighbourhood but not the whole scan.
constexpr double kDefectPart = 1.0 / 32;

// Limits for decimated parts. Adjustable; chosen on 559 objects of robots, games and scans, of which the decimated ones have
// forks at 0.29 to 0.69 of the vertices of rough creases and sharp turns at 0.13 to 0.29 of those of two, and constructed
// parts forks at up to 0.08.
constexpr std::size_t kFewestRough = 100;        ///< rough creases
constexpr double kRoughPart = 1.0 / 2;           ///< smallest part of the creases that are rough
constexpr double kForkPart = 1.0 / 4;            ///< smallest part of their vertices at which more than two end
constexpr double kTurnPart = 0.15;               ///< smallest part of the vertices of two at which they turn sharply
constexpr double kSharpTurnCosine = 0.64278761;  ///< 50 degrees
constexpr double kMeanLengthPart = 1.0 / 20;     ///< largest mean length, in sizes of the object
/// Creases that continue each other by less than 45 degrees over this part of the size of the object are a line.
constexpr double kLinePart = 1.0 / 12, kLineCosine = 0.70710678;
/// Cosine of the least bend of a corner, which is a right angle to 20 degrees. Folds that decimation leaves in a fillet
/// bend less for the most part.
constexpr float kCornerCosine = 0.34202014F;
constexpr std::size_t kFewestOfRing = 4;  ///< edges of a ring of corners; three are the rim of a triangle
/// Largest diagonal of the box of connected rings, in sizes of the object. Of larger features the lines tell.
constexpr double kSmallPart = 1.0 / 8;
constexpr double kHuge = std::numeric_limits<double>::max();

bool has_triangles_alone(const Scene& scene, const ScanObject& object) {
  for (std::uint32_t f = object.face_begin; f < object.face_end && !scene.faces.all_triangles(); ++f) {
    if (scene.faces.contour_count(f) != 1 || scene.faces.contour(f, 0).size() != 3) return false;
  }
  return true;
}

/// Cosine of the largest angle of a flat edge of an object, from the mean length of some of its edges.
double least_flat_cosine(const Scene& scene, const Topology& topology, const ScanObject& object, double precision) {
  constexpr std::size_t kSamples = 256;
  const std::size_t step = std::max<std::size_t>(1, (object.edge_end - object.edge_begin) / kSamples);
  double length = 0, count = 0;
  for (std::size_t e = object.edge_begin; e < object.edge_end; e += step, ++count)
    length += edge_length(scene, topology.edges[e]);
  const double turn = kFlatRoundings * precision * count / std::max(length, precision);
  return std::clamp(std::cos(turn), sine_cosine_degrees(kMostFlatDegrees).cosine,
                    sine_cosine_degrees(kLeastFlatDegrees).cosine);
}

/// The lengths of the edges of an object, or of runs of them, evenly spread. The edges of a grid repeat after a few.
std::vector<double> edge_lengths(const Scene& scene, const Topology& topology, const ScanObject& object) {
  constexpr std::size_t kRun = 64;
  const std::size_t count = object.edge_end - object.edge_begin, step = kRun * (1 + count / kMostLengths);
  std::vector<double> lengths;
  lengths.reserve(std::min(count, kMostLengths + kRun));
  for (std::size_t first = object.edge_begin; first < object.edge_end; first += step) {
    for (std::size_t e = first; e < std::min<std::size_t>(first + kRun, object.edge_end); ++e)
      lengths.push_back(edge_length(scene, topology.edges[e]));
  }
  return lengths;
}

/// Whether most edges are about as long as the median one, of which two in the middle the longer counts.
bool are_even(std::vector<double> lengths) {
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  const double median = *middle;
  double even = 0, even_length = 0, all_length = 0;
  for (const double length : lengths) {
    all_length += length;
    if (length < median / 2 || length > 2 * median) continue;
    ++even;
    even_length += length;
  }
  return even >= kEvenPart * static_cast<double>(lengths.size()) && even_length >= kEvenLength * all_length;
}

}  // namespace

bool is_scan(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object, double precision) {
  const Scene& scene = mesh.scene;
  const Topology& topology = mesh.topology;
  const auto is_bent = [](Bend bend) { return bend >= Bend::strong; };
  const auto first = bends.begin() + static_cast<std::ptrdiff_t>(object.edge_begin);
  if (std::none_of(first, bends.begin() + static_cast<std::ptrdiff_t>(object.edge_end), is_bent)) return false;
  constexpr std::uint16_t kSpoken = kEdgeSmooth | kEdgeSharp | kEdgeInner, kDefect = kEdgeUnlikeWound | kEdgeManyFaces;
  const auto count = static_cast<double>(object.edge_end - object.edge_begin);
  struct Counts {
    std::size_t spoken = 0, defect = 0, recognised = 0, bent = 0;
    Counts operator+(const Counts& o) const {
      return {spoken + o.spoken, defect + o.defect, recognised + o.recognised, bent + o.bent};
    }
  };
  const auto least = static_cast<float>(least_flat_cosine(scene, topology, object, precision));
  // Lets the count stop early, when too many edges are flat.
  std::atomic<std::size_t> all_flat{0};
  const auto too_flat = [&] { return static_cast<double>(all_flat) > kFlatPart * count; };
  const auto count_edges = [&](std::size_t begin, std::size_t end) {
    Counts sum;
    if (too_flat()) return sum;
    // Counts of 32 bits and loops without branches are vectorized.
    std::uint32_t spoken = 0, defect = 0, recognised = 0, bent_edges = 0, flat = 0;
    const std::uint16_t* const flags = topology.edge_flags.data() + object.edge_begin;
    const PatchEdge* const patch_edges = mesh.patch_edges.data() + object.edge_begin;
    const Bend* const bend = bends.data() + object.edge_begin;
    const float* const cosines = mesh.angles.cosines.data() + object.edge_begin;
    for (std::size_t e = begin; e < end; ++e) {
      spoken += (flags[e] & kSpoken) != 0;
      defect += (flags[e] & kDefect) != 0;
    }
    if (spoken > 0) return Counts{spoken, defect, 0, 0};
    for (std::size_t e = begin; e < end; ++e) recognised += patch_edges[e] == PatchEdge::inside;
    for (std::size_t e = begin; e < end; ++e) bent_edges += is_bent(bend[e]);
    for (std::size_t e = begin; e < end; ++e) flat += cosines[e] > least;
    all_flat += flat;
    return Counts{spoken, defect, recognised, bent_edges};
  };
  const Counts edges = parallel_reduce(object.edge_end - object.edge_begin, kShortWorkBlock, Counts{}, count_edges);
  const auto more_than = [&](std::size_t n, double part) { return static_cast<double>(n) > part * count; };
  if (edges.spoken > 0 || more_than(edges.defect, kDefectPart) || more_than(edges.recognised, kRecognisedPart)) return false;
  if (more_than(edges.bent, kBentPart) || too_flat()) return false;
  if (!has_triangles_alone(scene, object)) return false;
  return are_even(edge_lengths(scene, topology, object));
}

namespace {

/// Whether a crease is known by the surfaces on both sides of it, of which none is a free form. Others are rough.
bool is_between_surfaces(const CreaseMesh& mesh, std::uint32_t e) {
  const Edge& edge = mesh.topology.edges[e];
  if (edge.face1 == kNone || mesh.patch_edges[e] != PatchEdge::unknown) return true;
  return !mesh.is_freeform[edge.face0] && !mesh.is_freeform[edge.face1];
}

Point3 along(const CreaseMesh& mesh, std::uint32_t e) {
  const Edge& edge = mesh.topology.edges[e];
  return mesh.scene.vertices[edge.v1] - mesh.scene.vertices[edge.v0];
}

double size_of(const CreaseMesh& mesh, const ScanObject& object) {
  return mesh.sizes[object_of_vertex(mesh.scene, mesh.topology.edges[object.edge_begin].v0)];
}

/// Whether rough creases fork and turn sharply at many of their vertices.
bool form_teeth(const CreaseMesh& mesh, std::span<const std::uint32_t> rough) {
  struct Ends {
    std::uint32_t count = 0;
    Point3 sum{0, 0, 0};  ///< of the directions of the edges
  };
  const Object& object = mesh.scene.objects[object_of_vertex(mesh.scene, mesh.topology.edges[rough[0]].v0)];
  std::vector<Ends> ends(object.vertex_end - object.vertex_begin);
  for (const std::uint32_t e : rough) {
    const Point3 direction = glm::normalize(along(mesh, e));
    Ends &from = ends[mesh.topology.edges[e].v0 - object.vertex_begin],
         &to = ends[mesh.topology.edges[e].v1 - object.vertex_begin];
    ++from.count, ++to.count;
    from.sum += direction, to.sum -= direction;
  }
  double used = 0, forks = 0, passed = 0, turns = 0;
  for (const Ends& end : ends) {
    used += end.count > 0;
    forks += end.count > 2;
    passed += end.count == 2;
    // The square of the sum of two unit vectors tells the angle between them.
    turns += end.count == 2 && 1 - glm::dot(end.sum, end.sum) / 2 < kSharpTurnCosine;
  }
  return forks >= kForkPart * used && turns >= kTurnPart * passed;
}

/// Joins the creases of an object that continue each other, pair by pair at each vertex.
DisjointSets join_straight(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object) {
  struct End {
    std::uint32_t vertex, edge;
    auto operator<=>(const End&) const = default;
  };
  constexpr std::size_t kMostEnds = 32;
  std::vector<End> ends;
  for (std::uint32_t e = object.edge_begin; e < object.edge_end; ++e) {
    if (bends[e] < Bend::strong) continue;
    ends.push_back({mesh.topology.edges[e].v0, e});
    ends.push_back({mesh.topology.edges[e].v1, e});
  }
  std::ranges::sort(ends);
  DisjointSets lines(object.edge_end - object.edge_begin);
  const auto direction = [&](const End& end) {
    const Edge& edge = mesh.topology.edges[end.edge];
    const std::uint32_t other = edge.v0 == end.vertex ? edge.v1 : edge.v0;
    return glm::normalize(mesh.scene.vertices[other] - mesh.scene.vertices[end.vertex]);
  };
  struct Turn {
    double cosine;
    std::size_t a, b;
  };
  std::vector<Turn> turns;
  std::vector<std::uint8_t> is_joined;
  for (std::size_t i = 0, k = 0; i < ends.size(); i = k) {
    while (k < ends.size() && ends[k].vertex == ends[i].vertex) ++k;
    if (k - i > kMostEnds) continue;
    turns.clear();
    for (std::size_t a = i; a < k; ++a) {
      for (std::size_t b = i; b < a; ++b) {
        const double cosine = -glm::dot(direction(ends[a]), direction(ends[b]));
        if (cosine > kLineCosine) turns.push_back({cosine, a, b});
      }
    }
    std::ranges::stable_sort(turns, std::ranges::greater{}, &Turn::cosine);
    is_joined.assign(k - i, 0);
    for (const Turn& turn : turns) {
      if (is_joined[turn.a - i] || is_joined[turn.b - i]) continue;
      is_joined[turn.a - i] = is_joined[turn.b - i] = 1;
      lines.join(ends[turn.a].edge - object.edge_begin, ends[turn.b].edge - object.edge_begin);
    }
  }
  return lines;
}

}  // namespace

bool is_decimated(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object) {
  constexpr std::uint16_t kSpoken = kEdgeSmooth | kEdgeSharp | kEdgeInner;
  std::size_t creases = 0;
  double length = 0;
  std::vector<std::uint32_t> rough;
  for (std::uint32_t e = object.edge_begin; e < object.edge_end; ++e) {
    if (mesh.topology.edge_flags[e] & kSpoken) return false;
    if (bends[e] < Bend::strong) continue;
    ++creases;
    if (is_between_surfaces(mesh, e)) continue;
    rough.push_back(e);
    length += glm::length(along(mesh, e));
  }
  const auto count = static_cast<double>(rough.size());
  return rough.size() >= kFewestRough && count >= kRoughPart * static_cast<double>(creases) &&
         length <= kMeanLengthPart * count * size_of(mesh, object) && has_triangles_alone(mesh.scene, object) &&
         form_teeth(mesh, rough);
}

namespace {

/// The edges of an object whose faces form a corner.
std::vector<std::uint32_t> corners_of(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object) {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t e = object.edge_begin; e < object.edge_end; ++e) {
    const Edge& edge = mesh.topology.edges[e];
    if (bends[e] < Bend::strong || edge.face1 == kNone) continue;
    if (glm::dot(mesh.angles.normals[edge.face0], mesh.angles.normals[edge.face1]) < kCornerCosine) corners.push_back(e);
  }
  return corners;
}

/// Leaves those of the corners that lie on rings, or between two: removes the loose ends of the others one by one.
void keep_rings(const Topology& topology, const Object& object, std::vector<std::uint32_t>& corners) {
  struct Node {
    std::uint32_t count = 0, numbers = 0;  ///< of the corners that end here, and the exclusive or of their indices
  };
  std::vector<Node> nodes(object.vertex_end - object.vertex_begin);
  const auto node_at = [&](std::uint32_t v) -> Node& { return nodes[v - object.vertex_begin]; };
  for (const std::uint32_t e : corners) {
    for (const std::uint32_t v : {topology.edges[e].v0, topology.edges[e].v1}) ++node_at(v).count, node_at(v).numbers ^= e;
  }
  std::vector<std::uint32_t> loose;
  for (Node& first : nodes) {
    for (Node* node = &first; node->count == 1;) {
      const std::uint32_t e = node->numbers;
      const Edge& edge = topology.edges[e];
      Node& other = &node_at(edge.v0) == node ? node_at(edge.v1) : node_at(edge.v0);
      loose.push_back(e);
      node->count = 0;
      --other.count, other.numbers ^= e;
      node = &other;
    }
  }
  std::ranges::sort(loose);
  std::erase_if(corners, [&](std::uint32_t e) { return std::ranges::binary_search(loose, e); });
}

/// The corners of an object that form small closed rings, as the rims of bores, pockets and letters do. Teeth end in the air
/// or stand in long rows.
std::vector<std::uint32_t> small_rings(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object) {
  std::vector<std::uint32_t> corners = corners_of(mesh, bends, object);
  if (corners.empty()) return corners;
  const std::vector<Edge>& edges = mesh.topology.edges;
  const Object& whole = mesh.scene.objects[object_of_vertex(mesh.scene, edges[corners[0]].v0)];
  keep_rings(mesh.topology, whole, corners);
  DisjointSets sets(whole.vertex_end - whole.vertex_begin);
  for (const std::uint32_t e : corners) sets.join(edges[e].v0 - whole.vertex_begin, edges[e].v1 - whole.vertex_begin);
  struct Ring {
    std::size_t edges = 0;
    Point3 low{kHuge}, high{-kHuge};
  };
  std::vector<Ring> rings(whole.vertex_end - whole.vertex_begin);
  const auto ring_of = [&](std::uint32_t e) -> Ring& { return rings[sets.find(edges[e].v0 - whole.vertex_begin)]; };
  for (const std::uint32_t e : corners) {
    Ring& ring = ring_of(e);
    ++ring.edges;
    for (const std::uint32_t v : {edges[e].v0, edges[e].v1}) {
      ring.low = glm::min(ring.low, mesh.scene.vertices[v]);
      ring.high = glm::max(ring.high, mesh.scene.vertices[v]);
    }
  }
  const double largest = kSmallPart * size_of(mesh, object);
  std::erase_if(corners, [&](std::uint32_t e) {
    return ring_of(e).edges < kFewestOfRing || glm::distance(ring_of(e).low, ring_of(e).high) > largest;
  });
  return corners;
}

}  // namespace

std::vector<std::uint8_t> sure_creases(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object) {
  const std::uint32_t begin = object.edge_begin;
  DisjointSets lines = join_straight(mesh, bends, object);
  std::vector<double> lengths(object.edge_end - begin, 0);
  for (std::uint32_t e = begin; e < object.edge_end; ++e) {
    if (bends[e] >= Bend::strong) lengths[lines.find(e - begin)] += glm::length(along(mesh, e));
  }
  const double long_enough = kLinePart * size_of(mesh, object);
  std::vector<std::uint8_t> is_sure(lengths.size(), 0);
  for (const std::uint32_t e : small_rings(mesh, bends, object)) is_sure[e - begin] = 1;
  for (std::uint32_t e = begin; e < object.edge_end; ++e) {
    if (bends[e] < Bend::strong) continue;
    is_sure[e - begin] |= is_between_surfaces(mesh, e) || lengths[lines.find(e - begin)] >= long_enough;
  }
  return is_sure;
}

}  // namespace ligne
