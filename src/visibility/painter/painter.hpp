#pragma once
/// The painter's algorithm: paints faces from the farthest to the nearest, each over the earlier ones.
///
/// After M. E. Newell, R. G. Newell, T. L. Sancha, 1972, in the two simple versions of the sources of this project: the
/// plain sort of its page on filled objects (section 3), and step 2 of the lecture (section 3). docs/methods/painter.md.

#include "visibility/method.hpp"

namespace ligne {

class PainterMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
