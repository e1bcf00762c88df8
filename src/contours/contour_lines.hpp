#pragma once
/// Smooth contours in place of the outlines of a mesh: the way into a study. docs/smooth-contours.md.

#include <cstddef>
#include <span>
#include <vector>

#include "contours/contour_chains.hpp"
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
  std::uint32_t first_probe = 0;         ///< source of the probe of the first of them; the others follow

  bool empty() const { return replaced.empty() && chains.empty(); }
};

/// Takes the outlines inside smooth regions out of the candidate edges, and puts lines in their place at which the
/// visibility of the contours is studied (contour_sights.hpp), with sources from `source_count` on. Scenes that have lines
/// of their own on their faces (iso-curves, contour lines) stay as they are.
SmoothContours replace_outlines(const Scene& scene, const Topology& topology, ProjectedScene& projected,
                                const ContourOptions& options);

}  // namespace ligne
