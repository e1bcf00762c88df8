#pragma once
/// The depth buffer: the nearest face at every pixel.
///
/// After E. Catmull, "A subdivision algorithm for computer display of curved surfaces", 1974, in the scan-line version of
/// the lecture among this project's sources (section 5.1). docs/methods/zbuffer.md.

#include "visibility/method.hpp"

namespace ligne {

class ZBufferMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

/// Largest error of lines on the page, in mm: two pixels.
double zbuffer_tolerance_mm(double page_height_mm, unsigned rows);

}  // namespace ligne
