#pragma once
/// Makes lines on the page from the visible parts of the edges of one part of the grid, in the order of the edges.

#include <vector>

#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/line_store.hpp"
#include "visibility/horizon/upright_lines.hpp"

namespace ligne::horizon {

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
