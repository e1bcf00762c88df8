#include "contours/surfaces/smooth_patch.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "base/uninitialized_vector.hpp"
#include "base/vertex_pair_index.hpp"
#include "contours/surfaces/rulings.hpp"
#include "scene/creases/crease_lines.hpp"
#include "view/edge_classes.hpp"

namespace ligne {
namespace {

/// As for classes of edges: float32 coordinates turn the normals of small faces by about this much.
constexpr double kCreaseSlackDegrees = 0.01;

/// Adjustable. Angle, in crease angles, above which an edge is a border whatever its class: a mean of normals across it
/// is meaningless.
constexpr double kSharp = 2;

const Point3 kNoNormal{0, 0, 0};

/// A set of vertices.
class VertexSet {
 public:
  explicit VertexSet(std::size_t n) : marked_(n, 0) {}
  void add(std::uint32_t v) { marked_[v] = 1; }
  bool has(std::uint32_t v) const { return marked_[v] != 0; }
  bool touches(const Triangle& t) const { return has(t.v[0]) || has(t.v[1]) || has(t.v[2]); }
  std::vector<std::uint32_t> list() const { return indices_of_marks(marked_); }

 private:
  std::vector<std::uint8_t> marked_;
};

/// The triangles that have a vertex in the set, ascending.
std::vector<std::uint32_t> touching(const std::vector<Triangle>& triangles, const VertexSet& set) {
  return indices_where(triangles.size(), [&](std::size_t i) { return set.touches(triangles[i]); });
}

/// The vertices of some triangles, numbered in ascending order.
class VertexNumbers {
 public:
  explicit VertexNumbers(std::span<const Triangle> triangles) {
    std::uint32_t highest = 0;
    for (const Triangle& t : triangles) {
      const auto [low, high] = std::minmax({t.v[0], t.v[1], t.v[2]});
      lowest_ = std::min(lowest_, low);
      highest = std::max(highest, high);
    }
    if (!triangles.empty()) number_.assign(highest - lowest_ + 1, kNone);
    for (const Triangle& t : triangles) {
      for (const std::uint32_t v : t.v) number_[v - lowest_] = 0;
    }
    for (std::uint32_t k = 0; k < number_.size(); ++k) {
      if (number_[k] == kNone) continue;
      number_[k] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(lowest_ + k);
    }
  }
  std::size_t size() const { return vertices_.size(); }
  std::uint32_t of(std::uint32_t vertex) const { return number_[vertex - lowest_]; }
  std::uint32_t vertex(std::uint32_t number) const { return vertices_[number]; }

 private:
  std::uint32_t lowest_ = kNone;
  std::vector<std::uint32_t> number_, vertices_;
};

/// Tells which edges are creases. Edges must be queried in ascending order.
class CreaseMarks {
 public:
  CreaseMarks(const std::vector<Edge>& edges, const std::vector<std::uint8_t>* creases) : edges_(edges), creases_(creases) {}

  bool given() const { return creases_ != nullptr; }
  bool has(std::uint32_t low, std::uint32_t high) {
    // Exponential search from the edge of the last query.
    std::size_t step = 1, last = at_;
    while (last < edges_.size() && before(edges_[last], low, high)) {
      at_ = last;
      last += step;
      step *= 2;
    }
    const auto first = edges_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto end = edges_.begin() + static_cast<std::ptrdiff_t>(std::min(last + 1, edges_.size()));
    const auto found = std::partition_point(first, end, [&](const Edge& e) { return before(e, low, high); });
    at_ = static_cast<std::size_t>(found - edges_.begin());
    return at_ < edges_.size() && edges_[at_].v0 == low && edges_[at_].v1 == high && (*creases_)[at_] == kCreaseLine;
  }

 private:
  static bool before(const Edge& e, std::uint32_t low, std::uint32_t high) { return e.v0 != low ? e.v0 < low : e.v1 < high; }

  const std::vector<Edge>& edges_;
  const std::vector<std::uint8_t>* creases_;
  std::size_t at_ = 0;
};

/// Cosine of `times` the crease angle.
double cosine(const RegionBorders& borders, double times) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  return std::cos(std::min(180.0, times * borders.crease_degrees + kCreaseSlackDegrees) * kDegree);
}

/// Whether a region certainly ends at an edge. The angle decides only between two triangles. `least_cosine`: least
/// cosine of the angle between two faces of one region.
bool is_border(const Scene& scene, const Topology& topology, const RegionBorders& borders, double least_cosine,
               std::uint32_t e) {
  if (borders.creases && (*borders.creases)[e] == kCreaseLine) return true;
  if (topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound)) return true;
  const Edge& edge = topology.edges[e];
  const auto is_triangle = [&](std::uint32_t f) {
    return scene.faces.contour_count(f) == 1 && scene.faces.contour(f, 0).size() == 3;
  };
  if (!is_triangle(edge.face0) || !is_triangle(edge.face1)) return false;
  const Point3 a = face_normal(scene, edge.face0), b = face_normal(scene, edge.face1);
  return a != kNoNormal && b != kNoNormal && glm::dot(a, b) < least_cosine;
}

/// Ranges of triangles of whole objects, since objects share no vertices. Small objects are combined.
std::vector<SmoothPatch::Run> runs_of(const Scene& scene, const std::vector<Triangle>& triangles) {
  constexpr std::uint32_t kLeastTriangles = 4096;
  std::vector<SmoothPatch::Run> runs;
  std::uint32_t begin = 0;
  for (const Object& object : scene.objects) {
    const auto after = std::ranges::lower_bound(triangles, object.face_end, {}, &Triangle::face);
    const auto end = static_cast<std::uint32_t>(after - triangles.begin());
    if (end - begin < kLeastTriangles && (end == begin || end < triangles.size())) continue;
    runs.push_back({begin, end});
    begin = end;
  }
  return runs;
}

class PatchBuilder {
 public:
  PatchBuilder(const Scene& scene, const Topology& topology, const Camera& camera, const RegionBorders& borders,
               SmoothPatch& patch)
      : scene_(scene),
        camera_(camera),
        edges_(topology.edges, borders.creases),
        patch_(patch),
        crease_cosine_(cosine(borders, 1)),
        sharp_cosine_(cosine(borders, kSharp)) {}

  void build() {
    measure_triangles();
    join_sides();
    make_sectors();
    if (cut_at_sharp_vertices()) make_sectors();
    square_to_rulings(scene_, camera_, {face_normals_.data(), patch_.triangles.size()}, patch_);
    fit_surfaces(scene_, camera_, patch_);
  }

 private:
  const Point3& vertex(std::uint32_t corner) const { return scene_.vertices[patch_.triangles[corner / 3].v[corner % 3]]; }

  void measure_triangles() {
    const std::size_t n = patch_.triangles.size();
    face_normals_ = UninitializedVector<Point3>(n);
    weighted_normals_ = UninitializedVector<Point3>(3 * n);
    patch_.facing.resize(n);
    parallel_blocks(n, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) measure(t);
    });
  }

  /// Computes the contribution of each corner to the normal of its vertex. The weights are those of N. Max (Weights for
  /// computing vertex normals from facet normals, 1999): if the vertices lie on a sphere, the normals are exact,
  /// however uneven the mesh is.
  void measure(std::uint32_t t) {
    const Point3 &a = vertex(3 * t), &b = vertex(3 * t + 1), &c = vertex(3 * t + 2);
    const Point3 ab = b - a, bc = c - b, ca = a - c, area = glm::cross(ab, -ca);
    const double size = glm::length(area);
    face_normals_[t] = size > 0 ? area / size : kNoNormal;
    const Point3 eye = to_eye(camera_, a);
    const double d = glm::dot(area, eye);
    patch_.facing[t] = std::abs(d) <= kEdgeOnSine * size * glm::length(eye) ? 0 : d > 0 ? 1 : -1;
    const double ab2 = glm::dot(ab, ab), bc2 = glm::dot(bc, bc), ca2 = glm::dot(ca, ca);
    const auto weigh = [&](const Point3& twice_area, double sizes) { return sizes > 0 ? twice_area / sizes : kNoNormal; };
    weighted_normals_[3 * t] = weigh(area, ab2 * ca2);
    weighted_normals_[3 * t + 1] = weigh(glm::cross(bc, -ab), bc2 * ab2);
    weighted_normals_[3 * t + 2] = weigh(glm::cross(ca, -bc), ca2 * bc2);
  }

  /// Pairs the sides that two triangles have in common, unless a border runs along them.
  void join_sides() {
    patch_.across.assign(3 * patch_.triangles.size(), kNone);
    parallel_tasks(patch_.runs.size(), [&](std::size_t r) { join_sides(patch_.runs[r]); });
  }

  void join_sides(const SmoothPatch::Run& run) {
    const std::size_t count = run.triangle_end - run.triangle;
    const VertexNumbers numbers(std::span(patch_.triangles).subspan(run.triangle, count));
    const VertexPairIndex sides(numbers.size(), 3 * count, [&](const auto& add) {
      for (std::uint32_t t = run.triangle; t < run.triangle_end; ++t) {
        const auto& v = patch_.triangles[t].v;
        const std::array of{numbers.of(v[0]), numbers.of(v[1]), numbers.of(v[2])};
        for (std::uint32_t k = 0; k < 3; ++k) add(of[k], of[(k + 1) % 3], 3 * t + k);
      }
    });
    parallel_blocks(numbers.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      CreaseMarks edges = edges_;
      sides.for_each_pair(begin, end, [&](std::uint32_t low, std::span<const VertexPairIndex::Entry> pair) {
        if (pair.size() != 2) return;
        const std::uint32_t a = pair[0].item, b = pair[1].item;
        if (edges.given() && edges.has(numbers.vertex(low), numbers.vertex(pair[0].high))) return;
        if (!are_smooth(a, b)) return;
        patch_.across[a] = b;
        patch_.across[b] = a;
      });
    });
  }

  /// Whether two sides on one edge are wound consistently and their angle makes no crease. A triangle without area has
  /// no normal that could differ.
  bool are_smooth(std::uint32_t s, std::uint32_t r) const {
    if (patch_.triangles[s / 3].v[s % 3] == patch_.triangles[r / 3].v[r % 3]) return false;
    const Point3 &a = face_normals_[s / 3], &b = face_normals_[r / 3];
    return a == kNoNormal || b == kNoNormal || glm::dot(a, b) >= (edges_.given() ? sharp_cosine_ : crease_cosine_);
  }

  /// Numbers the sectors in the order of their first corners, and sums their normals in the order of their corners.
  void make_sectors() {
    std::vector<SmoothPatch::Run>& runs = patch_.runs;
    patch_.sector.assign(3 * patch_.triangles.size(), kNone);
    std::vector<std::vector<std::uint32_t>> first(runs.size());  // per run: the first corner of each sector
    parallel_tasks(runs.size(), [&](std::size_t r) {
      for (std::uint32_t c = 3 * runs[r].triangle; c < 3 * runs[r].triangle_end; ++c) {
        if (patch_.sector[c] != kNone) continue;
        number_sector(c, static_cast<std::uint32_t>(first[r].size()));
        first[r].push_back(c);
      }
    });
    std::uint32_t count = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      runs[r].sector = count;
      runs[r].sector_end = count += static_cast<std::uint32_t>(first[r].size());
    }
    patch_.normals.assign(count, kNoNormal);
    patch_.g.resize(count);
    parallel_tasks(runs.size(), [&](std::size_t r) { sum_normals(runs[r], first[r]); });
  }

  /// Sums the normals of the sectors of a run, and turns the numbers of the sectors, which start at 0, into numbers of
  /// the patch. `first`: the first corner of each sector.
  void sum_normals(const SmoothPatch::Run& run, const std::vector<std::uint32_t>& first) {
    for (std::uint32_t c = 3 * run.triangle; c < 3 * run.triangle_end; ++c) {
      patch_.sector[c] += run.sector;
      patch_.normals[patch_.sector[c]] += weighted_normals_[c];
    }
    for (std::uint32_t s = run.sector; s < run.sector_end; ++s) {
      Point3& n = patch_.normals[s];
      const double size = glm::length(n);
      n = size > 0 ? n / size : kNoNormal;
      patch_.g[s] = glm::dot(n, to_eye(camera_, vertex(first[s - run.sector])));
    }
  }

  /// Numbers the connected corners around the vertex of corner c: a full ring, or a fan between two borders.
  void number_sector(std::uint32_t c, std::uint32_t number) {
    std::uint32_t at = c;
    do {
      patch_.sector[at] = number;
      const std::uint32_t r = patch_.across[at];
      if (r == kNone) break;
      at = next_corner(r);
    } while (patch_.sector[at] == kNone);
    if (at == c && patch_.across[c] != kNone) return;  // a full ring
    for (at = c;;) {
      const std::uint32_t r = patch_.across[previous_corner(at)];
      if (r == kNone) return;
      at = r;
      patch_.sector[at] = number;
    }
  }

  /// Turns all sides at vertices whose normal differs too much from a face into borders. Returns whether there are such
  /// vertices.
  bool cut_at_sharp_vertices() {
    std::vector<std::uint8_t> any(patch_.runs.size(), 0);
    parallel_tasks(patch_.runs.size(), [&](std::size_t r) { any[r] = cut_at_sharp_vertices(patch_.runs[r]); });
    return std::ranges::any_of(any, [](std::uint8_t cut) { return cut != 0; });
  }

  bool cut_at_sharp_vertices(const SmoothPatch::Run& run) {
    std::vector<std::uint8_t> sharp(run.sector_end - run.sector, 0);
    const auto is_sharp = [&](std::uint32_t c) -> std::uint8_t& { return sharp[patch_.sector[c] - run.sector]; };
    const std::uint32_t first = 3 * run.triangle, last = 3 * run.triangle_end;
    bool any = false;
    for (std::uint32_t c = first; c < last; ++c) {
      const Point3& face = face_normals_[c / 3];
      if (face == kNoNormal || glm::dot(face, patch_.normals[patch_.sector[c]]) >= crease_cosine_) continue;
      is_sharp(c) = 1;
      any = true;
    }
    for (std::uint32_t s = first; any && s < last; ++s) {
      if (patch_.across[s] == kNone || !(is_sharp(s) || is_sharp(next_corner(s)))) continue;
      patch_.across[patch_.across[s]] = kNone;
      patch_.across[s] = kNone;
    }
    return any;
  }

  const Scene& scene_;
  const Camera& camera_;
  CreaseMarks edges_;
  SmoothPatch& patch_;
  double crease_cosine_, sharp_cosine_;
  UninitializedVector<Point3> face_normals_;
  UninitializedVector<Point3> weighted_normals_;  ///< per corner
};

}  // namespace

Point3 to_eye(const Camera& camera, const Point3& p) { return camera.perspective ? camera.eye - p : -camera.forward; }

std::vector<std::uint32_t> outlines_inside_regions(const Scene& scene, const Topology& topology,
                                                   std::span<const std::uint32_t> outline_edges,
                                                   const RegionBorders& borders) {
  const double least_cosine = cosine(borders, borders.creases ? kSharp : 1);
  std::vector<std::uint32_t> inside =
      indices_where(outline_edges.size(), [&](std::size_t i) {  // an edge on a border lies inside no region
        return !is_border(scene, topology, borders, least_cosine, outline_edges[i]);
      });
  for (std::uint32_t& e : inside) e = outline_edges[e];
  VertexSet on_outline(scene.vertices.size()), continued(scene.vertices.size());
  for (const std::uint32_t e : inside) {
    for (const std::uint32_t v : {topology.edges[e].v0, topology.edges[e].v1}) {
      if (on_outline.has(v)) continued.add(v);
      on_outline.add(v);
    }
  }
  auto next = inside.begin();
  for (const std::uint32_t v : on_outline.list()) {
    const auto [first, last] = edges_up_from(topology, v);
    for (std::uint32_t e = first; e < last; ++e) {
      if (!on_outline.has(topology.edges[e].v1)) continue;
      if (next != inside.end() && *next == e) {
        ++next;
        continue;
      }
      continued.add(v);
      continued.add(topology.edges[e].v1);
    }
  }
  std::erase_if(
      inside, [&](std::uint32_t e) { return !continued.has(topology.edges[e].v0) && !continued.has(topology.edges[e].v1); });
  return inside;
}

SmoothPatch smooth_patch(const Scene& scene, const Topology& topology, const Camera& camera,
                         std::span<const std::uint32_t> outline_edges, const RegionBorders& borders) {
  SmoothPatch patch;
  patch.surfaces = borders.surfaces;
  VertexSet on_outline(scene.vertices.size());
  for (const std::uint32_t e : outline_edges) {
    on_outline.add(topology.edges[e].v0);
    on_outline.add(topology.edges[e].v1);
  }
  VertexSet ring(scene.vertices.size());
  for (const std::uint32_t t : touching(topology.triangles, on_outline)) {
    for (const std::uint32_t v : topology.triangles[t].v) ring.add(v);
  }
  const std::vector<std::uint32_t> inside = touching(topology.triangles, ring);
  patch.triangles.resize(inside.size());
  patch.complete.resize(3 * inside.size());
  parallel_each(inside.size(), [&](std::size_t t) {
    patch.triangles[t] = topology.triangles[inside[t]];
    for (std::size_t k = 0; k < 3; ++k) patch.complete[3 * t + k] = ring.has(patch.triangles[t].v[k]);
  });
  patch.runs = runs_of(scene, patch.triangles);
  PatchBuilder(scene, topology, camera, borders, patch).build();
  return patch;
}

}  // namespace ligne
