#include "view/projected_scene.hpp"

#include <algorithm>
#include <atomic>
#include <unordered_map>

#include "base/hash.hpp"
#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/model/bounds.hpp"
#include "view/clip.hpp"
#include "view/coincident.hpp"
#include "view/edge_classes.hpp"
#include "view/edge_on.hpp"
#include "view/spatial_order.hpp"

namespace ligne {
namespace {

/// Relative rounding of the projection: a few double operations on coordinates as large as the largest one.
constexpr double kProjectionRounding = 0x1p-50;

double input_error_mm(const Scene& scene, const View& view, double largest) {
  double error = 0;
  for (const Object& object : scene.objects) error = std::max(error, object.precision);
  return projected_error_mm(view, error, largest);
}

ProjectedVertex to_vertex(const HomogeneousPoint& p, const Lattice& lattice) {
  return {lattice.snap({p.x / p.w, p.y / p.w}), p.z / p.w};
}

/// The volumes to which lines and faces are clipped; that of lines is inside the other.
struct Volumes {
  ClipVolume lines, faces;
};

Volumes volumes_of(const ProjectedScene& scene) {
  return {line_volume(scene.view, scene.lattice), face_volume(scene.view, scene.lattice)};
}

/// Projects the vertices that need no clipping, as corners of faces or as ends of lines. Returns whether all vertices
/// need none. The others are left for the clipping.
bool project_vertices(const Scene& scene, const View& view, const Volumes& volumes, ProjectedScene& out) {
  std::atomic<bool> all_inside{true};
  out.vertices = large_vector<ProjectedVertex>(scene.vertices.size());
  parallel_blocks(out.vertices.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    bool inside = true;
    for (std::size_t i = begin; i < end; ++i) {
      const HomogeneousPoint p = to_homogeneous(view, scene.vertices[i]);
      const bool in_lines = volumes.lines.contains(p);
      if (in_lines || volumes.faces.contains(p)) out.vertices[i] = to_vertex(p, out.lattice);
      inside = inside && in_lines;
    }
    if (!inside) all_inside = false;
  });
  return all_inside;
}

/// Clips triangles and candidate edges that cross the border of the view volume.
class Clipper {
 public:
  Clipper(const Scene& scene, const View& view, const Volumes& volumes, ProjectedScene& out)
      : scene_(scene), view_(view), volumes_(volumes), out_(out) {
    inside_.resize(scene.vertices.size());
    parallel_each(inside_.size(),
                  [&](std::size_t i) { inside_[i] = volumes_.faces.contains(to_homogeneous(view_, scene_.vertices[i])); });
  }

  void clip_triangles(const std::vector<Triangle>& triangles) {
    std::vector<HomogeneousPoint> contour;
    std::vector<std::uint32_t> corners;
    std::size_t object = 0;
    for (const Triangle& t : triangles) {
      while (object < scene_.objects.size() && t.face >= scene_.objects[object].face_end) ++object, cut_vertices_.clear();
      if (inside_[t.v[0]] && inside_[t.v[1]] && inside_[t.v[2]]) {
        out_.triangles.push_back(t);
        continue;
      }
      contour.clear();
      for (const std::uint32_t v : t.v) contour.push_back(to_homogeneous(view_, scene_.vertices[v]));
      clip_contour(contour, volumes_.faces);
      if (contour.size() < 3) continue;
      corners.clear();
      for (const HomogeneousPoint& p : contour) corners.push_back(corner(p, t));
      for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        out_.triangles.push_back({{corners[0], corners[k], corners[k + 1]}, t.face});
      }
    }
  }

  void clip_edges() {
    out_.edge_parts.reserve(out_.edges.size());
    std::size_t kept = 0;
    for (const ProjectedEdge& edge : out_.edges) {
      const HomogeneousPoint a = to_homogeneous(view_, scene_.vertices[edge.v0]);
      const HomogeneousPoint b = to_homogeneous(view_, scene_.vertices[edge.v1]);
      const auto part = clip_segment(a, b, volumes_.lines);
      if (!part) continue;
      ProjectedEdge clipped = edge;
      if (part->cut[0]) clipped.v0 = add_vertex(interpolate(a, b, part->range[0]));
      if (part->cut[1]) clipped.v1 = add_vertex(interpolate(a, b, part->range[1]));
      out_.edges[kept++] = clipped;
      out_.edge_parts.push_back(part->range);
    }
    out_.edges.resize(kept);
  }

 private:
  using Coordinates = std::array<double, 4>;
  struct Hash {
    std::size_t operator()(const Coordinates& c) const {
      std::size_t h = 0;
      for (const double v : c) h = extend_hash(h, bits_of_number(v));
      return h;
    }
  };
  static Coordinates coordinates(const HomogeneousPoint& p) { return {p.x, p.y, p.z, p.w}; }

  /// The vertex of a corner of the clipped triangle: an original vertex if it remains, else a vertex shared with the
  /// neighbours of the same object, since a common edge is cut at the same point to the last bit. So neighbours stay
  /// neighbours.
  std::uint32_t corner(const HomogeneousPoint& p, const Triangle& t) {
    for (const std::uint32_t v : t.v) {
      if (inside_[v] && coordinates(to_homogeneous(view_, scene_.vertices[v])) == coordinates(p)) return v;
    }
    const auto [place, is_new] = cut_vertices_.try_emplace(coordinates(p), 0u);
    if (is_new) place->second = add_vertex(p);
    return place->second;
  }

  std::uint32_t add_vertex(const HomogeneousPoint& p) {
    out_.vertices.push_back(to_vertex(p, out_.lattice));
    return static_cast<std::uint32_t>(out_.vertices.size() - 1);
  }

  const Scene& scene_;
  const View& view_;
  Volumes volumes_;
  ProjectedScene& out_;
  std::vector<std::uint8_t> inside_;                                   ///< per vertex: inside the volume of faces
  std::unordered_map<Coordinates, std::uint32_t, Hash> cut_vertices_;  ///< of the current object
};

/// `sure`: sure_facings(), or empty.
void select_edges(const Scene& scene, const Topology& topology, const EdgeSelection& selection,
                  std::vector<std::int8_t> sure, ProjectedScene& out) {
  const std::vector<LineClass> classes =
      classify_edges(scene, topology, out.view, selection.crease_degrees, selection.creases, std::move(sure));
  const std::vector<std::uint32_t> selected =
      indices_where(classes.size(), [&](std::size_t e) { return selection.classes.has(classes[e]); });
  out.edges = large_vector<ProjectedEdge>(selected.size());
  parallel_each(selected.size(), [&](std::size_t k) {
    const std::uint32_t e = selected[k];
    const Edge& edge = topology.edges[e];
    out.edges[k] = {edge.v0, edge.v1, edge.face0, edge.face1, e, classes[e]};
  });
}

}  // namespace

double projected_error_mm(const View& view, double precision, double largest) {
  return view.scale * std::max(precision, kProjectionRounding * largest);
}

std::vector<std::uint8_t> transparent_faces(const Scene& scene) {
  const auto transparent = [&](std::uint32_t material) {
    return material < scene.materials.size() && scene.materials[material].opacity < 1;
  };
  bool any = false;
  for (std::uint32_t m = 0; m < scene.materials.size(); ++m) any |= transparent(m);
  if (!any) return {};
  std::vector<std::uint8_t> result(scene.faces.size());
  for (std::size_t f = 0; f < result.size(); ++f)
    result[f] = transparent(scene.face_material.empty() ? 0 : scene.face_material[f]);
  return result;
}

ProjectedScene select_candidates(const Scene& scene, const Topology& topology, const View& view,
                                 const EdgeSelection& selection) {
  ProjectedScene out{.model = &scene,
                     .lattice = page_lattice(view),
                     .view = view,
                     .source_count = static_cast<std::uint32_t>(topology.edges.size()),
                     .with_intersections = selection.classes.has(LineClass::intersection)};
  const double largest = largest_coordinate(scene);
  out.input_error_mm = input_error_mm(scene, view, largest);
  out.face_is_transparent = transparent_faces(scene);
  std::vector<std::int8_t> sure;
  if (selection.shapes) sure = sure_facings(scene, view.camera, *selection.shapes, largest);
  out.face_is_edge_on = faces_seen_edge_on(scene, topology, view.camera, largest, sure);
  if (!selection.no_edges) select_edges(scene, topology, selection, std::move(sure), out);
  return out;
}

std::optional<PlacedNumbers> place_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected) {
  if (!project_vertices(scene, projected.view, volumes_of(projected), projected)) return std::nullopt;
  projected.triangles = large_vector<Triangle>(topology.triangles.size());
  parallel_blocks(projected.triangles.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    std::copy_n(topology.triangles.data() + begin, end - begin, projected.triangles.data() + begin);
  });
  PlacedNumbers numbers{order_faces_spatially(projected), {}};
  numbers.faces = merge_coincident_faces(projected, topology.may_repeat_triangles);
  return numbers;
}

void place_candidates(const PlacedNumbers& numbers, ProjectedScene& projected) {
  order_edges_spatially(projected, numbers.vertices);
  merge_coincident_edges(projected, numbers.faces);
}

void place_on_page(const Scene& scene, const Topology& topology, ProjectedScene& projected) {
  std::optional<PlacedNumbers> numbers = place_faces(scene, topology, projected);
  if (!numbers) {
    Clipper clipper(scene, projected.view, volumes_of(projected), projected);
    clipper.clip_triangles(topology.triangles);
    clipper.clip_edges();
    numbers = PlacedNumbers{order_faces_spatially(projected), {}};
    numbers->faces = merge_coincident_faces(projected, true);
  }
  place_candidates(*numbers, projected);
}

ProjectedScene project(const Scene& scene, const Topology& topology, const View& view, const EdgeSelection& selection) {
  ProjectedScene projected = select_candidates(scene, topology, view, selection);
  place_on_page(scene, topology, projected);
  return projected;
}

void add_lines(ProjectedScene& projected, std::span<const std::array<Point3, 2>> lines, LineClass line_class) {
  const ClipVolume volume = line_volume(projected.view, projected.lattice);
  const auto add_vertex = [&](const HomogeneousPoint& p) {
    projected.vertices.push_back(to_vertex(p, projected.lattice));
    return static_cast<std::uint32_t>(projected.vertices.size() - 1);
  };
  for (const auto& line : lines) {
    const std::uint32_t source = projected.source_count++;
    const HomogeneousPoint a = to_homogeneous(projected.view, line[0]), b = to_homogeneous(projected.view, line[1]);
    const auto part = clip_segment(a, b, volume);
    if (!part) continue;
    if (!part->whole() && projected.edge_parts.empty()) projected.edge_parts.assign(projected.edges.size(), {0, 1});
    const std::uint32_t v0 = add_vertex(part->cut[0] ? interpolate(a, b, part->range[0]) : a);
    const std::uint32_t v1 = add_vertex(part->cut[1] ? interpolate(a, b, part->range[1]) : b);
    projected.edges.push_back({v0, v1, kNone, kNone, source, line_class});
    if (!part->whole() || !projected.edge_parts.empty()) projected.edge_parts.push_back(part->range);
  }
}

}  // namespace ligne
