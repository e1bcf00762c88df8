// Experiments on the priority list, [Boulle1980] 2.5.2.7.

#include <algorithm>

#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/scenes/generators.hpp"
#include "visibility/newell/priority_list.hpp"

namespace ligne::studies {
namespace {

struct ListRun {
  newell::ListCounts counts;
  std::uint64_t elements = 0;
};

ListRun sort_faces(Scene scene) {
  finish(scene);
  const ProjectedScene projected = on_sheet(scene);
  newell::PaintElements elements(projected);
  newell::PriorityList list(elements);
  ListRun run;
  run.elements = list.sort().size();
  run.counts = list.counts();
  return run;
}

std::uint64_t cuts(const ListRun& run) { return run.counts.plane_cuts + run.counts.page_cuts; }

Table apart(const StudyRequest& request, bool& holds) {
  Table table{"Figure 2.83: the depths of all faces are apart",
              {{"faces", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"pairs compared", ColumnKind::count},
               {"slabs", ColumnKind::count},
               {"ms", ColumnKind::time}}};
  for (int n = 10; n <= request.pick(100, 10000); n *= 10) {
    ListRun run;
    const double seconds = least_seconds(1, [&] { run = sort_faces(apart_in_depth(n)); });
    holds = holds && run.counts.compared == 0 && run.counts.slabs == static_cast<std::uint64_t>(n);
    table.rows.push_back({std::to_string(n), "O(n): no comparison", run.counts.compared, run.counts.slabs, 1e3 * seconds});
  }
  return table;
}

Table mutual(const StudyRequest& request) {
  Table table{"Figure 2.84: n faces of r corners in mutual overlap with P",
              {{"faces", ColumnKind::label},
               {"r", ColumnKind::label},
               {"thesis: (n (r/2 + 1))^2", ColumnKind::source},
               {"pairs compared", ColumnKind::count},
               {"cuts", ColumnKind::count},
               {"final elements", ColumnKind::count},
               {"elements over (faces + 1)", ColumnKind::measure}}};
  for (const int teeth : {2, 4}) {
    for (int n = 2; n <= request.pick(4, 64); n *= 2) {
      const ListRun run = sort_faces(combs_through_plate(n, teeth));
      const int r = 4 * teeth, pieces = n * (r / 2 + 1);
      table.rows.push_back({std::to_string(n), std::to_string(r), std::to_string(pieces * pieces), run.counts.compared,
                            cuts(run), run.elements, double(run.elements) / double(n + 1)});
    }
  }
  return table;
}

Table pieces_of_a_cut(bool& holds) {
  Table table{"Figure 2.85: a comb of r corners cut through its teeth",
              {{"r", ColumnKind::label}, {"thesis: at most r/2 + 1", ColumnKind::source}, {"pieces", ColumnKind::count}}};
  for (int teeth = 1; teeth <= 6; ++teeth) {
    Scene scene;
    add_comb(scene, teeth, 5);
    finish(scene);
    const ProjectedScene projected = on_sheet(scene);
    newell::PaintElements elements(projected);
    const std::uint64_t pieces = elements.cut(0, {{1, 0, 0}, {6, 0, 0}}).size();
    const std::uint64_t most = 2 * static_cast<std::uint64_t>(teeth) + 1;
    holds = holds && pieces <= most;
    table.rows.push_back({std::to_string(4 * teeth), std::to_string(most), pieces});
  }
  return table;
}

Table rings(const StudyRequest& request, Chart& chart) {
  Table table{"Rings: n bars, each over the next",
              {{"bars", ColumnKind::label},
               {"thesis: n (n - 1) comparisons", ColumnKind::source},
               {"pairs compared", ColumnKind::count},
               {"moved", ColumnKind::count},
               {"cuts", ColumnKind::count},
               {"compared over n", ColumnKind::measure}}};
  chart.curves = {{"thesis", {}}, {"compared", {}}};
  for (int n = 3; n <= request.pick(6, 192); n = n < 6 ? n + 1 : 2 * n) {
    const ListRun run = sort_faces(ring(n));
    table.rows.push_back({std::to_string(n), std::to_string(n * (n - 1)), run.counts.compared, run.counts.moved, cuts(run),
                          double(run.counts.compared) / n});
    chart.curves[0].points.emplace_back(n, n * (n - 1.0));
    chart.curves[1].points.emplace_back(n, double(std::max<std::uint64_t>(run.counts.compared, 1)));
  }
  return table;
}

/// The division of a set in words, such as "zones, from the left".
std::string division_words(const newell::PriorityList::SetNode& node) {
  using Division = newell::PriorityList::Division;
  switch (node.division) {
    case Division::x:
      return "zones, from the left";
    case Division::y:
      return "zones, from the top";
    case Division::depth:
      return "slabs, from the nearest";
    case Division::list:
      return "a list, sorted";
    case Division::one:
      break;
  }
  return "one face";
}

/// The tree of figure 2.88, one row per set. "2.1" is the first part of the second part of the scene.
Table decomposition_of(const NamedScene& named, bool& without_list) {
  Table table{"Decomposition of " + named.name,
              {{"set", ColumnKind::label},
               {"divided into", ColumnKind::words},
               {"thesis", ColumnKind::source},
               {"faces", ColumnKind::count},
               {"first face", ColumnKind::count}}};
  const ProjectedScene projected = on_sheet(named.scene, named.view);
  newell::PaintElements elements(projected);
  newell::PriorityList list(elements, {.keep_sets = true});
  list.sort();
  const auto& tree = list.tree();
  std::vector<std::string> names(tree.size());
  std::vector<unsigned> children(tree.size(), 0);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const newell::PriorityList::SetNode& node = tree[i];
    if (i > 0) {
      const std::string& parent = names[node.parent];
      names[i] = (parent == "whole" ? "" : parent + ".") + std::to_string(++children[node.parent]);
    } else {
      names[i] = "whole";
    }
    without_list = without_list && node.division != newell::PriorityList::Division::list;
    table.rows.push_back({names[i], division_words(node), "boxes of one face: the study is done",
                          std::uint64_t{node.elements.size()},
                          std::uint64_t{elements[*std::ranges::min_element(node.elements)].face}});
  }
  std::ranges::sort(table.rows, [](const auto& a, const auto& b) {
    const auto path = [](const std::vector<Cell>& row) {
      std::vector<int> numbers;
      for (const char c : std::get<std::string>(row[0])) {
        if (c == '.' || numbers.empty()) numbers.push_back(0);
        if (c >= '0' && c <= '9') numbers.back() = 10 * numbers.back() + (c - '0');
      }
      return numbers;
    };
    return path(a) < path(b);
  });
  return table;
}

}  // namespace

Result study_decomposition(const StudyRequest& request) {
  NamedScene figure{"figure 2.88", zones_of_slabs(), "front"};
  finish(figure.scene);
  bool without_list = true, others = true;
  Result result;
  result.tables.push_back(decomposition_of(figure, without_list));
  for (const NamedScene& named : request.models) result.tables.push_back(decomposition_of(named, others));
  result.finding = without_list ? Finding::holds : Finding::no_longer;
  result.sentence =
      "Zones and slabs are decomposed in turn until each has one face; a walk through the tree is the model of visibility, "
      "and no "
      "pair of faces is compared.";
  return result;
}

Result study_list_cases(const StudyRequest& request) {
  Result result;
  bool holds = true;
  Chart chart{"Rings of n bars: pairs compared", "bars", "pairs"};
  chart.logarithmic = true;
  result.tables.push_back(apart(request, holds));
  result.tables.push_back(mutual(request));
  result.tables.push_back(pieces_of_a_cut(holds));
  result.tables.push_back(rings(request, chart));
  result.charts.push_back(std::move(chart));
  result.finding = holds ? Finding::in_part : Finding::no_longer;
  result.sentence =
      "Faces apart in depth are never compared and a cut makes r / 2 + 1 pieces at the most. A ring costs comparisons in "
      "proportion "
      "to its bars, since only faces that overlap on the page are compared; faces that all stand in one are compared with "
      "the square "
      "of their number, but the pieces of a cut do not count, so r plays no part.";
  return result;
}

}  // namespace ligne::studies
