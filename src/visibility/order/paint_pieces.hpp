#pragma once
/// Pieces of faces in model space, projected for painting on the page.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "drawing/result_models.hpp"
#include "view/clip.hpp"
#include "view/projected_scene.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

/// The viewpoint of a camera.
Viewpoint viewpoint_of(const Camera& camera);

/// Per face of the scene: 1 if the projected scene has a triangle of it that is not edge-on.
std::vector<std::uint8_t> shown_faces(const ProjectedScene& scene);

/// Maps planes in model space to depths over the page: z = p[0] x + p[1] y + p[2] at the page point (x, y) mm. Not finite
/// for edge-on planes.
class PagePlanes {
 public:
  explicit PagePlanes(const View& view);
  std::array<double, 3> operator()(const ModelPlane& plane) const;

 private:
  glm::dmat4 to_page_;  ///< maps plane coefficients
};

/// Projects pieces and clips them to the view volume. Omits pieces of faces that are edge-on or not in the projected scene.
class PaintPieces {
 public:
  PaintPieces(const ProjectedScene& scene, const ModelPieces& pieces);

  /// Appends the piece to the order.
  void add(std::uint32_t piece, PaintOrder& order);

  /// Appends one part of a face, made of these pieces and with that plane on the page, as one area with holes. Common sides
  /// of the pieces are interior, so the area has no seams.
  void add_whole(std::span<const std::uint32_t> pieces, const std::array<double, 3>& plane, PaintOrder& order);

  /// Outlines on the page, hidden or not, of all pieces of triangles that were cut.
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

/// One number for each visible group of pieces, at a point of the group that no later piece covers. `group_of`: group number
/// per piece of the order. Only sampled points are tried, so a group with a small visible part may get no number.
std::vector<PageNumber> order_numbers(const PaintOrder& order, std::span<const std::uint32_t> group_of);

/// Successive pieces of one face form a group. Number 1 is painted first.
std::vector<PageNumber> order_numbers(const PaintOrder& order);

}  // namespace ligne
