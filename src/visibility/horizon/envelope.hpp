#pragma once
/// The horizon: at every place u across the picture, the greatest height of the lines so far.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "visibility/horizon/columns.hpp"

namespace ligne::horizon {

/// Length on the u axis below which a span is only rounding, as a fraction of the picture's width.
inline constexpr double kLeastPart = 0x1p-42;

/// Largest difference of heights that count as level, as a fraction of the picture's size: a height carries a dozen
/// roundings. Heights of one line at places within this distance are level, too.
inline constexpr double kLevelPart = 0x1p-44;

/// A line over u, from its left to its right end: u0 < u1.
struct Line {
  double u0, v0, u1, v1;
};

/// A part of the u axis.
struct Span {
  double from, to;
};

/// Appends a span, or joins it to the last one if the gap between them is at most `least`.
inline void append_span(std::vector<Span>& spans, Span span, double least) {
  if (!spans.empty() && span.from - spans.back().to <= least) {
    spans.back().to = std::max(spans.back().to, span.to);
  } else {
    spans.push_back(span);
  }
}

/// Extends spans of a line that miss an end of it only by rounding, so that they continue in the next line.
inline void extend_to_ends(std::span<Span> spans, const Line& line, double least) {
  if (spans.empty()) return;
  if (spans.front().from - line.u0 <= least) spans.front().from = line.u0;
  if (line.u1 - spans.back().to <= least) spans.back().to = line.u1;
}

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// The upper horizon as a piecewise linear function. Its pieces keep their original lines, and crossings are computed
/// from these, so repeated cuts lose no precision. (The lower horizon is the upper one of the lines turned upside
/// down.) Cells of equal width hold the pieces, in ascending order; the time to take a line grows with the number of
/// pieces that it spans.
class ExactEnvelope {
 public:
  /// For a band of columns: results lie in its own columns. The best number of columns is about the number of curves.
  ExactEnvelope(const Columns& columns, ColumnRange own);

  /// Appends to `above` the parts of the line that are higher than the horizon, or where there is none yet: ascending,
  /// each as long as possible.
  void find_above(const Line& line, std::vector<Span>& above);

  /// Finds the parts above, then raises the horizon there.
  void raise(const Line& line, std::vector<Span>& above);

  /// Height of the horizon at u, kNothing where there is none: the higher one where it jumps.
  double height(double u) const;

  /// Limit of the height at u from the left (side < 0) or from the right.
  double height_beside(double u, int side) const;

  /// Length along u up to which a part is only rounding.
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
  std::vector<std::vector<Piece>> cells_;  ///< of the columns in held_
  std::vector<Span> found_;                ///< scratch: where the line is above, in one cell
  std::vector<Piece> rebuilt_;             ///< scratch
};

/// The upper horizon as an array of heights, one for each of the picture's columns of pixels.
class PixelEnvelope {
 public:
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
