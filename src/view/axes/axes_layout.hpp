#pragma once
/// Axes of a plot: box, ticks, numbers and names, laid out around the picture.

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/text_item.hpp"
#include "view/axes/axes_box.hpp"
#include "view/axes/ticks.hpp"

namespace ligne {

enum class AxesStyle {
  back,  ///< the edges of the sides behind the contents
  grid,  ///< like back, with lines at the ticks
  box,   ///< all edges
  base,  ///< the edges of the ground, and the axis of heights
};

struct AxisRequest {
  double from = 0, to = 1;  ///< range in units of the ticks
  double factor = 1;        ///< model units per unit of the ticks, > 0
  double origin = 0;        ///< value of the tick at the model coordinate 0
  std::string name;
  TickScale scale = TickScale::linear;
  std::vector<std::string> categories{};  ///< names of 0, 1, 2 ...; empty: numbers

  double model_coordinate(double tick) const { return (tick - origin) * factor; }
};

struct AxesRequest {
  std::array<AxisRequest, 3> axes;
  AxesStyle style = AxesStyle::back;
  double text_height_mm = 2.5;  ///< height of capitals in numbers and names; ticks and gaps scale with it

  AxesBox box() const;
};

struct AxesPicture {
  std::vector<AxisLine> lines;               ///< on the sides behind the contents, which may hide them
  std::vector<AxisLine> front_lines;         ///< in front of the contents
  std::vector<std::array<Point2, 2>> marks;  ///< ticks, page mm; in front of everything
  std::vector<TextItem> texts;
  std::vector<TextBox> boxes;       ///< boxes of the texts, in the same order
  std::array<bool, 3> has_scale{};  ///< per axis: it has ticks
  Rect extent;                      ///< page mm, of marks and texts; empty if there are none
};

using MeasureText = std::function<TextExtent(std::string_view utf8, double height_mm)>;

/// Lays out the axes of a picture that is placed already. Each axis is an edge of the outline of the box in view: x and
/// y low on the page if possible, z at the left. Ticks and texts are on its outer side, so they never overlap the
/// picture. There are as many numbers as fit; texts never overlap each other. An axis has no scale if it is seen end
/// on, has no edge on the outline, or its edge is out of view. No axis has one if the box reaches behind the viewer.
AxesPicture lay_out_axes(const AxesRequest& request, const View& view, const MeasureText& measure);

/// The title above a picture and everything around it, at most `width_mm` wide. Its capitals are `height_mm` high, or
/// lower if the title would be too wide.
TextItem title_above(const Rect& picture, const std::string& title, double height_mm, double width_mm,
                     const MeasureText& measure);

}  // namespace ligne
