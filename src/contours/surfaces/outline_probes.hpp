#pragma once
/// Probes that make sure that no outline is lost.
///
/// Normals are means, so where a mesh is coarse the smooth surface may have no contour at an edge beside which one looks
/// past the whole body. So for each edge of the mesh's outline that gave way to contours a *probe* is studied: the edge,
/// moved off its two faces on the page and pushed far back. Where the probe is seen nothing is close
/// behind the edge, and the edge is a true outline. Such an edge is drawn when no contour was drawn near it. The small folds
/// of a mesh along its outlines have the surface right behind them, and are not.

#include <array>
#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// The probe of a side of the patch. `object_size`: diagonal of the box round its object.
std::array<Point3, 2> outline_probe(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side,
                                    double object_size, double slack_mm);

/// The longest side on the page of the two triangles at a side of the patch, mm.
double size_on_page(const Scene& scene, const View& view, const SmoothPatch& patch, std::uint32_t side);

/// Lengths on the page that decide about probes, mm.
struct ProbeSizes {
  double pen_width_mm;
  double reach_mm;  ///< from the end of an outline to a contour on which it is put
};

/// Adds strokes for the edges whose probes are seen with no visible contour near them. `probes`: the strokes of the probes,
/// in the order of their sources.
void add_missing_outlines(StrokeModel& model, const View& view, const SmoothContours& contours,
                          const std::vector<Stroke>& probes, const std::vector<SeenContour>& seen, const ProbeSizes& sizes);

}  // namespace ligne
