#pragma once
/// The scene in the unit box, with edges of its own making.

#include "page_map.hpp"
#include "scene/model/scene.hpp"

namespace ligne::check {

/// Classes of lines, as bits of a set.
enum LineKind : std::uint8_t { kOutline = 1, kBorder = 2, kIntersection = 4, kCrease = 8, kMesh = 16 };
inline constexpr std::uint8_t kFeatureKinds = kOutline | kBorder | kIntersection | kCrease;
inline constexpr std::uint8_t kAllKinds = kFeatureKinds | kMesh;

/// A face as the rays see it. All coordinates are those of the unit box.
struct CheckedFace {
  Point3 normal{0, 0, 0};  ///< unit length; zero for a face without area, which hides nothing
  Point3 middle{0, 0, 0};
  double height = 0;     ///< area by longest side: how far a coordinate's error turns the normal
  double tolerance = 0;  ///< error of its coordinates
};

struct CheckedEdge {
  std::uint32_t v0 = 0, v1 = 0;
  std::vector<std::uint32_t> faces;
  bool same_way = false;     ///< two faces run through it in the same direction
  bool file_hidden = false;  ///< the file marks it as not to be drawn
  bool inner = false;        ///< inside a polygon that was cut into triangles
  double tolerance = 0;
};

struct CheckedScene {
  UnitBox box;
  std::vector<Point3> points;       ///< by vertex of the scene; equal positions of an object are equal here
  std::vector<std::uint32_t> weld;  ///< by vertex of the scene: the first vertex of its object at that position
  const PolygonFaces* contours = nullptr;
  std::vector<CheckedFace> faces;
  std::vector<CheckedEdge> edges;
  double largest_tolerance = 0;
};

/// Welds, moves into the unit box, finds edges. Keeps a reference to the scene's faces.
CheckedScene make_checked_scene(const Scene& scene);

/// The classes that an edge may have in this view: more than one where rounding of the input decides, or where a face
/// without area lies beside it.
std::uint8_t possible_kinds(const CheckedScene& scene, const CheckedEdge& edge, const PageMap& map, double crease_degrees);

}  // namespace ligne::check
