#pragma once
/// Marked points of a picture: their visibility, marks and labels.

#include <cstdint>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/line_groups.hpp"
#include "picture/requests.hpp"
#include "view/view.hpp"

namespace ligne {

/// Returns a short line in front of each point, by more than rounding errors. The point is visible if the line is.
std::vector<std::array<Point3, 2>> probes_of(const std::vector<MarkedPoint>& points, const View& view);

/// Removes the strokes of the probes, whose sources begin at `first`, from the model. Returns 1 for each visible point.
std::vector<std::uint8_t> read_probes(StrokeModel& model, std::uint32_t first, std::size_t count);

/// Text such as "5 of 7 points are not marked: 2 outside the page, 3 hidden"; empty if all are visible.
std::string unseen_points(const std::vector<MarkedPoint>& points, const std::vector<std::uint8_t>& seen, const View& view);

struct LabelStyle {
  double height_mm;  ///< height of capitals; the size of marks follows it
  TextStyle text;
};

/// Marks the visible points in the layer "points". Returns the labels, placed beside the marks where there is room;
/// labels that do not fit are left out. Lines have gaps for marks and labels. `taken` are the texts that exist already.
std::vector<TextItem> mark_points(Drawing& drawing, const std::vector<MarkedPoint>& points,
                                  const std::vector<std::uint8_t>& seen, const View& view, const LabelStyle& style,
                                  std::span<const TextItem> taken);

}  // namespace ligne
