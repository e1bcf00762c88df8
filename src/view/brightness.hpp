#pragma once
/// Brightness of faces, for grey faces, fills and hatching.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Brightness per face, 0 to 1, with a light at the eye: cos^2(theta) / R^2, divided by the largest such value among
/// the faces in front of the eye. theta is the angle between the normal of the face and the direction to the eye, R the
/// distance of the centre of the face from the eye ([Boulle1980] 2.3.2.1, figure 2.29). In parallel projection R is the
/// same for all faces. With the light at the eye no shadows are visible.
std::vector<double> face_brightness(const Scene& scene, const Camera& camera);

/// cos^2(theta) / R^2 at a point of a surface with this unit normal; 0 behind the eye. Multiply by
/// eye_brightness_factor() for the scale of face_brightness().
double eye_brightness(const Camera& camera, const Point3& point, const Point3& normal);
/// One over the largest eye_brightness() at the middle of a face; 0 if all are 0.
double eye_brightness_factor(const Scene& scene, const Camera& camera);

/// Computes the light on the visible side of faces. It keeps references to the scene, the camera and the lights.
class FaceLight {
 public:
  /// If there are no lights, a light at the eye is assumed: face_brightness().
  FaceLight(const Scene& scene, const Camera& camera, std::span<const Light> lights);

  /// Brightness of a face, 0 to 1: the mean over the lights of cos(theta), where theta is the angle between the normal
  /// and the direction to the light; 0 for a light behind the face. Bit i of `reached` says whether light i (of the
  /// first 32) reaches the face; shares[i] is the fraction of it that passes transparent faces, 1 if missing.
  double of(std::uint32_t face, std::uint32_t reached = 0xffffffffu, std::span<const double> shares = {}) const;
  /// Brightness at a point of a surface with this unit normal on its visible side. There must be lights.
  double at(const Point3& point, const Point3& normal, std::uint32_t reached = 0xffffffffu,
            std::span<const double> shares = {}) const;

 private:
  const Scene& scene_;
  const Camera& camera_;
  std::span<const Light> lights_;
  std::vector<double> from_eye_;  ///< face_brightness() if there are no lights
};

}  // namespace ligne
