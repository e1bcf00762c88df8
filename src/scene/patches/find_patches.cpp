#include "scene/patches/find_patches.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/patches/borders/flat_rows.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/freeform.hpp"
#include "scene/patches/parts/large_freeform.hpp"
#include "scene/patches/repeated_objects.hpp"
#include "scene/patches/search/patch_finder.hpp"
#include "scene/patches/swept/profile_curve.hpp"
#include "scene/patches/swept/swept_surfaces.hpp"

namespace ligne {
namespace {

/// The patches of one object, numbered from 0.
struct ObjectPatches {
  std::uint32_t edge_begin = 0;  ///< first edge of the object
  std::vector<Patch> patches;
  std::vector<std::uint32_t> patch_of;    ///< per face of the object; empty if there are no patches
  std::vector<std::uint8_t> is_freeform;  ///< per face of the object
  std::vector<std::uint32_t> plane_edges;
  std::vector<FreeformBorder> borders;
};

/// Limit surfaces of subdivision are splines, whose facets lie on cylinders and spheres only by accident. Each of their
/// triangles has a side inside the surface.
bool is_limit_surface(const Scene& scene, const Object& object) {
  if (scene.corner_flags.empty() || object.face_begin == object.face_end) return false;
  const auto sides =
      std::span(scene.corner_flags)
          .subspan(scene.faces.corner_index(object.face_begin, 0), scene.faces.contour(object.face_begin, 0).size());
  return std::ranges::any_of(sides, [](std::uint8_t flags) { return (flags & kCornerLimit) != 0; });
}

ObjectPatches patches_of(const Scene& scene, const Topology& topology, const Object& object, const MeshAngles& angles) {
  const std::vector<glm::vec3>& normals = angles.normals;
  const EdgeRange range = edges_of(topology, object);
  const auto [edge_begin, edge_end] = range;
  ObjectPatches found;
  found.edge_begin = edge_begin;
  if (is_limit_surface(scene, object)) {
    found.is_freeform.assign(object.face_end - object.face_begin, 1);
    return found;
  }
  std::vector<std::uint32_t> joints;
  if (auto free = find_large_freeform({scene, topology, object, range, angles}, joints)) {
    found.is_freeform = std::move(free->is_freeform);
    found.plane_edges = std::move(free->plane_edges);
    found.borders = std::move(free->borders);
    return found;
  }
  const FacetGraph graph = facet_graph(scene, topology, object, range, normals, joints);
  found.plane_edges = edges_inside_planes(topology, object, graph, edge_begin, edge_end, normals);
  const std::span edges(topology.edges.data() + edge_begin, topology.edges.data() + edge_end);
  std::vector<std::uint32_t> of_facet = PatchFinder(scene, topology, object, graph).run(found.patches);
  std::vector<std::uint8_t> freeform =
      freeform_facets(scene, topology, graph, {found.patches, of_facet, {}}, EdgeRows(scene, topology, normals));
  find_swept_surfaces({scene, topology, object, graph}, {found.patches, of_facet, freeform});
  std::vector<PatchOutline> outlines;
  if (!found.patches.empty()) outlines = patch_outlines(scene, edges, object, graph, {found.patches, of_facet, freeform});
  for (std::uint32_t f = 0; f < graph.size(); ++f) {
    if (of_facet[f] != kNone && outlines[of_facet[f]].is_speck()) freeform[f] = 1;
  }
  found.borders = freeform_borders(scene, topology, graph, {found.patches, of_facet, freeform}, outlines);
  found.patch_of.resize(graph.facet_of.size());
  found.is_freeform.resize(graph.facet_of.size());
  parallel_each(graph.facet_of.size(), [&](std::size_t f) {
    found.patch_of[f] = of_facet[graph.facet_of[f]];
    found.is_freeform[f] = freeform[graph.facet_of[f]];
  });
  assign_flat_rows(scene, topology, object, graph, {found.patches, found.patch_of, found.is_freeform});
  return found;
}

/// The profile in the frame of an object that repeats another one.
std::shared_ptr<const SweptProfile> moved_profile(const SweptProfile& profile, const Similarity& motion) {
  return std::make_shared<SweptProfile>(
      SweptProfile{profile.curve.scaled(motion.scale), motion.turned(profile.x), motion.turned(profile.y)});
}

/// The patches of an object that repeats another one.
ObjectPatches moved(ObjectPatches patches, const Similarity& motion, std::uint32_t edge_begin) {
  for (Patch& patch : patches.patches) {
    PatchSurface& surface = patch.surface;
    surface.at = motion(surface.at);
    surface.axis = glm::normalize(motion.turned(surface.axis));
    surface.radius *= motion.scale;
    surface.tube *= motion.scale;
    if (surface.profile) surface.profile = moved_profile(*surface.profile, motion);
    patch.sag *= motion.scale;
  }
  for (FreeformBorder& border : patches.borders) {
    border.edge += edge_begin - patches.edge_begin;
    border.length *= motion.scale;
  }
  for (std::uint32_t& edge : patches.plane_edges) edge += edge_begin - patches.edge_begin;
  patches.edge_begin = edge_begin;
  return patches;
}

/// The edges that have any of these flags or belong to one of the faces, ascending. `faces`: ascending.
std::vector<std::uint32_t> edges_with_or_at(const Topology& topology, unsigned flags, std::span<const std::uint32_t> faces) {
  std::vector<std::uint32_t> found = edges_with(topology, flags);
  auto t = topology.triangles.begin();
  for (const std::uint32_t f : faces) {
    t = std::ranges::lower_bound(t, topology.triangles.end(), f, {}, &Triangle::face);
    for (; t != topology.triangles.end() && t->face == f; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        // A side inside a polygon is no edge.
        const std::uint32_t edge = edge_between(topology, t->v[k], t->v[(k + 1) % 3]);
        if (edge != kNone) found.push_back(edge);
      }
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

Point3 Patches::normal(std::uint32_t face, const Point3& p, const Point3& face_normal) const {
  if (patch_of[face] == kNone) return face_normal;
  const Patch& patch = list[patch_of[face]];
  return patch.outward ? patch.surface.normal(p) : -patch.surface.normal(p);
}

Patches find_patches(const Scene& scene, const Topology& topology, const MeshAngles& angles) {
  std::vector<ObjectPatches> parts(scene.objects.size());
  const std::vector<Repetition> repetitions = find_repetitions(scene, topology);
  parallel_tasks(parts.size(), [&](std::size_t i) {
    if (repetitions[i].original == i) parts[i] = patches_of(scene, topology, scene.objects[i], angles);
  });
  parallel_tasks(parts.size(), [&](std::size_t i) {
    const auto& [original, motion] = repetitions[i];
    if (original == i) return;
    parts[i] = moved(parts[original], motion, edges_of(topology, scene.objects[i]).begin);
  });
  Patches found;
  found.patch_of.assign(scene.faces.size(), kNone);
  found.is_freeform.assign(scene.faces.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(found.list.size());
    const std::uint32_t begin = scene.objects[i].face_begin;
    // Edges are in the order of their objects, so the borders stay sorted.
    const auto first_chain = static_cast<std::uint32_t>(found.borders.size());
    for (FreeformBorder& border : parts[i].borders) border.chain += first_chain;
    found.borders.insert(found.borders.end(), parts[i].borders.begin(), parts[i].borders.end());
    found.plane_edges.insert(found.plane_edges.end(), parts[i].plane_edges.begin(), parts[i].plane_edges.end());
    found.list.insert(found.list.end(), parts[i].patches.begin(), parts[i].patches.end());
    parallel_each(parts[i].patch_of.size(), [&](std::size_t f) {
      if (parts[i].patch_of[f] != kNone) found.patch_of[begin + f] = first + parts[i].patch_of[f];
    });
    std::ranges::copy(parts[i].is_freeform, found.is_freeform.begin() + begin);
  }
  return found;
}

std::vector<std::uint32_t> edges_outside_freeforms(const Topology& topology, const Patches& patches) {
  std::vector<std::uint8_t> is_outside(patches.is_freeform.size());
  for (std::size_t f = 0; f < is_outside.size(); ++f) is_outside[f] = patches.is_freeform[f] == 0;
  for (std::size_t f = 0; f < is_outside.size() && !patches.list.empty(); ++f) is_outside[f] |= patches.patch_of[f] != kNone;
  constexpr unsigned kOutside = kEdgeBorder | kEdgeManyFaces;
  constexpr std::size_t kFewPart = 16;  // adjustable: one of so many faces takes less time to look up than all edges
  const std::vector<std::uint32_t> faces = indices_of_marks(is_outside);
  if (faces.size() <= is_outside.size() / kFewPart) return edges_with_or_at(topology, kOutside, faces);
  return indices_where(topology.edges.size(), [&, outside = is_outside.data()](std::size_t e) {
    const Edge& edge = topology.edges[e];
    if (topology.edge_flags[e] & kOutside) return true;
    return (outside[edge.face0] | outside[edge.face1]) != 0;
  });
}

}  // namespace ligne
