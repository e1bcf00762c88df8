#include <optional>

#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/occluded_cells.hpp"
#include "visibility/edges/edge_visibility.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/edges/propagation.hpp"
#include "visibility/method.hpp"
#include "visibility/methods.hpp"
#include "visibility/penetration/intersections.hpp"

namespace ligne {
namespace {

/// Visibility of edges by counting the faces in front of each part: each edge is tested by itself, or the counts are
/// carried from vertex to vertex.

/// Tests every line against all faces.
template <class LineOf>
CountedLines count_each(std::size_t lines, const FacetForest& forest, double coincidence_steps, bool with_faces,
                        PropagationCounts& counts, LineOf line_of) {
  CountedLines parts(lines);
  FaceCounter counter(forest, coincidence_steps);
  for (std::size_t i = 0; i < lines; ++i) {
    const PageLine line = line_of(i);
    if (line.p0 == line.p1) continue;
    ++counts.tested;
    parts[i] = counter.count(line, with_faces, counts.facets);
  }
  return parts;
}

/// A line is visible where no face lies in front of it.
LineVisibility seen_parts(const CountedLines& counted, const OccludedCells* blank) {
  return [&counted, blank](std::size_t i, const PageLine& line, std::vector<LinePart>& parts) {
    for (const CountedPart& part : counted[i]) {
      if (part.count == 0) append_part(parts, {part.from, part.to});
    }
    if (blank) blank->take_from(parts, line);
    return true;
  };
}

/// Gives the strokes of edge_visibility(); the level of a hidden stroke is the number of faces in front of it. Without
/// a propagation every edge is tested against all faces.
VisibilityResult counted_visibility(const ProjectedScene& scene, const VisibilityOptions& options,
                                    std::optional<Propagation> propagation) {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;
  const Facets facets = make_facets(scene, coincidence_steps);
  const FacetForest forest(scene, facets.facets);
  statistics.time("facets", clock.lap());

  std::vector<Intersection> intersections;
  if (scene.with_intersections)
    intersections = find_intersections(scene, facets.facets, coincidence_steps, options.hidden_strokes);
  statistics.time("intersections", clock.lap());

  const bool with_faces = propagation == Propagation::nature;
  PropagationCounts counts;
  const auto edge = [&](std::size_t i) {
    const ProjectedEdge& e = scene.edges[i];
    return PageLine(scene.vertices[e.v0], scene.vertices[e.v1], e.face0, e.face1);
  };
  const CountedLines of_edges = propagation
                                    ? propagate(scene, forest, coincidence_steps, *propagation, counts)
                                    : count_each(scene.edges.size(), forest, coincidence_steps, with_faces, counts, edge);
  PropagationCounts apart;
  const CountedLines of_intersections =
      count_each(intersections.size(), forest, coincidence_steps, with_faces, apart, [&](std::size_t i) {
        const Intersection& x = intersections[i];
        return PageLine(x.from, x.to, x.face0, x.face1);
      });
  LineStrokes strokes(scene, facets, options.hidden_strokes, kLeastPartMm / step);
  strokes.add_edges([&] { return seen_parts(of_edges, options.blank); }, options.progress, &of_edges);
  strokes.add_intersections(
      intersections, [&] { return seen_parts(of_intersections, options.blank); }, &of_intersections);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  statistics.count("facets", facets.facets.size());
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("edges against all faces", counts.tested);
  statistics.count("of these, in doubt", counts.in_doubt);
  statistics.count("edges propagated", counts.carried);
  statistics.count("line-facet tests", counts.facets + apart.facets);
  statistics.count("of these, for edges", counts.facets);
  statistics.count("facets near edges", counts.near);
  statistics.count("line-side tests", counts.sides);
  statistics.count("intersection segments tested", intersections.size());
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

enum class Carried : std::uint8_t { off, test, count, nature, path };
constexpr std::string_view kCarriedNames[] = {"off", "test", "count", "nature", "path"};
constexpr MethodParameter kParameters[] = {
    experiment(
        {"propagate", "off|test|count|nature|path",
         "count the faces in front of each edge part. test: one test per edge; count, nature: propagate their number or "
         "their set from vertex to vertex; path: propagate along a path of edges",
         "off", kCarriedNames}),
};

VisibilityResult appel_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  switch (options.settings.choice("propagate", Carried::off)) {
    case Carried::off:
      break;
    case Carried::test:
      return counted_visibility(scene, options, {});
    case Carried::count:
      return counted_visibility(scene, options, Propagation::count);
    case Carried::nature:
      return counted_visibility(scene, options, Propagation::nature);
    case Carried::path:
      return counted_visibility(scene, options, Propagation::path);
  }
  return edge_visibility(scene, options);
}

}  // namespace

const Method& appel_method() {
  static const FunctionMethod method(
      {.name = "appel",
       .summary = "each edge tested against the faces that can hide it, by exact intervals; the default for line drawings",
       .paper =
           "A. Appel, The notion of quantitative invisibility, 1967; R. Galimberti, U. Montanari, An algorithm for hidden line "
           "elimination, 1969",
       .parameters = kParameters},
      appel_visibility);
  return method;
}

}  // namespace ligne
