#pragma once
/// Makes lines on the page from the visible parts of the edges of one part of the grid, in the order of the edges.

#include <array>
#include <cstddef>
#include <vector>

#include "drawing/drawing.hpp"
#include "visibility/horizon/columns.hpp"
#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne::horizon {

/// The drawn parts of upright lines. In a view along an axis a whole curve, with every rim behind a hole, lies on one
/// upright line of the picture; a part that is visible twice is drawn once.
class UprightLines {
 public:
  /// `least`: largest distance between lines that count as one, and length up to which a part is only rounding.
  UprightLines(const Columns& columns, double least) : columns_(columns), least_(least), cells_(columns.count()) {}

  /// Removes the parts drawn at u from `spans` (of v, ascending), and remembers the rest as drawn.
  void draw(double u, std::vector<Span>& spans);

  /// The parts drawn at u: ascending, none touching another.
  std::vector<Span>& drawn_at(double u);

 private:
  struct Upright {
    double u;
    std::vector<Span> drawn;
  };

  Columns columns_;
  double least_;
  std::vector<std::vector<Upright>> cells_;
  std::vector<Span> open_;  ///< scratch
};

/// The visible lines of the sweeps over all parts of a grid.

/// Collects short segments on the page, and joins them to polylines at the end.
class Chains {
 public:
  explicit Chains(const Rect& page_mm) { model_.lattice = Lattice::covering(page_mm); }

  void add(Point2 a, Point2 b) {
    Stroke stroke{.from = model_.lattice.snap(a), .to = model_.lattice.snap(b)};
    if (!(stroke.from == stroke.to)) model_.strokes.push_back(stroke);
  }

  Polylines finish() {
    Drawing drawing = make_drawing(model_);
    return drawing.layers.empty() ? Polylines{} : std::move(drawing.layers.front().lines);
  }

 private:
  StrokeModel model_;
};

struct LineStore {
  HorizonLines lines;
  Chains outline, border;
  std::vector<Chains> contours, base_contours;  ///< per height
  /// Drawn parts of the curves straight in front of the eye, which two parts of the grid share: the column towards low
  /// and high y, the row towards low and high x.
  std::array<std::vector<Span>, 2> column_ahead, row_ahead;
};

class PartLines {
 public:
  /// `least`: largest gap over which spans of two bands are joined.
  PartLines(const Eye& eye, const Columns& columns, double least, LineStore& store);

  /// Takes the visible parts of a strip that the bands found.
  void add(EdgeList& list);

  UprightLines& upright_lines() { return upright_lines_; }

 private:
  const std::vector<Span>& seen(const EdgeList& list, std::uint32_t number);
  void emit(const HorizonEdge& edge, const std::vector<Span>& seen);

  const Eye& eye_;
  double upright_, least_;
  LineStore& store_;
  UprightLines upright_lines_;
  std::vector<std::size_t> taken_;          ///< per band: number of its spans taken
  std::vector<Span> above_, below_, seen_;  ///< scratch
};

}  // namespace ligne::horizon
