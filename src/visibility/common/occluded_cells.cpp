#include "visibility/common/occluded_cells.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

/// Parameter at which a line with component `d` reaches the next border of a square.
double next_border(std::int64_t cell, std::int64_t first, std::int64_t size, double origin, double d) {
  const double border = static_cast<double>(first + (cell + (d > 0 ? 1 : 0)) * size);
  return (border - origin) / d;
}

/// Calls visit(number, from, to) for the squares along a part of a line, in order.
template <class Visit>
void for_each_square(const PageSquares& squares, const PageLine& line, double from, double to, Visit visit) {
  const auto column_at = [&](double t) { return squares.column_of(std::lround(std::floor(line.p0.x + t * line.dx))); };
  const auto row_at = [&](double t) { return squares.row_of(std::lround(std::floor(line.p0.y + t * line.dy))); };
  std::int64_t column = column_at(from), row = row_at(from);
  const std::int64_t last_column = column_at(to), last_row = row_at(to);
  for (double t = from;;) {
    const double x = column == last_column ? to : next_border(column, squares.x, squares.size, line.p0.x, line.dx);
    const double y = row == last_row ? to : next_border(row, squares.y, squares.size, line.p0.y, line.dy);
    const bool across = column != last_column && (row == last_row || x <= y), down = !across && row != last_row;
    const double next = std::clamp(across ? x : down ? y : to, t, to);
    visit(squares.number(column, row), t, next);
    if (!across && !down) return;
    t = next;
    if (across) column += last_column > column ? 1 : -1;
    if (down) row += last_row > row ? 1 : -1;
  }
}

}  // namespace

void OccludedCells::take_from(std::vector<LinePart>& parts, const PageLine& line) const {
  thread_local std::vector<LinePart> left;
  left.clear();
  for (const LinePart& part : parts) {
    const std::size_t first = left.size();
    for_each_square(squares, line, part.from, part.to, [&](std::size_t square, double from, double to) {
      if (blank[square] || !(from < to)) return;
      if (left.size() > first && left.back().to == from) {
        left.back().to = to;
      } else {
        left.push_back({from, to, part.level});
      }
    });
  }
  parts.swap(left);
}

}  // namespace ligne
