#include "visibility/order/paint_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ligne {
namespace {

/// A directed side of a piece. Cuts through a common side of two pieces give both the same corner.
struct DirectedSide {
  Point3 from, to;
  std::array<double, 6> key() const { return {from.x, from.y, from.z, to.x, to.y, to.z}; }
  std::array<double, 6> opposite() const { return {to.x, to.y, to.z, from.x, from.y, from.z}; }
};

/// The sides that no two equally oriented pieces share, joined into contours. Where several contours pass through one
/// corner, any continuation gives the same area under parity filling.
std::vector<std::vector<Point3>> outer_contours(const ModelPieces& pieces, std::span<const std::uint32_t> parts) {
  std::vector<DirectedSide> sides;
  for (const std::uint32_t part : parts) {
    const std::span<const std::uint32_t> corners = pieces.corners(part);
    for (std::size_t i = 0; i < corners.size(); ++i)
      sides.push_back({pieces.point(corners[i]), pieces.point(corners[i + 1 == corners.size() ? 0 : i + 1])});
  }
  std::ranges::sort(sides, {}, &DirectedSide::key);
  std::vector<std::uint8_t> taken(sides.size(), 0);
  const auto find = [&](const std::array<double, 6>& key) {
    return static_cast<std::size_t>(std::ranges::lower_bound(sides, key, {}, &DirectedSide::key) - sides.begin());
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::size_t other = find(sides[i].opposite());
    taken[i] = other < sides.size() && sides[other].key() == sides[i].opposite();
  }
  std::vector<std::vector<Point3>> contours;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (taken[first]) continue;
    std::vector<Point3>& contour = contours.emplace_back();
    for (std::size_t side = first; side < sides.size();) {
      taken[side] = 1;
      contour.push_back(sides[side].from);
      const Point3 at = sides[side].to;
      constexpr double kLeast = std::numeric_limits<double>::lowest();
      side = find({at.x, at.y, at.z, kLeast, kLeast, kLeast});
      while (side < sides.size() && sides[side].from == at && taken[side]) ++side;
      if (side < sides.size() && sides[side].from != at) break;
    }
  }
  return contours;
}

double twice_area(const std::vector<Point2>& contour) {
  double sum = 0;
  for (std::size_t i = 2; i < contour.size(); ++i) sum += cross(contour[i - 1] - contour[0], contour[i] - contour[0]);
  return std::abs(sum);
}

}  // namespace

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

bool PaintPieces::project(std::span<const Point3> contour) {
  corners_.clear();
  for (const Point3& p : contour) corners_.push_back(to_homogeneous(view_, p));
  clip_contour(corners_, volume_);
  return corners_.size() >= 3;
}

/// Stores the visible part of the piece in corners_; returns false if there is none.
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

void PaintPieces::add_whole(std::span<const std::uint32_t> pieces, const std::array<double, 3>& plane, PaintOrder& order) {
  if (pieces.size() == 1) return add(pieces[0], order);
  if (!is_seen_[pieces_.face(pieces[0])]) return;
  PaintPiece painted{pieces_.face(pieces[0]), {}, plane};
  for (const std::vector<Point3>& contour : outer_contours(pieces_, pieces)) {
    if (!project(contour)) continue;
    std::vector<Point2>& on_page = painted.contours.emplace_back();
    for (const HomogeneousPoint& p : corners_) on_page.emplace_back(p.x / p.w, p.y / p.w);
  }
  if (painted.contours.empty()) return;
  const auto outer = std::ranges::max_element(painted.contours, {}, twice_area);
  std::swap(*outer, painted.contours.front());
  order.pieces.push_back(std::move(painted));
}

}  // namespace ligne
