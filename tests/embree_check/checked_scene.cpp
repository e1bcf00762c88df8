#include "checked_scene.hpp"

namespace ligne::check {

namespace {

/// Error of the transforms into the unit box and onto the page: a few roundings of numbers as large as the box and its
/// centre.
constexpr double kRounding = 0x1p-50;
/// A Newell sum this small against the square of the face's extent is rounding: the face has no area.
constexpr double kNoArea = 0x1p-46;
/// A face is taken as seen edge on when an error of its coordinates of this many tolerances can turn it so, ...
constexpr double kEdgeOnTolerances = 8;
/// ... or when its sine with the sight is below that of a face as long as an A4 sheet and 3 micrometres wide on the page.
constexpr double kEdgeOnSine = 1e-5;
/// Programs may differ on the crease angle by this much, float32 normals and rounding slack included.
constexpr double kCreaseSlackDegrees = 0.05;
constexpr double kDegrees = 180 / 3.14159265358979323846;

UnitBox unit_box(const Scene& scene) {
  if (scene.vertices.empty()) return {};
  Point3 low = scene.vertices[0], high = low;
  for (const Point3& v : scene.vertices) low = glm::min(low, v), high = glm::max(high, v);
  const Point3 size = high - low;
  const double longest = std::max({size.x, size.y, size.z});
  return {low + size * 0.5, longest > 0 ? longest : 1};
}

void weld_object(const Scene& scene, const Object& object, std::vector<std::uint32_t>& weld) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) order.push_back(v);
  const auto key = [&](std::uint32_t v) {
    const Point3& p = scene.vertices[v];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    weld[order[i]] = same ? weld[order[i - 1]] : order[i];
  }
}

CheckedFace make_face(const CheckedScene& scene, std::size_t f, double tolerance) {
  CheckedFace face;
  face.tolerance = tolerance;
  const auto outer = scene.contours->contour(f, 0);
  Point3 newell{0, 0, 0};
  double longest = 0;
  const Point3 origin = scene.points[outer[0]];
  for (std::size_t k = 0; k < outer.size(); ++k) {
    const Point3 a = scene.points[outer[k]] - origin, b = scene.points[outer[(k + 1) % outer.size()]] - origin;
    newell += glm::cross(a, b);
    face.middle += a / static_cast<double>(outer.size());
    longest = std::max(longest, glm::length(b - a));
  }
  face.middle += origin;
  const double area = glm::length(newell);
  if (area <= kNoArea * longest * longest) return face;
  face.normal = newell / area;
  face.height = area / longest;
  return face;
}

void find_edges(const Scene& scene, const std::vector<double>& tolerances, CheckedScene& out) {
  struct Side {
    std::uint32_t v0, v1, face;
    bool forward;
    std::uint8_t flags;
    auto key() const { return std::pair(v0, v1); }
  };
  std::vector<Side> sides;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f)
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      const std::size_t first = scene.faces.corner_index(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const std::uint32_t a = out.weld[contour[k]], b = out.weld[contour[(k + 1) % contour.size()]];
        if (a == b) continue;
        const std::uint8_t flags = scene.corner_flags.empty() ? std::uint8_t{0} : scene.corner_flags[first + k];
        sides.push_back({std::min(a, b), std::max(a, b), f, a < b, flags});
      }
    }
  std::sort(sides.begin(), sides.end(), [](const Side& l, const Side& r) {
    return std::tuple(l.v0, l.v1, l.face, l.forward) < std::tuple(r.v0, r.v1, r.face, r.forward);
  });
  for (std::size_t i = 0; i < sides.size();) {
    CheckedEdge edge;
    edge.v0 = sides[i].v0, edge.v1 = sides[i].v1;
    edge.file_hidden = true;
    std::size_t end = i;
    for (; end < sides.size() && sides[end].key() == sides[i].key(); ++end) {
      edge.faces.push_back(sides[end].face);
      edge.inner = edge.inner || (sides[end].flags & kCornerInner) != 0;
      edge.file_hidden = edge.file_hidden && (sides[end].flags & kCornerFileHidden) != 0;
      edge.tolerance = std::max(edge.tolerance, tolerances[sides[end].face]);
    }
    edge.same_way = end == i + 2 && sides[i].forward == sides[i + 1].forward;
    out.edges.push_back(std::move(edge));
    i = end;
  }
}

/// Which way a face looks: +1 to the viewer, -1 away, 0 when it may be seen edge on.
int facing(const CheckedFace& face, const Point3& q, const PageMap& map) {
  const double sine = glm::dot(face.normal, map.to_viewer(q).direction);
  const double doubt = kEdgeOnSine + kEdgeOnTolerances * face.tolerance / face.height;
  return sine > doubt ? 1 : sine < -doubt ? -1 : 0;
}

std::uint8_t fold_kinds(const CheckedFace& a, const CheckedFace& b, int turn, const CheckedEdge& edge,
                        double crease_degrees) {
  const Point3 other = b.normal * static_cast<double>(turn);
  const double angle = std::atan2(glm::length(glm::cross(a.normal, other)), glm::dot(a.normal, other)) * kDegrees;
  const double doubt = kCreaseSlackDegrees + kDegrees * (a.tolerance / a.height + b.tolerance / b.height);
  std::uint8_t kinds = 0;
  if (angle > crease_degrees - doubt) kinds |= kCrease;
  if (angle < crease_degrees + doubt) kinds |= kMesh;
  if (edge.file_hidden || edge.inner) kinds |= kMesh;
  if (edge.inner) kinds &= static_cast<std::uint8_t>(~kCrease);
  return kinds;
}

}  // namespace

CheckedScene make_checked_scene(const Scene& scene) {
  CheckedScene out;
  out.box = unit_box(scene);
  out.contours = &scene.faces;
  out.points.reserve(scene.vertices.size());
  out.weld.resize(scene.vertices.size());
  double reach = 1;  // largest coordinate, in unit boxes
  for (const Point3& p : scene.vertices) {
    out.points.push_back(out.box.into(p));
    reach = std::max(reach, glm::length(p) / out.box.size);
  }
  std::vector<double> tolerances(scene.faces.size(), kRounding * reach);
  for (const Object& object : scene.objects) {
    weld_object(scene, object, out.weld);
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f)
      tolerances[f] = std::max(tolerances[f], object.precision / out.box.size);
  }
  out.faces.reserve(scene.faces.size());
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    out.faces.push_back(make_face(out, f, tolerances[f]));
    out.largest_tolerance = std::max(out.largest_tolerance, tolerances[f]);
  }
  find_edges(scene, tolerances, out);
  return out;
}

std::uint8_t possible_kinds(const CheckedScene& scene, const CheckedEdge& edge, const PageMap& map, double crease_degrees) {
  if (edge.faces.size() == 1) return kBorder;
  if (edge.faces.size() > 2) return edge.inner || edge.file_hidden ? kCrease | kMesh : kCrease;
  const CheckedFace &a = scene.faces[edge.faces[0]], &b = scene.faces[edge.faces[1]];
  if (a.height == 0 || b.height == 0) return kOutline | kCrease | kMesh;
  const int turn = edge.same_way ? -1 : 1;
  const Point3& q = scene.points[edge.v0];
  const int facing_a = facing(a, q, map), facing_b = turn * facing(b, q, map);
  const std::uint8_t fold = fold_kinds(a, b, turn, edge, crease_degrees);
  if (facing_a == 0 || facing_b == 0) return kOutline | fold;
  if (facing_a == facing_b) return fold;
  return edge.inner ? kOutline | kMesh : kOutline;
}

}  // namespace ligne::check
