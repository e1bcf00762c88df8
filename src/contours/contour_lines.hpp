#pragma once
/// Replaces the outlines of a mesh by smooth contours, before a visibility method runs. The page
/// docs/smooth-contours.md explains the phases and defines sector, sight, probe and sag.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contours/contour_chains.hpp"
#include "contours/surfaces/smooth_patch.hpp"
#include "scene/creases/trace_creases.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

struct ContourOptions {
  RegionBorders borders{};              ///< where smooth regions end
  std::span<const ScanObject> scans{};  ///< objects that are scans, whose noise is levelled
  double pen_width_mm = 0.35;           ///< smaller details on the page are ignored
};

/// The contours that replace outlines of the mesh in a projected scene. In the method's run, sources number first the
/// sights of all segments, then the probes of all replaced edges, then these edges themselves.
struct SmoothContours {
  std::vector<ContourChain> chains;
  std::vector<std::vector<std::uint32_t>> faces;  ///< per chain and segment: the face of the scene
  std::vector<std::vector<int>> sides;            ///< per chain and segment: ContourSight::side
  std::vector<std::uint32_t> first_source;        ///< per chain: source of its first segment; the others follow
  std::vector<SourceEdge> replaced;               ///< the edges of the mesh that contours replace
  std::vector<double> replaced_size_mm;           ///< per replaced edge: size of its two triangles on the page
  std::vector<std::uint8_t> bulges;               ///< per replaced edge: 1 if it is convex, by the winding of its faces
  std::uint32_t first_probe = 0;                  ///< source of the probe of the first replaced edge; the others follow
  std::uint32_t first_edge = 0;                   ///< source of the first replaced edge itself; the others follow

  bool empty() const { return replaced.empty() && chains.empty(); }
};

/// The result of replacement_of(), before it is put into a projected scene.
struct OutlineReplacement {
  SmoothContours contours;
  std::vector<std::array<Point3, 2>>
      lines;  ///< lines in model space whose visibility the method computes, in the order of the sources in `contours`
  std::vector<std::uint32_t> removed;  ///< edges of the topology that are no longer candidates
};

/// The edges of the topology that are candidates of class outline, ascending.
std::vector<std::uint32_t> outline_edges(const Topology& topology, const ProjectedScene& projected);

/// The outline edges inside smooth regions, and the triangles around them.
struct OutlinePatch {
  std::vector<std::uint32_t> inside;  ///< edges of the topology
  SmoothPatch patch;
};

/// Makes the patch of the given outline edges: phase 1 of docs/smooth-contours.md without islands. It is empty for
/// scenes with iso-curves or contour lines on their faces. Nearly all of the work is parallel.
OutlinePatch patch_of_outlines(const Scene& scene, const Topology& topology, const Camera& camera,
                               const std::vector<std::uint32_t>& outlines, const RegionBorders& borders);

/// Finds the contours that replace these outlines, and the lines to test for visibility in their place
/// (contour_sights.hpp). Sources start at `projected.source_count`. Reads only the members of the projected scene that
/// select_candidates() sets. About half of the work is done in one thread.
OutlineReplacement replacement_of(const Scene& scene, const Topology& topology, const ProjectedScene& projected,
                                  OutlinePatch outlines, const ContourOptions& options);

/// Removes the replaced outlines from the candidates, and adds the lines. To be called before other lines are added.
SmoothContours replace_outlines(ProjectedScene& projected, OutlineReplacement replacement);
/// Does all of the above for the outlines that are candidates.
SmoothContours replace_outlines(const Scene& scene, const Topology& topology, ProjectedScene& projected,
                                const ContourOptions& options);

/// On scans, flips the sign of g on islands of the opposite sign if the surface there is nowhere inclined to the line
/// of sight by 4 degrees. These islands are noise of the scan; their contours would be many small rings where the body
/// is seen edge on. O(corners of the patch).
void level_shallow_islands(SmoothPatch& patch, const Scene& scene, const Camera& camera, std::span<const ScanObject> scans);

}  // namespace ligne
