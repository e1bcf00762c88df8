#include "linework/map/line_cells.hpp"

namespace ligne {

double walked_cell(const std::vector<Stroke>& strokes, double wanted) {
  // Adjustable: largest mean number of cells that a stroke crosses, and number of cells that is always permitted.
  constexpr double kCellsPerStroke = 64, kCellsOfFew = 1 << 18;
  // Sum of the sides of cells that a stroke of this extent crosses at most.
  double sum = 0;
  for (const Stroke& s : strokes) sum += std::abs(double(s.to.x) - s.from.x) + std::abs(double(s.to.y) - s.from.y);
  return std::max(wanted, sum / (kCellsPerStroke * static_cast<double>(strokes.size()) + kCellsOfFew));
}

}  // namespace ligne
