#include "visibility/edges/appel.hpp"

#include "visibility/edges/study_edges.hpp"

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

VisibilityResult AppelMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  return study_edges(scene, options);
}

}  // namespace ligne
