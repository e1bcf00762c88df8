#pragma once
/// Tests edges against convex bodies, by linear inequalities.
///
/// After L. G. Roberts, "Machine perception of three-dimensional solids", 1963. docs/methods/roberts.md.

#include "visibility/method.hpp"

namespace ligne {

class RobertsMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
