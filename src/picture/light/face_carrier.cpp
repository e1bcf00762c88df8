#include "picture/light/face_carrier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/clip.hpp"

namespace ligne {

std::vector<LatticePoint> points_in_view(std::vector<HomogeneousPoint> contour, const View& view, const Lattice& lattice) {
  const ClipVolume volume = face_volume(view, lattice);
  if (!std::all_of(contour.begin(), contour.end(), [&](const HomogeneousPoint& p) { return volume.contains(p); })) {
    clip_contour(contour, volume);
  }
  std::vector<LatticePoint> points;
  for (const HomogeneousPoint& p : contour) points.push_back(lattice.snap({p.x / p.w, p.y / p.w}));
  return points;
}

bool carry(const View& from, const std::vector<Point2>& contour_mm, const FacePlane& plane, const View& to,
           const Lattice& lattice, std::vector<LatticePoint>& out) {
  std::vector<HomogeneousPoint> contour;
  for (const Point2& p : contour_mm) {
    Point3 on_face;
    if (!point_on_face(from, p, plane, on_face)) return false;
    contour.push_back(to_homogeneous(to, on_face));
  }
  out = points_in_view(std::move(contour), to, lattice);
  return true;
}

FaceBorder::FaceBorder(const Scene& scene, std::uint32_t face, const View& view, const Lattice& lattice, double near_mm)
    : near_(near_mm / lattice.step_mm) {
  std::vector<Point2> corners;
  for (std::uint32_t c = 0; c < scene.faces.contour_count(face); ++c) {
    corners.clear();
    for (const std::uint32_t v : scene.faces.contour(face, c)) {
      const HomogeneousPoint h = to_homogeneous(view, scene.vertices[v]);
      if (view.camera.perspective && !(h.w > view.near_distance)) break;
      corners.push_back((Point2{h.x / h.w, h.y / h.w} - lattice.origin_mm) / lattice.step_mm);
    }
    if (corners.size() < scene.faces.contour(face, c).size()) continue;
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point2 a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
      area += a.x * b.y - a.y * b.x;
    }
    // The face lies to the left of the outer contour, or to the right.
    const double right = (area > 0) == (c == 0) ? 1 : -1;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point2 a = corners[i], d = corners[i + 1 == corners.size() ? 0 : i + 1] - a;
      const double length = glm::length(d);
      if (length > 0) edges_.push_back({a, d, {right * d.y / length, -right * d.x / length}});
    }
  }
}

bool FaceBorder::lies_on(const Edge& edge, LatticePoint p) const {
  const Point2 q = Point2{p.x, p.y} - edge.from;
  return glm::distance(q, edge.along * std::clamp(glm::dot(q, edge.along) / glm::dot(edge.along, edge.along), 0.0, 1.0)) <=
         near_;
}

void FaceBorder::move_beyond(std::vector<LatticePoint>& contour) const {
  constexpr double kFarthest = 8;  // longest move, in near_, where directions are nearly equal
  const std::size_t n = contour.size();
  struct Place {
    const Edge* border[2] = {nullptr, nullptr};  ///< edges along which the sides before and after the corner run
  };
  std::vector<Place> places(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 == n ? 0 : i + 1;
    const auto along = std::find_if(edges_.begin(), edges_.end(),
                                    [&](const Edge& e) { return lies_on(e, contour[i]) && lies_on(e, contour[next]); });
    if (along != edges_.end()) places[i].border[1] = places[next].border[0] = &*along;
  }
  const std::vector<LatticePoint> before = contour;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [first, last] = places[i].border;
    if (!first && !last) continue;
    const Point2 p{before[i].x, before[i].y};
    Point2 way = first && last ? first->out + last->out : Point2{0, 0};
    const Edge& edge = last ? *last : *first;
    if (!first || !last) {  // one side leads into the face: extends it in its direction
      const LatticePoint inner = before[last ? (i == 0 ? n - 1 : i - 1) : (i + 1 == n ? 0 : i + 1)];
      way = p - Point2{inner.x, inner.y};
    }
    const double length = glm::length(way);
    if (!(length > 0)) continue;
    const double rise = std::max(1 / kFarthest, glm::dot(way, edge.out) / length);
    const Point2 moved = p + way * (near_ / (rise * length));
    contour[i] = {static_cast<std::int32_t>(std::lround(moved.x)), static_cast<std::int32_t>(std::lround(moved.y))};
  }
}

}  // namespace ligne
