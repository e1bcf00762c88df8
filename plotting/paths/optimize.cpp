#include "plotting/paths/optimize.hpp"

#include <glm/geometric.hpp>

namespace ligne {

std::vector<std::uint32_t> long_strokes(const Polylines& lines, double min_length_mm) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (path_length(lines[i]) >= min_length_mm) kept.push_back(i);
  }
  return kept;
}

Polylines picked(const Polylines& lines, std::span<const std::uint32_t> numbers) {
  Polylines some;
  for (const std::uint32_t i : numbers) some.add(lines[i]);
  return some;
}

Polylines optimize_paths(const Polylines& lines, const PathOptions& options) {
  const bool joins = options.optimize == Optimize::join || options.optimize == Optimize::full,
             orders = options.optimize == Optimize::order || options.optimize == Optimize::full;
  Polylines strokes = joins ? join_strokes(lines, options.tolerances) : lines;
  if (options.min_length_mm > 0) strokes = picked(strokes, long_strokes(strokes, options.min_length_mm));
  return orders ? order_strokes(strokes, options.order) : strokes;
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
    lengths.down_mm += path_length(line);
    pen = line.back();
  }
  if (returns && lengths.strokes > 0) lengths.up_mm += glm::distance(pen, home);
  return lengths;
}

}  // namespace ligne
