#pragma once
/// Selects the creases of clear lines.

#include <functional>

#include "contours/shapes/shape_lines.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Whether lines of these classes are creases, or depend on creases.
bool needs_creases(LineClasses classes);

/// The search for the creases of clear lines; empty where the crease angle selects edges.
std::function<Creases()> search_creases(const Scene& scene, const Topology& topology, const LineRequest& request,
                                        LineClasses classes);

/// Selects the edges of a picture by search_creases(). The result of the search goes into `creases`, which must outlive the
/// selection. Counts in `run` what clear lines change.
EdgeSelection select_edges(const std::function<Creases()>& search, const LineRequest& request, LineClasses classes,
                           Creases& creases, RunReport& run);

/// Decides on edges of more than two faces. Removes those of `creases` that are visible from one side only (WallEdge) if
/// the viewer is on the other side. Marks as kFoldLine those that are no creases where all of their faces lie on one side
/// of them on the page (FoldSheet): there the sheets turn away from the viewer.
void decide_sheets_by_view(const Scene& scene, const Topology& topology, const Camera& camera, Creases& creases);

/// Marks in `creases` the borders between surfaces that join smoothly, and between colours that no other line separates,
/// where LineRequest::tangent draws them. Returns the lines along the middle of fillets that replace the borders of these
/// fillets.
std::vector<ShapeLine> choose_tangent_lines(const Scene& scene, const Topology& topology, const PictureRequest& request,
                                            const View& view, Creases& creases);

}  // namespace ligne
