#include "base/no_index.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/convex_body.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/methods.hpp"

// Phases: (1) sort faces by the sign of their area on the page, (2) check that the scene is one convex body, (3) draw
// edges with a front face. See docs/methods/culling.md.

namespace ligne {
namespace {

using namespace convexity;

/// Finds the visible parts of a line that is not an edge of the body, such as a line of the axes or of a contour.
void visible_of_free_line(const PageLine& line, const std::vector<Facet>& front, const ProjectedScene& scene,
                          double coincidence_steps, OpenParts& open, std::vector<LinePart>& parts) {
  open.reset(0, 1);
  bool near = false;
  for (const Facet& f : front) {
    if (open.empty()) break;
    open.take(hidden_interval(line, f, scene.vertices.data(), {open.from(), open.to()}, coincidence_steps, near));
  }
  if (!open.empty()) parts = open.finish();
}

VisibilityResult culling_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;

  // 1. Faces.
  const Faces faces = face_the_viewer(scene);
  statistics.time("faces", clock.lap());

  // 2. The body.
  result.unsupported_reason = why_not_one_convex_body(scene, faces);
  statistics.time("convexity", clock.lap());

  // 3. Edges.
  const Facets facets = make_facets(scene, coincidence_steps);
  const auto is_front = [&](std::uint32_t f) { return f < faces.facing.size() && faces.facing[f] == Facing::front; };
  std::vector<Facet> front;
  for (const Facet& f : facets.facets) {
    if (is_front(f.face)) front.push_back(f);
  }
  LineStrokes strokes(scene, facets, options.hidden_strokes, kLeastPartMm / step);
  const auto by_faces = [&]() -> LineVisibility {
    return [&, open = OpenParts()](std::size_t, const PageLine& line, std::vector<LinePart>& parts) mutable {
      if (line.face0 == kNone) {
        visible_of_free_line(line, front, scene, coincidence_steps, open, parts);
      } else if (is_front(line.face0) || is_front(line.face1)) {
        parts.push_back({0, 1});
      }
      return true;
    };
  };
  strokes.add_edges(by_faces, options.progress);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  statistics.count("front faces", faces.front);
  statistics.count("back faces, left out", faces.back);
  statistics.count("faces seen edge on, left out", faces.edge_on);
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

}  // namespace

const Method& culling_method() {
  static const FunctionMethod method(
      {.name = "culling",
       .summary = "edges of front faces: sufficient for one convex body",
       .penetration = false,
       .paper =
           "P. Boulle, Etude et realisation d'algorithmes pour la visualisation de scenes composees de facettes planes, 1980",
       .only_for = "one opaque convex body entirely in view"},
      culling_visibility);
  return method;
}

}  // namespace ligne
