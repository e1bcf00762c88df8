#pragma once
/// Faces clip faces: the result is visible polygons with holes.
///
/// After K. Weiler and P. Atherton, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977, and P. Atherton, K.
/// Weiler and D. Greenberg, "Polygon shadow generation", SIGGRAPH 1978. docs/methods/atherton-weiler.md.

#include "visibility/method.hpp"

namespace ligne {

class AthertonWeilerMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
