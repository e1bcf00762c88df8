#pragma once
/// The part of a line that one facet hides: Appel's elementary operation, on the lattice.

#include <cmath>
#include <cstdint>

#include "visibility/appel/facet.hpp"

namespace ligne::appel {

/// A candidate line on the page. P(t) = p0 + t (p1 - p0), z(t) = z0 + t (z1 - z0), 0 <= t <= 1.
struct Line {
  LatticePoint p0, p1;
  double z0 = 0, z1 = 0;
  std::uint32_t face0 = kNone, face1 = kNone;  ///< its own faces, which never hide it

  double z(double t) const { return z0 + t * (z1 - z0); }
};

/// What a facet does to a line. A facet whose side runs exactly along the line covers only one bank of it: a point of a line
/// is hidden when both of its banks are covered, so that an edge behind the common side of two faces is hidden, and one
/// behind the rim of the outermost face is not (it lies on the rim, and is drawn once).
enum class Bank : std::uint8_t { none, both, left, right };

struct HiddenInterval {
  double from = 0, to = 0;
  Bank bank = Bank::none;
};

/// The part of [from, to] on which the facet lies strictly in front of the line, by more than its touching tolerance
/// somewhere. The ends at which the line enters or leaves the facet are quotients of exact determinants: two facets on one
/// side give the same end to the last bit.
/// `near_side` is set when a side of the facet lies along the line within `coincidence_steps`.
inline HiddenInterval hidden_interval(const Line& line, const Facet& facet, const ProjectedVertex* vertices, double from,
                                      double to, double coincidence_steps, bool& near_side) {
  const ProjectedVertex& a = vertices[facet.v[0]];
  const ProjectedVertex& b = vertices[facet.v[1]];
  const ProjectedVertex& c = vertices[facet.v[2]];
  const LatticePoint corners[4] = {a.p, b.p, c.p, a.p};
  const double dx = double(line.p1.x) - line.p0.x, dy = double(line.p1.y) - line.p0.y;

  // The corners against the line: all on one side of it, and the facet is beside it. Two corners close to it, and a side
  // of the facet lies along it.
  double f[3];
  const double close = coincidence_steps * (std::abs(dx) + std::abs(dy));
  int left = 0, right = 0, at = 0;
  for (int i = 0; i < 3; ++i) {
    f[i] = dx * (double(corners[i].y) - line.p0.y) - dy * (double(corners[i].x) - line.p0.x);
    left += f[i] > 0;
    right += f[i] < 0;
    at += std::abs(f[i]) <= close;
  }
  if (at >= 2) near_side = true;
  if ((left == 0 || right == 0) && left + right == 3 && at == 0) return {};

  // The line against the sides.
  Bank bank = Bank::both;
  double e0[3], e1[3];
  for (int i = 0; i < 3; ++i) {
    const double sx = double(corners[i + 1].x) - corners[i].x, sy = double(corners[i + 1].y) - corners[i].y;
    const double q0 = sx * (double(line.p0.y) - corners[i].y) - sy * (double(line.p0.x) - corners[i].x);
    const double q1 = sx * (double(line.p1.y) - corners[i].y) - sy * (double(line.p1.x) - corners[i].x);
    e0[i] = q0;
    e1[i] = q1;
    const double close_to_side = coincidence_steps * (std::abs(sx) + std::abs(sy));
    if (std::abs(q0) <= close_to_side && std::abs(q1) <= close_to_side) near_side = true;
    if (q0 <= 0 && q1 <= 0) {
      if (q0 < 0 || q1 < 0) return {};
      bank = sx * dx + sy * dy > 0 ? Bank::left : Bank::right;
    } else if (q0 < 0) {
      const double t = q0 / (q0 - q1);
      if (t > from) from = t;
    } else if (q1 < 0) {
      const double t = q0 / (q0 - q1);
      if (t < to) to = t;
    }
  }
  if (!(from < to)) return {};
  // Depth of the line behind the facet at both ends, where it is inside the facet and the weights are not negative.
  const double area = e0[0] + e0[1] + e0[2];
  const auto behind = [&](double t) {
    const double w2 = e0[0] + t * (e1[0] - e0[0]), w0 = e0[1] + t * (e1[1] - e0[1]), w1 = e0[2] + t * (e1[2] - e0[2]);
    return line.z(t) - (w0 * a.z + w1 * b.z + w2 * c.z) / area;
  };
  const double d_from = behind(from), d_to = behind(to);
  const double touch = facet.touch;
  if (d_from <= touch && d_to <= touch) return {};
  if (d_from < -touch) {
    from += (to - from) * (d_from / (d_from - d_to));
  } else if (d_to < -touch) {
    to = from + (to - from) * (d_from / (d_from - d_to));
  }
  return {from, to, bank};
}

}  // namespace ligne::appel
