#include "page_map.hpp"

#include <glm/matrix.hpp>

namespace ligne::check {

namespace {

/// Radius of a ball round the unit box.
constexpr double kBoxReach = 0.9;

}  // namespace

PageMap::PageMap(const Rows& model_to_page, const UnitBox& box, const Rect& window, double near_distance)
    : window_(window), near_(near_distance) {
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) to_page_[k][i] = model_to_page[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  glm::dmat4 out_of_box(box.size);
  out_of_box[3] = glm::dvec4(box.centre, 1);
  to_page_ = to_page_ * out_of_box;
  to_box_ = glm::inverse(to_page_);
  for (int k = 0; k < 4; ++k)
    if (!std::isfinite(glm::dot(to_box_[k], to_box_[k])))
      throw std::runtime_error("the matrix of the view can not be inverted");
  perspective_ = to_page_[0].w != 0 || to_page_[1].w != 0 || to_page_[2].w != 0;
  // The viewer stands where the depth goes to minus infinity: at a finite point in perspective, else in a direction.
  const Point3 far = -Point3(to_box_[2]);
  viewer_ = perspective_ ? far / -to_box_[2].w : glm::normalize(far * (to_page_[3].w < 0 ? -1.0 : 1.0));
}

Point2 PageMap::page(const Point3& q) const {
  const glm::dvec4 h = homogeneous(q);
  return {h.x / h.w, h.y / h.w};
}

Point3 PageMap::unproject(double x, double y, double z) const {
  const glm::dvec4 h = to_box_ * glm::dvec4(x, y, z, 1);
  return Point3(h) / h.w;
}

Point3 PageMap::shifted(const Point3& q, Point2 mm) const {
  const glm::dvec4 h = homogeneous(q);
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
  const glm::dvec4 ha = homogeneous(a), hb = homogeneous(b);
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
