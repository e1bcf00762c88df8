#pragma once
/// Back-face culling as a method by itself: enough for one convex body.
///
/// After the lecture among this project's sources (section 2), its page on filled objects (section 2) and [Boulle1980]
/// 1.2.2.3. docs/methods/culling.md.

#include "visibility/method.hpp"

namespace ligne {

class CullingMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
