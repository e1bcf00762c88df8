#pragma once
/// Axes of a plot: box, ticks, numbers and names, laid out round the picture.

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/text_item.hpp"
#include "drawing/ticks.hpp"
#include "view/axes/axes_box.hpp"

namespace ligne {

enum class AxesStyle {
  back,  ///< the edges of the sides behind the picture
  grid,  ///< the same, with lines at the ticks
  box,   ///< all edges
  base,  ///< the edges of the ground, and the axis of the heights
};

struct AxisRequest {
  double from = 0, to = 1;  ///< as the ticks say it
  double factor = 1;        ///< model units for one unit of the ticks, > 0
  double origin = 0;        ///< the tick at the model coordinate 0
  std::string name;
  TickScale scale = TickScale::linear;
  std::vector<std::string> categories{};  ///< names of 0, 1, 2 ...; empty: numbers

  double model_coordinate(double tick) const { return (tick - origin) * factor; }
};

struct AxesRequest {
  std::array<AxisRequest, 3> axes;
  AxesStyle style = AxesStyle::back;
  double text_height_mm = 2.5;  ///< of the capitals of numbers and names; lengths of ticks and gaps follow

  AxesBox box() const;
};

struct AxesPicture {
  std::vector<AxisLine> lines;               ///< on the sides behind what the box holds: may be hidden by it
  std::vector<AxisLine> front_lines;         ///< before it
  std::vector<std::array<Point2, 2>> marks;  ///< ticks, page mm: before everything
  std::vector<TextItem> texts;
  std::vector<TextBox> boxes;       ///< of the texts, in their order
  std::array<bool, 3> has_scale{};  ///< the axis has ticks
  Rect extent;                      ///< page mm, of marks and texts; empty when there are none
};

using MeasureText = std::function<TextExtent(std::string_view utf8, double height_mm)>;

/// Lays out the axes of a picture that is placed already. Each axis stands on an edge of the outline of the box as seen, x
/// and y as low on the page as there is one, z at the left, so that ticks and texts, which lie on its outer side, never lie
/// on the picture. There are as many numbers as have room; texts never overlap each other. An axis that is seen end on, or
/// that has no edge on the outline, or whose edge is out of view, has no scale; none has one when the box reaches behind the
/// viewer.
AxesPicture lay_out_axes(const AxesRequest& request, const View& view, const MeasureText& measure);

/// The title above a picture with all that is round it, no wider than `width_mm`. Its capitals have `height_mm`, less where
/// it would be too wide.
TextItem title_above(const Rect& picture, const std::string& title, double height_mm, double width_mm,
                     const MeasureText& measure);

}  // namespace ligne
