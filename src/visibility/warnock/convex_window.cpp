#include "visibility/warnock/convex_window.hpp"

#include <algorithm>

namespace ligne::warnock {
namespace {

__extension__ typedef __int128 Wide;

/// Relative error bound of two products and their difference, each with an error of 2^-53. Below it the sign is uncertain.
constexpr double kTurnError = 0x1p-51;

}  // namespace

Border::Border(FramePoint p, FramePoint q) : p_(p), q_(q) {
  const double du = q.u - p.u, dv = q.v - p.v, length = std::hypot(du, dv);
  nu_ = -dv / length;
  nv_ = du / length;
}

Border Border::moved(double units) const {
  Border moved = *this;
  moved.shift_ += units;
  return moved;
}

ConvexWindow::ConvexWindow(const Window& w) {
  const FramePoint corners[] = {{w.u0, w.v0}, {w.u1, w.v0}, {w.u1, w.v1}, {w.u0, w.v1}};
  if (w.u0 < w.u1 && w.v0 < w.v1) {
    for (int i = 0; i < 4; ++i) edges_.push_back({Border(corners[i], corners[(i + 1) % 4]), corners[i]});
  }
  measure();
}

/// Sutherland and Hodgman, with the border of each edge.
void ConvexWindow::cut(const Border& border) {
  std::vector<Edge> kept;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const FramePoint a = edge.from, b = edges_[(i + 1) % edges_.size()].from;
    const double da = border.distance(a), db = border.distance(b), t = da / (da - db);
    const FramePoint crossing{a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
    if (da >= 0) {
      kept.push_back(edge);
      if (db < 0) kept.push_back({border, crossing});
    } else if (db >= 0) {
      kept.push_back({edge.border, crossing});
    }
  }
  // An edge without a length bounds nothing.
  edges_.clear();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!(kept[i].from == kept[(i + 1) % kept.size()].from)) edges_.push_back(kept[i]);
  }
}

void ConvexWindow::measure() {
  if (empty()) {
    edges_.clear();
    box_ = {0, -1, 0, -1};
    return;
  }
  const FramePoint first = edges_.front().from;
  Window box{first.u, first.u, first.v, first.v};
  double u = 0, v = 0;
  for (const Edge& e : edges_) {
    box = {std::min(box.u0, e.from.u), std::max(box.u1, e.from.u), std::min(box.v0, e.from.v), std::max(box.v1, e.from.v)};
    u += e.from.u - first.u;
    v += e.from.v - first.v;
  }
  const auto n = static_cast<double>(edges_.size());
  box_ = {std::floor(box.u0), std::ceil(box.u1), std::floor(box.v0), std::ceil(box.v1)};
  middle_ = {std::round(first.u + u / n), std::round(first.v + v / n)};
}

std::optional<std::pair<FramePoint, FramePoint>> ConvexWindow::edge_along(const Border& border) const {
  const auto edge = std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) { return e.border == border; });
  if (edge == edges_.end()) return std::nullopt;
  const auto next = edge + 1 == edges_.end() ? edges_.begin() : edge + 1;
  return std::pair{edge->from, next->from};
}

ConvexWindow ConvexWindow::part(const Border& border) const {
  ConvexWindow result = *this;
  result.cut(border);
  result.measure();
  return result;
}

ConvexWindow ConvexWindow::shrunk(double units) const {
  ConvexWindow result = *this;
  for (const Edge& e : edges_) result.cut(e.border.moved(units));
  result.measure();
  if (!result.empty() && !result.holds(result.middle_)) {
    result.edges_.clear();
    result.measure();
  }
  return result;
}

bool ConvexWindow::meets(FramePoint p, FramePoint q, double margin) const {
  if (std::max(p.u, q.u) < box_.u0 - margin || std::min(p.u, q.u) > box_.u1 + margin ||
      std::max(p.v, q.v) < box_.v0 - margin || std::min(p.v, q.v) > box_.v1 + margin)
    return false;
  double from = 0, to = 1;
  for (const Edge& e : edges_) {
    const double a = e.border.distance(p) + margin, b = e.border.distance(q) + margin;
    if (a < 0 && b < 0) return false;
    if (a < 0) from = std::max(from, a / (a - b));
    if (b < 0) to = std::min(to, a / (a - b));
    if (from > to) return false;
  }
  return !empty();
}

bool ConvexWindow::holds(FramePoint p) const {
  return !empty() && std::all_of(edges_.begin(), edges_.end(), [&](const Edge& e) { return e.border.distance(p) >= 0; });
}

int turn(FramePoint p, FramePoint q, FramePoint r) {
  // Differences of integers below 2^52 are exact.
  const double qu = q.u - p.u, qv = q.v - p.v, ru = r.u - p.u, rv = r.v - p.v;
  const double l = qu * rv, m = qv * ru;
  const double d = l - m;
  if (std::abs(d) > kTurnError * (std::abs(l) + std::abs(m))) return d > 0 ? 1 : -1;
  const Wide exact = static_cast<Wide>(qu) * static_cast<Wide>(rv) - static_cast<Wide>(qv) * static_cast<Wide>(ru);
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

bool meets(FramePoint p, FramePoint q, const Window& w) {
  if (std::max(p.u, q.u) < w.u0 || std::min(p.u, q.u) > w.u1 || std::max(p.v, q.v) < w.v0 || std::min(p.v, q.v) > w.v1)
    return false;
  if (w.holds(p) || w.holds(q)) return true;
  // The window's corners farthest to either side of the line.
  const bool right = q.u >= p.u, up = q.v >= p.v;
  const FramePoint most{up ? w.u0 : w.u1, right ? w.v1 : w.v0}, least{up ? w.u1 : w.u0, right ? w.v0 : w.v1};
  return turn(p, q, most) >= 0 && turn(p, q, least) <= 0;
}

int winding(FramePoint p, FramePoint q, FramePoint r) {
  if ((p.v <= r.v) == (q.v <= r.v)) return 0;
  const bool up = p.v <= r.v;
  // The side crosses the ray to the right of r if r is to the left of an upward side.
  const int side = turn(p, q, r);
  if (up) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

}  // namespace ligne::warnock
