#include "drawing/hidden_parts.hpp"

#include <algorithm>
#include <utility>

namespace ligne {

const HiddenPart* hidden_part_at(const StrokeModel& model, std::uint32_t source, double t) {
  const auto begins_behind = [](const std::pair<std::uint32_t, double>& at, const HiddenPart& part) {
    return at < std::pair(part.source, part.t_from);
  };
  const auto behind =
      std::upper_bound(model.hidden_parts.begin(), model.hidden_parts.end(), std::pair(source, t), begins_behind);
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
