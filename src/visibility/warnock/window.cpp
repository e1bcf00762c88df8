#include "visibility/warnock/window.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::warnock {
namespace {

__extension__ typedef __int128 Wide;

/// Relative error bound of two products and their difference, each with an error of 2^-53. Below it the sign is uncertain.
constexpr double kTurnError = 0x1p-51;

}  // namespace

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
