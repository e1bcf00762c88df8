#include "studies/scenes/scan_input.hpp"

#include "studies/measure.hpp"
#include "studies/scenes/generators.hpp"
#include "view/tolerances.hpp"

namespace ligne::studies {
namespace {

using namespace watkins;

class Nobody final : public LineListener {
 public:
  void line(const LineScan&, std::uint32_t, bool) override {}
};

}  // namespace

ScanInput make_scan_input(const NamedScene& named) {
  ScanInput input{named.name, on_sheet(named.scene, named.view, false), {}, {}};
  const double step = input.scene.lattice.step_mm;
  input.facets = make_facets(input.scene, coincidence_mm(input.scene) / step).facets;
  for (const ProjectedEdge& e : input.scene.edges)
    input.lines.push_back({input.scene.vertices[e.v0], input.scene.vertices[e.v1], e.face0, e.face1});
  ExactOptions exact{.coincidence_steps = coincidence_mm(input.scene) / step, .penetrations = true};
  ExactResult found = study_exactly(input.scene.vertices, input.facets, {}, exact);
  for (const Intersection& i : take_intersections(found, input.scene.vertices, input.facets, kLeastPartMm / step))
    input.lines.push_back({i.from, i.to, i.face0, i.face1});
  return input;
}

ScanCost scan_cost(const ScanInput& input, std::uint32_t lines, bool whole, const ScanOptions& options, int times) {
  LineGrid grid = grid_of_lines(input.scene, lines);
  grid.whole = whole;
  const double thin_steps = coincidence_mm(input.scene) / input.scene.lattice.step_mm;
  const ScanScene scene = make_scan_scene(input.scene, input.facets, input.lines, grid, thin_steps);
  ScanCost cost;
  cost.seconds = least_seconds(times, [&] {
    Nobody nobody;
    LineScan scan(scene, input.scene.vertices, input.facets, input.lines, options, nobody);
    scan.scan(0, lines);
    cost.scan = scan.counts();
    cost.spans = scan.span_counts();
  });
  return cost;
}

std::vector<NamedScene> scan_scenes(const StudyRequest& request) {
  std::vector<NamedScene> scenes;
  const int blocks = request.pick(3, 14), rows = request.pick(8, 60), boxes = request.pick(4, 60);
  scenes.push_back({"5 square columns at 30 degrees", columns(5, 30)});
  scenes.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", city(blocks)});
  scenes.push_back({"a ball of " + std::to_string(2 * rows * (rows - 1)) + " triangles", ball(rows)});
  scenes.push_back({std::to_string(boxes) + " boxes that penetrate", penetrating_boxes(boxes)});
  for (NamedScene& s : scenes) finish(s.scene);
  for (const NamedScene& s : request.models) scenes.push_back(s);
  return scenes;
}

}  // namespace ligne::studies
