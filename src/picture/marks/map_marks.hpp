#pragma once
/// The marks of a map below its picture: a scale bar, an arrow to the north, a legend.

#include <array>
#include <vector>

#include "drawing/text_item.hpp"
#include "geometry/point.hpp"
#include "picture/requests.hpp"
#include "scene/surfaces/height_source.hpp"
#include "view/axes/axes_layout.hpp"
#include "view/view.hpp"

namespace ligne {

/// Metres of a degree of latitude: of a sphere of the earth's mean radius, 6371.009 km.
inline constexpr double kMetresOfDegree = 111195.08;

struct MapMarks {
  std::vector<std::array<Point2, 2>> lines;    ///< page mm
  std::vector<TextItem> texts;                 ///< of all
  std::vector<std::array<Point2, 2>> samples;  ///< of the legend, one for each entry
  Rect extent;                                 ///< of all; empty where there is nothing
};

/// The ground of a map: what its coordinates were multiplied by, and their unit.
struct MapGround {
  Point3 factor{1, 1, 1};
  GroundUnit unit = GroundUnit::unknown;
};

/// Lays them out in rows below `all`, the picture with what is round it. Lengths across the picture are true in parallel
/// projection: then the scale bar is right for what lies level from left to right. Throws RequestError where a view has no
/// scale, or no north.
MapMarks lay_out_map_marks(const AxesChoice& choice, const MapGround& ground, const View& view, const Rect& all,
                           double text_height_mm, const MeasureText& measure);

}  // namespace ligne
