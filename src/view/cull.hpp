#pragma once
/// Back faces, which need no study: those of solids that look away from the viewer.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne {

/// The faces that may be left out.
///
/// A solid here is an object that is closed (every edge has two faces) and consistently wound. It falls into shells, sets of
/// faces that hang together by edges; which side of a shell is outside is decided by the sign of its volume, so that solids
/// wound inwards and cavities are oriented right. From outside a shell that does not penetrate itself, a ray meets a face
/// that looks at the viewer before it meets any that looks away. Where that face is opaque, the latter hide nothing and show
/// nothing, whatever else, transparent or not, stands before or in the shell. Faces seen edge on stay.
///
/// All faces are kept by
/// - objects that are no solids, those with a shell whose volume drowns in the error of its coordinates, and those whose
///   bounding box has the eye in it, or comes so near that the near plane could cut them open;
/// - shells with a transparent face: one sees the back faces through it;
/// - shells that touch or penetrate themselves (scene/model/self_contact.hpp): what has turned inside out there shows its
/// back faces.
struct BackFaces {
  std::vector<std::uint8_t> culled;  ///< per face of the scene: 1 when it is left out
  std::size_t faces = 0;             ///< how many are left out
  std::size_t objects = 0;           ///< objects that have faces
  std::size_t kept_objects = 0;      ///< those of them that keep all faces, or those of a shell, for a reason given above
};

/// `topology` is that of `scene`.
BackFaces find_back_faces(const Scene& scene, const Topology& topology, const View& view);

/// Takes the triangles of culled faces out of the projected scene, and the candidate edges between two culled faces. Edges
/// between a culled face and one that stays keep their class and are studied as before.
void cull(ProjectedScene& projected, const BackFaces& back_faces);

}  // namespace ligne
