#pragma once
/// Surfaces that run into themselves.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// For each surface whether it may touch or penetrate itself: 1 when two of its triangles, of different faces, have a point
/// in common beside the vertices and the edges that they share, else 0. `surface[i]` is the number of the surface that
/// triangle i belongs to, below `surface_count`, or kNone when the triangle is not asked about.
///
/// 0 is certain: every pair was separated by signs that no rounding can turn. Where a sign is not certain the pair counts
/// as touching, so that 1 may also mean a distance of a few units in the last place. Triangles without area are no surface.
///
/// Method: a tree of boxes over each surface, halved along its longest side down to a few triangles, and compared with
/// itself: n log n, as long as each box meets few others. Pairs are tested as Guigue and Devillers do (Fast and robust
/// triangle-triangle overlap test using orientation predicates, 2003), by orientations alone.
std::vector<std::uint8_t> find_self_contacts(std::span<const Point3> vertices, std::span<const Triangle> triangles,
                                             std::span<const std::uint32_t> surface, std::uint32_t surface_count);

}  // namespace ligne
