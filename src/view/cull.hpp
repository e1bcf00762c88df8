#pragma once
/// Back-face culling: removes faces of solids that face away from the viewer and can not affect the drawing.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"

namespace ligne {

/// The faces that can be removed.
///
/// A solid is an object that is closed (every edge has two faces) and consistently wound. It consists of shells, the
/// sets of faces that are connected by edges. The sign of the volume of a shell says which side is outside, so solids
/// with inward windings and cavities are oriented correctly. A ray from outside a shell that does not penetrate itself
/// meets a front face before any back face. If that front face is opaque, back faces hide nothing and are not visible,
/// regardless of objects in front of the shell or inside it. Faces seen edge on stay.
///
/// These keep all their faces:
/// - objects that are not solids; objects with a shell whose volume is within the error of its coordinates; and objects
///   whose bounding box contains the eye or comes so close to it that the near plane could cut them open;
/// - shells with a transparent face, through which back faces are visible;
/// - shells that touch or penetrate themselves (scene/model/self_contact.hpp), since parts that are inside out there
///   show their back faces.
struct BackFaces {
  std::vector<std::uint8_t> culled;  ///< per face of the scene: 1 if it can be removed
  std::size_t faces = 0;             ///< number of faces that can be removed
  std::size_t objects = 0;           ///< number of objects that have faces
  std::size_t kept_objects = 0;      ///< objects that keep all faces of at least one shell, for a reason above
};

/// Finds the faces that can be removed for a view. `topology` is that of `scene`.
BackFaces find_back_faces(const Scene& scene, const Topology& topology, const View& view);

/// Removes the triangles of culled faces and the candidate edges between two culled faces from the projected scene. An
/// edge between a culled face and another one stays, with its class.
void cull(ProjectedScene& projected, const BackFaces& back_faces);

}  // namespace ligne
