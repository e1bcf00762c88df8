#pragma once
/// Continuous tone of gray faces: normals are interpolated over the faces of smooth surfaces ([Boulle1980] 1.2.5.3: the
/// contiguity of faces has to come with the model of visibility).

#include <array>
#include <cstdint>
#include <vector>

#include "picture/prepared_scene.hpp"
#include "scene/form/form_mesh.hpp"

namespace ligne {

/// Brightness at the points of faces. Surfaces end at creases, as in hatching; a flat face between creases has the tone of
/// face_brightness(). To be made before the topology of the prepared scene is released.
class SmoothTones {
 public:
  explicit SmoothTones(const PreparedScene& prepared);

  /// Brightness, 0 to 1, of the face at a point of the page that lies on it or beside its rim. May be called by several
  /// threads at once.
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
