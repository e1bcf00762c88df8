#pragma once
/// Looks up the faces in front of hidden strokes.

#include "linework/stroke.hpp"

namespace ligne {

/// Returns the part of StrokeModel::hidden_parts at the parameter `t` of a source, or null.
const HiddenPart* hidden_part_at(const StrokeModel& model, std::uint32_t source, double t);

/// Returns the part at the middle of a stroke. Null if the stroke is visible or no faces were counted there.
const HiddenPart* hidden_part_of(const StrokeModel& model, const Stroke& stroke);

/// Removes the hidden strokes that more than `most` faces hide. Strokes without a number stay.
void leave_out_often_hidden(StrokeModel& model, unsigned most);

}  // namespace ligne
