#pragma once
/// Smooth contours in place of the outlines of a mesh: the way into a study. docs/smooth-contours.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contours/contour_chains.hpp"
#include "contours/surfaces/smooth_patch.hpp"
#include "scene/creases/trace_creases.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

struct ContourOptions {
  RegionBorders borders{};
  std::span<const ScanObject> scans{};
  double pen_width_mm = 0.35;  ///< what is smaller on the page is no shape
};

/// The contours that stand for outlines of the mesh in a projected scene.
struct SmoothContours {
  std::vector<ContourChain> chains;
  std::vector<std::vector<std::uint32_t>> faces;  ///< per chain and segment: the face of the scene
  std::vector<std::vector<int>> sides;            ///< per chain and segment: see ContourSight::side
  std::vector<std::uint32_t> first_source;        ///< per chain: source of its first segment; the others follow
  /// Edges of the mesh that are left out, by their ends and first two faces.
  std::vector<SourceEdge> replaced;
  std::vector<double> replaced_size_mm;  ///< longest side on the page of the triangles at such an edge
  std::vector<std::uint8_t> bulges;      ///< 1 where the solid bulges at such an edge, by the winding of its faces
  std::uint32_t first_probe = 0;         ///< source of the probe of the first of them; the others follow
  std::uint32_t first_edge = 0;          ///< source of the first of them itself; the others follow

  bool empty() const { return replaced.empty() && chains.empty(); }
};

/// The lines that replace outlines of the mesh, before they are put into a projected scene.
struct OutlineReplacement {
  SmoothContours contours;
  std::vector<std::array<Point3, 2>>
      lines;                           ///< at which visibility is studied; their sources are those that `contours` names
  std::vector<std::uint32_t> removed;  ///< edges of the topology
};

/// The outlines of the mesh among the candidate edges, ascending: edges of the topology.
std::vector<std::uint32_t> outline_edges(const Topology& topology, const ProjectedScene& projected);

/// Outlines inside smooth regions, edges of the topology, and the faces round them.
struct OutlinePatch {
  std::vector<std::uint32_t> inside;
  SmoothPatch patch;
};

/// Those among the outlines of the mesh. Scenes that have lines of their own on their faces (iso-curves, contour lines) have
/// none. Nearly all of it is done in parallel.
OutlinePatch patch_of_outlines(const Scene& scene, const Topology& topology, const Camera& camera,
                               const std::vector<std::uint32_t>& outlines, const RegionBorders& borders);

/// Finds the contours that stand for these outlines, and lines at which the visibility of the contours is studied
/// (contour_sights.hpp), with sources from that of the last edge on. Of the projected scene, only what select_candidates()
/// has set is looked at. Half of it is done in one thread.
OutlineReplacement replacement_of(const Scene& scene, const Topology& topology, const ProjectedScene& projected,
                                  OutlinePatch outlines, const ContourOptions& options);

/// Takes the outlines out of the candidate edges, and puts the lines in their place. No other lines were added before.
SmoothContours replace_outlines(const Topology& topology, ProjectedScene& projected, OutlineReplacement replacement);
/// Both, for the outlines that are candidates.
SmoothContours replace_outlines(const Scene& scene, const Topology& topology, ProjectedScene& projected,
                                const ContourOptions& options);

}  // namespace ligne
