#include "visibility/warnock/initial_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex_hull.hpp"

namespace ligne::warnock {
namespace {

template <class Points, class At>
Window box_of(const Points& points, At at) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Window box{kFar, -kFar, kFar, -kFar};
  for (const auto& p : points) {
    const FramePoint f = at(p);
    box = {std::min(box.u0, f.u), std::max(box.u1, f.u), std::min(box.v0, f.v), std::max(box.v1, f.v)};
  }
  return box;
}

}  // namespace

WindowFrame principal_frame(const std::vector<ProjectedVertex>& vertices) {
  std::vector<LatticePoint> points;
  for (const ProjectedVertex& v : vertices) points.push_back(v.p);
  const std::vector<LatticePoint> hull = convex_hull(std::move(points));
  WindowFrame best;
  double best_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const LatticePoint p = hull[i], q = hull[(i + 1) % hull.size()];
    if (p == q) continue;
    WindowFrame frame{double(q.x) - p.x, double(q.y) - p.y};
    if (std::max(std::abs(frame.a), std::abs(frame.b)) > kLatticeLimit)
      frame = {std::trunc(frame.a / 2), std::trunc(frame.b / 2)};
    while (!(frame.a > 0 && frame.b >= 0)) frame = {frame.b, -frame.a};
    const Window box = box_of(hull, [&](LatticePoint c) { return frame(c); });
    const double area = box.width() * box.height() / (frame.unit() * frame.unit());
    if (area < best_area) {
      best_area = area;
      best = frame;
    }
  }
  return best;
}

InitialWindow initial_window(const ProjectedScene& scene, WindowChoice choice) {
  InitialWindow result;
  if (choice == WindowChoice::principal) result.frame = principal_frame(scene.vertices);
  Window& window = result.window;
  window = box_of(scene.vertices, [&](const ProjectedVertex& v) { return result.frame(v.p); });
  if (window.empty()) return result;
  if (choice == WindowChoice::bounding) {
    const double side = window.longer_side(), more_u = std::floor((side - window.width()) / 2),
                 more_v = std::floor((side - window.height()) / 2);
    window = {window.u0 - more_u, window.u0 - more_u + side, window.v0 - more_v, window.v0 - more_v + side};
  } else if (choice == WindowChoice::screen) {
    const LatticePoint low = scene.lattice.snap(scene.view.window.min), high = scene.lattice.snap(scene.view.window.max);
    window = {std::min<double>(low.x, window.u0), std::max<double>(high.x, window.u1), std::min<double>(low.y, window.v0),
              std::max<double>(high.y, window.v1)};
  }
  return result;
}

}  // namespace ligne::warnock
