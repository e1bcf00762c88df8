#pragma once
/// Points on a picture: whether each is seen, its mark and its label.

#include <cstdint>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/line_groups.hpp"
#include "picture/requests.hpp"
#include "view/view.hpp"

namespace ligne {

/// A short line before each point, nearer to the viewer than roundings are: the point is seen where the line is.
std::vector<std::array<Point3, 2>> probes_of(const std::vector<MarkedPoint>& points, const View& view);

/// Takes the strokes of the probes, whose sources begin at `first`, out of the model; 1 for each point that is seen.
std::vector<std::uint8_t> take_probes(StrokeModel& model, std::uint32_t first, std::size_t count);

/// "5 of 7 points are not marked: 2 outside the page, 3 hidden"; empty when all are seen.
std::string unseen_points(const std::vector<MarkedPoint>& points, const std::vector<std::uint8_t>& seen, const View& view);

struct LabelStyle {
  double height_mm;  ///< of letters; marks follow it
  TextStyle text;
};

/// Marks the points that are seen, in the layer "points", and writes their labels beside them where there is room; lines
/// make a gap for these. Labels that do not fit are left out; `taken` are the texts that are there already.
std::vector<TextItem> mark_points(Drawing& drawing, const std::vector<MarkedPoint>& points,
                                  const std::vector<std::uint8_t>& seen, const View& view, const LabelStyle& style,
                                  std::span<const TextItem> taken);

}  // namespace ligne
