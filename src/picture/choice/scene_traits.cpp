#include "picture/choice/scene_traits.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/connected_boxes.hpp"
#include "geometry/predicates.hpp"
#include "picture/choice/cover_samples.hpp"
#include "picture/choice/face_pairs.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/convex_body.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {
namespace {

/// Number of rows of sample points, on the page and on the plan, at which faces are counted.
constexpr std::uint32_t kSampleRows = 512;

Point2 at(LatticePoint p) { return {double(p.x), double(p.y)}; }

bool is_transparent(const ProjectedScene& scene, std::uint32_t face) {
  return face < scene.face_is_transparent.size() && scene.face_is_transparent[face];
}

double area_of(const ProjectedScene& scene, const Triangle& t) {
  return orientation(scene.vertices[t.v[0]].p, scene.vertices[t.v[1]].p, scene.vertices[t.v[2]].p);
}

/// Bounding boxes on the page of the faces of the scene.
struct FaceBoxes {
  std::vector<std::uint32_t> faces;
  std::vector<AxisBox> boxes;
};

FaceBoxes boxes_of(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  constexpr std::uint32_t kNotSeen = 0xffffffffu;
  FaceBoxes found;
  std::vector<std::uint32_t> number;
  for (const Facet& f : facets) {
    if (f.face >= number.size()) number.resize(f.face + 1, kNotSeen);
    if (number[f.face] == kNotSeen) {
      number[f.face] = static_cast<std::uint32_t>(found.faces.size());
      found.faces.push_back(f.face);
      found.boxes.push_back({1e300, 1e300, -1e300, -1e300});
    }
    AxisBox& box = found.boxes[number[f.face]];
    for (const std::uint32_t v : f.v) {
      const Point2 p = at(scene.vertices[v].p);
      box = {std::min(box.x0, p.x), std::min(box.y0, p.y), std::max(box.x1, p.x), std::max(box.y1, p.y)};
    }
  }
  return found;
}

void count_zones(const std::vector<AxisBox>& boxes, SceneTraits& traits) {
  DisjointSets sets = connect_boxes(boxes);
  std::vector<std::size_t> size(boxes.size(), 0);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const std::size_t n = ++size[sets.find(i)];
    traits.zones += n == 1;
    traits.largest_zone = std::max(traits.largest_zone, n);
  }
}

void count_faces(const ProjectedScene& scene, const std::vector<std::uint32_t>& faces, SceneTraits& traits) {
  std::unordered_map<std::uint32_t, double> areas;
  for (const Triangle& t : scene.triangles) areas[t.face] += area_of(scene, t);
  traits.faces = faces.size();
  for (const std::uint32_t f : faces) {
    // Counter-clockwise as seen is a negative turn on the page, whose y axis points down.
    traits.front_faces += areas[f] < 0;
    traits.transparent_faces += is_transparent(scene, f);
  }
}

/// Counts the vertices that are above, or below, both their neighbours on a contour of a face. Of two vertices at equal
/// height, the left one counts as higher, so that a horizontal side makes one such vertex and not two. Contours consist
/// of the sides that belong to one triangle of the face.
std::size_t count_turning_vertices(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  struct Side {
    std::uint32_t face, from, to;
    auto key() const { return std::tuple(face, std::min(from, to), std::max(from, to)); }
  };
  std::vector<Side> sides;
  for (const Facet& f : facets) {
    for (int k = 0; k < 3; ++k) sides.push_back({f.face, scene.place(f.v[k]), scene.place(f.v[(k + 1) % 3])});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key() < b.key(); });
  // For each side of a contour, whether it goes down or up from each of its ends.
  std::vector<std::array<std::uint32_t, 3>> ends;  // face, vertex, 1 for a side that goes down
  const auto above = [&](std::uint32_t a, std::uint32_t b) {
    const LatticePoint p = scene.vertices[a].p, q = scene.vertices[b].p;
    return p.y != q.y ? p.y < q.y : p.x < q.x;
  };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].key() == sides[i].key(); ++end) {
    }
    if (end - i != 1) continue;
    const bool down = above(sides[i].from, sides[i].to);
    ends.push_back({sides[i].face, sides[i].from, down});
    ends.push_back({sides[i].face, sides[i].to, !down});
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::uint32_t> turning;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] == ends[i + 1]) turning.push_back(ends[i++][1]);
  }
  std::sort(turning.begin(), turning.end());
  return static_cast<std::size_t>(std::unique(turning.begin(), turning.end()) - turning.begin());
}

/// Counts the convex ones among the sets of triangles that are connected by vertices. Each set is tested as a scene of
/// its own.
std::size_t count_convex_objects(const ProjectedScene& scene) {
  DisjointSets sets(scene.vertices.size());
  for (const Triangle& t : scene.triangles) {
    sets.join(t.v[0], t.v[1]);
    sets.join(t.v[1], t.v[2]);
  }
  std::vector<std::uint32_t> by_set(scene.triangles.size());
  for (std::uint32_t i = 0; i < by_set.size(); ++i) by_set[i] = i;
  const auto set_of = [&](std::uint32_t triangle) { return sets.find(scene.triangles[triangle].v[0]); };
  std::stable_sort(by_set.begin(), by_set.end(), [&](std::uint32_t a, std::uint32_t b) { return set_of(a) < set_of(b); });
  std::size_t convex = 0;
  std::vector<std::uint32_t> vertex_number(scene.vertices.size(), kNone);
  for (std::size_t begin = 0, end = 0; begin < by_set.size(); begin = end) {
    ProjectedScene body;
    body.lattice = scene.lattice;
    body.view = scene.view;
    body.input_error_mm = scene.input_error_mm;
    std::map<std::uint32_t, std::uint32_t> face_number;
    bool opaque = true;
    for (end = begin; end < by_set.size() && set_of(by_set[end]) == set_of(by_set[begin]); ++end) {
      const Triangle& t = scene.triangles[by_set[end]];
      Triangle copy = t;
      copy.face = face_number.emplace(t.face, static_cast<std::uint32_t>(face_number.size())).first->second;
      for (std::uint32_t& v : copy.v) {
        if (vertex_number[v] == kNone) {
          vertex_number[v] = static_cast<std::uint32_t>(body.vertices.size());
          body.vertices.push_back(scene.vertices[v]);
        }
        v = vertex_number[v];
      }
      opaque = opaque && !is_transparent(scene, t.face);
      body.triangles.push_back(copy);
    }
    if (!opaque) continue;
    if (!scene.face_is_edge_on.empty()) {
      body.face_is_edge_on.resize(face_number.size());
      for (const auto& [face, number] : face_number) body.face_is_edge_on[number] = scene.face_is_edge_on[face];
    }
    convex += convexity::why_not_one_convex_body(body, convexity::face_the_viewer(body)).empty();
  }
  return convex;
}

/// The position on the plan of the scene, by its two horizontal axes.
Point2 in_plan(const Point3& p, Axis up) {
  return up == Axis::x ? Point2{p.y, p.z} : up == Axis::y ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

/// Whether no vertical line meets the scene twice. Tests exactly that neighbours lie on opposite sides of their common
/// line, and by samples that no point of the plan has two triangles.
bool is_height_field(const Scene& scene, const Topology& topology) {
  if (topology.triangles.empty()) return false;
  struct Side {
    std::uint32_t low, high, third;
  };
  std::vector<Side> sides;
  const auto plan = [&](std::uint32_t v) { return in_plan(scene.vertices[v], scene.up_axis); };
  Rect around{plan(topology.triangles[0].v[0]), plan(topology.triangles[0].v[0])};
  for (const Triangle& t : topology.triangles) {
    const Point2 p[3] = {plan(t.v[0]), plan(t.v[1]), plan(t.v[2])};
    if (orientation_sign(p[0], p[1], p[2]) == 0) return false;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t.v[k], b = t.v[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t.v[(k + 2) % 3]});
      around = {glm::min(around.min, p[k]), glm::max(around.max, p[k])};
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tuple(a.low, a.high, a.third) < std::tuple(b.low, b.high, b.third);
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    const auto side_of = [&](std::uint32_t v) { return orientation_sign(plan(a.low), plan(a.high), plan(v)); };
    if (side_of(a.third) == side_of(b.third)) return false;
  }
  CoverSamples samples(around, kSampleRows);
  for (const Triangle& t : topology.triangles) samples.add({plan(t.v[0]), plan(t.v[1]), plan(t.v[2])});
  return samples.cover().most <= 1;
}

void count_overlap(const ProjectedScene& scene, const std::vector<Facet>& facets, SceneTraits& traits) {
  if (facets.empty()) return;
  const auto corners = [&](const Facet& f) {
    return std::array{at(scene.vertices[f.v[0]].p), at(scene.vertices[f.v[1]].p), at(scene.vertices[f.v[2]].p)};
  };
  Rect around{corners(facets[0])[0], corners(facets[0])[0]};
  for (const Facet& f : facets) {
    for (const Point2& p : corners(f)) around = {glm::min(around.min, p), glm::max(around.max, p)};
  }
  CoverSamples samples(around, kSampleRows);
  for (const Facet& f : facets) samples.add(corners(f));
  const CoverSamples::Cover cover = samples.cover();
  traits.mean_overlap = cover.mean;
  traits.most_overlap = cover.most;
}

}  // namespace

SceneTraits scene_traits(const Scene& scene, const Topology& topology, const ProjectedScene& projected) {
  SceneTraits traits;
  const double coincidence_steps = coincidence_mm(projected) / projected.lattice.step_mm;
  const std::vector<Facet> facets = make_facets(projected, coincidence_steps).facets;
  const FaceBoxes boxes = boxes_of(projected, facets);
  count_faces(projected, boxes.faces, traits);
  count_zones(boxes.boxes, traits);
  count_overlap(projected, facets, traits);
  traits.convex_objects = count_convex_objects(projected);
  traits.turning_vertices = count_turning_vertices(projected, facets);
  const FacePairs pairs = find_face_pairs(projected, facets, coincidence_steps);
  traits.penetrations = {pairs.penetrating.size(), pairs.complete};
  traits.conflicts = {pairs.overlapping.size(), pairs.complete};
  traits.height_field = is_height_field(scene, topology);
  return traits;
}

}  // namespace ligne
