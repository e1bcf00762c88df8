#pragma once
/// The marks of a map below its picture: a scale bar, a north arrow, a legend.

#include <array>
#include <vector>

#include "drawing/text_item.hpp"
#include "geometry/point.hpp"
#include "picture/requests.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/axes/axes_layout.hpp"
#include "view/view.hpp"

namespace ligne {

/// Metres per degree of latitude, on a sphere of the earth's mean radius, 6371.009 km.
inline constexpr double kMetresPerDegree = 111195.08;

struct MapMarks {
  std::vector<std::array<Point2, 2>> lines;    ///< page mm
  std::vector<TextItem> texts;                 ///< texts of all marks
  std::vector<std::array<Point2, 2>> samples;  ///< samples of the legend, one for each entry
  Rect extent;                                 ///< bounding box of all marks; empty if there are none
};

/// The ground of a map: the factors of its coordinates, and their unit.
struct MapGround {
  Point3 factor{1, 1, 1};
  GroundUnit unit = GroundUnit::unknown;
};

/// Places the marks in rows below `all`, the box of the picture and its axes. In parallel projection lengths across the
/// picture are true, so the scale bar holds for horizontal distances from left to right. Throws RequestError if the view
/// has no scale or no north.
MapMarks lay_out_map_marks(const AxesChoice& choice, const MapGround& ground, const View& view, const Rect& all,
                           double text_height_mm, const MeasureText& measure);

}  // namespace ligne
