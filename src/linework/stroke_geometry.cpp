#include "linework/stroke_geometry.hpp"

#include <iterator>
#include <utility>

namespace ligne {

void unite(std::vector<StrokePart>& parts) {
  std::ranges::sort(parts, {}, &StrokePart::from);
  std::size_t last = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].from > parts[last].to) parts[++last] = parts[i];
    parts[last].to = std::max(parts[last].to, parts[i].to);
  }
  if (!parts.empty()) parts.resize(last + 1);
}

/// The part is the hull of the parts in the two discs around the ends of the other stroke and in the strip between
/// them.
StrokePart part_near(const Stroke& bit, const Stroke& line, double reach) {
  const Point2 d = offset(bit.from, bit.to), u = offset(line.from, line.to), start = offset(line.from, bit.from);
  const double square = glm::dot(d, d), length = glm::length(u);
  StrokePart part;
  for (const LatticePoint end : {line.from, line.to}) {
    const Point2 p = offset(bit.from, end);
    const double middle = glm::dot(p, d) / square, beside = std::abs(cross(p, d)) / std::sqrt(square);
    if (beside > reach) continue;
    const double half = std::sqrt((reach - beside) * (reach + beside) / square);
    part.add(middle - half, middle + half);
  }
  if (length == 0) return part;
  // Clips to the fractions at which the distances along and across the other stroke are in range. Both are linear in
  // the fraction.
  StrokePart beside{0, 1};
  beside.keep(glm::dot(start, u) / length, glm::dot(d, u) / length, 0, length);
  beside.keep(cross(start, u) / length, cross(d, u) / length, -reach, reach);
  part.add(beside.from, beside.to);
  return part;
}

double walked_cell(const std::vector<Stroke>& strokes, double wanted) {
  // Adjustable: largest mean number of cells that a stroke crosses, and number of cells that is always permitted.
  constexpr double kCellsPerStroke = 64, kCellsOfFew = 1 << 18;
  // Sum of the sides of cells that a stroke of this extent crosses at most.
  double sum = 0;
  for (const Stroke& s : strokes) sum += std::abs(double(s.to.x) - s.from.x) + std::abs(double(s.to.y) - s.from.y);
  return std::max(wanted, sum / (kCellsPerStroke * static_cast<double>(strokes.size()) + kCellsOfFew));
}

const HiddenPart* hidden_part_at(const StrokeModel& model, std::uint32_t source, double t) {
  const auto begin_of = [](const HiddenPart& part) { return std::pair(part.source, part.t_from); };
  const auto behind = std::ranges::upper_bound(model.hidden_parts, std::pair(source, t), {}, begin_of);
  if (behind == model.hidden_parts.begin()) return nullptr;
  const HiddenPart& part = *std::prev(behind);
  return part.source == source && t <= part.t_to ? &part : nullptr;
}

const HiddenPart* hidden_part_of(const StrokeModel& model, const Stroke& stroke) {
  return stroke.visible ? nullptr : hidden_part_at(model, stroke.source, (stroke.t_from + stroke.t_to) / 2);
}

void leave_out_often_hidden(StrokeModel& model, unsigned most) {
  std::erase_if(model.strokes, [most](const Stroke& s) { return !s.visible && s.level > most; });
}

}  // namespace ligne
