#pragma once
/// Edges and areas by recursive subdivision of the picture.
///
/// After J. E. Warnock, "A hidden surface algorithm for computer generated halftone pictures", 1969, in the version for
/// edges of [Boulle1980] among this project's sources (chapter 2.2). docs/methods/warnock.md.

#include "visibility/method.hpp"

namespace ligne {

class WarnockMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override;
};

/// Largest error of lines on the page with `--set resolution`, mm: windows are at most as large as the longer side of the
/// sheet divided by `resolution`, and everything is decided within one window.
double warnock_tolerance_mm(const Rect& sheet, unsigned resolution);

}  // namespace ligne
