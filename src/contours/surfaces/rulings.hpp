#pragma once
/// Rulings: long straight edges on a smooth surface. Sag: bound on the distance between mesh and surface.
///
/// A mean of face normals is wrong where long faces meet short ones. Where a flat side, a cylinder or a cone passes
/// into a fillet, the long edges that end there lie on the surface: they are its rulings, and its normal is
/// perpendicular to them. A mean is tilted towards the fillet by half of the angle between the faces.

#include <cstdint>
#include <span>

#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// Makes the normals of sectors perpendicular to the rulings that end there. A ruling is an edge several times as long
/// as the extent of the faces beyond its end. Two rulings of different directions span a flat side. `face_normals`: per
/// triangle, unit length or zero. Sets SmoothPatch::ruled, and updates g of the sectors that change.
void square_to_rulings(const Scene& scene, const Camera& camera, std::span<const Point3> face_normals, SmoothPatch& patch);

/// The sag of a triangle: bound on its distance from the smooth surface, model units. A face of width w (from an edge
/// to its farthest vertex) whose normal differs by the angle t from that of its neighbour is the chord of an arc of
/// height w/2 tan(t/4). Beside a much narrower neighbour, w is the width of the neighbour. The sag is the sum over the
/// edges. Half of a rectangle needs the sum of two arcs; the centre of an equilateral triangle is 8/9 of the sum of
/// three arcs away from the surface.
double sag_of(const Scene& scene, const SmoothPatch& patch, std::uint32_t triangle);

}  // namespace ligne
