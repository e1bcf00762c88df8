#include "picture/culling.hpp"

namespace ligne {

BackFaces cull_back_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected, RunReport& run) {
  BackFaces back_faces = find_back_faces(scene, topology, projected.view);
  cull(projected, back_faces);
  if (back_faces.kept_objects > 0) {
    run.warn(
        std::to_string(back_faces.kept_objects) + " of " + std::to_string(back_faces.objects) +
        " objects keep their back faces, or some of them: they are not closed and consistently wound, touch or penetrate "
        "themselves, are transparent, or surround the eye");
  }
  return back_faces;
}

}  // namespace ligne
