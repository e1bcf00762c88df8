#pragma once
/// Lines of a surface picture with styles of their own: contour lines by height, bands, hachures, curves in space.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// The style of a group of lines. Empty members mean the style of the line class.
struct LineGroup {
  std::string layer{};
  std::string object{};
  std::optional<std::array<double, 3>> color{};
  std::optional<double> width_mm{};
  std::optional<double> height{};  ///< height of contour lines
};

/// A line that is not an edge of the scene. Faces hide it like an edge.
struct SpaceLine {
  std::array<Point3, 2> ends;  ///< model coordinates
  std::uint32_t group = 0;     ///< index into LineGroups::groups
};

/// A point that is marked on the page if it is visible.
struct MarkedPoint {
  Point3 at{0, 0, 0};  ///< model coordinates
  std::string label;   ///< text beside the mark
};

struct LineGroups {
  std::vector<LineGroup> groups{{}};  ///< group 0 contains all lines that are in no other group
  std::vector<SpaceLine> lines{};
  std::vector<MarkedPoint> points{};
  std::function<std::uint32_t(const SourceEdge&, LineClass)> group_of{};  ///< group of an edge of the scene; empty: 0
};

}  // namespace ligne
