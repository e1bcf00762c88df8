#include "visibility/watkins/scan_scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/no_index.hpp"
#include "visibility/polygons/facet_order.hpp"

namespace ligne::watkins {
namespace {

/// The plane of each face, from its largest triangle on the page.
std::vector<GridPlane> planes_of(const ProjectedScene& scene, const LineGrid& grid, std::uint32_t face_count) {
  std::vector<GridPlane> planes(face_count);
  std::vector<double> largest(face_count, 0);
  for (const Triangle& t : scene.triangles) {
    if (scene.is_edge_on(t)) continue;
    const ProjectedVertex &a = scene.vertices[t.v[0]], &b = scene.vertices[t.v[1]], &c = scene.vertices[t.v[2]];
    const double area = orientation(a.p, b.p, c.p);
    if (std::abs(area) <= largest[t.face]) continue;
    largest[t.face] = std::abs(area);
    const double abx = double(b.p.x) - a.p.x, aby = double(b.p.y) - a.p.y, acx = double(c.p.x) - a.p.x,
                 acy = double(c.p.y) - a.p.y;
    const double zx = ((b.z - a.z) * acy - (c.z - a.z) * aby) / area, zy = ((c.z - a.z) * abx - (b.z - a.z) * acx) / area;
    GridPlane& plane = planes[t.face];
    plane.zu = zx * grid.spacing;
    plane.zv = zy * grid.spacing;
    plane.z0 = a.z + zx * (grid.u_origin - a.p.x) + zy * (grid.v_origin - a.p.y);
  }
  return planes;
}

/// Largest depth tolerance of the facets of each face, without facets thinner than `thin_steps`.
std::vector<double> depth_tolerances(const ProjectedScene& scene, const std::vector<Facet>& facets, std::uint32_t face_count,
                                     double thin_steps) {
  std::vector<double> tolerances(face_count, 0);
  for (const Facet& f : facets) {
    const auto& v = scene.vertices;
    const double area = orientation(v[f.v[0]].p, v[f.v[1]].p, v[f.v[2]].p);
    if (area > thin_steps * f.size) tolerances[f.face] = std::max(tolerances[f.face], double(f.depth_tolerance));
  }
  return tolerances;
}

/// The edges of a scene, with the faces and lines that use them.
std::vector<ScanEdge> make_edges(ScanScene& result, const std::vector<ProjectedVertex>& vertices,
                                 const ListsOf<SegmentUse>& sides) {
  const LineGrid& grid = result.grid;
  std::vector<ScanEdge> edges;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const std::span<const SegmentUse> uses = sides[v];
    const auto end = uses.end();
    for (auto use = uses.begin(); use != end;) {
      ScanEdge edge{.faces_begin = static_cast<std::uint32_t>(result.edge_faces.size()),
                    .lines_begin = static_cast<std::uint32_t>(result.edge_lines.size())};
      const std::uint32_t other = use->other;
      while (use != end && use->other == other) {
        if (use->line) {
          result.edge_lines.push_back(use->index);
          ++use;
          continue;
        }
        auto same = use;
        while (same != end && same->other == other && !same->line && same->index == use->index) ++same;
        if ((same - use) % 2 == 1) result.edge_faces.push_back(use->index);
        use = same;
      }
      edge.faces_end = static_cast<std::uint32_t>(result.edge_faces.size());
      edge.lines_end = static_cast<std::uint32_t>(result.edge_lines.size());
      if (edge.faces_begin == edge.faces_end && edge.lines_begin == edge.lines_end) continue;
      edge.top = v;
      edge.bottom = other;
      if (comes_before(vertices[other].p, vertices[v].p)) std::swap(edge.top, edge.bottom);
      const ProjectedVertex &a = vertices[edge.top], &b = vertices[edge.bottom];
      edge.u_top = grid.u(a.p.x);
      edge.v_top = grid.v(a.p.y);
      edge.u_bottom = grid.u(b.p.x);
      edge.v_bottom = grid.v(b.p.y);
      edge.track = EdgeTrack::between({edge.u_top, edge.v_top, a.z}, {edge.u_bottom, edge.v_bottom, b.z}, grid.count);
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace

ScanScene make_scan_scene(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                          const LineGrid& grid, double thin_steps, const SkewFaces* skew) {
  ScanScene result;
  result.grid = grid;
  for (const Triangle& t : scene.triangles) result.face_count = std::max(result.face_count, t.face + 1);
  result.planes = planes_of(scene, grid, result.face_count);
  result.skew = skew;
  for (std::uint32_t f = 0; f < result.face_count; ++f) {
    if (result.is_skew(f)) result.planes[f] = {skew->farthest(f), 0, 0};
  }
  result.of_faces =
      numbers_by_key(result.face_count, facets.size(), [&](std::uint32_t facet) { return facets[facet].face; });
  result.depth_tolerance = depth_tolerances(scene, facets, result.face_count, thin_steps);

  // Lines that are edges of the scene share its vertices; the others get vertices of their own.
  std::vector<ProjectedVertex> vertices = scene.vertices;
  std::vector<std::array<std::uint32_t, 2>> line_ends(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i < scene.edges.size()) {
      line_ends[i] = {scene.edges[i].v0, scene.edges[i].v1};
    } else {
      const auto n = static_cast<std::uint32_t>(vertices.size());
      line_ends[i] = {n, n + 1};
      vertices.push_back(lines[i].from);
      vertices.push_back(lines[i].to);
    }
  }
  const auto for_each_use = [&](const auto& use) {
    for (const Triangle& t : scene.triangles) {
      if (scene.is_edge_on(t)) continue;
      for (int k = 0; k < 3; ++k) use(t.v[k], t.v[(k + 1) % 3], false, t.face);
    }
    for (std::uint32_t i = 0; i < line_ends.size(); ++i) use(line_ends[i][0], line_ends[i][1], true, i);
  };
  const std::vector<ScanEdge> edges = make_edges(result, vertices, uses_by_end(vertices.size(), for_each_use));
  ListsOf<ScanEdge> by_first_line(std::size_t{grid.count} + 1, [&](const auto& put) {
    for (const ScanEdge& e : edges) put(e.track.first, e);
  });
  result.first_of_line = std::move(by_first_line.begin);
  result.edges = std::move(by_first_line.values);
  result.unlisted = static_cast<std::uint32_t>(result.edges.size());
  result.edges.emplace_back();
  result.edges.back().track.last = kNone;
  return result;
}

DepthOrder FaceOrders::of(std::uint32_t a, std::uint32_t b) {
  if (a == b || (skew_ && (skew_->has(a) || skew_->has(b)))) return DepthOrder::crossing;
  const std::uint32_t low = std::min(a, b), high = std::max(a, b);
  const auto [place, fresh] = known_.try_emplace((std::uint64_t{low} << 32) | high, DepthOrder::crossing);
  if (fresh) place->second = decide(low, high);
  const DepthOrder order = place->second;
  if (a == low || order == DepthOrder::crossing) return order;
  return order == DepthOrder::first ? DepthOrder::second : DepthOrder::first;
}

void FaceOrders::extents_of(std::uint32_t face, std::vector<Extent>& extents) const {
  extents.clear();
  for (const std::uint32_t f : of_faces_[face]) {
    const std::uint32_t* v = facets_[f].v;
    const LatticePoint a = vertices_[v[0]].p, b = vertices_[v[1]].p, c = vertices_[v[2]].p;
    extents.push_back(
        {std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), f});
  }
  std::sort(extents.begin(), extents.end(),
            [](const Extent& p, const Extent& q) { return p.x0 != q.x0 ? p.x0 < q.x0 : p.facet < q.facet; });
}

/// Compares all facets of one face with the overlapping facets of the other, from left to right. Requires a < b.
DepthOrder FaceOrders::decide(std::uint32_t a, std::uint32_t b) {
  extents_of(a, extents_a_);
  extents_of(b, extents_b_);
  open_.clear();
  bool a_in_front = false, b_in_front = false;
  std::size_t next = 0;
  for (const Extent& e : extents_a_) {
    while (next < extents_b_.size() && extents_b_[next].x0 < e.x1) open_.push_back(extents_b_[next++]);
    // Drops extents that end left of this one: later ones begin no farther left.
    std::erase_if(open_, [&](const Extent& o) { return o.x1 <= e.x0; });
    for (const Extent& o : open_) {
      if (o.x0 >= e.x1 || o.y1 <= e.y0 || o.y0 >= e.y1) continue;
      const FacetOrder order = order_of(facets_, vertices_, e.facet, o.facet);
      if (order.order == DepthOrder::crossing) return DepthOrder::crossing;
      if (order.order == DepthOrder::apart || order.tie) continue;
      (order.order == DepthOrder::first ? a_in_front : b_in_front) = true;
      if (a_in_front && b_in_front) return DepthOrder::crossing;
    }
  }
  return b_in_front ? DepthOrder::second : DepthOrder::first;
}

}  // namespace ligne::watkins
