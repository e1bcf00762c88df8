#pragma once
/// The scan-line method: spans by one of several methods, and visible edges tracked from line to line into strokes.
///
/// After G. S. Watkins, "A real time visible surface algorithm", 1970; G. W. Romney, G. S. Watkins, D. C. Evans, "Real time
/// display of computer generated half-tone perspective pictures", 1969; M. Archuleta, "Hidden surface line-drawing
/// algorithm", 1972. docs/methods/watkins.md.

#include "visibility/method.hpp"

namespace ligne {

class WatkinsMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

}  // namespace ligne
