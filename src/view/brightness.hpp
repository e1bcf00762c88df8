#pragma once
/// How bright faces look with a light at the eye.

#include <vector>

#include "scene/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// By face, from 0 to 1: cos^2(theta) / R^2, theta the angle between the face's normal and the direction to the eye, R the distance of the face's
/// middle from the eye, over the largest such value among the faces before the eye (thesis 2.3.2.1, figure 2.29). In parallel projection the eye is
/// far away, and R is the same for all. With the light at the eye there are no shadows to be seen.
std::vector<double> face_brightness(const Scene& scene, const Camera& camera);

}  // namespace ligne
