#pragma once
/// Exact normals of a smooth patch where surfaces were recognised behind the mesh (docs/patches.md).

#include <cstdint>
#include <optional>
#include <span>

#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// The recognised surface of a triangle of the patch; null if there is none, or only a band (Patch::is_band).
const Patch* surface_at(const SmoothPatch& patch, std::uint32_t triangle);

/// Unit normal of the surface near p, on the side that the faces face.
Point3 facing_normal(const Patch& surface, const Point3& p);

/// The derivative of facing_normal(): the sum over both principal curvatures of the curvature times the outer product
/// of its unit direction with itself.
NormalTurn facing_turn(const Patch& surface, const Point3& p);

/// The point of the surface nearest to p.
Point3 nearest_point(const Patch& surface, const Point3& p);

/// The normal that the surfaces around a vertex agree on.
struct KnownNormal {
  Point3 normal{0, 0, 0};
  std::optional<NormalTurn> turn;  ///< its derivative, if all triangles belong to one surface
};

/// The normal of a sector with the given corners. Returns nothing if no triangle has a surface, or if two surfaces meet
/// at an angle.
std::optional<KnownNormal> known_normal(const Scene& scene, const SmoothPatch& patch,
                                        std::span<const std::uint32_t> corners);

/// Where the outline of a surface crosses the segment from p to q near it: the fraction of the segment at which the
/// nearest point of the surface has a normal perpendicular to the line of sight. Returns nothing if the surface near
/// both ends faces the same way.
std::optional<double> outline_crossing(const Patch& surface, const Camera& camera, const Point3& p, const Point3& q);

}  // namespace ligne
