#pragma once
/// From the visible parts of a line to strokes.

#include <array>
#include <cstdint>
#include <vector>

#include "drawing/stroke.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/common/penetration.hpp"

namespace ligne {

class StrokeMaker {
 public:
  /// `hidden_too`: what lies between the parts becomes hidden strokes.
  StrokeMaker(const ProjectedScene& scene, bool hidden_too) : scene_(scene), hidden_too_(hidden_too) {}

  /// Appends the strokes of the visible `parts` of a line that is the part `range` of its source edge.
  void add(const PageLine& line, const std::vector<LinePart>& parts, std::array<double, 2> range, std::uint32_t source,
           LineClass line_class, bool may_coincide, std::vector<Stroke>& out) const;

 private:
  Stroke stroke(const PageLine& line, LinePart part, std::array<double, 2> range, std::uint32_t source, LineClass line_class,
                bool may_coincide, bool visible) const;
  double model_parameter(const PageLine& line, double t) const;

  const ProjectedScene& scene_;
  bool hidden_too_;
};

/// Length on the page in steps.
double page_length(const PageLine& line);

/// Strokes whose source is `scene.source_count` + i come from intersections[i]. Gives numbers to those that have strokes,
/// without gaps, and lists them in the model.
void number_intersections(const ProjectedScene& scene, const std::vector<Intersection>& intersections, StrokeModel& model);

}  // namespace ligne
