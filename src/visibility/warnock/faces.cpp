#include "visibility/warnock/faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne::warnock {
namespace {

/// A side with the places of its ends sorted. Sides of one face that coincide in opposite directions are cuts. They are
/// found by place, because clipping may create two vertices at one place.
struct PlacedSide {
  LatticePoint low, high;
  bool ascending;
  Side side;
  auto key() const { return std::tie(low.x, low.y, high.x, high.y); }
};

void append_contours(const FaceTable& table, std::span<const std::uint32_t> facets, std::vector<Side>& out) {
  const auto& vertices = *table.vertices;
  if (facets.size() == 1) {
    const Facet& f = (*table.facets)[facets[0]];
    for (int i = 0; i < 3; ++i) out.push_back({f.v[i], f.v[(i + 1) % 3]});
    return;
  }
  std::vector<PlacedSide> all;
  for (const std::uint32_t id : facets) {
    const Facet& f = (*table.facets)[id];
    for (int i = 0; i < 3; ++i) {
      const Side s{f.v[i], f.v[(i + 1) % 3]};
      const LatticePoint p = vertices[s.v0].p, q = vertices[s.v1].p;
      const bool ascending = std::tie(p.x, p.y) < std::tie(q.x, q.y);
      all.push_back({ascending ? p : q, ascending ? q : p, ascending, s});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const PlacedSide& a, const PlacedSide& b) { return a.key() < b.key(); });
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    int net = 0;
    for (; end < all.size() && all[end].key() == all[i].key(); ++end) net += all[end].ascending ? 1 : -1;
    for (std::size_t k = i; k < end && net != 0; ++k) {
      if (all[k].ascending != (net > 0)) continue;
      out.push_back(all[k].side);
      net += net > 0 ? -1 : 1;
    }
    i = end;
  }
}

/// Sets the plane of the face's largest facet. `slack` includes the distances of the other corners from it.
void set_plane(const FaceTable& table, Face& face) {
  const auto& vertices = *table.vertices;
  const Facet* largest = nullptr;
  double largest_area = 0;
  float touch = 0;
  face.z_near = std::numeric_limits<float>::infinity();
  face.z_far = -face.z_near;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  face.box = {kFar, -kFar, kFar, -kFar};
  for (const std::uint32_t id : table.facets_of(face)) {
    const Facet& f = (*table.facets)[id];
    const double area = orientation(vertices[f.v[0]].p, vertices[f.v[1]].p, vertices[f.v[2]].p);
    if (area > largest_area) {
      largest_area = area;
      largest = &f;
    }
    touch = std::max(touch, f.depth_tolerance);
    face.z_near = std::min(face.z_near, f.z_near);
    face.z_far = std::max(face.z_far, f.z_far);
    for (const std::uint32_t v : f.v) {
      const FramePoint p = table.at(v);
      face.box = {std::min(face.box.u0, p.u), std::max(face.box.u1, p.u), std::min(face.box.v0, p.v),
                  std::max(face.box.v1, p.v)};
    }
  }
  const FramePoint p0 = table.at(largest->v[0]), p1 = table.at(largest->v[1]), p2 = table.at(largest->v[2]);
  const double z0 = vertices[largest->v[0]].z;
  const double dz1 = vertices[largest->v[1]].z - z0, dz2 = vertices[largest->v[2]].z - z0;
  // The determinant in frame units: the frame rotates the lattice and scales it by |(a, b)|.
  const double area = largest_area * (table.frame.a * table.frame.a + table.frame.b * table.frame.b);
  face.base = p0;
  face.base_z = z0;
  face.gu = (dz1 * (p2.v - p0.v) - dz2 * (p1.v - p0.v)) / area;
  face.gv = (dz2 * (p1.u - p0.u) - dz1 * (p2.u - p0.u)) / area;
  double off = 0;
  for (const std::uint32_t id : table.facets_of(face)) {
    if (&(*table.facets)[id] == largest) continue;
    for (const std::uint32_t v : (*table.facets)[id].v) {
      const FramePoint p = table.at(v);
      off = std::max(off, std::abs(vertices[v].z - face.z(p.u, p.v)));
    }
  }
  face.slack = round_up(double(touch) + off);
}

}  // namespace

DepthRange Face::depths_over(const Window& window) const {
  const double u = (window.u0 + window.u1) / 2, v = (window.v0 + window.v1) / 2;
  const double centre = z(u, v), reach = std::abs(gu) * (window.u1 - u) + std::abs(gv) * (window.v1 - v) + slack;
  return {std::max<double>(z_near, centre - reach), std::min<double>(z_far, centre + reach)};
}

DepthRange Face::depths_over(const ConvexWindow& window, double margin) const {
  double near = std::numeric_limits<double>::infinity(), far = -near;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const FramePoint corner = window.corner(i);
    near = std::min(near, z(corner.u, corner.v));
    far = std::max(far, z(corner.u, corner.v));
  }
  const double reach = std::hypot(gu, gv) * margin + slack;
  return {std::max<double>(z_near, near - reach), std::min<double>(z_far, far + reach)};
}

FaceTable make_faces(const ProjectedScene& scene, const std::vector<Facet>& facets, const WindowFrame& frame) {
  FaceTable table{.facets = &facets, .vertices = &scene.vertices, .frame = frame};
  // Faces are in the order of their first facets. Facets are grouped by face and keep their order in each.
  std::uint32_t face_count = 0;
  for (const Facet& f : facets) face_count = std::max(face_count, f.face + 1);
  std::vector<std::uint32_t> index(face_count, kNone);
  for (const Facet& f : facets) {
    if (index[f.face] == kNone) {
      index[f.face] = static_cast<std::uint32_t>(table.faces.size());
      table.faces.emplace_back().face = f.face;
    }
    ++table.faces[index[f.face]].facet_end;  // a count until the ranges are set
  }
  std::uint32_t begin = 0;
  for (Face& face : table.faces) {
    face.facet_begin = begin;
    begin += face.facet_end;
    face.facet_end = face.facet_begin;
  }
  table.facet_order.resize(facets.size());
  for (std::uint32_t i = 0; i < facets.size(); ++i) table.facet_order[table.faces[index[facets[i].face]].facet_end++] = i;
  constexpr std::size_t kBlock = 8192;
  const std::size_t n = table.faces.size(), blocks = (n + kBlock - 1) / kBlock;
  std::vector<std::vector<Side>> sides(blocks);
  parallel_for(blocks, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) {
      Face& face = table.faces[i];
      set_plane(table, face);
      face.side_begin = static_cast<std::uint32_t>(sides[block].size());
      append_contours(table, table.facets_of(face), sides[block]);
      face.side_end = static_cast<std::uint32_t>(sides[block].size());
    }
  });
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto first = static_cast<std::uint32_t>(table.sides.size());
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) {
      table.faces[i].side_begin += first;
      table.faces[i].side_end += first;
    }
    table.sides.insert(table.sides.end(), sides[block].begin(), sides[block].end());
  }
  using Key = std::tuple<float, std::uint32_t, std::uint32_t>;  // z_near, face number, index
  std::vector<Key> order(n);
  for (std::uint32_t i = 0; i < n; ++i) order[i] = {table.faces[i].z_near, table.faces[i].face, i};
  parallel_sort(order.begin(), order.end());
  table.by_depth.resize(n);
  for (std::size_t i = 0; i < n; ++i) table.by_depth[i] = std::get<2>(order[i]);
  return table;
}

}  // namespace ligne::warnock
