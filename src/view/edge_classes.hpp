#pragma once
/// Classes of edges for one view.

#include <cstdint>
#include <vector>

#include "drawing/stroke.hpp"
#include "scene/creases/crease_lines.hpp"
#include "scene/model/topology.hpp"
#include "view/view.hpp"

namespace ligne {

/// A face as high as an A4 sheet whose plane makes an angle of this sine with the sight is 1 micrometre wide on the page:
/// it is seen edge on.
inline constexpr double kEdgeOnSine = 0.001 / 297;

/// Which way a face looks: +1 towards the viewer, -1 away, 0 when it is seen edge on.
std::vector<std::int8_t> face_facings(const Scene& scene, const Camera& camera);

/// The class of every edge: border (one face), outline (one of its faces looks at the viewer, the other does not; a face
/// seen edge on looks neither way), crease (normals differ by more than the angle, or more than two faces), mesh (all
/// others; edges that the file hides or that only cut a polygon can be outlines, but not creases), and before all of these
/// intersection where surfaces cross along the edge, contour and horizon where it is part of a contour line or of an
/// iso-curve. Faces that are wound against each other are compared as if one were turned round. A face without area takes
/// the plane of its neighbour across its longest edge. `creases`: per edge kCreaseLine or kTangentLine
/// (scene/creases/crease_lines.hpp) where it is such a line
/// if it is none of the others; then neither the angle nor the number of faces decides.
std::vector<LineClass> classify_edges(const Scene& scene, const Topology& topology, const Camera& camera,
                                      double crease_degrees, const std::vector<std::uint8_t>* creases = nullptr);

}  // namespace ligne
