#pragma once
/// An order of painting against the oracle, at points of the page.

#include "support/judge.hpp"

namespace ligne::test {

struct OrderVerdict {
  std::string faults;  ///< empty when there is none
  int points = 0;      ///< that were asked
  int covered = 0;     ///< points with two faces or more
};

/// At random points of pieces the faces painted there are all that are there, each once, at their depths, the farthest
/// first. Points nearer than two micrometres to a side or a cut are not asked; faces that differ less than half a micrometre
/// in depth touch or cross there.
OrderVerdict check_order(const PaintOrder& order, const oracle::Oracle& oracle, unsigned seed, int points);

}  // namespace ligne::test
