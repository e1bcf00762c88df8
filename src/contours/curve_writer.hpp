#pragma once
/// Writes strokes of smooth curves in place of the strokes of the lines whose visibility was computed for them.

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "contours/contour_junctions.hpp"
#include "linework/stroke.hpp"
#include "view/view.hpp"

namespace ligne {

/// Removes the strokes with the sources [first, first + count) from the model, and returns them sorted by source.
std::vector<Stroke> take_strokes(StrokeModel& model, std::uint32_t first, std::size_t count);

/// The sources of curves in a model: source `first` + i is a segment whose visibility was computed on the line with
/// source lines[i].
struct ContourSources {
  std::uint32_t first = 0;
  std::vector<std::uint32_t> lines;
  /// The parts of the mesh's outline that curves replace and behind which nothing lies closely, as segments in mm of the
  /// page.
  std::vector<std::array<Point2, 2>> replaced;
};

/// Adds strokes to a model, each with a new source in StrokeModel::intersections. It keeps references to its arguments.
class CurveWriter {
 public:
  /// With `hidden_too` hidden runs are written, too. Turns back of up to `longest_fold_mm` are removed (unfold()).
  CurveWriter(StrokeModel& model, const View& view, bool hidden_too, double longest_fold_mm);

  /// The sources of all strokes that were added.
  ContourSources take_sources() { return std::move(sources_); }

  /// Adds the runs of a curve with `segments` segments. `first_line` is the source of the line that stood for segment
  /// 0; source_of(i) is the source edge of segment i.
  void add(LineClass line_class, std::size_t segments, std::uint32_t first_line, const ContourCurve& curve,
           const std::vector<ContourRun>& runs, const std::function<SourceEdge(std::size_t)>& source_of);

 private:
  /// A segment of the curve at hand.
  struct Segment {
    std::uint32_t number = 0;
    std::uint32_t source = 0;  ///< of its strokes
    std::uint32_t line = 0;    ///< source of the line that stood for it
  };
  void add_stroke(LineClass line_class, const CurvePoint& from, const CurvePoint& to, int state, const Segment& segment);
  void carry_count(Stroke& s, std::uint32_t line);

  StrokeModel& model_;
  ContourSources sources_;
  const View& view_;
  bool hidden_too_;
  double longest_fold_mm_;
};

}  // namespace ligne
