#include "plotting/dashes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Adds the dashes of a line. The pattern is dashes and gaps in turn, and begins at `offset`.
void cut_line(Polylines& out, std::span<const Point2> line, std::span<const double> pattern, double offset) {
  std::size_t part = 0;
  double left = pattern[0];
  // A dash of no length at the beginning is a dot.
  while (offset > left || (offset == left && left > 0)) {
    offset -= left;
    part = (part + 1) % pattern.size();
    left = pattern[part];
  }
  left -= offset;
  bool drawing = part % 2 == 0;
  if (drawing) out.points.push_back(line[0]);
  const auto end_stroke = [&] {
    if (out.points.size() - out.begin.back() == 1) out.points.push_back(out.points.back());
    if (out.points.size() > out.begin.back()) out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double segment = glm::distance(line[i - 1], line[i]);
    double at = 0;
    while (segment - at > left) {
      at += left;
      const Point2 p = line[i - 1] + (line[i] - line[i - 1]) * (at / segment);
      out.points.push_back(p);
      if (drawing) end_stroke();
      drawing = !drawing;
      if (!drawing) out.points.resize(out.begin.back());
      part = (part + 1) % pattern.size();
      left = pattern[part];
    }
    left -= segment - at;
    if (drawing) out.points.push_back(line[i]);
  }
  if (drawing) {
    end_stroke();
  } else {
    out.points.resize(out.begin.back());
  }
}

}  // namespace

Polylines cut_pattern(const Polylines& lines, std::span<const double> lengths_mm, double offset_mm) {
  std::vector<double> pattern(lengths_mm.begin(), lengths_mm.end());
  if (pattern.size() % 2 == 1) pattern.insert(pattern.end(), lengths_mm.begin(), lengths_mm.end());
  const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
  if (pattern.empty() || !(period >= kShortestPatternMm) || !std::isfinite(period)) return lines;
  double offset = std::fmod(offset_mm, period);
  if (offset < 0) offset += period;
  if (!(offset < period)) offset = 0;
  Polylines out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].empty()) cut_line(out, lines[i], pattern, offset);
  }
  return out;
}

Polylines cut_dashes(const Polylines& lines, std::span<const double> dashes_mm, double pen_width_mm) {
  const double period = std::accumulate(dashes_mm.begin(), dashes_mm.end(), 0.0);
  if (dashes_mm.size() < 2 || dashes_mm.size() % 2 == 1 || !(period >= kShortestPatternMm)) return lines;
  std::vector<double> drawn;
  for (std::size_t i = 0; i < dashes_mm.size(); i += 2) {
    const double tip = std::min(pen_width_mm, dashes_mm[i]);
    drawn.push_back(dashes_mm[i] - tip);
    drawn.push_back(dashes_mm[i + 1] + tip);
  }
  Polylines out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (line.empty()) continue;
    // The number of whole patterns that, with one more dash, come nearest to the length of the line.
    const double wanted = path_length(line);
    const double patterns = std::round((wanted - drawn[0]) / period);
    if (patterns < 1) {
      out.add(line);
      continue;
    }
    const double stretch = wanted / (patterns * period + drawn[0]);
    std::vector<double> pattern(drawn);
    for (double& part : pattern) part *= stretch;
    cut_line(out, line, pattern, 0);
  }
  return out;
}

}  // namespace ligne
