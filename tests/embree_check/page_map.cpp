#include "page_map.hpp"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "support/standard.hpp"

namespace ligne::check {

namespace {

/// Radius of a ball round the unit box.
constexpr double kBoxReach = 0.9;

}  // namespace

PageMap::PageMap(const Rows& model_to_page, const UnitBox& box, const Rect& window, double near_distance)
    : window_(window), near_(near_distance) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& row = model_to_page[i];
    for (std::size_t k = 0; k < 3; ++k) to_page_[i][k] = row[k] * box.size;
    to_page_[i][3] = row[0] * box.centre.x + row[1] * box.centre.y + row[2] * box.centre.z + row[3];
  }
  const auto& w_row = to_page_[3];
  perspective_ = w_row[0] != 0 || w_row[1] != 0 || w_row[2] != 0;
  glm::dmat4 matrix;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) matrix[k][i] = to_page_[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const glm::dmat4 inverse = glm::inverse(matrix);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) {
      to_box_[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = inverse[k][i];
      if (!std::isfinite(inverse[k][i])) throw std::runtime_error("the matrix of the view can not be inverted");
    }
  // The viewer stands where the depth goes to minus infinity: at a finite point in perspective, else in a direction.
  const Point3 far{-to_box_[0][2], -to_box_[1][2], -to_box_[2][2]};
  if (perspective_) {
    viewer_ = far / -to_box_[3][2];
  } else {
    viewer_ = glm::normalize(far * (w_row[3] < 0 ? -1.0 : 1.0));
  }
}

Homogeneous PageMap::homogeneous(const Point3& q) const {
  const auto row = [&](std::size_t i) {
    return to_page_[i][0] * q.x + to_page_[i][1] * q.y + to_page_[i][2] * q.z + to_page_[i][3];
  };
  return {row(0), row(1), row(2), row(3)};
}

Point2 PageMap::page(const Point3& q) const {
  const Homogeneous h = homogeneous(q);
  return {h.x / h.w, h.y / h.w};
}

Point3 PageMap::unproject(double x, double y, double z) const {
  const auto row = [&](std::size_t i) { return to_box_[i][0] * x + to_box_[i][1] * y + to_box_[i][2] * z + to_box_[i][3]; };
  return Point3{row(0), row(1), row(2)} / row(3);
}

Point3 PageMap::shifted(const Point3& q, Point2 mm) const {
  const Homogeneous h = homogeneous(q);
  const double x = h.x / h.w, y = h.y / h.w, z = h.z / h.w;
  return q + (unproject(x + mm.x, y + mm.y, z) - unproject(x, y, z));
}

Sightline PageMap::to_viewer(const Point3& q) const {
  if (!perspective_) return {viewer_, std::numeric_limits<double>::infinity()};
  const Point3 way = viewer_ - q;
  const double length = glm::length(way);
  const double w = homogeneous(q).w;
  return {way / length, w > near_ ? length * (1 - near_ / w) : 0};
}

std::pair<Point3, Point3> PageMap::sight_through(Point2 mm) const {
  const Point3 on_plane = unproject(mm.x, mm.y, 0);
  if (!perspective_) {
    const Point3 away = -viewer_;
    return {on_plane - away * (glm::dot(on_plane, away) + kBoxReach), away};
  }
  const Point3 away = glm::normalize(on_plane - viewer_);
  const Point3 at_near = on_plane + (viewer_ - on_plane) * (1 - near_ / homogeneous(on_plane).w);
  const double along = glm::dot(-at_near, away) - kBoxReach;
  return {at_near + away * std::max(0.0, along), away};
}

std::optional<Part> PageMap::clip(const Point3& a, const Point3& b, double margin_mm) const {
  const Homogeneous ha = homogeneous(a), hb = homogeneous(b);
  Part part;
  const auto keep_positive = [&](double fa, double fb) {  // where (1 - t) fa + t fb > 0
    if (fa <= 0 && fb <= 0) return false;
    if (fa < 0) part.from = std::max(part.from, fa / (fa - fb));
    if (fb < 0) part.to = std::min(part.to, fa / (fa - fb));
    return part.from < part.to;
  };
  const auto side = [&](double sign, double limit, double c_a, double c_b) {
    return keep_positive(sign * (c_a - limit * ha.w), sign * (c_b - limit * hb.w));
  };
  if (perspective_ && !keep_positive(ha.w - near_, hb.w - near_)) return std::nullopt;
  if (!side(+1, window_.min.x + margin_mm, ha.x, hb.x) || !side(-1, window_.max.x - margin_mm, ha.x, hb.x) ||
      !side(+1, window_.min.y + margin_mm, ha.y, hb.y) || !side(-1, window_.max.y - margin_mm, ha.y, hb.y)) {
    return std::nullopt;
  }
  return part;
}

}  // namespace ligne::check
