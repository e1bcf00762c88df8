#pragma once
/// Lines of a surface's picture that are drawn apart: heights of contours, bands, hachures, curves in space.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawing/stroke.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// Lines of one look. What is not said is as for all lines of their class.
struct LineGroup {
  std::string layer{};
  std::string object{};
  std::optional<std::array<double, 3>> color{};
  std::optional<double> width_mm{};
  std::optional<double> height{};  ///< of contour lines
};

/// A line beside the edges of the scene: hidden like these.
struct SpaceLine {
  std::array<Point3, 2> ends;
  std::uint32_t group = 0;
};

/// A point that is marked where it is seen, and what is written beside it.
struct MarkedPoint {
  Point3 at{0, 0, 0};
  std::string label;
};

struct LineGroups {
  std::vector<LineGroup> groups{{}};  ///< the first one is of all other lines
  std::vector<SpaceLine> lines{};
  std::vector<MarkedPoint> points{};
  std::function<std::uint32_t(const SourceEdge&, LineClass)> group_of{};  ///< of edges of the scene; empty: the first
};

}  // namespace ligne
