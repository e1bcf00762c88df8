#pragma once
/// Holds drawn segments against expected ones, on the page.

#include "geometry/point.hpp"
#include "linework/stroke.hpp"
#include "support/standard.hpp"

namespace ligne::test {

struct PageSegment {
  Point2 from{0, 0}, to{0, 0};  ///< page mm
  double z_from = 0, z_to = 0;  ///< depths at the ends; linear in between
  LineClass line_class = LineClass::mesh;
  bool visible = true;
  std::string label{};  ///< stands in messages
};

/// How far a drawn segment may be from the expected one, in page mm; see tolerance_of_lattice().
struct CompareTolerance {
  double line = 0;   ///< across the line
  double end = 0;    ///< along it, at an end
  double depth = 0;  ///< in depth, on a line that faces the viewer; on others more, by their slope
};

/// Distances that the lattice leaves open. With r = step / sqrt(2), the farthest that rounding moves a point:
/// - across: a stroke lies on the line between its rounded vertices, which is within r of the true one, and its ends are
///   rounded once more: 2 r.
/// - along: an end is where two lines cross that are each within r of the true ones. At an angle of sine s their crossing is
///   within 2 r / s of the true one, and is rounded: 2 r / s + r. The answers keep s >= kLeastCrossingSine. An end where
///   a line pierces a face is where depths agree that are known up to the face's change of depth over one step; the answers
///   keep lines steep against the faces that they pierce, so that the same bound holds.
/// - in depth: kDepthMm. Of lines that coincide on the page it tells which one stands for all.
CompareTolerance tolerance_of_lattice(double step_mm);

/// Sine of the least angle on the page at which a line ends at another one in an answer: 30 degrees.
inline constexpr double kLeastCrossingSine = 0.5;
/// The accuracy that a drawing owes. Lines of the answers that coincide on the page are millimetres apart in depth.
inline constexpr double kDepthMm = 0.001;

/// Pairs of segments that lie on each other, whatever their classes, one message each.
std::vector<std::string> overlaps(const std::vector<PageSegment>& segments, const CompareTolerance& tolerance);

/// Compares as sets: every expected segment is covered by drawn ones of its class and visibility from end to end, every
/// drawn one lies on an expected one, no two drawn ones lie on each other. It does not matter into how many pieces a line is
/// cut, nor which way they run. One message for each difference; none when the two agree.
std::vector<std::string> differences(const std::vector<PageSegment>& expected, const std::vector<PageSegment>& drawn,
                                     const CompareTolerance& tolerance);

}  // namespace ligne::test
