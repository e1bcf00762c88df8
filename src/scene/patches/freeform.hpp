#pragma once
/// Free forms: facets of smooth surfaces that are no cylinder, cone, sphere or torus.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/edge_rows.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {

struct FacetSurfaces;
struct Patches;

/// Smallest number of connected facets that make a free form. Fewer facets with small angles between them are planes,
/// unless they form a regular row.
inline constexpr std::size_t kFewestFreeform = 8;

/// A facet is a plane if it extends this many times as far from an edge as the free-form facet on the other side. The
/// facets of one free form have similar sags, so their extents differ less. Adjustable.
inline constexpr double kPlaneDepths = 3;

/// Largest distance of corners from the line of an edge, model units.
double depth_behind(const Scene& scene, std::span<const std::uint32_t> corners, const Edge& edge);

/// Per facet: 1 if it has no surface (`surfaces.is_freeform` is not read) and
/// - is so narrow that rounding determines its normal, so that it is no evidence of a plane, or
/// - is a single triangle: planes of machine parts are seldom as small, and many free forms consist of triangles only,
///   or
/// - is connected to at least kFewestFreeform facets without a surface that are no planes, neither by their number of
///   corners (FacetGraph::has_many_corners) nor by their extent (kPlaneDepths) nor since a surface runs into them, or
/// - lies in a regular row: it is as wide as a neighbour, between parallel edges with the same angle in the same sense.
///   That is a cylinder whose facets were cut by other bodies, so that their corners lie on no circle, or
/// - is the last facet of such a row, as wide as the one behind it, or
/// - lies in a row of five facets or more whose bends are small and change gradually: an extruded spline, or
/// - belongs to fewer such facets at which the rows of the surfaces around them go on: a cut has left them of a tube, whose
///   bands lie on cones. A plane runs into a surface by half the angle of its facets, or
/// - lies amid triangles without a surface that are about as deep: several triangles of a free form may lie in one plane.
std::vector<std::uint8_t> freeform_facets(const Scene& scene, const Topology& topology, const FacetGraph& graph,
                                          const FacetSurfaces& surfaces, const EdgeRows& edge_rows);

/// Whether planes and recognised surfaces take half of the area of an object or more. Others may have been sculpted or
/// decimated, and have no edges of a part. The first few faces of a scan decide.
bool is_part(const Scene& scene, const Patches& patches, const Object& object);

}  // namespace ligne
