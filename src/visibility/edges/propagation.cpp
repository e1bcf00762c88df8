#include "visibility/edges/propagation.hpp"

#include <algorithm>
#include <deque>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"

namespace ligne {
namespace {

constexpr std::int64_t kNotThere = -(std::int64_t{1} << 40);  ///< stays below 0 for any number of faces added

/// The faces in front of a place: their number, or the faces themselves.
struct Invisibility {
  std::int64_t count = 0;              ///< below 0 if a face was removed that was not there: the count is then
                                       ///< uncertain
  std::vector<std::uint32_t> faces{};  ///< ascending; empty unless the set is carried

  void change(std::uint32_t face, int by, bool with_faces) {
    count += by;
    if (!with_faces) return;
    const auto at = std::lower_bound(faces.begin(), faces.end(), face);
    if (by > 0) {
      faces.insert(at, face);
    } else if (at != faces.end() && *at == face) {
      faces.erase(at);
    } else {
      count = kNotThere;
    }
  }
};

/// A side of facets with different surfaces on its two sides: the faces to the right of v0 -> v1, with y down, and to
/// the left.
struct SurfaceSide {
  std::uint32_t v0, v1;
  double tolerance;  ///< largest depth tolerance of its facets
  std::vector<std::uint32_t> right, left;
};

/// The neighbourhood of an edge in space.
struct EdgeNear {
  bool certain = true;
  std::vector<std::uint32_t> at_start, at_end;  ///< faces at either vertex that hide the edge there
};

class Propagator {
 public:
  Propagator(const ProjectedScene& scene, const FacetForest& forest, double coincidence_steps, Propagation kind,
             PropagationCounts& counts)
      : scene_(scene), forest_(forest), kind_(kind), counts_(counts), counter_(forest, coincidence_steps) {
    find_sides();
    find_edges_of_vertices();
  }

  std::vector<std::vector<CountedPart>> run();

 private:
  bool with_faces() const { return kind_ == Propagation::nature; }
  PageLine line_of(std::uint32_t edge) const {
    const ProjectedEdge& e = scene_.edges[edge];
    return {scene_.vertices[e.v0], scene_.vertices[e.v1], e.face0, e.face1};
  }
  bool is_whole(std::uint32_t edge) const {
    return scene_.edge_parts.empty() || scene_.edge_parts[edge] == std::array<double, 2>{0, 1};
  }

  void find_sides();
  void find_edges_of_vertices();
  std::vector<std::uint32_t> start_order() const;
  void start_at(std::uint32_t edge);
  void follow(std::uint32_t vertex);
  EdgeNear look_near(std::uint32_t edge, const PageLine& line);
  bool look_at_facet(std::uint32_t edge, const PageLine& line, const Facet& facet, EdgeNear& near) const;
  bool carry(std::uint32_t edge, const EdgeNear& near, bool from_end);
  bool find_crossings(std::uint32_t edge, const PageLine& line);
  void arrive(std::uint32_t vertex, Invisibility at_vertex, const std::vector<std::uint32_t>& hiding);

  /// A side that the edge passes behind, and whether the edge passes to its right.
  struct Crossing {
    double t;
    std::uint32_t side;
    bool to_right;
  };

  const ProjectedScene& scene_;
  const FacetForest& forest_;
  Propagation kind_;
  PropagationCounts& counts_;
  FaceCounter counter_;
  std::vector<SurfaceSide> sides_;
  BoxForest side_forest_;
  std::uint32_t side_root_ = 0;
  IndexLists edges_of_;                                 ///< candidate edges by vertex
  std::vector<std::optional<Invisibility>> at_vertex_;  ///< not counting the faces at the vertex
  std::deque<std::uint32_t> open_;                      ///< vertices whose edges are to be followed
  std::vector<std::uint8_t> done_;
  std::vector<Crossing> crossings_;
  std::vector<std::vector<CountedPart>> parts_;
};

void Propagator::find_sides() {
  struct Use {
    std::uint32_t low, high, face;
    bool right;
    float tolerance;
  };
  std::vector<Use> uses;
  uses.reserve(3 * forest_.facets().size());
  for (const Facet& f : forest_.facets()) {
    for (int k = 0; k < 3; ++k) {
      // A facet is positively turned: its inside lies to the right of its sides where y points down.
      const std::uint32_t a = f.v[k], b = f.v[(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), f.face, a < b, f.depth_tolerance});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.face, a.right) < std::tie(b.low, b.high, b.face, b.right);
  });
  std::vector<DepthBox> boxes;
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    SurfaceSide side{uses[i].low, uses[i].high, 0, {}, {}};
    for (end = i; end < uses.size() && uses[end].low == side.v0 && uses[end].high == side.v1; ++end) {
      (uses[end].right ? side.right : side.left).push_back(uses[end].face);
      side.tolerance = std::max<double>(side.tolerance, uses[end].tolerance);
    }
    if (with_faces() ? side.right == side.left : side.right.size() == side.left.size()) continue;
    DepthBox box;
    for (const std::uint32_t v : {side.v0, side.v1}) {
      box.extend(scene_.vertices[v].p);
      box.z_near = std::min(box.z_near, round_down(scene_.vertices[v].z - side.tolerance));
    }
    boxes.push_back(box);
    sides_.push_back(std::move(side));
  }
  side_root_ = side_forest_.add_tree(boxes);
}

void Propagator::find_edges_of_vertices() {
  edges_of_ = {scene_.vertices.size(), [this](const auto& put) {
                 for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) {
                   put(scene_.edges[e].v0, e);
                   put(scene_.edges[e].v1, e);
                 }
               }};
}

/// The order in which edges may become starts; for paths, the edges with the nearest vertex come first.
std::vector<std::uint32_t> Propagator::start_order() const {
  std::vector<std::uint32_t> order(scene_.edges.size());
  std::iota(order.begin(), order.end(), 0u);
  if (kind_ != Propagation::path) return order;
  const auto depth = [&](std::uint32_t e) {
    return std::min(scene_.vertices[scene_.edges[e].v0].z, scene_.vertices[scene_.edges[e].v1].z);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return depth(a) < depth(b); });
  return order;
}

std::vector<std::vector<CountedPart>> Propagator::run() {
  parts_.resize(scene_.edges.size());
  done_.assign(scene_.edges.size(), 0);
  at_vertex_.resize(scene_.vertices.size());
  for (const std::uint32_t e : start_order()) {
    if (!done_[e]) start_at(e);
    while (!open_.empty()) {
      const bool last = kind_ == Propagation::path;
      const std::uint32_t vertex = last ? open_.back() : open_.front();
      if (last) {
        open_.pop_back();
      } else {
        open_.pop_front();
      }
      follow(vertex);
    }
  }
  return std::move(parts_);
}

/// Tests the edge against all faces. If the result is certain, the faces in front of its two ends are known from then
/// on.
void Propagator::start_at(std::uint32_t edge) {
  done_[edge] = 1;
  const PageLine line = line_of(edge);
  if (line.p0 == line.p1) return;
  ++counts_.tested;
  parts_[edge] = counter_.count(line, with_faces(), counts_.facets);
  const EdgeNear near = look_near(edge, line);
  if (!near.certain || !find_crossings(edge, line)) {
    ++counts_.in_doubt;
    return;
  }
  const CountedPart &first = parts_[edge].front(), &last = parts_[edge].back();
  arrive(scene_.edges[edge].v0, {first.count, first.faces}, near.at_start);
  arrive(scene_.edges[edge].v1, {last.count, last.faces}, near.at_end);
}

/// Carries the faces in front of the vertex along its edges.
void Propagator::follow(std::uint32_t vertex) {
  for (const std::uint32_t edge : edges_of_[vertex]) {
    if (done_[edge]) continue;
    const PageLine line = line_of(edge);
    const bool is_seen_end_on = line.p0 == line.p1;
    if (!is_seen_end_on) {
      const EdgeNear near = look_near(edge, line);
      if (near.certain && find_crossings(edge, line) && carry(edge, near, scene_.edges[edge].v1 == vertex)) {
        done_[edge] = 1;
        ++counts_.carried;
        continue;
      }
    }
    done_[edge] = 1;
    if (is_seen_end_on) continue;
    ++counts_.tested;
    ++counts_.in_doubt;
    parts_[edge] = counter_.count(line, with_faces(), counts_.facets);
  }
}

/// Looks at the facets near the edge in space.
EdgeNear Propagator::look_near(std::uint32_t edge, const PageLine& line) {
  EdgeNear near;
  near.certain = is_whole(edge) && line.face0 != kNone;
  if (!near.certain) return near;
  forest_.for_each_near(line, [&](std::uint32_t number) {
    const Facet& facet = forest_.facets()[number];
    if (!near.certain || facet.face == line.face0 || facet.face == line.face1) return;
    ++counts_.near;
    near.certain = look_at_facet(edge, line, facet, near);
  });
  return near;
}

/// Whether the facet certainly lies all in front of, or all behind, the part of the edge over it; a common vertex does
/// not count. A facet in front at a common vertex is added to the faces that hide the edge there.
bool Propagator::look_at_facet(std::uint32_t edge, const PageLine& line, const Facet& facet, EdgeNear& near) const {
  const ProjectedVertex* const p = scene_.vertices.data();
  double enter = 0, leave = 1;
  SideAreas areas;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint a = p[facet.v[i]].p, b = p[facet.v[(i + 1) % 3]].p;
    const double q0 = orientation(a, b, line.p0), q1 = orientation(a, b, line.p1);
    areas.at_start[i] = q0;
    areas.fall[i] = q0 - q1;
    if (q0 == 0 && q1 == 0) return false;
    if (q0 <= 0 && q1 <= 0) return true;
    if (q0 < 0) enter = std::max(enter, q0 / (q0 - q1));
    if (q1 < 0) leave = std::min(leave, q0 / (q0 - q1));
  }
  if (!(enter < leave)) return true;
  const double area = areas.at_start[0] + areas.at_start[1] + areas.at_start[2];
  const auto behind = [&](double t) {
    const double w2 = areas.at_start[0] - t * areas.fall[0], w0 = areas.at_start[1] - t * areas.fall[1],
                 w1 = areas.at_start[2] - t * areas.fall[2];
    return line.z(t) - (w0 * p[facet.v[0]].z + w1 * p[facet.v[1]].z + w2 * p[facet.v[2]].z) / area;
  };
  const auto side_at = [&](double t) {
    const double d = behind(t);
    return d > facet.depth_tolerance ? 1 : d < -facet.depth_tolerance ? -1 : 0;
  };
  const auto has_vertex = [&](std::uint32_t v) { return std::find(facet.v, facet.v + 3, v) != facet.v + 3; };
  const bool at_start = has_vertex(scene_.edges[edge].v0) && enter == 0;
  const bool at_end = has_vertex(scene_.edges[edge].v1) && leave == 1;
  if (at_start && at_end) return false;
  const int first = at_start ? side_at(leave) : side_at(enter), last = at_end ? side_at(enter) : side_at(leave);
  if (first == 0 || first != last) return false;
  if (first > 0 && at_start) near.at_start.push_back(facet.face);
  if (first > 0 && at_end) near.at_end.push_back(facet.face);
  return true;
}

/// Finds the sides that the edge passes behind; false if one is in doubt. A side at one of the edge's own vertices
/// meets the edge only there, unless it lies along it.
bool Propagator::find_crossings(std::uint32_t edge, const PageLine& line) {
  crossings_.clear();
  const ProjectedEdge& e = scene_.edges[edge];
  const auto is_own = [&](std::uint32_t v) { return v == e.v0 || v == e.v1; };
  bool certain = true;
  OpenParts whole;
  whole.reset(0, 1);
  side_forest_.for_each_before(side_root_, line, whole, [&](std::uint32_t number) {
    if (!certain) return;
    const SurfaceSide& side = sides_[number];
    if (is_own(side.v0) && is_own(side.v1)) return;
    ++counts_.sides;
    const ProjectedVertex &a = scene_.vertices[side.v0], &b = scene_.vertices[side.v1];
    const double s0 = orientation(line.p0, line.p1, a.p), s1 = orientation(line.p0, line.p1, b.p);
    const double r0 = orientation(a.p, b.p, line.p0), r1 = orientation(a.p, b.p, line.p1);
    if ((s0 > 0 && s1 > 0) || (s0 < 0 && s1 < 0) || (r0 > 0 && r1 > 0) || (r0 < 0 && r1 < 0)) return;
    if (is_own(side.v0) || is_own(side.v1)) {
      certain = s0 != s1;
      return;
    }
    certain = s0 != 0 && s1 != 0 && r0 != 0 && r1 != 0;
    if (!certain) return;
    const double t = r0 / (r0 - r1), depth = a.z + s0 / (s0 - s1) * (b.z - a.z), behind = line.z(t) - depth;
    if (behind < -side.tolerance) return;
    certain = behind > side.tolerance;
    crossings_.push_back({t, number, r1 > 0});
  });
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return std::tie(a.t, a.side) < std::tie(b.t, b.side); });
  return certain;
}

/// Carries the count from one end of the edge to the other. False if it falls below zero: then it was not certain.
bool Propagator::carry(std::uint32_t edge, const EdgeNear& near, bool from_end) {
  const ProjectedEdge& e = scene_.edges[edge];
  Invisibility now = *at_vertex_[from_end ? e.v1 : e.v0];
  for (const std::uint32_t face : from_end ? near.at_end : near.at_start) now.change(face, 1, with_faces());
  if (from_end) std::reverse(crossings_.begin(), crossings_.end());
  std::vector<CountedPart> parts;
  double from = from_end ? 1 : 0;
  const auto add_part = [&](double to) {
    if (from != to) {
      CountedPart part{std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(now.count), now.faces};
      const bool goes_on = !parts.empty() && parts.back().is_like(part);
      if (!goes_on) {
        parts.push_back(std::move(part));
      } else if (from_end) {
        parts.back().from = part.from;
      } else {
        parts.back().to = part.to;
      }
    }
    from = to;
  };
  for (const Crossing& crossing : crossings_) {
    if (now.count < 0) return false;
    add_part(crossing.t);
    const SurfaceSide& side = sides_[crossing.side];
    const bool to_right = crossing.to_right != from_end;
    for (const std::uint32_t face : to_right ? side.right : side.left) now.change(face, 1, with_faces());
    for (const std::uint32_t face : to_right ? side.left : side.right) now.change(face, -1, with_faces());
  }
  if (now.count < 0) return false;
  add_part(from_end ? 0 : 1);
  if (from_end) std::reverse(parts.begin(), parts.end());
  parts_[edge] = std::move(parts);
  arrive(from_end ? e.v0 : e.v1, std::move(now), from_end ? near.at_start : near.at_end);
  return true;
}

void Propagator::arrive(std::uint32_t vertex, Invisibility at_vertex, const std::vector<std::uint32_t>& hiding) {
  if (at_vertex_[vertex]) return;
  for (const std::uint32_t face : hiding) at_vertex.change(face, -1, with_faces());
  if (at_vertex.count < 0) return;
  at_vertex_[vertex] = std::move(at_vertex);
  open_.push_back(vertex);
}

}  // namespace

std::vector<std::vector<CountedPart>> propagate(const ProjectedScene& scene, const FacetForest& forest,
                                                double coincidence_steps, Propagation kind, PropagationCounts& counts) {
  return Propagator(scene, forest, coincidence_steps, kind, counts).run();
}

}  // namespace ligne
