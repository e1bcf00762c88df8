#pragma once
/// Cameras, and the placement of their picture on the page.

#include <optional>
#include <string_view>

#include <glm/mat4x4.hpp>

#include "geometry/lattice.hpp"
#include "geometry/point.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// A request for a camera.
struct CameraRequest {
  std::string_view named_view = "iso";  ///< used when neither direction nor eye is given
  std::optional<Point3> direction{};    ///< parallel projection along this direction, from the viewer into the scene
  std::optional<Point3> eye{};          ///< perspective from this point
  std::optional<Point3> target{};       ///< default: the centre of the scene's bounding box
  double fov_degrees = 35;              ///< perspective: vertical field of view
  std::optional<double> aspect{};       ///< perspective: width by height of the field of view; nothing: that of a sheet
  std::optional<Point3> up{};
  Axis up_axis = Axis::z;
};

/// A camera: an orthonormal frame (right, down, forward) and an eye. Camera coordinates of a point p are
/// x = right . (p - eye), y = down . (p - eye), w = forward . (p - eye).
struct Camera {
  bool perspective = false;
  Point3 eye{0, 0, 0};  ///< position of the viewer; in parallel projection the centre of the scene's bounding box
  Point3 right{1, 0, 0}, down{0, -1, 0}, forward{0, 0, -1};
  double fov_degrees = 35;
  double target_distance = 1;  ///< perspective: distance of the target plane, to which the scale refers
  double aspect = 1.41421356;  ///< perspective: width of the field of view divided by its height
};

inline constexpr std::string_view kNamedViews[] = {"front",  "back", "left",     "right",    "top",
                                                   "bottom", "iso",  "dimetric", "trimetric"};

/// Makes the camera. Throws std::invalid_argument with a message of one line if the request is invalid: unknown name,
/// zero direction, eye equal to target, or a field of view outside (0, 180).
///
/// The up vector is the requested one, or else the up axis. If the requested one is parallel to the line of sight, the
/// up axis is used. If that is parallel too, up is the direction to the back of the model (looking down) or to its
/// front (looking up), as in the named views top and bottom. The front view looks along +y if z is up, along -z if y is
/// up, along +z if x is up.
/// `centre`: see bounding_box_centre().
Camera make_camera(const CameraRequest& request, const Point3& centre);

/// Makes the camera for the centre of the scene.
Camera make_camera(const CameraRequest& request, const Scene& scene);

/// The rectangle of the page that may be drawn on, in page mm (x right, y down).
struct Frame {
  Rect area;
};

/// A camera with its placement on the page. `model_to_page` maps (x, y, z, 1) to (X, Y, Z, W): the page point is (X/W,
/// Y/W) in mm, and Z/W is the depth, which grows with the distance from the viewer. Planes are mapped to planes. In
/// parallel projection W is 1 and the depth is in page mm. In perspective the depth is D - D^2/w scaled to page mm,
/// where w is the distance along the line of sight and D the target distance: it is 0 and has slope 1 at the target.
struct View {
  Camera camera{};
  double scale = 1;     ///< page mm per model unit (in perspective: on the target plane)
  Point2 offset{0, 0};  ///< page mm: point at which the camera's axis meets the page
  glm::dmat4 model_to_page{1};
  Rect window{};             ///< page mm; everything outside is clipped away
  double near_distance = 0;  ///< perspective: w of the near plane, > 0
};

/// Margin around the window, in lattice steps, within which faces are kept. It exceeds the two steps by which a drawn
/// line may lie outside (half a step, plus its rounding). It is half a micrometre on A0, so areas made from faces
/// exceed the window by less than the accuracy of a drawing.
inline constexpr int kWindowMarginSteps = 16;

/// The page lattice of a view: it covers the window and the margin of faces around it.
inline Lattice page_lattice(const View& view) { return Lattice::covering(view.window, kWindowMarginSteps); }

/// A point before the division by w; see View::model_to_page.
struct HomogeneousPoint {
  double x = 0, y = 0, z = 0, w = 1;
};

/// Maps a point by View::model_to_page. It is computed from the difference to the eye, so it is accurate where the
/// translation of the matrix would cancel.
HomogeneousPoint to_homogeneous(const View& view, const Point3& p);

/// The page point of p, mm. p must lie in front of the eye.
Point2 page_point(const View& view, const Point3& p);

/// The model point with this page point and depth: the inverse of model_to_page.
Point3 to_model_point(const View& view, Point2 page_mm, double depth);

/// The camera coordinates (x, y, w) of p, see Camera.
Point3 camera_coordinates(const Camera& camera, const Point3& p);

/// Bounding rectangle of the picture of the scene at a scale of 1 mm per model unit, in perspective clipped to the
/// field of view. Empty if nothing is in view.
Rect projected_extent(const Scene& scene, const Camera& camera);

/// The camera whose picture shows the model rotated about the axis through `centre`, counter-clockwise as seen with
/// the axis pointing at the viewer.
Camera with_model_turned(const Camera& camera, Axis axis, const Point3& centre, double degrees);

/// Places the camera's picture on the page: centres `extent` (see projected_extent) on `frame`, at `scale` page mm per
/// model unit or, without it, scaled to fit. Lines outside `window` (the page) will be clipped.
View make_view(Rect extent, const Camera& camera, const Frame& frame, const Rect& window,
               std::optional<double> scale = std::nullopt);

/// Makes the view from the extent of the scene.
View make_view(const Scene& scene, const Camera& camera, const Frame& frame, const Rect& window,
               std::optional<double> scale = std::nullopt);

}  // namespace ligne
