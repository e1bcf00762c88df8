#pragma once
/// Strokes of curves that were studied as lines of their own.

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "contours/contour_states.hpp"
#include "drawing/stroke.hpp"
#include "view/view.hpp"

namespace ligne {

/// Takes the strokes of `count` sources from `first` on out of the model, in the order of their sources.
std::vector<Stroke> take_strokes(StrokeModel& model, std::uint32_t first, std::size_t count);

/// The sources of curves in a model: `first` + i is a segment that was studied at the line lines[i], beside the curve.
struct ContourSources {
  std::uint32_t first = 0;
  std::vector<std::uint32_t> lines;
};

/// Adds strokes to a model, with sources of their own behind the intersections. It refers to its arguments.
class CurveWriter {
 public:
  CurveWriter(StrokeModel& model, const View& view, bool hidden_too, double longest_fold_mm);

  /// The sources of all that was added.
  ContourSources take_sources() { return std::move(sources_); }

  /// The runs of a curve of so many segments. The first segment was studied at `first_line`; source_of(segment) says where
  /// it lies.
  void add(LineClass line_class, std::size_t segments, std::uint32_t first_line, const ContourCurve& curve,
           const std::vector<ContourRun>& runs, const std::function<SourceEdge(std::size_t)>& source_of);

 private:
  void add_stroke(LineClass line_class, const CurvePoint& from, const CurvePoint& to, int state, std::uint32_t source,
                  double segment);

  StrokeModel& model_;
  ContourSources sources_;
  const View& view_;
  bool hidden_too_;
  double longest_fold_mm_;
};

}  // namespace ligne
