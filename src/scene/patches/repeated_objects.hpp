#pragma once
/// Objects of a scene that are copies of an earlier one, moved, turned and scaled: the screws of an assembly.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// A rotation and a uniform scaling about the origin, then a translation.
struct Similarity {
  std::array<Point3, 3> rows{Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1)};  ///< of the rotation matrix
  double scale = 1;
  Point3 shift{0, 0, 0};

  Point3 turned(const Point3& direction) const;
  Point3 operator()(const Point3& p) const { return scale * turned(p) + shift; }
};

/// The object that an object repeats, and the motion that takes the vertices of that one to those of the other.
struct Repetition {
  std::uint32_t original = 0;  ///< index of an object that repeats none; the object itself if it repeats none
  Similarity motion;
};

/// For each object the earlier one that it repeats: one of the same contours of faces, flags of edges and order of vertices,
/// whose vertices lie where a motion puts them, within the precision of the coordinates. Mirror images are no repetitions.
/// Objects that share everything but the places of their vertices are compared with a constant number of others, so the time
/// is proportional to the number of corners.
std::vector<Repetition> find_repetitions(const Scene& scene, const Topology& topology);

}  // namespace ligne
