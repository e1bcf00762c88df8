#pragma once
/// Continuous tone of faces, gray or in colour: normals are interpolated over the faces of smooth surfaces
/// ([Boulle1980] 1.2.5.3: the contiguity of faces has to come with the model of visibility).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "picture/prepared_scene.hpp"
#include "scene/form/form_mesh.hpp"

namespace ligne {

/// A point of a smooth surface, with the interpolated normal on the visible side of its face.
struct SurfacePoint {
  Point3 point{0, 0, 0}, normal{0, 0, 0};
  bool turns_away = false;  ///< the normal turns away before the face does, as near outlines
};

/// Normals and brightness at the points of faces. Surfaces end at creases, as in hatching; a flat face between creases has
/// the tone of face_brightness(). To be made before the topology of the prepared scene is released.
class SmoothTones {
 public:
  explicit SmoothTones(const PreparedScene& prepared);

  /// The point of the face at a point of the page that lies on it or beside its rim. Nothing if the face is flat. May be
  /// called by several threads at once.
  std::optional<SurfacePoint> surface_at(std::uint32_t face, Point2 page_mm) const;

  /// Brightness, 0 to 1, with a light at the eye, of the face at a point of the page that lies on it or beside its rim. May
  /// be called by several threads at once.
  double at(std::uint32_t face, Point2 page_mm) const;

 private:
  /// A node before the division by w: page mm.
  struct Projected {
    double x, y, w;
  };
  std::array<double, 3> weights(const FormTriangle& triangle, Point2 page_mm) const;
  bool is_flat(const Scene& scene, std::uint32_t face) const;

  Camera camera_;
  FormMesh mesh_;
  std::vector<Projected> projected_;   ///< by node
  std::vector<double> of_face_;        ///< face_brightness()
  std::vector<std::uint8_t> is_flat_;  ///< by face
  double factor_;
};

}  // namespace ligne
