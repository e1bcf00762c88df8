#pragma once
/// A line on the page and what covers it.

#include <optional>
#include <utility>

#include "oracle/faces.hpp"

namespace oracle {

/// Half the width of a line's cross-section: the micrometre that a drawing owes.
inline constexpr double kMicrometre = 0.001;

/// A segment of the page with coordinates of its own: tau runs along it from 0 to 1, s across it, in micrometres of the page
/// (to a rounding; the axes themselves are exact).
class Line {
 public:
  Line(const PagePoint& a, const PagePoint& b, const Projection& projection);

  PagePoint a, b;
  Exact dx, dy;  ///< b - a
  Exact ox, oy;  ///< one micrometre across

  Point2 a_mm{0, 0}, direction_mm{0, 0};  ///< rounded; the direction has length 1
  double length_mm = 0;
  Box box;

  /// Surely the face lies beside the line, farther than its cross-section reaches: told in doubles with ample room for
  /// roundings, so that nothing exact need be computed.
  bool surely_beside(const Face& face) const;

  Exact tau(const PagePoint& p) const { return ((p.x - a.x) * oy - (p.y - a.y) * ox) / det_; }
  Exact s(const PagePoint& p) const { return (dx * (p.y - a.y) - dy * (p.x - a.x)) / det_; }

 private:
  Exact det_;
};

/// A face in the coordinates of a line.
struct FaceOverLine {
  struct Corner {
    Exact tau, s;
    double tau_rounded = 0, s_rounded = 0;
  };
  const Face* face = nullptr;
  std::vector<Corner> corners;
  // The line's depth behind the face's plane is behind_a + tau (behind_b - behind_a). Below -delta the face is behind the
  // line.
  Exact behind_a, behind_b;
  double delta = 0;

  FaceOverLine(const Face& face, const Line& line);
  /// Finds the corners' places, without which the line can only be asked whether it is before the plane.
  void find_corners(const Line& line);
  Exact behind(const Exact& tau) const { return behind_a + tau * (behind_b - behind_a); }

  /// The parts of the cross-section at tau that the face covers, in order: parts [first, second] of the s axis.
  std::vector<std::pair<Exact, Exact>> cover(double tau) const;
};

/// Places on the line at which something changes: where sides of the face cross the line or come within `reach` micrometres
/// of it, where corners lie that near, and where the line comes to the depths -delta, 0 and delta behind the face. Rounded:
/// a place only says where to cut, what the parts between are told is found out exactly.
void add_changes(const FaceOverLine& face, double reach, std::vector<double>& places);

/// Places where sides of different faces cross each other within `reach` of the line, for sides that stay there for longer
/// than `longest` (a part of the line); shorter ones change nothing that is longer.
void add_crossings(const std::vector<FaceOverLine>& faces, double reach, double longest, std::vector<double>& places);

/// Sorts the places and returns the parts between them that are longer than `shortest`, in order.
std::vector<std::array<double, 2>> parts_between(std::vector<double> places, double shortest);

}  // namespace oracle
