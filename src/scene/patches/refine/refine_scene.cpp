#include "scene/patches/refine/refine_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"
#include "scene/patches/refine/bodies_apart.hpp"

namespace ligne {
namespace {

/// Open edges are neighbours where one lies nearer to the middle of the other than so many of its sags: both may be chords.
constexpr double kRimSags = 2;

/// Open edges of recognised surfaces, of `curved` ones, beside which no other open edge lies: the rim of a bowl. Beside the
/// open end of a tube that a separate disk closes lies the border of the disk, and the one would leave the other.
std::vector<std::uint32_t> free_rims(const Scene& scene, const Topology& topology, const Patches& patches,
                                     std::span<const std::uint32_t> curved) {
  const auto is_open = [&](std::uint32_t e) { return topology.edges[e].face1 == kNone; };
  if (std::ranges::none_of(curved, is_open)) return {};
  const std::vector<std::uint32_t> open =
      indices_where(topology.edges.size(), [&](std::size_t e) { return is_open(static_cast<std::uint32_t>(e)); });
  std::vector<EdgeTree::Segment> segments;
  segments.reserve(open.size());
  for (const std::uint32_t e : open)
    segments.push_back({scene.vertices[topology.edges[e].v0], scene.vertices[topology.edges[e].v1]});
  const EdgeTree tree(segments);
  std::vector<std::uint32_t> rims;
  for (const std::uint32_t e : curved) {
    if (!is_open(e)) continue;
    const Edge& edge = topology.edges[e];
    const std::uint32_t patch = patches.patch_of[edge.face0];
    if (patch == kNone) continue;
    const Point3 middle = 0.5 * (scene.vertices[edge.v0] + scene.vertices[edge.v1]);
    const double within = kRimSags * std::abs(patches.list[patch].surface.distance(middle));
    const auto is_apart = [&](std::uint32_t segment, double) { return !share_vertex(topology.edges[open[segment]], edge); };
    if (tree.nearest(middle, within, is_apart).segment == kNone) rims.push_back(e);
  }
  return rims;
}

bool has_lines_of_its_own(const Scene& scene) {
  constexpr unsigned kLines = kCornerFileHidden | kCornerCurve | kCornerCrossing | kCornerContour;
  return std::ranges::any_of(scene.corner_flags, [](std::uint8_t flags) { return (flags & kLines) != 0; });
}

class RefinedSceneBuilder {
 public:
  RefinedSceneBuilder(const Scene& scene, const Topology& topology, const PlaneRegions& planes, const SplitTriangles& split)
      : scene_(scene), topology_(topology), planes_(planes), split_(split) {}

  RefinedScene build() {
    copy_the_rest();
    place_vertices();
    add_faces();
    for (Detail& detail : out_.scene.details) detail.face = first_part_[detail.face];
    out_.topology = build_topology(out_.scene);
    find_edges();
    return std::move(out_);
  }

 private:
  void copy_the_rest() {
    Scene& to = out_.scene;
    to.objects = scene_.objects;
    to.materials = scene_.materials;
    to.lights = scene_.lights;
    to.cameras = scene_.cameras;
    to.details = scene_.details;
    to.up_axis = scene_.up_axis;
    to.unit_mm = scene_.unit_mm;
  }

  /// Numbers the vertices by objects, the new ones of an object after its own.
  void place_vertices() {
    const std::size_t given = scene_.vertices.size();
    std::vector<std::uint32_t> added(split_.points.size());
    for (std::uint32_t i = 0; i < added.size(); ++i) added[i] = i;
    std::ranges::stable_sort(added, {}, [&](std::uint32_t i) { return object_of(split_.beside[i]); });
    number_.assign(given + added.size(), kNone);
    const std::vector<Point3>& at = split_.placed.empty() ? scene_.vertices : split_.placed;
    auto next = added.begin();
    std::vector<Point3>& vertices = out_.scene.vertices;
    const auto place = [&](std::size_t v, const Point3& p) {
      number_[v] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(p);
    };
    for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
      const Object& from = scene_.objects[o];
      Object& to = out_.scene.objects[o];
      to.vertex_begin = static_cast<std::uint32_t>(vertices.size());
      for (std::uint32_t v = from.vertex_begin; v < from.vertex_end; ++v) place(v, at[v]);
      for (; next != added.end() && object_of(split_.beside[*next]) == o; ++next) place(given + *next, split_.points[*next]);
      to.vertex_end = static_cast<std::uint32_t>(vertices.size());
    }
  }

  std::size_t object_of(std::uint32_t vertex) const {
    const auto after = std::ranges::upper_bound(scene_.objects, vertex, {}, &Object::vertex_end);
    return static_cast<std::size_t>(after - scene_.objects.begin());
  }

  void add_faces() {
    first_part_.assign(scene_.faces.size(), kNone);
    std::vector<std::uint32_t> face_of_region(planes_.list.size(), kNone);
    auto part = split_.parts.begin();
    for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
      const Object& object = scene_.objects[o];
      out_.scene.objects[o].face_begin = static_cast<std::uint32_t>(out_.face_of.size());
      for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
        const auto first = part;
        while (part != split_.parts.end() && part->face == f) ++part;
        const std::uint32_t region = planes_.region_of[f];
        if (region != kNone && split_.is_region_split[region]) {
          std::uint32_t& face = face_of_region[region];
          if (face == kNone) {
            face = static_cast<std::uint32_t>(out_.face_of.size());
            add_region(planes_.list[region], f);
          }
          first_part_[f] = face;
          continue;
        }
        first_part_[f] = static_cast<std::uint32_t>(out_.face_of.size());
        if (is_whole({first, part})) {
          add_whole(f);
        } else {
          for (auto p = first; p != part; ++p) add_part(*p);
        }
      }
      out_.scene.objects[o].face_end = static_cast<std::uint32_t>(out_.face_of.size());
    }
  }

  /// Whether none of the parts of a face has a new vertex or a turned edge.
  bool is_whole(std::span<const FacePart> parts) const {
    return std::ranges::all_of(parts, [&](const FacePart& part) {
      return !part.is_turned && std::ranges::all_of(part.v, [&](std::uint32_t v) { return v < scene_.vertices.size(); });
    });
  }

  void add_part(const FacePart& part) {
    out_.scene.faces.add_triangle(number_[part.v[0]], number_[part.v[1]], number_[part.v[2]]);
    add_flags(3, nullptr);
    add_attributes(part.face);
  }

  void add_whole(std::uint32_t f) {
    for (std::size_t c = 0; c < scene_.faces.contour_count(f); ++c) {
      const auto contour = scene_.faces.contour(f, c);
      add_contour({contour.begin(), contour.end()}, c > 0);
      add_flags(contour.size(),
                scene_.corner_flags.empty() ? nullptr : &scene_.corner_flags[scene_.faces.corner_index(f, c)]);
    }
    add_attributes(f);
  }

  void add_region(const PlaneRegion& region, std::uint32_t f) {
    for (std::size_t c = 0; c < region.loops.size(); ++c) {
      const std::vector<std::uint32_t>& loop = region.loops[c];
      std::vector<std::uint32_t> contour;
      for (std::size_t k = 0; k < loop.size(); ++k) split_.append_pieces(loop[k], loop[(k + 1) % loop.size()], contour);
      add_flags(contour.size(), nullptr);
      add_contour(std::move(contour), c > 0);
    }
    add_attributes(f);
  }

  void add_contour(std::vector<std::uint32_t> contour, bool is_hole) {
    for (std::uint32_t& v : contour) v = number_[v];
    if (is_hole) {
      out_.scene.faces.add_hole(contour);
    } else {
      out_.scene.faces.add_face(contour);
    }
  }

  /// Adds the flags of `count` corners; null: none.
  void add_flags(std::size_t count, const std::uint8_t* flags) {
    if (scene_.corner_flags.empty()) return;
    for (std::size_t k = 0; k < count; ++k) out_.scene.corner_flags.push_back(flags ? flags[k] : 0);
  }

  void add_attributes(std::uint32_t f) {
    out_.face_of.push_back(f);
    if (!scene_.face_material.empty()) out_.scene.face_material.push_back(scene_.face_material[f]);
    if (!scene_.face_source.empty()) out_.scene.face_source.push_back(scene_.face_source[f]);
  }

  /// Finds the given edges in the refined topology.
  void find_edges() {
    using Named = std::array<std::uint32_t, 3>;  // lower vertex, higher vertex, given edge
    std::vector<Named> given;
    std::vector<std::uint32_t> pieces;
    for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
      pieces.clear();
      split_.append_pieces(topology_.edges[e].v0, topology_.edges[e].v1, pieces);
      pieces.push_back(topology_.edges[e].v1);
      for (std::size_t k = 1; k < pieces.size(); ++k) {
        const std::uint32_t a = number_[pieces[k - 1]], b = number_[pieces[k]];
        given.push_back({std::min(a, b), std::max(a, b), e});
      }
    }
    std::sort(given.begin(), given.end());
    out_.edge_of.reserve(out_.topology.edges.size());
    auto next = given.begin();
    for (const Edge& edge : out_.topology.edges) {
      while (next != given.end() && std::tie((*next)[0], (*next)[1]) < std::tie(edge.v0, edge.v1)) ++next;
      const bool is_given = next != given.end() && (*next)[0] == edge.v0 && (*next)[1] == edge.v1;
      out_.edge_of.push_back(is_given ? (*next)[2] : kNone);
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  const PlaneRegions& planes_;
  const SplitTriangles& split_;
  std::vector<std::uint32_t> number_;      ///< per vertex, given or new: its number in the refined scene
  std::vector<std::uint32_t> first_part_;  ///< per given face: the first face that it became
  RefinedScene out_;
};

/// Gives scans the ranges of their objects in the refined scene, which has the same objects.
void carry_over(std::span<const Object> given, const RefinedScene& refined, std::vector<ScanObject>& scans) {
  for (ScanObject& scan : scans) {
    // An object without faces begins where the next one does.
    const auto object = std::ranges::find_if(
        given, [&](const Object& o) { return o.face_begin == scan.face_begin && o.face_end == scan.face_end; });
    const Object& now = refined.scene.objects[static_cast<std::size_t>(object - given.begin())];
    const EdgeRange edges = edges_of(refined.topology, now);
    scan = {now.face_begin, now.face_end, edges.begin, edges.end};
  }
}

void carry_over(const RefinedScene& refined, Creases& creases) {
  const std::size_t edges = refined.edge_of.size();
  std::vector<std::uint8_t> lines(edges, 0);
  std::vector<PatchEdge> patch_edges(edges, PatchEdge::inside);
  std::vector<std::uint32_t> new_edge(creases.lines.size(), kNone);
  for (std::uint32_t e = 0; e < edges; ++e) {
    const std::uint32_t given = refined.edge_of[e];
    if (given == kNone) continue;
    lines[e] = creases.lines[given];
    patch_edges[e] = creases.patch_edges[given];
    new_edge[given] = e;
  }
  creases.lines = std::move(lines);
  creases.patch_edges = std::move(patch_edges);
  Patches& patches = creases.patches;
  std::erase_if(patches.borders, [&](const FreeformBorder& border) { return new_edge[border.edge] == kNone; });
  for (FreeformBorder& border : patches.borders) border.edge = new_edge[border.edge];
  std::ranges::sort(patches.borders, {}, &FreeformBorder::edge);
  const auto by_new_face = [&](auto& of_face) {
    if (of_face.empty()) return;
    std::remove_reference_t<decltype(of_face)> of_new(refined.face_of.size());
    for (std::size_t f = 0; f < of_new.size(); ++f) of_new[f] = of_face[refined.face_of[f]];
    of_face = std::move(of_new);
  };
  by_new_face(patches.patch_of);
  by_new_face(patches.is_freeform);
}

}  // namespace

std::optional<RefinedScene> refine_scene(const Scene& scene, const Topology& topology, const RefineLimits& limits,
                                         Creases& creases) {
  const Patches& patches = creases.patches;
  if (patches.list.empty() || scene.stated.any_of_shape() || !has_few_objects(scene) || has_lines_of_its_own(scene))
    return std::nullopt;
  const std::optional<Bodies> bodies = find_few_bodies(scene, topology);
  if (!bodies) return std::nullopt;
  EdgeLevels levels = edge_levels(scene, topology, patches, limits);
  if (levels.of_patch.empty()) return std::nullopt;
  block_touching(scene, *bodies, patches, levels);
  if (std::ranges::all_of(levels.of_patch, [](std::uint8_t level) { return level == 0; })) return std::nullopt;
  levels.rims = free_rims(scene, topology, patches, levels.curved);
  const PlaneRegions planes = plane_regions(scene, topology, patches, creases.lines, levels.curved);
  const SplitTriangles split = split_triangles(scene, topology, patches, planes, levels);
  if (split.points.empty()) return std::nullopt;
  RefinedScene refined = RefinedSceneBuilder(scene, topology, planes, split).build();
  carry_over(scene.objects, refined, creases.scans);
  carry_over(refined, creases);
  return refined;
}

}  // namespace ligne
