#include "support/stroke_places.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "support/comparison.hpp"

namespace ligne::test {
namespace {

/// Half a step each for the ends of the line on which the stroke lies, and for the stroke's own end; rounded up for
/// intersections, whose lines are found between points of the lattice.
constexpr double kSteps = 3;
/// A parameter carries the roundings of two quotients and of the weights between page and model.
constexpr double kParameterRounding = 0x1p-50;
/// Four products, three sums and a quotient, and a translation that was itself a sum.
constexpr double kMatrixRounding = 0x1p-49;

struct Place {
  Point2 mm{0, 0};
  double error_mm = 0;
};

Place page_place(const View& view, const SourceEdge& source, double t) {
  const Point3 p = source.ends[0] + t * (source.ends[1] - source.ends[0]);
  const glm::dvec4 h = view.model_to_page * glm::dvec4(p, 1);
  glm::dvec4 sizes(0);
  for (int i = 0; i < 4; ++i) sizes += glm::abs(view.model_to_page[i]) * (i < 3 ? std::abs(p[i]) : 1.0);
  const Point2 mm{h.x / h.w, h.y / h.w};
  const double size = std::max(sizes.x, sizes.y) + sizes.w * std::max(std::abs(mm.x), std::abs(mm.y));
  return {mm, kMatrixRounding * size / std::abs(h.w)};
}

/// How far the end is from where it ought to be, less what rounding explains.
double distance(const View& view, const SourceEdge& source, double t, Point2 end, double tolerance_mm, Place& place) {
  place = page_place(view, source, t);
  const Place before = page_place(view, source, t - kParameterRounding);
  const Place after = page_place(view, source, t + kParameterRounding);
  const double along = std::max(glm::distance(before.mm, place.mm), glm::distance(after.mm, place.mm));
  return glm::distance(place.mm, end) - (tolerance_mm + along + place.error_mm);
}

}  // namespace

Fault misplaced(const StrokeModel& model, const Scene& scene, const Topology& topology, const View& view,
                double tolerance_mm) {
  Fault fault;
  const double tolerance = tolerance_mm + kSteps * model.lattice.step_mm;
  for (const Stroke& s : model.strokes) {
    SourceEdge source;
    if (s.source < topology.edges.size()) {
      const Edge& edge = topology.edges[s.source];
      source.ends = {scene.vertices[edge.v0], scene.vertices[edge.v1]};
    } else if (s.source >= model.edge_count) {
      source = model.intersections[s.source - model.edge_count];
    } else {
      continue;
    }
    for (const bool last : {false, true}) {
      const Point2 end = model.lattice.to_mm(last ? s.to : s.from);
      Place place;
      if (!(distance(view, source, last ? s.t_to : s.t_from, end, tolerance, place) <= 0)) {
        add(fault, {place.mm, end}, "end of a stroke of edge " + std::to_string(s.source) + " beside its place");
      }
    }
  }
  return fault;
}

}  // namespace ligne::test
