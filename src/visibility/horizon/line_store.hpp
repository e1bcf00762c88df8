#pragma once
/// Where the sweeps over the parts of a grid put what is seen.

#include <array>
#include <vector>

#include "visibility/horizon/chains.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne::horizon {

struct LineStore {
  HorizonLines lines;
  Chains outline, border;
  std::vector<Chains> contours, base_contours;  ///< of each height
  /// The drawn parts of the curves straight before the eye, which two parts share: the column towards low and high y,
  /// the row towards low and high x.
  std::array<std::vector<Span>, 2> column_ahead, row_ahead;
};

}  // namespace ligne::horizon
