#pragma once
/// The list of the method newell, sorted for a scene and a view.

#include "drawing/measures.hpp"
#include "studies/scenes/generators.hpp"
#include "support/scenes.hpp"
#include "visibility/newell/priority_list.hpp"

namespace ligne::test {

/// The picture of which the method makes its list, one millimetre a unit.
inline Picture listed(const Scene& scene, const Point3& direction = {0, 1, 0}) {
  return draw(scene, {along(direction), "all", false, 1, "appel"});
}

/// A list and how it came about. The viewer looks along +y: x to the right, z up, what has the larger y is farther.
struct Sorted {
  std::vector<std::uint32_t> faces;  ///< faces of the elements, the farthest first
  newell::ListCounts counts;
};

inline Sorted sorted(const Scene& scene, const Point3& direction = {0, 1, 0}) {
  const Picture picture = listed(scene, direction);
  newell::PaintElements elements(picture.projected);
  newell::PriorityList list(elements);
  Sorted result;
  for (const std::uint32_t e : list.sort()) result.faces.push_back(elements[e].face);
  result.counts = list.counts();
  return result;
}

using Order = std::vector<std::uint32_t>;

/// Plates, each by x0, x1, z0, z1 and the depths of its left and its right side.
inline Scene plates(const std::vector<std::array<double, 6>>& list) {
  Scene scene;
  for (const auto& [x0, x1, z0, z1, y0, y1] : list) studies::add_plate(scene, {x0, x1}, {z0, z1}, {y0, y1});
  return scene;
}

}  // namespace ligne::test
