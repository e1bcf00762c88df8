#pragma once
/// Pieces of faces in model space as they are painted on the page.

#include <array>
#include <span>
#include <vector>

#include "drawing/result_models.hpp"
#include "view/clip.hpp"
#include "view/projected_scene.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

/// From where the projected scene is seen.
Viewpoint viewpoint_of(const Camera& camera);

/// Per face of the scene 1 when the projected scene has a triangle of it that is not seen edge on.
std::vector<std::uint8_t> shown_faces(const ProjectedScene& scene);

/// Planes in model space as depths over the page: z = p[0] x + p[1] y + p[2] at the page point (x, y) mm, not finite for
/// planes that are seen edge on.
class PagePlanes {
 public:
  explicit PagePlanes(const View& view);
  std::array<double, 3> operator()(const ModelPlane& plane) const;

 private:
  glm::dmat4 to_page_;  ///< for the coefficients of planes
};

/// Projects pieces and clips them to what the study sees. Pieces of faces that the projected scene does not have, or that
/// are seen edge on, are left out.
class PaintPieces {
 public:
  PaintPieces(const ProjectedScene& scene, const ModelPieces& pieces);

  /// Puts the piece behind all that were added.
  void add(std::uint32_t piece, PaintOrder& order);

  /// Puts a part of a face that consists of these pieces, with that plane on the page, behind all that were added: as one
  /// area with holes. Sides that two of the pieces have in common are inside it, so it has no seams.
  void add_whole(std::span<const std::uint32_t> pieces, const std::array<double, 3>& plane, PaintOrder& order);

  /// The outlines on the page, hidden or not, of all pieces of triangles that were cut.
  std::vector<std::vector<Point2>> outlines_of_cut();

 private:
  bool project(std::uint32_t piece);
  bool project(std::span<const Point3> contour);

  const View& view_;
  const ModelPieces& pieces_;
  ClipVolume volume_;
  PagePlanes page_planes_;
  std::vector<std::uint8_t> is_seen_;  ///< per face
  std::vector<HomogeneousPoint> corners_;
};

}  // namespace ligne
