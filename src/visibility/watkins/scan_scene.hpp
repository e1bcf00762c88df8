#pragma once
/// The scene of the scan by lines: edges with the faces that they bound, in buckets by the first line that meets them (Td).

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/index_lists.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/raster/scan_conversion.hpp"
#include "visibility/watkins/exact/sweep_scene.hpp"
#include "visibility/watkins/skew_faces.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

/// The depth order of two touching faces: decided once per pair, from their whole overlap on the page, and cached.
///
/// Depths of touching faces differ only by rounding, and differently on every scan line. Compared line by line, the two
/// would change order from line to line and seem to penetrate each time. So where their depths on a line agree within the
/// depth tolerance (docs/numerics.md), this order decides. If the two touch everywhere, the face with the lower number is in
/// front everywhere. If one is in front somewhere and behind nowhere, it is in front also where they touch. Only faces that
/// penetrate by more than the tolerance are compared by their depths.
class FaceOrders {
 public:
  /// `skew`: faces that have no plane, or null. Depths decide between them and others.
  FaceOrders(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, const IndexLists& of_faces,
             const SkewFaces* skew = nullptr)
      : vertices_(vertices), facets_(facets), of_faces_(of_faces), skew_(skew) {}

  /// The result depends only on the two faces: of(b, a) is of(a, b) with exchanged roles.
  DepthOrder of(std::uint32_t a, std::uint32_t b);

  std::size_t pairs() const { return known_.size(); }  ///< number of pairs decided

 private:
  struct Extent {
    std::int32_t x0, x1, y0, y1;
    std::uint32_t facet;
  };

  DepthOrder decide(std::uint32_t a, std::uint32_t b);
  void extents_of(std::uint32_t face, std::vector<Extent>& extents) const;

  const std::vector<ProjectedVertex>& vertices_;
  const std::vector<Facet>& facets_;
  const IndexLists& of_faces_;
  const SkewFaces* skew_;
  std::unordered_map<std::uint64_t, DepthOrder> known_;  ///< by the lower, then the higher number; only looked up
  std::vector<Extent> extents_a_, extents_b_, open_;     ///< scratch of decide()
};

/// An edge of faces, or a candidate line, or both.
struct ScanEdge {
  EdgeTrack track{};
  std::uint32_t top = 0, bottom = 0;  ///< vertices of the scene
  double u_top = 0, v_top = 0, u_bottom = 0, v_bottom = 0;
  std::uint32_t faces_begin = 0, faces_end = 0;  ///< range in ScanScene::edge_faces
  std::uint32_t lines_begin = 0, lines_end = 0;  ///< range in ScanScene::edge_lines
};

/// The plane of a face in grid units: z = z0 + zu u + zv v.
struct GridPlane {
  double z0 = 0, zu = 0, zv = 0;
  double z(double u, double v) const { return z0 + zu * u + zv * v; }
};

/// Faces are polygons with holes: sides shared by two triangles of one face are no edges.
struct ScanScene {
  LineGrid grid;
  std::vector<ScanEdge> edges;  ///< by first line, including edges that no line meets; then `unlisted`
  std::uint32_t unlisted = 0;   ///< an edge of no face or line, met by all lines: represents penetrations without an edge
  std::vector<std::uint32_t>
      first_of_line;  ///< by line, plus two: first edge that begins at line i; the last bucket has edges below all lines
  std::vector<std::uint32_t> edge_faces, edge_lines;
  std::vector<GridPlane> planes;        ///< by face; of a skew face: at its farthest corner
  std::vector<double> depth_tolerance;  ///< by face: maximum of its facets that are not edge-on
  IndexLists of_faces;
  std::uint32_t face_count = 0;
  const SkewFaces* skew = nullptr;  ///< faces without a plane and without facets; null: none

  bool is_skew(std::uint32_t face) const { return skew && skew->has(face); }

  std::span<const std::uint32_t> faces_of(const ScanEdge& e) const {
    return {edge_faces.data() + e.faces_begin, edge_faces.data() + e.faces_end};
  }
  std::span<const std::uint32_t> lines_of(const ScanEdge& e) const {
    return {edge_lines.data() + e.lines_begin, edge_lines.data() + e.lines_end};
  }
};

/// `lines` are the scene's candidate edges in order, then lines with ends of their own (intersections). Faces without facets
/// (behind covers, edge-on) are still bounded by their edges.
///
/// Facets with a height on the page below `thin_steps` get no depth tolerance here. Their tolerance would span the depth of
/// whole bodies: they would touch faces far in front and far behind, and the order of three could be cyclic. Their depths
/// alone decide.
///
/// `skew`: faces whose segments run between their sides, without facets; null: none. It must outlive the result.
ScanScene make_scan_scene(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const SweepLine> lines,
                          const LineGrid& grid, double thin_steps, const SkewFaces* skew = nullptr);

}  // namespace ligne::watkins
