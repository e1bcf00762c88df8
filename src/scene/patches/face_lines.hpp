#pragma once
/// Zero sets of functions on a triangle mesh.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct FaceLine;

/// Adds the polylines along which a function is zero. `value` gives the function at the corners of the triangles, and
/// it is linear in between. Zero at a corner counts as positive, so lines never branch. If `keeps` is not empty, the
/// parts of the lines where keeps(point) is negative are cut off. `triangles` are indices into the topology. O(n log n)
/// for n triangles.
void add_zero_lines(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> triangles,
                    const std::function<double(const Point3&)>& value, const std::function<double(const Point3&)>& keeps,
                    std::vector<FaceLine>& lines);

}  // namespace ligne
