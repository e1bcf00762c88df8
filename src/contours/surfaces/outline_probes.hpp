#pragma once
/// Probes, which make sure that no outline is lost.
///
/// Normals are means, so on a coarse mesh the smooth surface may have no contour at an edge that is an outline of the
/// whole body. So each outline edge that contours replace gets a *probe*: a copy of the edge, moved off its two faces
/// on the page and far backwards. If the probe is visible, nothing lies closely behind the edge, and the edge is a true
/// outline. It is drawn where no contour was drawn near it. The small folds of a mesh along its outlines have the surface
/// closely behind them, and are not drawn. An edge of a coarse mesh, below which no triangle near it comes back, is no
/// fold: what lies behind it is another part of the body. Its probe is not moved backwards.

#include <array>
#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// Lengths that place the probe of a side.
struct ProbeOffsets {
  double size_mm;      ///< size_on_page() of the side
  double object_size;  ///< diagonal of the bounding box of its object, model units
  double slack_mm;     ///< least distance from the edge on the page
};

/// The probe of a side of the patch, in model space.
std::array<Point3, 2> outline_probe(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side,
                                    const ProbeOffsets& offsets);

/// Size on the page, mm, of the two triangles at a side of the patch: their longest side, or a multiple of their height
/// above this side and of the rise of the surface above it, if that is less.
double size_on_page(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side);

/// Lengths on the page, mm.
struct ProbeSizes {
  double pen_width_mm;
  double reach_mm;  ///< ends of new strokes within it of a contour are moved onto the contour
};

/// Adds strokes for the replaced edges whose probes are visible and that have no visible contour near them. `probes`:
/// the strokes of the probes, sorted by source.
void add_missing_outlines(StrokeModel& model, const View& view, const SmoothContours& contours,
                          const std::vector<Stroke>& probes, const std::vector<SeenContour>& seen, const ProbeSizes& sizes);

}  // namespace ligne
