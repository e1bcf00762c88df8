#pragma once
/// The horizon of a surface with holes. It is not a function of u, as lines behind a hole are visible through it: at
/// every u the covered places are any number of intervals of v.

#include <array>
#include <vector>

#include "visibility/horizon/envelope.hpp"

namespace ligne::horizon {

/// A union of triangles of the drawing plane, stored as bands between two lines over a range of u. No two bands
/// overlap. A band keeps its original lines, as in ExactEnvelope. Cells of equal width hold the bands.
class Coverage {
 public:
  /// For a band of columns: results lie in its own columns.
  Coverage(const Columns& columns, ColumnRange own);

  struct Corner {
    double u, v;
  };
  /// Adds a triangle.
  void cover(std::array<Corner, 3> corners);

  /// Appends the uncovered parts of the line, ascending, each as long as possible. A part level with the rim of a band
  /// counts as covered.
  void find_uncovered(const Line& line, std::vector<Span>& uncovered);

  /// Finds the covered parts of an upright line from (u, v0) to (u, v1), v0 < v1, on its left (side < 0) or its right
  /// side; appends them to `covered` as spans of v, in any order.
  void find_covered_beside(double u, double v0, double v1, int side, std::vector<Span>& covered) const;

  /// Sorts `covered`, and appends the rest of [from, to] to `uncovered`, except parts no longer than `least`. A part
  /// that begins at the end of the last span extends that span.
  static void append_uncovered(double from, double to, double least, std::vector<Span>& covered,
                               std::vector<Span>& uncovered);

  /// Length up to which a part is only rounding.
  double least() const { return least_; }

 private:
  /// A straight rim: at u it has the height v + slope (u - u_line).
  struct Rim {
    double u_line, v, slope;
    double height(double u) const { return v + slope * (u - u_line); }
    friend bool operator==(const Rim&, const Rim&) = default;
  };
  struct Band {
    double u0, u1;
    Rim lower, upper;
  };

  double tolerance(const Rim& rim) const;
  void cover_between(double u0, double u1, const Rim& lower, const Rim& upper);
  void add(std::vector<Band>& cell, const Band& band);
  void add_over(double from, double to, Band band, const std::vector<Band>& touched);
  void put(const Band& band);

  Columns columns_;
  ColumnRange own_, held_;
  double least_;
  std::vector<std::vector<Band>> cells_;  ///< of the columns in held_
  std::vector<Band> touched_, added_;     ///< scratch
  std::vector<double> cuts_;              ///< scratch
  std::vector<Span> hidden_;              ///< scratch
};

}  // namespace ligne::horizon
