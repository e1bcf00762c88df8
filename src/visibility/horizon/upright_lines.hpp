#pragma once
/// The drawn parts of upright lines. In a view along an axis a whole curve, with every rim behind a hole, lies on one
/// upright line of the picture; a part that is visible twice is drawn once.

#include <cstddef>
#include <vector>

#include "visibility/horizon/columns.hpp"
#include "visibility/horizon/envelope.hpp"

namespace ligne::horizon {

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

}  // namespace ligne::horizon
