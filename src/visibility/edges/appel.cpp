#include "visibility/edges/appel.hpp"

#include "visibility/edges/edge_visibility.hpp"

namespace ligne {

const MethodTraits& AppelMethod::traits() const {
  static const MethodTraits traits{
      "appel",
      "every edge against the faces that can hide it, by exact intervals; the default for line drawings",
      kStrokes,
      true,
      true,
      "A. Appel, The notion of quantitative invisibility, 1967; R. Galimberti, U. Montanari, An algorithm for hidden line "
      "elimination, 1969"};
  return traits;
}

VisibilityResult AppelMethod::compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const {
  return edge_visibility(scene, options);
}

}  // namespace ligne
