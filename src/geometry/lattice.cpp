#include "geometry/lattice.hpp"

#include <algorithm>

namespace ligne {
namespace {

/// Smallest extent of a page that sets the lattice, in millimetres: a picometre keeps the step a normal number.
constexpr double kLeastExtentMm = 1e-9;

}  // namespace

Lattice Lattice::covering(const Rect& page_mm, int margin_steps) {
  Lattice lattice;
  if (page_mm.empty()) return lattice;
  const double half = std::max({page_mm.width(), page_mm.height(), kLeastExtentMm}) / 2;
  // One step of slack on every side keeps rounded coordinates within the limit; another allows for the rounding of the
  // origin.
  const int exponent = static_cast<int>(std::ceil(std::log2(half / (kLatticeLimit - 2 - margin_steps))));
  lattice.step_mm = std::ldexp(1.0, exponent);
  const Point2 centre = (page_mm.min + page_mm.max) * 0.5;
  lattice.origin_mm = {std::round(centre.x / lattice.step_mm) * lattice.step_mm,
                       std::round(centre.y / lattice.step_mm) * lattice.step_mm};
  return lattice;
}

LatticePoint Lattice::snap(Point2 mm) const {
  constexpr double limit = kLatticeLimit;
  const double x = std::clamp((mm.x - origin_mm.x) / step_mm, -limit, limit);
  const double y = std::clamp((mm.y - origin_mm.y) / step_mm, -limit, limit);
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}

}  // namespace ligne
