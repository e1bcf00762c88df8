#pragma once
/// The priority list: faces sorted by depth, the sort checked and mended pair by pair, and cut where there is no order.
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
