#pragma once
/// Point in contour, C_C^P of [Boulle1980] 3.2.2: five methods over lattice points that count their operations.
///
/// No two successive corners are equal. Contours of methods for convex ones turn positively (orientation() > 0). Signs are
/// exact on the lattice; methods that add angles in doubles say so.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne::studies {

enum class Place : std::uint8_t { outside, inside, on_side, on_corner };

/// Counts of the operations of the methods.
struct ContourCounts {
  std::uint64_t sides = 0;        ///< sides visited
  std::uint64_t signs = 0;        ///< tests of a point against a line
  std::uint64_t comparisons = 0;  ///< comparisons of coordinates
  std::uint64_t angles = 0;       ///< computed arc tangents
};

/// Contours that a method accepts. `convex`: the method stops as soon as the answer is certain for a convex contour.
enum class ContourKind : std::uint8_t { any, convex };

/// 3.2.2.1: parity of the crossings of a ray with the sides. Corners on the ray count as above it, so there are no special
/// cases. A line crosses a convex contour at most twice: the second crossing that is no corner ends the search.
Place by_crossings(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts,
                   ContourKind kind = ContourKind::any);

/// 3.2.2.2: the angles subtended by the sides sum to zero outside. Any contour. Computed in doubles; does not detect points
/// on the contour. In a convex contour round the point all angles have one sign: an angle of the other sign ends the search.
Place by_angles(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts,
                ContourKind kind = ContourKind::any);

/// 3.2.2.3, Dahan and Le Tuan: the point is on the inner side of all sides. Convex contours.
Place by_half_planes(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts);

/// 3.2.2.3 for contours of unknown orientation: the point must lie on the side of Q_i on which the next corner lies, Q_i(x)
/// Q_i(x_i+2) > 0. Takes two signs per side.
Place by_unoriented_half_planes(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts);

/// Finds the triangle (0, i, i + 1) that contains the point; tests 3 to 2 n - 3 lines.
Place by_triangles(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts);

/// 3.2.2.4, Shamos: finds the sector of an inner point in which the point lies, then tests one side. Convex contours;
/// prepared once for many points.
class Sectors {
 public:
  explicit Sectors(std::span<const LatticePoint> contour);

  /// By polar angles, as described, in doubles: may err near a sector boundary and near the contour.
  Place by_angle(LatticePoint p, ContourCounts& counts) const;
  /// By signs alone, exact. The first corner serves as the inner point.
  Place by_signs(LatticePoint p, ContourCounts& counts) const;

 private:
  std::vector<LatticePoint> contour_;
  double x_ = 0, y_ = 0;        ///< the inner point
  std::vector<double> angles_;  ///< of the corners about the inner point, ascending
  std::size_t first_ = 0;       ///< corner of the smallest angle
};

/// 3.2.2.5: counts the octants round the point that the sides pass. A side that passes four octants is ambiguous: with
/// `mend` a sign test decides on which side it passes the point; without it the direction follows the source.
Place by_codes(std::span<const LatticePoint> contour, LatticePoint p, bool mend, ContourCounts& counts);

}  // namespace ligne::studies
