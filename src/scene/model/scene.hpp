#pragma once
/// The scene model: objects made of polygon faces with holes, materials, lights, cameras, details.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/polygon_faces.hpp"
#include "scene/model/stated_facts.hpp"

namespace ligne {

struct Material {
  std::string name{};
  Point3 color{0.8, 0.8, 0.8};  ///< red, green, blue in [0, 1]
  double opacity = 1;           ///< 0 transparent, 1 opaque
};

struct Light {
  enum class Kind : std::uint8_t { parallel, point };
  Kind kind = Kind::parallel;
  Point3 vector{0, 0, -1};  ///< parallel: direction in which the light travels, of any length; point: its position
};

/// A camera that the model file defines.
struct SceneCamera {
  std::string name{};
  Point3 eye{0, 0, 0};
  Point3 forward{0, 0, -1};        ///< viewing direction, of any length
  std::optional<Point3> up{};      ///< nothing: Scene::up_axis
  bool perspective = true;         ///< false: parallel projection along `forward`
  double fov_degrees = 35;         ///< vertical field of view, degrees
  std::optional<double> aspect{};  ///< width of the field of view divided by its height
};

/// A patch of another material on a face, such as a window on a wall.
struct Detail {
  std::uint32_t face = 0;       ///< index of the face
  std::uint32_t material = 0;   ///< index of the material
  std::vector<Point3> contour;  ///< model coordinates
};

/// A separate body. An edge joins faces of one object only, so two solids that touch keep their own edges. An object
/// owns a contiguous range of the vertices of the scene and a contiguous range of its faces.
struct Object {
  std::string name{};
  std::uint32_t vertex_begin = 0, vertex_end = 0;  ///< vertices [vertex_begin, vertex_end)
  std::uint32_t face_begin = 0, face_end = 0;      ///< faces [face_begin, face_end)
  /// Largest error of a coordinate as stored, in model units: half a unit in the last place of the file's number format
  /// at the object's largest coordinate (float32, double, or decimal digits), carried through the node transforms.
  double precision = 0;
};

enum class Axis : std::uint8_t { x, y, z };

/// Flags of a corner. They describe the edge from this corner to the next corner of its contour. "Class" is the
/// LineClass that the edge gets.
enum CornerFlag : std::uint8_t {
  kCornerFileHidden = 1,  ///< the file marks this edge as hidden (3D Studio: AB, BC or CA is 0): class mesh
  kCornerInner = 2,       ///< triangulation of a polygon made this edge: class mesh, never a crease
  kCornerCurve = 4,       ///< part of an iso-curve: class horizon, regardless of its faces
  kCornerCrossing = 8,    ///< surfaces penetrate each other along this edge: class intersection
  kCornerContour = 16,    ///< part of a contour line: class contour, regardless of its faces
  kCornerSmooth = 32,     ///< the file says that the surface is smooth across this edge; read for clear lines
  kCornerSharp = 64,      ///< the file says that it has a crease at this edge; read for clear lines
  kCornerLimit = 128,     ///< inside a limit surface of subdivision, which is smooth across this edge whatever it bends by
};

/// A scene. Indices refer to the arrays of this struct. After finish_scene() (scene/clean/clean.hpp) the vertices of an
/// object have distinct positions, and every face is planar and has at least three distinct corners.
struct Scene {
  std::vector<Point3> vertices;  ///< model coordinates in model units
  PolygonFaces faces;
  std::vector<std::uint32_t> face_material;  ///< per face; empty if every face has material 0
  std::vector<std::uint8_t> corner_flags;    ///< per corner: CornerFlag bits; empty if no corner has any
  /// Per face: index of the face of the input file that it came from, since repair drops, cuts and joins faces. Empty
  /// unless the caller needs it.
  std::vector<std::uint32_t> face_source{};
  std::vector<Object> objects;
  std::vector<Material> materials;
  std::vector<Light> lights;
  std::vector<SceneCamera> cameras;
  std::vector<Detail> details;
  Axis up_axis = Axis::z;
  double unit_mm = 1;    ///< true length of one model unit in mm, if the format defines it: 1000 in glTF (metres)
  StatedFacts stated{};  ///< facts that spare tests; find_false_fact() checks them
};

}  // namespace ligne
