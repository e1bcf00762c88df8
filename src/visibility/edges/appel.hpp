#pragma once
/// The default method: tests every edge against the faces that can hide it, in object space.
///
/// After A. Appel, "The notion of quantitative invisibility and the machine rendering of solids", 1967, and R. Galimberti
/// and U. Montanari, "An algorithm for hidden line elimination", CACM 12(4), 1969. docs/methods/appel.md.

#include "visibility/method.hpp"

namespace ligne {

class AppelMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
