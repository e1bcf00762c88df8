#include "visibility/roberts/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "base/index_lists.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "geometry/convex_hull.hpp"
#include "view/clip.hpp"
#include "visibility/common/convex_body.hpp"

namespace ligne::roberts {
namespace {

using convexity::Facing;

/// Adjustable: parts of the model in one task, and the number of facets above which a body's front gets a tree.
constexpr std::size_t kPartsPerTask = 64;
constexpr std::uint32_t kManyFacets = 16;

/// The model on the page: all triangles, also coincident ones. `outside` has, per vertex, a bit for each plane of the
/// view volume beyond which it lies; such a vertex has no place on the page.
struct PlacedModel {
  ProjectedScene page;
  std::vector<std::uint8_t> outside;
};

PlacedModel place_model(const ProjectedScene& scene) {
  PlacedModel placed;
  ProjectedScene& page = placed.page;
  page.lattice = scene.lattice;
  page.view = scene.view;
  page.input_error_mm = scene.input_error_mm;
  page.face_is_edge_on = scene.face_is_edge_on;
  const std::vector<Point3>& vertices = scene.model->vertices;
  page.vertices.resize(vertices.size());
  placed.outside.assign(vertices.size(), 0);
  const ClipVolume volume = face_volume(scene.view, scene.lattice);
  parallel_each(vertices.size(), [&](std::size_t i) {
    const HomogeneousPoint p = to_homogeneous(scene.view, vertices[i]);
    for (int plane = 0; plane < ClipVolume::kPlanes; ++plane) {
      if (volume.distance(plane, p) < 0) placed.outside[i] |= static_cast<std::uint8_t>(1 << plane);
    }
    if (!placed.outside[i]) page.vertices[i] = {page.lattice.snap({p.x / p.w, p.y / p.w}), p.z / p.w};
  });
  page.triangles = triangulate_faces(*scene.model);
  return placed;
}

DisjointSets connect(const std::vector<Triangle>& triangles) {
  struct Side {
    std::uint32_t low, high, triangle;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  DisjointSets sets(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (i > 0 && triangles[i].face == triangles[i - 1].face) sets.join(i - 1, i);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[i].v[k], b = triangles[i].v[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), i});
    }
  }
  parallel_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high; ++end) {
    }
    if (end - i == 2) sets.join(sides[i].triangle, sides[i + 1].triangle);
  }
  return sets;
}

/// The triangles of each connected part. Parts join triangles of one face, and two triangles if no third one has their
/// common side. So bodies that touch in an edge stay separate.
IndexLists find_parts(const std::vector<Triangle>& triangles) {
  DisjointSets sets = connect(triangles);
  const auto n = static_cast<std::uint32_t>(triangles.size());
  std::vector<std::uint32_t> part_of(n);
  std::uint32_t parts = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t root = sets.find(i);  // the lowest number of its set
    part_of[i] = root == i ? parts++ : part_of[root];
  }
  return numbers_by_key(parts, n, [&](std::uint32_t i) { return part_of[i]; });
}

enum class Place : std::uint8_t { in_view, out_of_view, cut };

/// The study of one part.
struct FoundPart {
  Place place = Place::in_view;
  bool is_flat = false;
  std::string unsupported;
  std::vector<LatticePoint> hull;
  std::vector<std::uint32_t> faces;    ///< faces of the model, ascending
  std::vector<std::uint8_t> is_front;  ///< per face of `faces`: 1 if it is a front face
};

Place place_of(const PlacedModel& model, std::span<const std::uint32_t> triangles) {
  std::uint8_t any = 0, all = 0xff;
  for (const std::uint32_t t : triangles) {
    for (const std::uint32_t v : model.page.triangles[t].v) {
      any |= model.outside[v];
      all &= model.outside[v];
    }
  }
  return all ? Place::out_of_view : any ? Place::cut : Place::in_view;
}

/// The part as a separate scene, with new numbers of faces and vertices.
ProjectedScene scene_of_part(const ProjectedScene& page, std::span<const std::uint32_t> triangles,
                             std::vector<std::uint32_t>& faces) {
  ProjectedScene part{.lattice = page.lattice, .view = page.view, .input_error_mm = page.input_error_mm};
  std::vector<std::uint32_t> vertices;
  vertices.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles)
    vertices.insert(vertices.end(), page.triangles[t].v.begin(), page.triangles[t].v.end());
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const std::uint32_t v : vertices) part.vertices.push_back(page.vertices[v]);
  for (const std::uint32_t t : triangles) {
    Triangle copy = page.triangles[t];
    if (faces.empty() || faces.back() != copy.face) {
      faces.push_back(copy.face);
      if (!page.face_is_edge_on.empty()) part.face_is_edge_on.push_back(page.face_is_edge_on[copy.face]);
    }
    copy.face = static_cast<std::uint32_t>(faces.size() - 1);
    for (std::uint32_t& v : copy.v) {
      v = static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    }
    part.triangles.push_back(copy);
  }
  return part;
}

/// A single face is convex if its triangles fill the hull of its corners, but for the rounding of each corner by half a
/// step.
bool is_convex_face(const ProjectedScene& face, const std::vector<LatticePoint>& hull) {
  double filled = 0;
  for (const Triangle& t : face.triangles)
    filled += std::abs(orientation(face.vertices[t.v[0]].p, face.vertices[t.v[1]].p, face.vertices[t.v[2]].p));
  const auto [area, border] = convexity::area_and_border(hull);
  return std::abs(area - filled) <= 2 * border;
}

FoundPart look_at(const PlacedModel& model, std::span<const std::uint32_t> triangles) {
  FoundPart found;
  found.place = place_of(model, triangles);
  if (found.place == Place::out_of_view) return found;
  const ProjectedScene part = scene_of_part(model.page, triangles, found.faces);
  found.is_flat = found.faces.size() == 1;
  if (found.place == Place::cut) {
    found.unsupported = "it is not entirely in view";
    return found;
  }
  std::vector<LatticePoint> points;
  for (const ProjectedVertex& v : part.vertices) points.push_back(v.p);
  found.hull = convex_hull(std::move(points));
  if (found.is_flat) {
    const bool is_seen = part.face_is_edge_on.empty() || !part.face_is_edge_on[0];
    found.is_front = {is_seen};
    if (is_seen && !is_convex_face(part, found.hull)) found.unsupported = "it is a face that is not convex";
    return found;
  }
  const convexity::Faces faces = convexity::face_the_viewer(part);
  for (const Facing facing : faces.facing) found.is_front.push_back(facing == Facing::front);
  found.unsupported = convexity::why_not_one_convex_body(part, faces);
  return found;
}

std::string object_name(const Scene& model, std::uint32_t face) {
  const auto object = std::ranges::find_if(model.objects, [&](const Object& o) { return face < o.face_end; });
  if (object == model.objects.end()) return "the scene";
  if (!object->name.empty()) return "object \"" + object->name + "\"";
  return "object " + std::to_string(object - model.objects.begin() + 1);
}

/// Adds the part as the next body, without its front.
void add_body(FoundPart& found, Bodies& bodies) {
  const auto number = static_cast<std::uint32_t>(bodies.list.size());
  for (std::size_t i = 0; i < found.faces.size(); ++i) {
    bodies.of_face[found.faces[i]] = number;
    bodies.is_front[found.faces[i]] = found.is_front[i];
  }
  Body body;
  body.hull_begin = static_cast<std::uint32_t>(bodies.hull.size());
  bodies.hull.insert(bodies.hull.end(), found.hull.begin(), found.hull.end());
  body.hull_end = static_cast<std::uint32_t>(bodies.hull.size());
  for (const LatticePoint p : found.hull) body.box.extend(p);
  bodies.flat_faces += found.is_flat;
  bodies.list.push_back(body);
}

/// Adds the facets of front faces, by body.
void add_fronts(Bodies& bodies) {
  const auto body_of = [&](const Facet& f) { return bodies.is_front[f.face] ? bodies.of_face[f.face] : kNone; };
  ListsOf<Facet> fronts(bodies.list.size(), [&](const auto& put) {
    for (const Facet& f : bodies.facets.facets) {
      if (body_of(f) != kNone) put(body_of(f), f);
    }
  });
  for (std::size_t b = 0; b < bodies.list.size(); ++b) {
    bodies.list[b].front_begin = fronts.begin[b];
    bodies.list[b].front_end = fronts.begin[b + 1];
  }
  bodies.front = std::move(fronts.values);
}

double area_of(const Bodies& bodies, std::uint32_t facet) {
  const std::uint32_t* v = bodies.front[facet].v;
  return orientation(bodies.vertices[v[0]].p, bodies.vertices[v[1]].p, bodies.vertices[v[2]].p);
}

/// Finds the planes and bounds of a body's front. The largest facet of a face gives its plane, as its plane is the most
/// accurate elsewhere. Facets are ordered by face.
void measure_front(Body& body, Bodies& bodies) {
  body.plane_begin = static_cast<std::uint32_t>(bodies.planes.size());
  body.z_far = -std::numeric_limits<float>::infinity();
  for (std::uint32_t f = body.front_begin; f < body.front_end; ++f) {
    const Facet& facet = bodies.front[f];
    body.box.z_near = std::min(body.box.z_near, facet.z_near);
    body.z_far = std::max(body.z_far, facet.z_far);
    body.tolerance = std::max(body.tolerance, facet.depth_tolerance);
    const bool goes_on = f > body.front_begin && bodies.front[f - 1].face == facet.face;
    if (!goes_on) {
      bodies.planes.push_back(f);
    } else if (area_of(bodies, f) > area_of(bodies, bodies.planes.back())) {
      bodies.planes.back() = f;
    }
  }
  body.plane_end = static_cast<std::uint32_t>(bodies.planes.size());
}

void plant_trees(Bodies& bodies) {
  std::vector<DepthBox> boxes;
  for (Body& body : bodies.list) {
    if (body.front_size() <= kManyFacets) continue;
    boxes.clear();
    for (std::uint32_t f = body.front_begin; f < body.front_end; ++f) {
      DepthBox box;
      for (const std::uint32_t v : bodies.front[f].v) box.extend(bodies.vertices[v].p);
      box.z_near = bodies.front[f].z_near;
      boxes.push_back(box);
    }
    body.root = bodies.forest.add_tree(boxes);
    body.has_tree = true;
  }
  boxes.clear();
  // A body without a front has no depth, so no line is behind it.
  for (const Body& body : bodies.list) boxes.push_back(body.box);
  bodies.root = bodies.forest.add_tree(boxes);
}

}  // namespace

Bodies find_bodies(const ProjectedScene& scene, double coincidence_steps) {
  Bodies bodies;
  PlacedModel model = place_model(scene);
  const IndexLists parts = find_parts(model.page.triangles);
  std::vector<FoundPart> found(parts.size());
  parallel_blocks(parts.size(), kPartsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) found[p] = look_at(model, parts[p]);
  });
  bodies.of_face.assign(scene.model->faces.size(), kNone);
  bodies.is_front.assign(scene.model->faces.size(), 0);
  for (FoundPart& part : found) {
    if (!part.unsupported.empty() && bodies.unsupported.empty()) {
      bodies.unsupported =
          "a part of " + object_name(*scene.model, part.faces[0]) + " is not a convex body: " + part.unsupported;
    }
    if (part.place == Place::in_view) add_body(part, bodies);
  }
  bodies.facets = make_facets(model.page, coincidence_steps);
  bodies.vertices = std::move(model.page.vertices);
  add_fronts(bodies);
  for (Body& body : bodies.list) measure_front(body, bodies);
  plant_trees(bodies);
  return bodies;
}

}  // namespace ligne::roberts
