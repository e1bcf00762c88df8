#pragma once
/// The exact surfaces behind a smooth patch, where they were found (docs/patches.md), in place of normals made of faces.

#include <cstdint>
#include <optional>
#include <span>

#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {

/// The surface of a triangle of the patch; null where none was found, or only a band of a free form.
const Patch* surface_at(const SmoothPatch& patch, std::uint32_t triangle);

/// Unit normal of the surface near p, on the side to which the faces look.
Point3 facing_normal(const Patch& surface, const Point3& p);

/// How that normal turns: the sum of both principal curvatures, each times the square of its direction.
NormalTurn facing_turn(const Patch& surface, const Point3& p);

/// The point of the surface nearest to p.
Point3 nearest_point(const Patch& surface, const Point3& p);

/// The normal that the surfaces round a vertex agree on, and how it turns where they are one surface.
struct KnownNormal {
  Point3 normal{0, 0, 0};
  std::optional<NormalTurn> turn;
};

/// `corners`: those of a sector. None where no triangle has a surface, or where two surfaces meet at an angle.
std::optional<KnownNormal> known_normal(const Scene& scene, const SmoothPatch& patch,
                                        std::span<const std::uint32_t> corners);

/// Where the outline of a surface crosses a segment that lies beside it: the share of the segment, from p on, at which the
/// nearest point of the surface has its normal square to the sight. None where both ends of it look the same way.
std::optional<double> outline_crossing(const Patch& surface, const Camera& camera, const Point3& p, const Point3& q);

}  // namespace ligne
