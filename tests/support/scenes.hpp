#pragma once
/// The shortest way from a scene to its strokes.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "drawing/drawing.hpp"
#include "scene/model/topology.hpp"
#include "support/scene_parts.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {

inline LineClasses classes(const std::string& names) {
  LineClasses c;
  for (std::size_t i = 0; i < kLineClassCount; ++i) {
    if (names == "all" || (names == "feature" && i < 4) || names.find(kLineClassNames[i]) != std::string::npos) {
      c.add(static_cast<LineClass>(i));
    }
  }
  return c;
}

struct Picture {
  ProjectedScene projected;
  StrokeModel model;  ///< every line once

  /// Page length in mm of the strokes of that visibility.
  double length(bool visible = true) const {
    double sum = 0;
    for (const Stroke& s : model.strokes) {
      if (s.visible == visible) sum += glm::length(model.lattice.to_mm(s.to) - model.lattice.to_mm(s.from));
    }
    return sum;
  }
  double length_of(LineClass c) const {
    double sum = 0;
    for (const Stroke& s : model.strokes) {
      if (s.visible && s.line_class == c) sum += glm::length(model.lattice.to_mm(s.to) - model.lattice.to_mm(s.from));
    }
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

/// The picture on an A4 sheet in landscape, the scene's centre in the middle.
inline Picture draw(const Scene& scene, const PictureRequest& request) {
  const Topology topology = build_topology(scene);
  const Camera camera = make_camera(request.camera, scene);
  const View view =
      make_view(scene, camera, {{{10, 10}, {kPageWidth - 10, kPageHeight - 10}}}, {{0, 0}, {kPageWidth, kPageHeight}},
                request.scale > 0 ? std::optional(request.scale) : std::nullopt);
  Picture picture{project(scene, topology, view, {classes(request.edges), 30}), {}};
  StudyOptions options;
  options.hidden_strokes = request.hidden;
  picture.model = *find_method(request.method)->study(picture.projected, options).strokes;
  remove_coincident_strokes(picture.model, coincidence_mm(picture.projected));
  return picture;
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
