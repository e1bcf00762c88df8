#pragma once
/// Lengths of the lines of a picture, by class.

#include "picture/scene_visibility.hpp"
#include "support/test.hpp"

namespace ligne::test {

/// Drawn length of each class, mm.
using Lengths = std::array<double, kLineClassCount>;

inline double length_of_all(const Lengths& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

/// Only visible strokes, or hidden ones too where the request has them drawn.
inline Lengths drawn_lengths(const Scene& scene, const PictureRequest& request) {
  RunReport run;
  PreparedScene prepared = prepare(scene, request, std::nullopt, run);
  SceneVisibility found = compute_visibility(prepared, std::nullopt, false, run);
  finish_lines(found, prepared, run);
  const StrokeModel& model = *found.result.strokes;
  Lengths sum{};
  for (const Stroke& s : model.strokes)
    if (s.visible || request.lines.hidden != HiddenLines::none)
      sum[static_cast<std::size_t>(s.line_class)] += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
  return sum;
}

}  // namespace ligne::test
