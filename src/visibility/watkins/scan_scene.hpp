#pragma once
/// The scene of the scan by lines: edges with the faces that they bound, in buckets by the first line that meets them
/// (Td).

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/raster/scan_conversion.hpp"
#include "visibility/watkins/exact/face_orders.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {

/// An edge of faces, or a candidate line, or both.
struct ScanEdge {
  EdgeTrack track;
  std::uint32_t top = 0, bottom = 0;  ///< vertices
  double u_top = 0, v_top = 0, u_bottom = 0, v_bottom = 0;
  std::uint32_t faces_begin = 0, faces_end = 0;  ///< in ScanScene::edge_faces
  std::uint32_t lines_begin = 0, lines_end = 0;  ///< in ScanScene::edge_lines
};

/// Depth over a face, in grid units: z = z0 + zu u + zv v.
struct GridPlane {
  double z0 = 0, zu = 0, zv = 0;
  double z(double u, double v) const { return z0 + zu * u + zv * v; }
};

/// Faces are polygons with holes: what two triangles of one face have in common is no edge.
struct ScanScene {
  LineGrid grid;
  std::vector<ScanEdge> edges;  ///< by first line, those that no line meets among them; behind them stands `unlisted`
  std::uint32_t unlisted = 0;  ///< an edge of no face and no line, met by all lines: stands for penetrations without an edge
  std::vector<std::uint32_t>
      first_of_line;  ///< by line, and two more: edges that begin at line i; behind the last line lie those that begin below
  std::vector<std::uint32_t> edge_faces, edge_lines;
  std::vector<GridPlane> planes;        ///< by face
  std::vector<double> depth_tolerance;  ///< by face: largest of its facets that are not seen edge on
  FacetsOfFaces of_faces;
  std::uint32_t face_count = 0;

  std::span<const std::uint32_t> faces_of(const ScanEdge& e) const {
    return {edge_faces.data() + e.faces_begin, edge_faces.data() + e.faces_end};
  }
  std::span<const std::uint32_t> lines_of(const ScanEdge& e) const {
    return {edge_lines.data() + e.lines_begin, edge_lines.data() + e.lines_end};
  }
};

/// `lines` are those of the scene's candidate edges, in order, and behind them such as have ends of their own
/// (intersections). Faces without facets (behind covers, edge on) are bounded by their edges all the same.
///
/// Facets whose height on the page is below `thin_steps` have no depth tolerance here. Theirs is the depth of whole
/// bodies: faces far before and far behind would touch them alike, and which of three is in front would go round in a
/// circle. As narrow as they are, their depths alone may decide.
ScanScene make_scan_scene(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                          const LineGrid& grid, double thin_steps);

}  // namespace ligne::watkins
