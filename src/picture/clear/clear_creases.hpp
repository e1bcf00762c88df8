#pragma once
/// The creases of clear lines.

#include "contours/shapes/shape_lines.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Whether lines of these classes are creases, or depend on them.
bool asks_for_creases(LineClasses classes);

/// The edges that a picture has: of exact lines by the crease angle, of clear ones by find_creases(), whose result goes into
/// `creases`, which must outlive the selection. What clear lines change is counted in `run`.
EdgeSelection select_edges(const Scene& scene, const Topology& topology, const LineRequest& request, LineClasses classes,
                           Creases& creases, RunReport& run);

/// Takes out of `creases` what is seen from one side alone (WallEdge) where the viewer is on the other.
void leave_out_walls_behind(const Scene& scene, const Topology& topology, const Camera& camera, Creases& creases);

/// Marks the borders between surfaces that run into each other in `creases`, where they are drawn (LineRequest::tangent).
/// Returns the lines along the middle of fillets that are drawn in place of theirs.
std::vector<ShapeLine> choose_tangent_lines(const Scene& scene, const Topology& topology, const PictureRequest& request,
                                            const View& view, Creases& creases);

}  // namespace ligne
