#pragma once
/// Small scenes for tests, made of faces and boxes.

#include "scene/clean/clean.hpp"
#include "scene/model/scene_parts.hpp"

namespace ligne::test {

using ligne::add_box;
using ligne::add_face;
using ligne::Basis;
using ligne::begin_object;
using ligne::end_object;
using ligne::kUpright;
using ligne::rotation;

/// A scene of faces without holes, each an object of its own.
inline Scene scene_of_faces(const std::vector<std::vector<Point3>>& faces) {
  Scene scene;
  for (const auto& face : faces) add_face(scene, {face});
  return scene;
}

/// Cleans a scene as after reading, without its warnings.
inline void finish(Scene& scene) {
  Warnings warnings;
  finish_scene(scene, warnings);
}

}  // namespace ligne::test
