#include "visibility/order/paint_pieces.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ligne {

Viewpoint viewpoint_of(const Camera& camera) { return {camera.eye, -camera.forward, camera.perspective}; }

std::vector<std::uint8_t> shown_faces(const ProjectedScene& scene) {
  std::vector<std::uint8_t> shown(scene.model->faces.size(), 0);
  for (const Triangle& t : scene.triangles) {
    if (!scene.is_edge_on(t)) shown[t.face] = 1;
  }
  return shown;
}

PagePlanes::PagePlanes(const View& view) : to_page_(glm::transpose(glm::inverse(view.model_to_page))) {}

std::array<double, 3> PagePlanes::operator()(const ModelPlane& plane) const {
  const glm::dvec4 p = to_page_ * glm::dvec4(plane.normal, -glm::dot(plane.normal, plane.point));
  return {-p.x / p.z, -p.y / p.z, -p.w / p.z};
}

PaintPieces::PaintPieces(const ProjectedScene& scene, const ModelPieces& pieces)
    : view_(scene.view),
      pieces_(pieces),
      volume_(face_volume(scene.view, scene.lattice)),
      page_planes_(scene.view),
      is_seen_(shown_faces(scene)) {}

/// Puts what is seen of the piece into corners_; returns whether there is anything.
bool PaintPieces::project(std::uint32_t piece) {
  corners_.clear();
  if (!is_seen_[pieces_.face(piece)]) return false;
  for (const std::uint32_t corner : pieces_.corners(piece)) corners_.push_back(to_homogeneous(view_, pieces_.point(corner)));
  clip_contour(corners_, volume_);
  return corners_.size() >= 3;
}

std::vector<std::vector<Point2>> PaintPieces::outlines_of_cut() {
  std::vector<std::uint32_t> count(pieces_.triangles().size(), 0);
  for (const ModelPiece& piece : pieces_.pieces()) ++count[piece.triangle];
  std::vector<std::vector<Point2>> outlines;
  for (std::uint32_t piece = 0; piece < pieces_.pieces().size(); ++piece) {
    if (count[pieces_.pieces()[piece].triangle] < 2 || !project(piece)) continue;
    std::vector<Point2>& outline = outlines.emplace_back();
    for (const HomogeneousPoint& p : corners_) outline.emplace_back(p.x / p.w, p.y / p.w);
    outline.push_back(outline.front());
  }
  return outlines;
}

void PaintPieces::add(std::uint32_t piece, PaintOrder& order) {
  if (!project(piece)) return;
  PaintPiece painted{pieces_.face(piece), {{}}, page_planes_(pieces_.plane_of(piece))};
  for (const double c : painted.plane) {
    if (!std::isfinite(c)) return;  // seen edge on
  }
  for (const HomogeneousPoint& p : corners_) painted.contours[0].emplace_back(p.x / p.w, p.y / p.w);
  order.pieces.push_back(std::move(painted));
}

}  // namespace ligne
