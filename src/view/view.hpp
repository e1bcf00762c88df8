#pragma once
/// Cameras, and where the picture lies on the page.

#include <optional>
#include <string_view>

#include <glm/mat4x4.hpp>

#include "geometry/lattice.hpp"
#include "geometry/point.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// The camera that the user asked for.
struct CameraRequest {
  std::string_view named_view = "iso";  ///< used when neither direction nor eye is given
  std::optional<Point3> direction;      ///< line of sight, from the viewer into the scene: parallel projection
  std::optional<Point3> eye;            ///< perspective
  std::optional<Point3> target;         ///< default: the centre of the scene's bounding box
  double fov_degrees = 35;              ///< vertical angle of view
  std::optional<double> aspect{};       ///< perspective: width by height of the field of view; else that of a sheet
  std::optional<Point3> up;
  Axis up_axis = Axis::z;
};

/// A camera: an orthonormal frame (right, down, forward) and an eye. Camera coordinates of a point p are
/// x = right . (p - eye), y = down . (p - eye), w = forward . (p - eye).
struct Camera {
  bool perspective = false;
  Point3 eye{0, 0, 0};  ///< parallel: a point of the scene, the centre of its bounding box
  Point3 right{1, 0, 0}, down{0, -1, 0}, forward{0, 0, -1};
  double fov_degrees = 35;
  double target_distance = 1;  ///< perspective: distance of the plane on which a true scale holds
  double aspect = 1.41421356;  ///< perspective: width by height of the field of view
};

inline constexpr std::string_view kNamedViews[] = {"front",  "back", "left",     "right",    "top",
                                                   "bottom", "iso",  "dimetric", "trimetric"};

/// Throws std::invalid_argument with one line when the request has no meaning (unknown name, zero direction, eye equal to
/// target, a field of view outside (0, 180)).
/// The up vector: the one given, else the up axis. When it is parallel to the line of sight the up axis is taken instead of
/// the one given, and where that is parallel too the model's back (looking down) or front (looking up), as in the named
/// views top and bottom. The model's front is seen along +y when z is up, along -z when y is up, along +z when x is up.
Camera make_camera(const CameraRequest& request, const Scene& scene);

/// The rectangle of the page that may be drawn on, in page mm (x right, y down).
struct Frame {
  Rect area;
};

/// A camera with its place on the page. `model_to_page` maps (x, y, z, 1) to (X, Y, Z, W): the page point is
/// (X/W, Y/W) in mm and Z/W is the depth, which grows with the distance from the viewer. Planes stay planes. In parallel
/// projection W is 1 and the depth is in page mm; in perspective the depth is D - D^2/w scaled to page mm, w the distance
/// along the line of sight and D the target distance, so that it is 0 and has slope 1 at the target.
struct View {
  Camera camera;
  double scale = 1;     ///< page mm per model unit (in perspective: on the target plane)
  Point2 offset{0, 0};  ///< page mm of the camera's axis
  glm::dmat4 model_to_page{1};
  Rect window;               ///< page mm; what lies outside is clipped away
  double near_distance = 0;  ///< perspective: w of the near plane, > 0
};

/// Faces are studied so far beyond the window. More than the two steps by which a line that is drawn may lie outside (half a
/// step, and what it is rounded by); half a micrometre on A0, so that what is made of faces exceeds the window by less than
/// a drawing may be off.
inline constexpr int kWindowMarginSteps = 16;

/// The lattice of the view's page: it holds the window and the margin of faces round it.
inline Lattice page_lattice(const View& view) { return Lattice::covering(view.window, kWindowMarginSteps); }

/// A point before the division by w; see View::model_to_page.
struct HomogeneousPoint {
  double x = 0, y = 0, z = 0, w = 1;
};

/// The point through View::model_to_page, computed from its difference to the eye (which is exact where the matrix's
/// translation cancels).
HomogeneousPoint to_homogeneous(const View& view, const Point3& p);

/// Where the point is drawn, in mm; it lies before the eye.
Point2 page_point(const View& view, const Point3& p);

/// The model point that is drawn at the page point with the depth: the inverse of model_to_page.
Point3 to_model_point(const View& view, Point2 page_mm, double depth);

/// (right, down, forward) of p, see Camera.
Point3 camera_coordinates(const Camera& camera, const Point3& p);

/// Extent of the scene on the drawing plane at a scale of 1 mm per model unit, clipped to the field of view in perspective.
/// Empty when nothing is in view.
Rect projected_extent(const Scene& scene, const Camera& camera);

/// The camera as it sees the model turned about the axis through `centre`, counter-clockwise where the axis points to the
/// viewer.
Camera with_model_turned(const Camera& camera, Axis axis, const Point3& centre, double degrees);

/// The middle of the scene's bounding box; the origin without vertices.
Point3 bounding_box_centre(const Scene& scene);

/// Places the camera's picture on the page: `extent` (see projected_extent) centred on `frame`, scaled to fit it, or at
/// `scale` page mm per model unit when that is given; then what would leave `window` (the page) is clipped.
View make_view(Rect extent, const Camera& camera, const Frame& frame, const Rect& window,
               std::optional<double> scale = std::nullopt);

/// Makes the view from the extent of the scene.
View make_view(const Scene& scene, const Camera& camera, const Frame& frame, const Rect& window,
               std::optional<double> scale = std::nullopt);

}  // namespace ligne
