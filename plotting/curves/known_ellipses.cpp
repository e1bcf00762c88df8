#include "plotting/curves/known_ellipses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ligne {
namespace {

/// Number of cells along the page. Adjustable.
constexpr double kCells = 32;

double side_of(const Rect& page) { return std::max(page.width(), page.height()); }

/// The lattice of a page, and of the chords that leave it.
Lattice lattice_around(const Rect& page) {
  const Point2 margin(side_of(page));
  return Lattice::covering({page.min - margin, page.max + margin});
}

/// Least and largest number of chords of an ellipse.
constexpr double kLeastChords = 8, kMostChords = 4096;

}  // namespace

KnownEllipses::KnownEllipses(std::vector<Ellipse> ellipses, const Rect& page)
    : ellipses_(std::move(ellipses)), lattice_(lattice_around(page)), cells_(side_of(page) / kCells / lattice_.step_mm) {
  for (std::uint32_t i = 0; i < ellipses_.size(); ++i) file(i, page);
}

/// Files the chords of an ellipse that may meet the page, about one for each cell that it passes.
void KnownEllipses::file(std::uint32_t ellipse, const Rect& page) {
  const Ellipse& e = ellipses_[ellipse];
  const double cell_mm = side_of(page) / kCells;
  const double count = std::clamp(std::ceil(2 * std::numbers::pi * e.radii.x / cell_mm), kLeastChords, kMostChords);
  const double step = 2 * std::numbers::pi / count, rise_mm = e.radii.x * (1 - std::cos(step / 2));
  rise_mm_ = std::max(rise_mm_, rise_mm);
  const Point2 margin(rise_mm + kNearMm);
  const EllipseFrame frame(e);
  Point2 from, to = frame.point_at(0);
  for (double k = 0; k < count; ++k) {
    Rect chord;
    from = std::exchange(to, frame.point_at((k + 1) * step));
    for (const Point2 p : {from, to}) chord.extend(p - margin), chord.extend(p + margin);
    const bool is_outside =
        chord.max.x < page.min.x || chord.max.y < page.min.y || chord.min.x > page.max.x || chord.min.y > page.max.y;
    if (!is_outside) cells_.insert(ellipse, lattice_.snap(from), lattice_.snap(to));
  }
}

std::vector<std::uint32_t> KnownEllipses::near(Point2 p) const {
  std::vector<std::uint32_t> found;
  const LatticePoint at = lattice_.snap(p);
  cells_.near(at, at, (kNearMm + rise_mm_) / lattice_.step_mm, [&](std::uint32_t i) {
    found.push_back(i);
    return false;
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ligne
