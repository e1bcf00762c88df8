#include "plotting/paths/optimize.hpp"

#include <glm/geometric.hpp>

namespace ligne {

Polylines optimize_paths(const Polylines& lines, const PathOptions& options) {
  if (options.optimize == Optimize::off) return lines;
  if (options.optimize == Optimize::order) return order_strokes(lines, options.order);
  Polylines joined = join_strokes(lines, options.tolerances);
  return options.optimize == Optimize::full ? order_strokes(joined, options.order) : joined;
}

double PathPace::seconds(const PathLengths& lengths) const {
  return lengths.down_mm / down_mm_s + lengths.up_mm / up_mm_s + static_cast<double>(lengths.strokes) * lift_s;
}

PathLengths& PathLengths::operator+=(const PathLengths& other) {
  strokes += other.strokes;
  down_mm += other.down_mm;
  up_mm += other.up_mm;
  return *this;
}

PathLengths measure(const Polylines& lines, Point2 home, bool returns) {
  PathLengths lengths;
  Point2 pen = home;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (line.empty()) continue;
    ++lengths.strokes;
    lengths.up_mm += glm::distance(pen, line.front());
    for (std::size_t k = 1; k < line.size(); ++k) lengths.down_mm += glm::distance(line[k - 1], line[k]);
    pen = line.back();
  }
  if (returns && lengths.strokes > 0) lengths.up_mm += glm::distance(pen, home);
  return lengths;
}

}  // namespace ligne
