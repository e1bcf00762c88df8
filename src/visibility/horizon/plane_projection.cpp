#include "visibility/horizon/plane_projection.hpp"

namespace ligne::horizon {

PlaneProjection::PlaneProjection(const Camera& camera, double sign_x, double sign_y)
    : perspective_(camera.perspective), eye_(camera.eye), forward_(camera.forward) {
  if (perspective_) {
    // The part spans a quarter of the circle round the eye, so every point of it is within 45 degrees of its middle.
    forward_ = Point3{sign_x, sign_y, 0} * std::sqrt(0.5);
    right_ = {forward_.y, -forward_.x, 0};
    up_ = {0, 0, 1};
    return;
  }
  // Seen straight from above or below, any upright plane is edge on; then the ground is the drawing plane, and y is up.
  const double level = std::hypot(forward_.x, forward_.y);
  right_ = level > 0 ? Point3{forward_.y / level, -forward_.x / level, 0} : Point3{1, 0, 0};
  up_ = glm::cross(right_, forward_);
}

}  // namespace ligne::horizon
