#pragma once
/// The shortest way from a scene to its strokes.

#include "drawing/drawing.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "scene/model/topology.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {

inline LineClasses classes(const std::string& names) {
  LineClasses c;
  for (std::size_t i = 0; i < kLineClassCount; ++i) {
    if (names == "all" || (names == "feature" && i < 4) || names.find(kLineClassNames[i]) != std::string::npos)
      c.add(static_cast<LineClass>(i));
  }
  return c;
}

struct Picture {
  ProjectedScene projected;
  StrokeModel model;  ///< every line once

  /// Page length in mm of the strokes of that visibility.
  double length(bool visible = true) const {
    return length_if([=](const Stroke& s) { return s.visible == visible; });
  }
  double length_of(LineClass c) const {
    return length_if([=](const Stroke& s) { return s.visible && s.line_class == c; });
  }
  template <class Counts>
  double length_if(const Counts& counts) const {
    double sum = 0;
    for (const Stroke& s : model.strokes)
      if (counts(s)) sum += glm::length(model.lattice.to_mm(s.to) - model.lattice.to_mm(s.from));
    return sum;
  }
};

struct PictureRequest {
  CameraRequest camera{};
  std::string edges = "feature";
  bool hidden = false;
  double scale = 0;  ///< page mm by unit; 0: fit
  std::string method = "auto";
};

inline constexpr double kPageWidth = 297, kPageHeight = 210;

/// The view on an A4 sheet in landscape with a margin of 10 mm, as large as it fits, unless a scale is given.
inline View view_on_a4(const Scene& scene, const CameraRequest& camera, std::optional<double> scale = {}) {
  return make_view(scene, make_camera(camera, scene), {{{10, 10}, {kPageWidth - 10, kPageHeight - 10}}},
                   {{0, 0}, {kPageWidth, kPageHeight}}, scale);
}

/// The scene that the methods study, with its faces and edges projected onto that sheet.
inline ProjectedScene project_on_a4(const Scene& scene, const CameraRequest& camera, const std::string& edges = "all",
                                    std::optional<double> scale = {}) {
  return project(scene, build_topology(scene), view_on_a4(scene, camera, scale), {classes(edges), 30});
}

/// The picture on that sheet, the scene's centre in the middle.
inline Picture draw(const Scene& scene, const PictureRequest& request) {
  const auto scale = request.scale > 0 ? std::optional(request.scale) : std::nullopt;
  Picture picture{project_on_a4(scene, request.camera, request.edges, scale), {}};
  VisibilityOptions options;
  options.hidden_strokes = request.hidden;
  picture.model = *find_method(request.method)->compute_visibility(picture.projected, options).strokes;
  remove_coincident_strokes(picture.model, coincidence_mm(picture.projected));
  return picture;
}

/// The count of the method under that name; 0 when it knows no such count.
inline std::uint64_t count_of(const Statistics& statistics, std::string_view name) {
  for (const auto& [known, count] : statistics.counts)
    if (known == name) return count;
  return 0;
}

/// All that a study found but for the debug layer, member by member: padding has no value.
inline std::string bytes_of(const VisibilityResult& result) {
  std::string bytes;
  const auto add = [&](const auto&... values) { (bytes.append(raw(values)), ...); };
  const auto add_contours = [&](const std::vector<std::vector<Point2>>& contours) {
    for (const auto& contour : contours) {
      add(contour.size());
      for (const Point2 p : contour) add(p.x, p.y);
    }
  };
  if (result.strokes) {
    for (const Stroke& s : result.strokes->strokes)
      add(s.t_from, s.t_to, s.from.x, s.from.y, s.to.x, s.to.y, s.z_from, s.z_to, s.w_from, s.w_to, s.source, s.line_class,
          s.visible, s.needs_overlap_check, s.level);
    for (const SourceEdge& e : result.strokes->intersections) add(e.faces[0], e.faces[1], e.intersection);
  }
  for (const Region& r : result.regions ? *result.regions : std::vector<Region>{}) {
    add(r.face, r.level);
    add_contours(r.contours);
  }
  for (const PaintPiece& p : result.order ? result.order->pieces : std::vector<PaintPiece>{}) {
    add(p.face, p.plane[0], p.plane[1], p.plane[2]);
    add_contours(p.contours);
  }
  for (const Span& s : result.spans ? result.spans->spans : std::vector<Span>{}) add(s.line, s.x_from, s.x_to, s.face);
  if (result.pixels)
    for (const std::uint32_t face : result.pixels->face) add(face);
  return bytes + result.unsupported_reason + result.left_out;
}

/// Boxes turned at random, their corners in a cube that reaches from -`spread` to `spread` before they are turned.
inline Scene random_boxes(int count, unsigned seed, double spread, const Point3& size) {
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < count; ++i)
    add_box(scene, Point3{u(random), u(random), u(random)} * spread, size,
            rotation(u(random) * 3, u(random) * 3, u(random) * 3));
  return scene;
}

/// Calls visit(triangle, depth, least) for the triangles that are not edge on, with the depth of their planes at a point of
/// the lattice and the least of its three barycentric weights there: negative when the point lies outside.
template <class Visit>
void for_triangles_at(const ProjectedScene& scene, Point2 p, const Visit& visit) {
  for (const Triangle& t : scene.triangles) {
    const ProjectedVertex* v[3] = {&scene.vertices[t.v[0]], &scene.vertices[t.v[1]], &scene.vertices[t.v[2]]};
    const double area = orientation(v[0]->p, v[1]->p, v[2]->p);
    if (area == 0) continue;
    double z = 0, least = 1;
    for (int k = 0; k < 3; ++k) {
      const LatticePoint a = v[(k + 1) % 3]->p, b = v[(k + 2) % 3]->p;
      const double weight = ((double(b.x) - a.x) * (p.y - a.y) - (double(b.y) - a.y) * (p.x - a.x)) / area;
      least = std::min(least, weight);
      z += weight * v[k]->z;
    }
    visit(t, z, least);
  }
}

/// Names of tests have no hyphens.
inline std::string as_test_name(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

inline CameraRequest along(const Point3& direction) {
  CameraRequest r;
  r.direction = direction;
  return r;
}

inline CameraRequest from_eye(const Point3& eye, const Point3& target, double fov = 35) {
  CameraRequest r;
  r.eye = eye;
  r.target = target;
  r.fov_degrees = fov;
  return r;
}

}  // namespace ligne::test
