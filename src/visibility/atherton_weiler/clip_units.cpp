#include "visibility/atherton_weiler/clip_units.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "visibility/polygons/clip_part.hpp"

namespace ligne::atherton_weiler {
namespace {

class UnitMaker {
 public:
  UnitMaker(const ProjectedScene& scene, const std::vector<Facet>& facets) : scene_(scene), facets_(facets) {}

  /// The union of the facets. Contours that are convex are marked.
  std::vector<ContourFace> outline(const std::vector<std::uint32_t>& facets) const {
    std::vector<ContourFace> faces;
    faces.reserve(facets.size());
    for (const std::uint32_t f : facets) faces.push_back(whole_facet(facets_, scene_.vertices, f).face());
    if (faces.size() == 1) return faces;
    std::vector<ContourFace> outline = clip_contour_by_contour(faces, {}).outside;
    for (ContourFace& face : outline) face.is_convex = is_convex(face);
    return outline;
  }

  ClipUnit unit_of(std::vector<UnitFace> faces, std::vector<ContourFace> outline) const {
    ClipUnit unit{.z_near = 1e300, .z_far = -1e300};
    for (const UnitFace& face : faces) {
      for (const std::uint32_t f : face.facets) {
        const Facet& facet = facets_[f];
        unit.z_near = std::min(unit.z_near, double(facet.z_near) - facet.depth_tolerance);
        unit.z_far = std::max(unit.z_far, double(facet.z_far) + facet.depth_tolerance);
      }
    }
    unit.transparent = !scene_.face_is_transparent.empty() && scene_.face_is_transparent[faces[0].face] != 0;
    unit.box = box_of(outline);
    unit.body = faces.size() > 1;
    unit.faces = std::move(faces);
    unit.outline = std::move(outline);
    return unit;
  }

 private:
  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
};

enum class Side : std::uint8_t { front, back, neither };

/// The side of the facet's plane that has the vertices: behind it (a front face), in front of it, or both.
Side side_of(const ProjectedScene& scene, const Facet& f, const std::vector<std::uint32_t>& vertices) {
  const ProjectedVertex &a = scene.vertices[f.v[0]], &b = scene.vertices[f.v[1]], &c = scene.vertices[f.v[2]];
  const double area = orientation(a.p, b.p, c.p);
  bool before = false, behind = false;
  for (const std::uint32_t v : vertices) {
    const ProjectedVertex& p = scene.vertices[v];
    const double plane_z =
        (orientation(b.p, c.p, p.p) * a.z + orientation(c.p, a.p, p.p) * b.z + orientation(a.p, b.p, p.p) * c.z) / area;
    before |= p.z < plane_z - f.depth_tolerance;
    behind |= p.z > plane_z + f.depth_tolerance;
  }
  return before && behind ? Side::neither : before ? Side::back : Side::front;
}

/// A closed body of opaque faces, connected by vertices: its vertices and facets.
struct Body {
  std::vector<std::uint32_t> vertices, facets;
};

std::vector<Body> closed_bodies(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  constexpr std::uint32_t kOpen = 0xffffffffu;
  DisjointSets groups(scene.vertices.size());
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (const Triangle& t : scene.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = t.v[k], w = t.v[(k + 1) % 3];
      groups.join(v, w);
      sides.push_back({std::min(v, w), std::max(v, w)});
    }
  }
  std::ranges::sort(sides);
  std::vector<std::uint32_t> number(scene.vertices.size(), 0);  // of its body, at the root of each group
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if (end - i != 2) number[groups.find(sides[i][0])] = kOpen;
    i = end;
  }
  if (!scene.face_is_transparent.empty()) {
    for (const Triangle& t : scene.triangles) {
      if (scene.face_is_transparent[t.face]) number[groups.find(t.v[0])] = kOpen;
    }
  }
  std::vector<Body> bodies;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    std::uint32_t& n = number[groups.find(facets[f].v[0])];
    if (n == kOpen) continue;
    if (n == 0) {
      bodies.emplace_back();
      n = static_cast<std::uint32_t>(bodies.size());
    }
    bodies[n - 1].facets.push_back(f);
  }
  for (std::uint32_t v = 0; v < scene.vertices.size(); ++v) {
    const std::uint32_t n = number[groups.find(v)];
    if (n != kOpen && n != 0) bodies[n - 1].vertices.push_back(v);
  }
  return bodies;
}

double area_of(const std::vector<ContourFace>& faces) { return twice_area(faces); }

/// The facets of a list grouped by face.
std::vector<UnitFace> by_face(const std::vector<Facet>& facets, const std::vector<std::uint32_t>& list,
                              const UnitMaker& maker) {
  std::vector<std::uint32_t> sorted = list;
  std::ranges::stable_sort(sorted, [&](std::uint32_t a, std::uint32_t b) { return facets[a].face < facets[b].face; });
  std::vector<UnitFace> faces;
  for (const std::uint32_t f : sorted) {
    if (faces.empty() || faces.back().face != facets[f].face) faces.push_back({facets[f].face, {}, {}});
    faces.back().facets.push_back(f);
  }
  for (UnitFace& face : faces) face.outline = maker.outline(face.facets);
  return faces;
}

/// The body as one unit, if it is also convex on the page.
std::optional<ClipUnit> silhouette(const ProjectedScene& scene, const std::vector<Facet>& facets, const Body& body,
                                   const UnitMaker& maker) {
  std::vector<std::uint32_t> front, back;
  for (const std::uint32_t f : body.facets) {
    const Side side = side_of(scene, facets[f], body.vertices);
    if (side == Side::neither) return std::nullopt;
    (side == Side::front ? front : back).push_back(f);
  }
  if (front.empty()) return std::nullopt;
  std::vector<UnitFace> faces = by_face(facets, front, maker);
  if (faces.size() < 2) return std::nullopt;
  std::vector<ContourFace> outline = maker.outline(front);
  double sum = 0;
  for (const UnitFace& face : faces) sum += area_of(face.outline);
  if (sum != area_of(outline)) return std::nullopt;
  if (!back.empty() && !clip_contour_by_contour(maker.outline(back), outline).outside.empty()) return std::nullopt;
  return maker.unit_of(std::move(faces), std::move(outline));
}

}  // namespace

PageBox box_of(const std::vector<ContourFace>& faces) {
  constexpr double kPart = 1.0 / (1 << kFineBits);
  PageBox box;
  for (const ContourFace& face : faces) {
    for (const ContourEdge& e : face.contours[0]) {
      const FinePoint p = e.begin();
      const double x = static_cast<double>(p.x) * kPart, y = static_cast<double>(p.y) * kPart;
      box.extend({x, y, x, y});
    }
  }
  return box;
}

PageBox box_of(const Facet& facet, const std::vector<ProjectedVertex>& vertices) {
  PageBox box;
  for (const std::uint32_t v : facet.v) {
    const LatticePoint p = vertices[v].p;
    box.extend({double(p.x), double(p.y), double(p.x), double(p.y)});
  }
  return box;
}

std::vector<ClipUnit> clip_units(const ProjectedScene& scene, const std::vector<Facet>& facets, bool silhouettes) {
  const UnitMaker maker(scene, facets);
  std::vector<std::pair<std::uint32_t, ClipUnit>> units;  // each with its lowest facet
  std::vector<std::uint8_t> taken(facets.size(), 0);
  if (silhouettes) {
    for (const Body& body : closed_bodies(scene, facets)) {
      std::optional<ClipUnit> unit = silhouette(scene, facets, body, maker);
      if (!unit) continue;
      for (const std::uint32_t f : body.facets) taken[f] = 1;
      units.emplace_back(body.facets.front(), std::move(*unit));
    }
  }
  std::vector<std::uint32_t> rest;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    if (!taken[f]) rest.push_back(f);
  }
  for (UnitFace& face : by_face(facets, rest, maker)) {
    std::vector<ContourFace> outline = face.outline;
    const std::uint32_t first = face.facets.front();
    std::vector<UnitFace> one;
    one.push_back(std::move(face));
    units.emplace_back(first, maker.unit_of(std::move(one), std::move(outline)));
  }
  std::ranges::sort(units, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ClipUnit> result;
  result.reserve(units.size());
  for (auto& [first, unit] : units) result.push_back(std::move(unit));
  return result;
}

void PolygonClip::divide_general(std::span<const ContourFace> subject, std::span<const ContourFace> clip) {
  ++counts_.general_clips;
  ClipResult parts = clip_contour_by_contour(subject, clip, true, &counts_.signs);
  for (std::vector<ContourFace>* faces : {&parts.inside, &parts.outside}) {
    std::vector<ContourFace>& all = faces == &parts.inside ? inside_ : outside_;
    for (ContourFace& face : *faces) {
      face.is_convex = kind_ == ClipKind::convex && is_convex(face);
      all.push_back(std::move(face));
    }
  }
}

void PolygonClip::divide_convex(const ContourFace& subject, const ContourFace& clip) {
  ++counts_.convex_pairs;
  switch (convex_.meet(subject.contours[0], clip.contours[0])) {
    case ConvexMeeting::apart:
      ++counts_.convex_apart;
      untouched_.push_back(&subject);
      return;
    case ConvexMeeting::within:
      ++counts_.convex_within;
      inside_.push_back(subject);
      return;
    case ConvexMeeting::thin:
      rest_.push_back(subject);
      return;
    case ConvexMeeting::cut:
      break;
  }
  ContourFace& inside = inside_.emplace_back();
  inside.contours.push_back(convex_.inside());
  inside.is_convex = true;
  for (ContourFace& face : convex_.outside()) {
    ++counts_.parts_outside;
    counts_.convex_outside += face.is_convex;
    outside_.push_back(std::move(face));
  }
}

bool PolygonClip::divide(std::span<const ContourFace> subject, std::span<const ContourFace> clip) {
  inside_.clear();
  outside_.clear();
  untouched_.clear();
  if (kind_ == ClipKind::general || clip.size() != 1 || !clip[0].is_convex) {
    divide_general(subject, clip);
    return !inside_.empty();
  }
  rest_.clear();
  const std::uint64_t signs = convex_.signs();
  for (const ContourFace& face : subject) {
    if (face.is_convex) {
      divide_convex(face, clip[0]);
    } else {
      rest_.push_back(face);
    }
  }
  counts_.signs += convex_.signs() - signs;
  if (!rest_.empty()) divide_general(rest_, clip);
  return !inside_.empty();
}

std::vector<ContourFace> PolygonClip::take_outside() {
  for (const ContourFace* face : untouched_) outside_.push_back(*face);
  return std::move(outside_);
}

}  // namespace ligne::atherton_weiler
