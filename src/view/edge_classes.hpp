#pragma once
/// Classifies the edges of a scene for one view.

#include <cstdint>
#include <vector>

#include "linework/stroke.hpp"
#include "scene/creases/crease_lines.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// Sine of the angle between the plane of a face and the line of sight below which the face is seen edge on. A face as
/// high as an A4 sheet (297 mm) would then be at most 1 micrometre wide on the page.
inline constexpr double kEdgeOnSine = 0.001 / 297;

/// Sine of that angle below which the corners of a face, rounded to the page, may turn the other way than its normal tells.
/// Such a face is seen edge on. The bound is that of faces 0.008 mm high on A4, which rounding makes a lattice step wider.
inline constexpr double kNearlyEdgeOnSine = 0x1p-10;

/// Per face: +1 if it faces the viewer, -1 if it faces away, 0 if it is seen edge on.
std::vector<std::int8_t> face_facings(const Scene& scene, const View& view);

/// The class of every edge of the topology: the first of these that applies.
/// - intersection, contour, horizon: surfaces penetrate each other along the edge; it is part of a contour line; of an
///   iso-curve.
/// - border: it has one face.
/// - crease: it has more than two faces. Only two of them are stored, so they can not decide whether it is an outline.
/// - outline: its two faces do not face the same way. A face seen edge on faces neither way.
/// - crease: the normals differ by more than the angle.
/// - mesh: any other edge. Edges that the file hides, and edges made by triangulation of a polygon, can be outlines but
///   not creases.
///
/// If the windings of two faces contradict each other, one is treated as reversed. A face without area takes the normal
/// of its neighbour across its longest edge. If `creases` is given (per edge kCreaseLine, kTangentLine, kFoldLine or 0, see
/// scene/creases/crease_lines.hpp), it decides on creases and tangent lines instead of the angle and the number of
/// faces. `sure`: sure_facings() (edge_on.hpp), or empty.
std::vector<LineClass> classify_edges(const Scene& scene, const Topology& topology, const View& view, double crease_degrees,
                                      const std::vector<std::uint8_t>* creases = nullptr,
                                      std::vector<std::int8_t> sure = {});

}  // namespace ligne
