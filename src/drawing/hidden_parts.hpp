#pragma once
/// Looks up the faces before hidden strokes.

#include "linework/stroke.hpp"

namespace ligne {

/// The part of StrokeModel::hidden_parts that holds the parameter `t` of a source; null where there is none.
const HiddenPart* hidden_part_at(const StrokeModel& model, std::uint32_t source, double t);

/// The part that holds the middle of a stroke. Null if the stroke is visible, or if nothing was counted there.
const HiddenPart* hidden_part_of(const StrokeModel& model, const Stroke& stroke);

/// Removes the hidden strokes that more than `most` faces hide. Strokes without a number stay.
void leave_out_often_hidden(StrokeModel& model, unsigned most);

}  // namespace ligne
