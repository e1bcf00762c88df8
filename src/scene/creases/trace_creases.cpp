#include "scene/creases/trace_creases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "base/index_lists.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

// Limits for a clean line. Adjustable.
constexpr double kWidePart = 3.0 / 4;       ///< of the crease angle: a line ends where the surface bends less
constexpr double kWalkCosine = 0.70710678;  ///< 45 degrees, from the last kLookBack edges to the next one
constexpr std::size_t kLookBack = 3;
constexpr std::size_t kFewestEdges = 6;
constexpr double kRidgePart = 2.0 / 3;        ///< smallest part of vertices at an edge above the crease angle
constexpr double kZigzagPart = 1.0 / 3;       ///< largest part of vertices that turn more than kZigzagCosine
constexpr double kZigzagCosine = 0.64278761;  ///< 50 degrees
constexpr double kSharpPart = 0.95;           ///< of the bend farther out; a line below lies on a fillet
constexpr double kLongPart = 1.0 / 8;         ///< of the size of the object: a shorter line on a fillet is not a crease

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Traces the creases of one object, whose edges are [edge_begin, edge_end).
class Tracer {
 public:
  /// `is_sure` is empty, or tells by edge, from the first one of the object, which creases stay as they are.
  Tracer(const CreaseMesh& mesh, std::vector<Bend>& bends, const ScanObject& edges, const Object& object,
         std::vector<std::uint8_t> is_sure)
      : scene_(mesh.scene),
        topology_(mesh.topology),
        normals_(mesh.angles.normals),
        bends_(bends),
        object_(object),
        edge_begin_(edges.edge_begin),
        edge_end_(edges.edge_end),
        size_(mesh.sizes[static_cast<std::size_t>(&object - mesh.scene.objects.data())]),
        is_sure_(std::move(is_sure)) {}

  TracedCreases run(double crease_degrees) {
    collect();
    const double crease = radians(crease_degrees);
    least_wide_ = kWidePart * crease;
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
      if (bends_[candidates_[k]] >= Bend::strong && wide_[k] > crease) seeds.push_back(k);
    }
    std::ranges::sort(seeds,
                      [&](std::uint32_t a, std::uint32_t b) { return std::pair(-wide_[a], a) < std::pair(-wide_[b], b); });
    for (const std::uint32_t seed : seeds) {
      if (!on_line_[seed] && !refused_[seed]) trace(seed);
    }
    TracedCreases result;
    for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
      Bend& bend = bends_[candidates_[k]];
      if (on_line_[k]) {
        result.continued += bend < Bend::strong;
        bend = std::max(bend, Bend::strong);
        if (!firm_[k]) bend = Bend::strong;
      } else {
        result.left_out += bend >= Bend::strong;
        bend = Bend::none;
      }
    }
    return result;
  }

 private:
  static constexpr double kUnknown = -1;
  enum class VertexState : std::uint8_t { open, beside, line };

  Point3 along(std::size_t e) const {
    return scene_.vertices[topology_.edges[e].v1] - scene_.vertices[topology_.edges[e].v0];
  }

  /// The number of a vertex near candidates among these vertices; one number for all others.
  std::uint32_t place_of(std::uint32_t vertex) const { return place_of_vertex_[vertex - object_.vertex_begin]; }

  VertexState& state_of(std::uint32_t vertex) { return state_of_vertex_[vertex - object_.vertex_begin]; }

  void add_edges_of(std::uint32_t f) {
    const auto first = topology_.edges.begin() + static_cast<std::ptrdiff_t>(edge_begin_);
    const auto last = topology_.edges.begin() + static_cast<std::ptrdiff_t>(edge_end_);
    const auto contour = scene_.faces.contour(f, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<std::uint32_t, std::uint32_t> key = std::minmax(contour[i], contour[(i + 1) % 3]);
      const auto edge =
          std::lower_bound(first, last, key, [](const Edge& e, const auto& ends) { return std::pair(e.v0, e.v1) < ends; });
      const auto e = static_cast<std::uint32_t>(edge - topology_.edges.begin());
      if (edge->face1 != kNone && !is_sure(e)) candidates_.push_back(e);
    }
  }

  /// Collects the edges that may lie on a line, the faces around them, and the bend of the surface at each.
  void collect() {
    for (const std::uint32_t k : indices_of_marks(std::span(bends_).subspan(edge_begin_, edge_end_ - edge_begin_))) {
      const std::size_t e = edge_begin_ + k;
      if (is_sure(e)) continue;
      candidates_.push_back(static_cast<std::uint32_t>(e));
      if (bends_[e] < Bend::strong) continue;
      // If triangles cross a ridge alternately from both sides, the edges along the ridge do not bend at all.
      for (const std::uint32_t f : {topology_.edges[e].face0, topology_.edges[e].face1}) add_edges_of(f);
    }
    std::ranges::sort(candidates_);
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
    const std::vector<std::uint8_t> wanted = near_candidates();
    const std::vector<std::uint32_t> wanted_faces = faces_at(wanted), near = indices_of_marks(wanted);
    const auto count = static_cast<std::uint32_t>(near.size());
    place_of_vertex_.assign(wanted.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) place_of_vertex_[near[i]] = i;
    edges_at_ = IndexLists(count + 1, [&](const auto& add) {
      for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
        add(place_of(topology_.edges[candidates_[k]].v0), k);
        add(place_of(topology_.edges[candidates_[k]].v1), k);
      }
    });
    faces_at_ = IndexLists(count + 1, [&](const auto& add) {
      for (const std::uint32_t f : wanted_faces) {
        for (const std::uint32_t v : scene_.faces.contour(f, 0)) {
          if (wanted[v - object_.vertex_begin]) add(place_of(v), f);
        }
      }
    });
    wide_.assign(candidates_.size(), kUnknown);
    parallel_blocks(candidates_.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> round;
      for (std::size_t k = begin; k < end; ++k) {
        if (bends_[candidates_[k]] >= Bend::strong) wide_[k] = wide_bend(candidates_[k], round);
      }
    });
    on_line_.assign(candidates_.size(), 0);
    firm_.assign(candidates_.size(), 0);
    refused_.assign(candidates_.size(), 0);
    state_of_vertex_.assign(wanted.size(), VertexState::open);
    on_ridge_.assign(wanted.size(), 0);
    for (const std::uint32_t e : candidates_) {
      if (bends_[e] < Bend::strong) continue;
      for (const std::uint32_t v : {topology_.edges[e].v0, topology_.edges[e].v1}) {
        on_ridge_[v - object_.vertex_begin] = 1;
      }
    }
    mark_sure();
  }

  bool is_sure(std::size_t e) const { return !is_sure_.empty() && is_sure_[e - edge_begin_] != 0; }

  /// No line runs beside a crease that stays.
  void mark_sure() {
    for (std::size_t e = edge_begin_; e < edge_end_; ++e) {
      if (!is_sure(e)) continue;
      const Edge& edge = topology_.edges[e];
      for (const std::uint32_t f : {edge.face0, edge.face1}) {
        if (f == kNone) continue;
        for (const std::uint32_t v : scene_.faces.contour(f, 0)) state_of(v) = std::max(state_of(v), VertexState::beside);
      }
      state_of(edge.v0) = state_of(edge.v1) = VertexState::line;
    }
  }

  /// Per vertex of the object: 1 if it is on a face that shares a vertex with a face of a candidate.
  std::vector<std::uint8_t> near_candidates() const {
    std::vector<std::uint8_t> at(object_.vertex_end - object_.vertex_begin, 0);
    for (const std::uint32_t e : candidates_) {
      for (const std::uint32_t f : {topology_.edges[e].face0, topology_.edges[e].face1}) {
        for (const std::uint32_t v : scene_.faces.contour(f, 0)) at[v - object_.vertex_begin] = 1;
      }
    }
    std::vector<std::uint8_t> near = at;
    for (const std::uint32_t f : faces_at(at)) {
      for (const std::uint32_t v : scene_.faces.contour(f, 0)) near[v - object_.vertex_begin] = 1;
    }
    return near;
  }

  /// The faces of the object with a marked vertex, ascending.
  std::vector<std::uint32_t> faces_at(const std::vector<std::uint8_t>& marked) const {
    const std::uint8_t* marks = marked.data();
    const std::uint32_t first = object_.vertex_begin;
    // All faces are triangles.
    const std::uint32_t* corners = scene_.faces.corners().data() + scene_.faces.corner_index(object_.face_begin, 0);
    std::vector<std::uint32_t> faces = indices_where(object_.face_end - object_.face_begin, [&](std::size_t i) {
      const std::uint32_t* own = corners + 3 * i;
      return (marks[own[0] - first] | marks[own[1] - first] | marks[own[2] - first]) != 0;
    });
    for (std::uint32_t& f : faces) f += object_.face_begin;
    return faces;
  }

  /// Appends to `round`, in ascending order, all faces that share a vertex with one of `faces`.
  void faces_round(std::span<const std::uint32_t> faces, std::vector<std::uint32_t>& round) const {
    round.clear();
    for (const std::uint32_t f : faces) {
      for (const std::uint32_t v : scene_.faces.contour(f, 0)) {
        const auto more = faces_at_[place_of(v)];
        round.insert(round.end(), more.begin(), more.end());
      }
    }
    std::ranges::sort(round);
    round.erase(std::unique(round.begin(), round.end()), round.end());
  }

  /// The angle between the faces on one side of an edge and those on the other, in radians.
  double bend_between(std::uint32_t e, std::span<const std::uint32_t> faces) const {
    const Edge& edge = topology_.edges[e];
    const Point3 across = glm::cross(along(e), Point3(normals_[edge.face0] + normals_[edge.face1]));
    Point3 sides[2] = {Point3(0), Point3(0)};
    for (const std::uint32_t f : faces) {
      const auto contour = scene_.faces.contour(f, 0);
      const Point3 a = scene_.vertices[contour[0]], b = scene_.vertices[contour[1]], c = scene_.vertices[contour[2]];
      const Point3 middle = (a + b + c) / 3.0;
      sides[glm::dot(middle - scene_.vertices[edge.v0], across) > 0] += glm::cross(b - a, c - a);
    }
    return std::atan2(glm::length(glm::cross(sides[0], sides[1])), glm::dot(sides[0], sides[1]));
  }

  /// bend_between() for the faces that share a vertex with the edge's faces. A triangle that stands out is only a small
  /// part of either side, and an edge across a ridge has both slopes on both sides. `round` is scratch memory for these
  /// faces.
  double wide_bend(std::uint32_t e, std::vector<std::uint32_t>& round) const {
    faces_round(std::array{topology_.edges[e].face0, topology_.edges[e].face1}, round);
    return bend_between(e, round);
  }

  /// bend_between() for the next ring of faces, without those of wide_bend().
  double far_bend(std::uint32_t e) const {
    std::vector<std::uint32_t> near, far;
    faces_round(std::array{topology_.edges[e].face0, topology_.edges[e].face1}, near);
    faces_round(near, far);
    std::erase_if(far, [&](std::uint32_t f) { return std::ranges::binary_search(near, f); });
    return bend_between(e, far);
  }

  /// A line being traced: its vertices and the edges between them.
  struct Line {
    std::vector<std::uint32_t> vertices, edges;
    void turn_round() {
      std::ranges::reverse(vertices);
      std::ranges::reverse(edges);
    }
  };

  /// No line may run on another one or beside it, but it may reach one and end there.
  bool may_run(std::uint32_t from, std::uint32_t to) {
    const VertexState a = state_of(from), b = state_of(to);
    return a == VertexState::open || b == VertexState::open || (a == VertexState::line) != (b == VertexState::line);
  }

  void trace(std::uint32_t seed) {
    const Edge& edge = topology_.edges[candidates_[seed]];
    if (state_of(edge.v0) != VertexState::open && state_of(edge.v1) != VertexState::open) return;
    Line line{{edge.v0, edge.v1}, {seed}};
    for (int k = 0; k < 2; ++k) {
      while (extend(line)) {
      }
      shorten(line);
      line.turn_round();
    }
    const auto firm_edges =
        std::ranges::count_if(line.edges, [&](std::uint32_t k) { return bends_[candidates_[k]] == Bend::firm; });
    const bool firm = 2 * static_cast<std::size_t>(firm_edges) >= line.edges.size();
    const bool is_clean_line = is_clean(line), is_crease = is_clean_line && (firm || !is_short_fillet(line));
    for (const std::uint32_t k : line.edges) {
      on_line_[k] = is_crease;
      firm_[k] = firm;
      refused_[k] = !is_crease;
    }
    if (!is_clean_line) return;
    // Also beside a fillet that is not a crease: another line along it would be no better.
    for (const std::uint32_t v : line.vertices) {
      for (const std::uint32_t face : faces_at_[place_of(v)]) {
        for (const std::uint32_t next : scene_.faces.contour(face, 0)) {
          state_of(next) = std::max(state_of(next), VertexState::beside);
        }
      }
    }
    for (const std::uint32_t v : line.vertices) state_of(v) = VertexState::line;
  }

  /// Adds the edge that continues the line behind its last vertex: the one that bends most and turns least.
  bool extend(Line& line) {
    const std::uint32_t v = line.vertices.back();
    if (state_of(v) == VertexState::line) return false;
    const std::size_t back = std::min(line.vertices.size() - 1, kLookBack);
    const Point3 behind = scene_.vertices[line.vertices[line.vertices.size() - 1 - back]];
    if (behind == scene_.vertices[v]) return false;
    const Point3 direction = glm::normalize(scene_.vertices[v] - behind);
    std::uint32_t best = kNone, best_vertex = kNone;
    double best_score = 0;
    for (const std::uint32_t k : edges_at_[place_of(v)]) {
      if (on_line_[k] || k == line.edges.back()) continue;
      const Edge& edge = topology_.edges[candidates_[k]];
      const std::uint32_t next = edge.v0 == v ? edge.v1 : edge.v0;
      if (!may_run(v, next)) continue;
      const double cosine = glm::dot(glm::normalize(scene_.vertices[next] - scene_.vertices[v]), direction);
      if (cosine < kWalkCosine) continue;
      if (wide_[k] == kUnknown) wide_[k] = wide_bend(candidates_[k], round_);
      const double score = cosine * cosine * wide_[k];
      if (wide_[k] <= least_wide_ || score <= best_score) continue;
      best = k, best_vertex = next, best_score = score;
    }
    if (best == kNone) return false;
    const auto met = std::ranges::find(line.vertices, best_vertex);
    if (met != line.vertices.end() && met != line.vertices.begin()) return false;
    const bool closes = met != line.vertices.end();
    line.vertices.push_back(best_vertex);
    line.edges.push_back(best);
    return !closes;
  }

  bool is_on_ridge(std::uint32_t vertex) const { return on_ridge_[vertex - object_.vertex_begin] != 0; }

  /// Cuts the end of a line back to the end of its ridge, unless the line reaches another one.
  void shorten(Line& line) {
    while (line.edges.size() > 1 && !is_on_ridge(line.vertices.back()) &&
           state_of(line.vertices.back()) != VertexState::line) {
      line.vertices.pop_back();
      line.edges.pop_back();
    }
  }

  bool is_clean(const Line& line) const {
    if (line.edges.size() < kFewestEdges) return false;
    const auto on_ridge = std::ranges::count_if(line.vertices, [&](std::uint32_t v) { return is_on_ridge(v); });
    std::size_t turns = 0;
    for (std::size_t i = 2; i < line.vertices.size(); ++i) {
      const Point3 a = scene_.vertices[line.vertices[i - 2]], b = scene_.vertices[line.vertices[i - 1]];
      const Point3 c = scene_.vertices[line.vertices[i]];
      turns += glm::dot(glm::normalize(b - a), glm::normalize(c - b)) < kZigzagCosine;
    }
    const auto count = static_cast<double>(line.vertices.size());
    return static_cast<double>(on_ridge) >= kRidgePart * count && static_cast<double>(turns) <= kZigzagPart * count;
  }

  /// Whether the line is short and the surface goes on bending beside it: then many lines along a fillet would do.
  bool is_short_fillet(const Line& line) const {
    double length = 0, wide = 0, far = 0;
    for (const std::uint32_t k : line.edges) length += glm::length(along(candidates_[k]));
    if (length >= kLongPart * size_) return false;
    for (const std::uint32_t k : line.edges) {
      wide += wide_[k];
      far += far_bend(candidates_[k]);
    }
    return wide < kSharpPart * far;
  }

  const Scene& scene_;
  const Topology& topology_;
  const std::vector<glm::vec3>& normals_;
  std::vector<Bend>& bends_;
  const Object& object_;
  std::size_t edge_begin_, edge_end_;
  double size_;
  std::vector<std::uint8_t> is_sure_;
  std::vector<std::uint32_t> candidates_;
  double least_wide_ = 0;
  std::vector<double> wide_;                            ///< per candidate: wide_bend(), computed where lines come
  std::vector<std::uint32_t> round_;                    ///< scratch memory for wide_bend()
  std::vector<std::uint8_t> on_line_, firm_, refused_;  ///< per candidate
  std::vector<VertexState> state_of_vertex_;            ///< per vertex of the object
  std::vector<std::uint8_t> on_ridge_;                  ///< per vertex of the object: 1 if an edge exceeds the angle
  std::vector<std::uint32_t> place_of_vertex_;          ///< per vertex of the object: see place_of()
  IndexLists edges_at_;                                 ///< by place_of(): the candidates, by their index in candidates_
  IndexLists faces_at_;                                 ///< by place_of(): the faces, ascending
};

}  // namespace

TracedCreases trace_creases(const CreaseMesh& mesh, double crease_degrees, std::vector<Bend>& bends) {
  TracedCreases sum;
  for (const Object& object : mesh.scene.objects) {
    const auto [edge_begin, edge_end] = edges_of(mesh.topology, object);
    ScanObject own{object.face_begin, object.face_end, edge_begin, edge_end};
    std::vector<std::uint8_t> is_sure;
    if (!is_scan(mesh, bends, own, object.precision)) {
      if (!is_decimated(mesh, bends, own)) continue;
      is_sure = sure_creases(mesh, bends, own);
      ++sum.decimated;
      own.is_decimated = true;
    }
    sum.scans.push_back(own);
    const TracedCreases traced = Tracer(mesh, bends, own, object, std::move(is_sure)).run(crease_degrees);
    sum.left_out += traced.left_out;
    sum.continued += traced.continued;
  }
  return sum;
}

}  // namespace ligne
