// Faces in front of an edge, found edge by edge or propagated from vertex to vertex: [Boulle1980] 1.1, after [Appel1967],
// [GalimbertiMontanari1969] and [Loutrel1970].

#include <algorithm>

#include "studies/experiments.hpp"
#include "studies/scenes/generators.hpp"
#include "visibility/registry.hpp"

namespace ligne::studies {
namespace {

struct HidingWay {
  std::string_view word, name, source;
};
constexpr HidingWay kHidingWays[] = {
    {"test", "every edge against all faces", "no figure: what the three papers spare"},
    {"count", "the number", "Appel: it changes where outlines are crossed, and nowhere else"},
    {"nature", "the set of faces", "Galimberti and Montanari: it changes at every side"},
    {"path", "the number along a path", "Loutrel: one start, then edge after edge"},
};

std::uint64_t counted(const Statistics& statistics, std::string_view name) {
  const auto found = std::ranges::find(statistics.counts, name, [](const auto& c) { return std::string_view(c.first); });
  return found == statistics.counts.end() ? 0 : found->second;
}

}  // namespace

Result study_propagation(const StudyRequest& request) {
  Table table{"Edges tested against all faces, and edges that go on from a vertex",
              {{"scene", ColumnKind::label},
               {"carried", ColumnKind::label},
               {"source", ColumnKind::source},
               {"edges", ColumnKind::count},
               {"tested", ColumnKind::count},
               {"gone on", ColumnKind::count},
               {"edge against face", ColumnKind::count},
               {"edge against near face", ColumnKind::count},
               {"edge against side", ColumnKind::count},
               {"all, of testing", ColumnKind::measure},
               {"strokes", ColumnKind::count}}};
  const int blocks = request.pick(3, 8), rows = request.pick(6, 16), boxes = request.pick(4, 20);
  std::vector<NamedScene> scenes;
  scenes.push_back({"a ring of 9 bars", ring(9), "front"});
  scenes.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", city(blocks)});
  scenes.push_back({"a ball, " + std::to_string(rows) + " rows", ball(rows)});
  scenes.push_back({std::to_string(boxes) + " boxes that penetrate", penetrating_boxes(boxes)});
  scenes.insert(scenes.end(), request.models.begin(), request.models.end());
  const ligne::Method& appel = *find_method("appel");
  bool spared = true, alike = true;
  for (NamedScene& named : scenes) {
    finish(named.scene);
    const ProjectedScene projected = on_sheet(named.scene, named.view);
    double all_tests = 0;
    std::uint64_t strokes = 0, faces = 0;
    for (std::size_t w = 0; w < std::size(kHidingWays); ++w) {
      VisibilityOptions options;
      options.settings.set("propagate", ParameterWord{w + 1});
      const VisibilityResult result = appel.compute_visibility(projected, options);
      const Statistics& statistics = result.statistics;
      const std::uint64_t tests = counted(statistics, "of these, for edges"),
                          near = counted(statistics, "facets near edges"), sides = counted(statistics, "line-side tests");
      if (w == 0) {
        all_tests = std::max(1.0, double(tests));
        strokes = result.strokes->strokes.size();
        faces = tests;
      }
      spared = spared && tests <= faces;
      alike = alike && strokes == result.strokes->strokes.size();
      table.rows.push_back({named.name, std::string(kHidingWays[w].name), std::string(kHidingWays[w].source),
                            std::uint64_t{projected.edges.size()}, counted(statistics, "edges against all faces"),
                            counted(statistics, "edges propagated"), tests, near, sides,
                            double(tests + near + sides) / all_tests, std::uint64_t{result.strokes->strokes.size()}});
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = !alike || !spared ? Finding::no_longer : Finding::in_part;
  result.sentence =
      "All ways give the same lines, and carrying spares tests of edges against all faces; but to be certain that nothing "
      "is "
      "touched or pierced takes looks at faces near by, and a set of faces changes at so many sides that it costs more than "
      "it "
      "spares.";
  return result;
}

}  // namespace ligne::studies
