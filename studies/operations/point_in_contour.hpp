#pragma once
/// Point against contour, C_C^P of [Boulle1980] 3.2.2: five ways, over lattice points, with what each of them does counted.
///
/// Contours have no two equal corners one after the other; those of the methods for convex ones turn positively
/// (orientation() > 0). The signs are exact on the lattice, but where a method adds angles, which says so.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne::studies {

enum class Place : std::uint8_t { outside, inside, on_side, on_corner };

/// Counts of the operations of the methods.
struct ContourCounts {
  std::uint64_t sides = 0;        ///< sides looked at
  std::uint64_t signs = 0;        ///< on which side of a line a point lies
  std::uint64_t comparisons = 0;  ///< of coordinates
  std::uint64_t angles = 0;       ///< arc tangents
};

/// Which contours a method may be given. `convex`: it ends as soon as the answer is known of a convex one.
enum class ContourKind : std::uint8_t { any, convex };

/// 3.2.2.1: crossings of a ray with the sides, by parity. Corners on the ray belong to what lies above it, so there are no
/// special cases. A line crosses a convex contour twice at the most: the second crossing that is no corner ends the search.
Place by_crossings(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts,
                   ContourKind kind = ContourKind::any);

/// 3.2.2.2: the angles under which the sides are seen add up to nothing outside. Any contour; in doubles, and what lies on
/// the contour is not told. The sum is monotonous where a convex contour holds the point: an angle of the other sign ends
/// the search.
Place by_angles(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts,
                ContourKind kind = ContourKind::any);

/// 3.2.2.3, Dahan and Le Tuan: on one side of all sides. Convex contours.
Place by_half_planes(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts);

/// 3.2.2.3, the same without an orientation: the point is on the side of Q_i on which the corner behind it lies,
/// Q_i(x) Q_i(x_i+2) > 0. Two signs a side.
Place by_unoriented_half_planes(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts);

/// Decides by triangles: 3 to 2 n - 3 lines.
Place by_triangles(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts);

/// 3.2.2.4, Shamos: the sector of an inner point in which it lies, then one side. Convex contours; prepared once for many
/// points.
class Sectors {
 public:
  explicit Sectors(std::span<const LatticePoint> contour);

  /// By polar angles, as described; in doubles: beside the border of two sectors, and beside the contour, it may err.
  Place by_angle(LatticePoint p, ContourCounts& counts) const;
  /// Decides by signs alone, exact: the first corner stands for the inner point.
  Place by_signs(LatticePoint p, ContourCounts& counts) const;

 private:
  std::vector<LatticePoint> contour_;
  double x_ = 0, y_ = 0;        ///< the inner point
  std::vector<double> angles_;  ///< of the corners about it, rising
  std::size_t first_ = 0;       ///< corner of the least angle
};

/// 3.2.2.5: eight domains round the point, and how many borders of domains the sides pass. `mend`: a side that passes four
/// is looked at for the side on which it passes the point; without it, as in the source, it is turned round.
Place by_codes(std::span<const LatticePoint> contour, LatticePoint p, bool mend, ContourCounts& counts);

}  // namespace ligne::studies
