#pragma once
/// The part of a line that one facet hides: Appel's elementary operation, on the lattice.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "visibility/common/facet.hpp"

namespace ligne {

/// A candidate line on the page. P(t) = p0 + t (p1 - p0), z(t) = z0 + t (z1 - z0), 0 <= t <= 1.
struct PageLine {
  PageLine(const ProjectedVertex& from, const ProjectedVertex& to, std::uint32_t f0, std::uint32_t f1)
      : p0(from.p),
        p1(to.p),
        z0(from.z),
        z1(to.z),
        face0(f0),
        face1(f1),
        dx(double(p1.x) - p0.x),
        dy(double(p1.y) - p0.y),
        size(std::abs(dx) + std::abs(dy)) {}

  LatticePoint p0, p1;
  double z0, z1;
  std::uint32_t face0, face1;  ///< its own faces, which never hide it
  double dx, dy;               ///< p1 - p0
  double size;                 ///< |dx| + |dy|

  double z(double t) const { return z0 + t * (z1 - z0); }
};

/// The sides of a line that a facet covers. A facet whose side runs exactly along the line covers only one side of it,
/// and a point of a line is hidden only when both sides are covered. So an edge behind the common side of two faces is
/// hidden; one behind the rim of the outermost face is not (it coincides with the rim, and is drawn once).
enum class HiddenSides : std::uint8_t { none, both, left, right };

/// A part of a line, as parameters.
struct ParameterRange {
  double from = 0, to = 1;
};

struct HiddenInterval {
  double from = 0, to = 0;
  HiddenSides sides = HiddenSides::none;
};

/// The signed areas of the triangles between a point of the line and the sides of a facet. Each is linear in the
/// parameter: at_start - t * fall. The area of side i is the weight of corner i + 2.
struct SideAreas {
  double at_start[3], fall[3];
};

/// Narrows [enter, leave], the part of the line over the facet, to the part behind the facet. False if no point of it
/// is farther behind than the depth tolerance.
inline bool narrow_to_behind(const PageLine& line, const Facet& facet, const ProjectedVertex* vertices,
                             const SideAreas& sides, double& enter, double& leave) {
  const double *e0 = sides.at_start, *fall = sides.fall;
  const double area = e0[0] + e0[1] + e0[2];
  const double za = vertices[facet.v[0]].z, zb = vertices[facet.v[1]].z, zc = vertices[facet.v[2]].z;
  const auto behind = [&](double t) {
    const double w2 = e0[0] - t * fall[0], w0 = e0[1] - t * fall[1], w1 = e0[2] - t * fall[2];
    return line.z(t) - (w0 * za + w1 * zb + w2 * zc) / area;
  };
  const double d_enter = behind(enter), d_leave = behind(leave);
  const double tolerance = facet.depth_tolerance;
  if (d_enter <= tolerance && d_leave <= tolerance) return false;
  if (d_enter < -tolerance) {
    enter += (leave - enter) * (d_enter / (d_enter - d_leave));
  } else if (d_leave < -tolerance) {
    leave = enter + (leave - enter) * (d_enter / (d_enter - d_leave));
  }
  return true;
}

/// Finds the interval that the facet hides, for the whole line, and clips it to `part`. The facet must lie in front of
/// the interval, by more than its depth tolerance somewhere. As the interval is that of the whole line, the result does
/// not depend on how the caller divides the line (by cells, by windows or by earlier facets). The ends at which the
/// line enters or leaves the facet are quotients of exact determinants: two facets with a common side give the same end
/// to the last bit. `near_side` is set when a side of the facet lies along the line within `coincidence_steps`.
inline HiddenInterval hidden_interval(const PageLine& line, const Facet& facet, const ProjectedVertex* vertices,
                                      ParameterRange part, double coincidence_steps, bool& near_side) {
  double from = part.from, to = part.to;
  const ProjectedVertex& a = vertices[facet.v[0]];
  const ProjectedVertex& b = vertices[facet.v[1]];
  const ProjectedVertex& c = vertices[facet.v[2]];
  // Corners relative to the line's first point, and f = d x corner, whose sign is the side of the line. All
  // determinants here are exact (geometry/lattice.hpp).
  const double x[3] = {double(a.p.x) - line.p0.x, double(b.p.x) - line.p0.x, double(c.p.x) - line.p0.x};
  const double y[3] = {double(a.p.y) - line.p0.y, double(b.p.y) - line.p0.y, double(c.p.y) - line.p0.y};
  const double f[3] = {line.dx * y[0] - line.dy * x[0], line.dx * y[1] - line.dy * x[1], line.dx * y[2] - line.dy * x[2]};
  // A facet with no corner on one side of the line, and at most one corner on it, is beside it. Before it is dismissed,
  // `near_side` needs a test for a side along the line: a corner is |f| / |d| from the line, and the line at most |f| /
  // |side| from a side.
  const double close = coincidence_steps * std::max<double>(line.size, facet.size);
  const double lowest = std::min({f[0], f[1], f[2]}), highest = std::max({f[0], f[1], f[2]});
  if (lowest > close || highest < -close) return {};
  const bool maybe_near = (std::abs(f[0]) <= close) + (std::abs(f[1]) <= close) + (std::abs(f[2]) <= close) >= 2;
  if (maybe_near) {
    const double limit = coincidence_steps * line.size;
    near_side |= (std::abs(f[0]) <= limit) + (std::abs(f[1]) <= limit) + (std::abs(f[2]) <= limit) >= 2;
  } else if (lowest >= 0 || highest <= 0) {
    return {};
  }

  // The ends of the line against the sides: E_i(p0) = corner_i x corner_(i+1), E_i(p0) - E_i(p1) = f_(i+1) - f_i.
  HiddenSides sides = HiddenSides::both;
  double enter = 0, leave = 1;
  SideAreas areas;
  for (int i = 0; i < 3; ++i) {
    const int k = i == 2 ? 0 : i + 1;
    const double q0 = x[i] * y[k] - y[i] * x[k];
    const double q0_q1 = f[k] - f[i];
    const double q1 = q0 - q0_q1;
    areas.at_start[i] = q0;
    areas.fall[i] = q0_q1;
    if (maybe_near) {
      const double limit = coincidence_steps * (std::abs(x[k] - x[i]) + std::abs(y[k] - y[i]));
      near_side |= std::abs(q0) <= limit && std::abs(q1) <= limit;
    }
    if (q0 <= 0 && q1 <= 0) {
      if (q0 < 0 || q1 < 0) return {};
      sides = (x[k] - x[i]) * line.dx + (y[k] - y[i]) * line.dy > 0 ? HiddenSides::left : HiddenSides::right;
    } else if (q0 < 0) {
      enter = std::max(enter, q0 / q0_q1);
    } else if (q1 < 0) {
      leave = std::min(leave, q0 / q0_q1);
    }
  }
  if (!(std::max(enter, from) < std::min(leave, to))) return {};
  // At both ends the line is inside the facet, and the weights are not negative.
  if (!narrow_to_behind(line, facet, vertices, areas, enter, leave)) return {};
  from = std::max(from, enter);
  to = std::min(to, leave);
  if (!(from < to)) return {};
  return {from, to, sides};
}

}  // namespace ligne
