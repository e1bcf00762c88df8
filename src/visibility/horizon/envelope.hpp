#pragma once
/// The horizon: the highest of the lines taken so far, over every place u across the picture.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "visibility/horizon/columns.hpp"

namespace ligne::horizon {

/// A line over u, from its left to its right end: u0 < u1.
struct Line {
  double u0, v0, u1, v1;
};

/// A part of the u axis.
struct Span {
  double from, to;
};

/// Appends a span, joined to the last one where that ends but for `least`.
inline void append_span(std::vector<Span>& spans, Span span, double least) {
  if (!spans.empty() && span.from - spans.back().to <= least) {
    spans.back().to = std::max(spans.back().to, span.to);
  } else {
    spans.push_back(span);
  }
}

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// The upper horizon as a piecewise linear function that knows the lines that it is made of, so that nothing is lost when it
/// is cut again and again: crossings are computed from the lines themselves. (The lower horizon is the upper one of the
/// lines turned upside down.) The pieces stand in cells of equal width, ascending in each; to take a line costs time with
/// the pieces that it spans.
class ExactEnvelope {
 public:
  /// For lines in [u_min, u_max]. `cells` is best about the number of curves.
  ExactEnvelope(double u_min, double u_max, std::size_t cells);
  /// The horizon over a band: what is found lies in its own columns.
  ExactEnvelope(const Columns& columns, ColumnRange own);

  /// Appends to `above` where the line is higher than the horizon, or where there is none yet: ascending, each as long as
  /// can be.
  void find_above(const Line& line, std::vector<Span>& above);

  /// Finds the parts above; then raises the horizon there.
  void raise(const Line& line, std::vector<Span>& above);

  /// Height of the horizon at u, kNothing where there is none: the higher one where it jumps.
  double height(double u) const;

  /// Its limit from the left (side < 0) or from the right.
  double height_beside(double u, int side) const;

  /// Parts of u no longer than this are rounding.
  double least() const { return least_; }

 private:
  /// A part of a line: over u in [u0, u1] it has the height v + slope (u - u_line).
  struct Piece {
    double u0, u1;
    double u_line, v, slope;
    double height(double u) const { return v + slope * (u - u_line); }
  };

  template <bool kRaise>
  void search(const Line& line, std::vector<Span>& above);
  void find_in_cell(const std::vector<Piece>& cell, const Piece& line, double tolerance);
  void rebuild(std::vector<Piece>& cell, const Piece& line);

  std::vector<Piece>& cell(std::size_t c) { return cells_[c - held_.begin]; }
  const std::vector<Piece>& cell(std::size_t c) const { return cells_[c - held_.begin]; }

  Columns columns_;
  ColumnRange own_, held_;
  double least_;
  std::vector<std::vector<Piece>> cells_;  ///< of the columns held
  std::vector<Span> found_;                ///< scratch: where the line is above, in one cell
  std::vector<Piece> rebuilt_;             ///< scratch
};

/// The upper horizon as an array of heights, one for each of the picture's columns of pixels.
class PixelEnvelope {
 public:
  PixelEnvelope(double u_min, double u_max, std::size_t columns);
  PixelEnvelope(const Columns& columns, ColumnRange own);
  void find_above(const Line& line, std::vector<Span>& above);
  void raise(const Line& line, std::vector<Span>& above);
  double height(double u) const { return heights_[columns_.at(u) - own_.begin]; }
  double height_beside(double u, int) const { return height(u); }
  double least() const { return 0; }

 private:
  template <bool kRaise>
  void search(const Line& line, std::vector<Span>& above);

  Columns columns_;
  ColumnRange own_;
  std::vector<double> heights_;
};

}  // namespace ligne::horizon
