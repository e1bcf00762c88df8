#pragma once
/// A scene as nothing but points: easy to shuffle, turn, cut and write.

#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne::test {

using Contour = std::vector<Point3>;

struct PlainFace {
  std::vector<Contour> contours;  ///< the outer one, then the holes
};

struct PlainObject {
  double precision = 0;  ///< as in Object
  std::vector<PlainFace> faces;
};

struct PlainScene {
  Axis up_axis = Axis::z;
  std::vector<PlainObject> objects;
};

/// Leaves out names, materials, details and corner flags.
PlainScene plain(const Scene& scene);

/// Vertices are numbered as the faces of an object name them; equal points of an object are one vertex.
Scene to_scene(const PlainScene& plain);

/// The scene in the format ligne-scene; numbers read back as the same doubles.
std::string to_json(const PlainScene& plain);

}  // namespace ligne::test
