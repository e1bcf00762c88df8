#pragma once
/// Long straight edges in smooth regions, and how far a mesh lies from its surface.
///
/// A mean of face normals means little where long faces meet short ones. Where a flat side, a cylinder or a cone goes over
/// into a rounding, the long edges that end there lie on the surface: they are its rulings, and its normal is square to
/// them. A mean tilts it towards the rounding, by half of the angle between the faces.

#include <cstdint>
#include <span>

#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// Makes the normals of sectors square to the rulings that end there: edges several times as long as the faces reach beyond
/// their end, on the other side of the bend. Two rulings of different directions span a flat side. `face_normals`: of the
/// triangles, unit length or zero. Sets SmoothPatch::ruled, and g of the sectors that change.
void square_to_rulings(const Scene& scene, const Camera& camera, std::span<const Point3> face_normals, SmoothPatch& patch);

/// The sag of a triangle: how far it may lie from the smooth surface, model units. A face of width w (from an edge to its
/// farthest vertex) that bends by the angle t against its neighbour is the chord of an arc of height w/2 tan(t/4); beside a
/// much narrower neighbour the width of that one counts. The sag is the sum over the edges: half of a rectangle has the sum
/// of two such arcs, and the middle of an equilateral triangle lies 8/9 of the sum of three from the surface.
double sag_of(const Scene& scene, const SmoothPatch& patch, std::uint32_t triangle);

}  // namespace ligne
