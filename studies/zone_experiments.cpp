// Experiment on the zones of the priority list, sorted at the same time, [Boulle1980] 2.6.

#include <algorithm>
#include <chrono>

#include <glm/geometric.hpp>

#include "scene/model/scene_parts.hpp"
#include "studies/experiments.hpp"
#include "studies/scenes/generators.hpp"
#include "visibility/newell/priority_list.hpp"

namespace ligne::studies {
namespace {

/// A grid of n x n crowds of boxes that penetrate each other, apart in the view from the front. The first has `of_first`
/// boxes, the others three.
Scene crowds(int n, int of_first) {
  Scene scene;
  Chance chance(5);
  for (int i = 0; i < n * n; ++i) {
    for (int k = 0; k < (i == 0 ? of_first : 3); ++k) {
      const Basis basis = rotation(chance.uniform(-3, 3), chance.uniform(-3, 3), chance.uniform(-3, 3));
      const Point3 middle{10.0 * (i % n) + chance.uniform(-1, 1), chance.uniform(-1, 1),
                          10.0 * (i / n) + chance.uniform(-1, 1)};
      const Point3 size{chance.uniform(1, 2), chance.uniform(1, 2), chance.uniform(1, 2)};
      // The basis turns a box about the origin.
      const Point3 turned{glm::dot(basis[0], middle), glm::dot(basis[1], middle), glm::dot(basis[2], middle)};
      add_box(scene, turned - size * 0.5, size, basis);
    }
  }
  return scene;
}

struct ZoneRun {
  newell::ListCounts counts;
  std::vector<newell::PriorityList::SortedList> lists;
  std::vector<std::uint32_t> faces;  ///< of the elements, farthest first
  std::size_t elements = 0;          ///< before cuts
  double seconds = 1e300;            ///< by the clock on the wall, least of the runs
};

ZoneRun sort_zones(const ProjectedScene& projected, bool parallel, int times) {
  ZoneRun run;
  for (int i = 0; i < times; ++i) {
    newell::PaintElements elements(projected);
    newell::PriorityList list(elements, {.parallel = parallel});
    run.elements = elements.size();
    const auto start = std::chrono::steady_clock::now();
    const std::vector<std::uint32_t> order = list.sort();
    run.seconds = std::min(run.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    run.counts = list.counts();
    run.lists = list.lists();
    run.faces.clear();
    for (const std::uint32_t e : order) run.faces.push_back(elements[e].face);
  }
  return run;
}

/// A row of the table. Returns whether both ways give one order.
bool add_zone_row(const NamedScene& named, int times, Table& table) {
  const ProjectedScene projected = on_sheet(named.scene, named.view);
  const ZoneRun one = sort_zones(projected, false, times), all = sort_zones(projected, true, times);
  std::size_t longest = 0;
  std::uint64_t most = 0, cuts = 0;
  for (const auto& list : all.lists) {
    longest = std::max(longest, list.elements);
    most = std::max(most, list.compared);
    cuts += list.cuts;
  }
  const bool is_same = one.faces == all.faces && one.counts.compared == all.counts.compared;
  table.rows.push_back({named.name, "the number of zones permits treatment in parallel", std::uint64_t{all.elements},
                        all.counts.zones, all.counts.slabs, std::uint64_t{all.lists.size()}, std::uint64_t{longest},
                        all.counts.compared, cuts, most,
                        double(all.counts.compared) / double(std::max<std::uint64_t>(most, 1)),
                        std::string(is_same ? "yes" : "no"), 1e3 * one.seconds, 1e3 * all.seconds});
  return is_same;
}

}  // namespace

Result study_zones(const StudyRequest& request) {
  Table table{"Lists of zones and slabs, one after the other and at the same time",
              {{"scene", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"elements", ColumnKind::count},
               {"zones", ColumnKind::count},
               {"slabs", ColumnKind::count},
               {"lists", ColumnKind::count},
               {"elements of the longest", ColumnKind::count},
               {"pairs compared", ColumnKind::count},
               {"cuts", ColumnKind::count},
               {"pairs of the list with most", ColumnKind::count},
               {"bound of the gain", ColumnKind::measure},
               {"one order", ColumnKind::words},
               {"ms, one after the other", ColumnKind::time},
               {"ms, at the same time", ColumnKind::time}}};
  const int n = request.pick(5, 40);
  std::vector<NamedScene> scenes{
      {"figure 2.88", zones_of_slabs(), "front"},
      {std::to_string(n * n) + " crowds of 3 boxes", crowds(n, 3), "front"},
      {std::to_string(n * n) + " crowds, the first of 24 boxes", crowds(n, 24), "front"},
      {"a city of " + std::to_string(n * n) + " boxes, from above", city(n), "top"},
      {"a city of " + std::to_string(n * n) + " boxes, aslant", city(n), "iso"},
  };
  for (NamedScene& named : scenes) finish(named.scene);
  scenes.insert(scenes.end(), request.models.begin(), request.models.end());
  bool is_same = true;
  for (const NamedScene& named : scenes) is_same = add_zone_row(named, request.pick(1, 3), table) && is_same;
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = is_same ? Finding::holds : Finding::no_longer;
  result.sentence =
      "Zones are sorted at the same time with the order and the counts of one after the other, since a cut stays within its list. "
      "The bound of the gain is all pairs over those of the list with most. A view aslant has few zones, and the comparisons within "
      "one list are shared as well.";
  return result;
}

}  // namespace ligne::studies
