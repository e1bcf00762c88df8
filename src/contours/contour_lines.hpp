#pragma once
/// Smooth contours in place of the outlines of a mesh: the way into a study. docs/smooth-contours.md.

#include <cstddef>
#include <vector>

#include "contours/contour_chains.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

struct ContourOptions {
  double crease_degrees = 30;
  double pen_width_mm = 0.35;  ///< what is smaller on the page is no shape
};

/// The contours that stand for outlines of the mesh in a projected scene.
struct SmoothContours {
  std::vector<ContourChain> chains;
  std::vector<std::vector<std::uint32_t>> faces;  ///< per chain and segment: the face of the scene
  std::vector<std::vector<int>> sides;            ///< per chain and segment: see ContourSight::side
  std::vector<std::uint32_t> first_source;        ///< per chain: source of its first segment; the others follow
  std::size_t replaced_edges = 0;                 ///< of the mesh, candidates that are left out
  double fold_mm = 0;                             ///< length on the page of those of them for which nothing stands

  bool empty() const { return chains.empty(); }
};

/// Takes the outlines inside smooth regions out of the candidate edges, and puts lines in their place at which the
/// visibility of the contours is studied (contour_sights.hpp), with sources from `source_count` on. Scenes that have lines
/// of their own on their faces (iso-curves, contour lines) stay as they are.
SmoothContours replace_outlines(const Scene& scene, const Topology& topology, ProjectedScene& projected,
                                const ContourOptions& options);

}  // namespace ligne
