#include "visibility/roberts/roberts.hpp"

#include <memory>

#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/roberts/body_lines.hpp"

// Phases: (1) bodies and their inequalities, (2) lines of penetration, (3) every line against the bodies in front of
// it. See docs/methods/roberts.md.

namespace ligne {
namespace {

using namespace roberts;

void report(const Bodies& bodies, const BodyCounts& counts, Statistics& statistics) {
  statistics.count("bodies", bodies.list.size());
  statistics.count("flat bodies", bodies.flat_faces);
  statistics.count("sides of silhouettes", bodies.hull.size());
  statistics.count("planes of front faces", bodies.planes.size());
  statistics.count("lines behind their own body", counts.own);
  statistics.count("line-body tests", counts.bodies);
  statistics.count("outside the silhouette", counts.beside);
  statistics.count("in front of the body", counts.before);
  statistics.count("behind all planes", counts.behind);
  statistics.count("line-plane tests", counts.planes);
  statistics.count("line-facet tests", counts.facets);
}

}  // namespace

const MethodTraits& RobertsMethod::traits() const {
  static const MethodTraits traits{"roberts",
                                   "each edge tested against the convex bodies in front of it, by linear inequalities",
                                   kStrokes,
                                   true,
                                   true,
                                   "L. G. Roberts, Machine perception of three-dimensional solids, 1963",
                                   MethodTraits{}.tolerance_mm,
                                   {},
                                   "scenes of convex bodies and flat convex faces entirely in view"};
  return traits;
}

VisibilityResult RobertsMethod::compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;

  // 1. Bodies.
  const Bodies bodies = find_bodies(scene, coincidence_steps);
  result.unsupported_reason = bodies.unsupported;
  statistics.time("bodies", clock.lap());

  // 2. Lines of penetration, of the projected scene, which has only one of coincident faces.
  std::vector<Intersection> intersections;
  if (scene.with_intersections) {
    const Facets facets = make_facets(scene, coincidence_steps);
    intersections = find_intersections(scene, facets.facets, coincidence_steps, options.hidden_strokes);
  }
  statistics.time("intersections", clock.lap());

  // 3. Lines. Each may coincide with another.
  BodyTotals totals;
  const auto against_bodies = [&](LineKind kind) {
    return [&bodies, &totals, coincidence_steps, kind]() -> LineVisibility {
      const auto search = std::make_shared<BodyLines>(bodies, coincidence_steps, kind, totals);
      return [search](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
        search->find(line, parts);
        return true;
      };
    };
  };
  LineStrokes strokes(scene, bodies.facets, options.hidden_strokes, kLeastPartMm / step);
  const auto edges = against_bodies(LineKind::edge), penetrations = against_bodies(LineKind::intersection);
  strokes.add_edges(edges, options.progress);
  strokes.add_intersections(intersections, penetrations);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  report(bodies, totals.counts, statistics);
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("intersection segments tested", intersections.size());
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

}  // namespace ligne
