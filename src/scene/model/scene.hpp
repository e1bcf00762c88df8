#pragma once
/// The description model: objects made of polygon faces with holes, materials, lights, details.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/polygon_faces.hpp"

namespace ligne {

struct Material {
  std::string name;
  Point3 color{0.8, 0.8, 0.8};  ///< red, green, blue in [0, 1]
  double opacity = 1;           ///< 0 transparent, 1 opaque
};

struct Light {
  enum class Kind : std::uint8_t { parallel, point };
  Kind kind = Kind::parallel;
  Point3 vector{0, 0, -1};  ///< parallel: direction in which the light travels; point: position
};

/// A camera of the file. Angles in degrees.
struct SceneCamera {
  std::string name;
  Point3 eye{0, 0, 0};
  Point3 forward{0, 0, -1};        ///< line of sight, of any length
  std::optional<Point3> up{};      ///< without it, the up axis
  bool perspective = true;         ///< else a parallel projection along the line of sight
  double fov_degrees = 35;         ///< vertical angle of view
  std::optional<double> aspect{};  ///< of the field of view: width by height
};

/// A contour of another colour that lies on a face.
struct Detail {
  std::uint32_t face = 0;
  std::uint32_t material = 0;
  std::vector<Point3> contour;
};

/// A thing of its own: edges join faces of one object only, so that two solids that touch keep their own edges.
/// An object owns a contiguous range of the scene's vertices and of its faces.
struct Object {
  std::string name;
  std::uint32_t vertex_begin = 0, vertex_end = 0;
  std::uint32_t face_begin = 0, face_end = 0;
  /// Largest error of a coordinate as stored, in model units: half a unit in the last place of the file's number format at
  /// the object's largest coordinate (float32, double, or decimal digits), carried through the node transforms.
  double precision = 0;
};

enum class Axis : std::uint8_t { x, y, z };

/// Per-corner flags: they speak of the edge from this corner to the next one of its contour.
enum CornerFlag : std::uint8_t {
  kCornerFileHidden = 1,  ///< the file marks this edge as not to be drawn (3D Studio AB BC CA = 0): class mesh
  kCornerInner = 2,       ///< cut inside a polygon by triangulation: class mesh, never a crease
  kCornerCurve = 4,       ///< part of an iso-curve: class horizon, whatever its faces
  kCornerCrossing = 8,    ///< surfaces pass through each other along this edge: class intersection
  kCornerContour = 16,    ///< part of a contour line: class contour, whatever its faces
  kCornerSmooth = 32,     ///< clear lines: the file says that the surface runs smoothly over this edge
  kCornerSharp = 64,      ///< clear lines: the file says that it does not
};

/// A scene. Indices are into the arrays here. After finish_scene() (scene/clean.hpp) vertices of an object are distinct in
/// position, every face is planar and has three or more distinct corners.
struct Scene {
  std::vector<Point3> vertices;  ///< model coordinates, model units
  PolygonFaces faces;
  std::vector<std::uint32_t> face_material;  ///< per face, or empty when every face has material 0
  std::vector<std::uint8_t> corner_flags;    ///< CornerFlag per corner, or empty when no corner has any
  /// Per face, that of the input from which it is: mending drops, cuts and joins faces. Empty when nobody asks.
  std::vector<std::uint32_t> face_source{};
  std::vector<Object> objects;
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<SceneCamera> cameras;
  std::vector<Detail> details;
  Axis up_axis = Axis::z;
  double unit_mm = 1;  ///< true length of one model unit, where the format says it: glTF counts in metres
};

}  // namespace ligne
