#pragma once
/// How much light faces get. Gray faces, fills and hatching all take it from here.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// By face, from 0 to 1: cos^2(theta) / R^2, theta the angle between the face's normal and the direction to the eye, R the
/// distance of the face's middle from the eye, over the largest such value among the faces before the eye
/// ([Boulle1980] 2.3.2.1, figure 2.29). In parallel projection the eye is far away, and R is the same for all. With the
/// light at the eye there are no shadows to be seen.
std::vector<double> face_brightness(const Scene& scene, const Camera& camera);

/// The light that faces get on the side that is seen. It refers to the scene, the camera and the lights.
class FaceLight {
 public:
  /// Without lights one is at the eye: face_brightness().
  FaceLight(const Scene& scene, const Camera& camera, std::span<const Light> lights);

  /// From 0 to 1: the mean over the lights of cos(theta), theta between the normal and the way to the light, 0 for one
  /// behind the face. Bit i of `reached` says whether light i (of the first 32) reaches it, shares[i] how much of it comes
  /// through transparent faces (all, where there is no such number).
  double of(std::uint32_t face, std::uint32_t reached = 0xffffffffu, std::span<const double> shares = {}) const;

 private:
  const Scene& scene_;
  const Camera& camera_;
  std::span<const Light> lights_;
  std::vector<double> from_eye_;  ///< without lights
};

}  // namespace ligne
