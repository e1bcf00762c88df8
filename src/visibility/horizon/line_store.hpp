#pragma once
/// The visible lines of the sweeps over all parts of a grid.

#include <array>
#include <vector>

#include "visibility/horizon/chains.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne::horizon {

struct LineStore {
  HorizonLines lines;
  Chains outline, border;
  std::vector<Chains> contours, base_contours;  ///< per height
  /// Drawn parts of the curves straight in front of the eye, which two parts of the grid share: the column towards low
  /// and high y, the row towards low and high x.
  std::array<std::vector<Span>, 2> column_ahead, row_ahead;
};

}  // namespace ligne::horizon
