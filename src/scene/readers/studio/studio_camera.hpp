#pragma once
/// Cameras of 3D Studio, whose files give the focal length of a lens and the bank of the camera.

#include "scene/model/scene.hpp"

namespace ligne {

/// Sets the field of view and the aspect of a camera with this focal length, mm, on a film 36 mm wide and 24 mm high.
/// A length that is not positive gives 180 degrees.
void set_lens(SceneCamera& camera, double lens_mm);

/// Turns the camera, whose z axis was up, about its line of sight, degrees. Without effect if it looks straight up or down.
void bank_camera(SceneCamera& camera, double degrees);

}  // namespace ligne
