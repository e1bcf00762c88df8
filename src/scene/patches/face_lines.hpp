#pragma once
/// Zero sets of functions over triangles.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct FaceLine;

/// Adds the polylines over triangles along which a function, linear between the corners, is zero. Zero at a corner counts as
/// positive, so lines never branch. With `keeps`, the parts where that function of the points is negative are cut off.
/// O(n log n) for n triangles.
void add_zero_lines(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> triangles,
                    const std::function<double(const Point3&)>& value, const std::function<double(const Point3&)>& keeps,
                    std::vector<FaceLine>& lines);

}  // namespace ligne
