#pragma once
/// The horizon in general, where it is no function of u: behind holes of the surface one sees through it. What is covered
/// is, at every u, any number of intervals of v.

#include <array>
#include <cstddef>
#include <vector>

#include "visibility/horizon/envelope.hpp"

namespace ligne::horizon {

/// A union of triangles of the drawing plane, as bands between two lines over a range of u. No two bands overlap; a band
/// keeps the lines that it is made of, as in ExactEnvelope, and the bands stand in cells of equal width.
class Coverage {
 public:
  /// For triangles in [u_min, u_max].
  Coverage(double u_min, double u_max, std::size_t cells);
  /// Over a band of columns: what is found lies in its own.
  Coverage(const Columns& columns, ColumnRange own);

  struct Corner {
    double u, v;
  };
  /// Adds a triangle.
  void cover(std::array<Corner, 3> corners);

  /// Appends where the line is not covered: ascending, each as long as can be. What is level with the rim of a band is
  /// covered.
  void find_uncovered(const Line& line, std::vector<Span>& uncovered);

  /// Finds the cover of an upright line from (u, v0) to (u, v1), v0 < v1, looking at what covers its left (side < 0) or
  /// right side; appends to `covered` spans of v, in any order.
  void find_covered_beside(double u, double v0, double v1, int side, std::vector<Span>& covered) const;

  /// Sorts `covered`, and appends the parts that it leaves of [from, to], but for parts no longer than `least`; a span
  /// continues the last one that ends where it begins.
  static void append_uncovered(double from, double to, double least, std::vector<Span>& covered,
                               std::vector<Span>& uncovered);

  /// Parts no longer than this are rounding.
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
  std::vector<std::vector<Band>> cells_;  ///< of the columns held
  std::vector<Band> touched_, added_;     ///< scratch
  std::vector<double> cuts_;              ///< scratch
  std::vector<Span> hidden_;              ///< scratch
};

}  // namespace ligne::horizon
