#pragma once
/// The priority list: faces are sorted by depth, the sort is checked and corrected pair by pair, and faces without an order
/// are cut.
///
/// After M. E. Newell, R. G. Newell, T. L. Sancha, "A solution to the hidden surface problem", ACM National Conference 1972.
/// docs/methods/newell.md.

#include "visibility/method.hpp"

namespace ligne {

class NewellMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
