// Experiments on faces that clip faces, [Boulle1980] 2.4.2.4 and 2.4.2.6.

#include <algorithm>
#include <array>

#include "picture/light/shadows.hpp"
#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/scenes/generators.hpp"
#include "view/tolerances.hpp"
#include "visibility/atherton_weiler/polygon_study.hpp"
#include "visibility/newell/paint_elements.hpp"
#include "visibility/registry.hpp"

namespace ligne::studies {
namespace {

using atherton_weiler::PolygonCounts;

struct PolygonRun {
  PolygonCounts counts;
  std::uint64_t regions = 0;
};

PolygonRun study_polygons(Scene scene) {
  finish(scene);
  const ProjectedScene projected = on_sheet(scene);
  const Facets facets = make_facets(projected, coincidence_mm(projected) / projected.lattice.step_mm);
  PolygonRun run;
  run.regions = atherton_weiler::study_polygons(projected, facets.facets, {}, {}, run.counts).regions.size();
  return run;
}

/// A key for sorting faces by depth, after figure 2.68. The face with the smaller key is assumed to be in front.
struct SortKey {
  const char *name, *thesis;
  double (*of)(const std::vector<double>& depths);
};
constexpr SortKey kKeys[] = {
    {"nearest point", "the key used; it errs", [](const std::vector<double>& d) { return *std::ranges::min_element(d); }},
    {"mean of the corners", "other keys: costlier, fewer errors",
     [](const std::vector<double>& d) {
       double sum = 0;
       for (const double z : d) sum += z;
       return sum / static_cast<double>(d.size());
     }},
    {"farthest point", "other keys: costlier, fewer errors",
     [](const std::vector<double>& d) { return *std::ranges::max_element(d); }},
    {"middle of the extent", "other keys: costlier, fewer errors",
     [](const std::vector<double>& d) {
       const auto [low, high] = std::minmax_element(d.begin(), d.end());
       return *low + *high;
     }},
};

struct Wrong {
  std::uint64_t pairs = 0;
  std::array<std::uint64_t, std::size(kKeys)> wrong{};
};

/// Counts the pairs in which one face hides the other, and those that each key orders wrongly.
Wrong wrong_pairs(Scene scene) {
  finish(scene);
  const ProjectedScene projected = on_sheet(scene);
  newell::PaintElements elements(projected);
  std::vector<std::array<double, std::size(kKeys)>> keys(elements.size());
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    std::vector<double> depths;
    for (const std::uint32_t v : scene.faces.contour(elements[i].face, 0)) depths.push_back(scene.vertices[v].y);
    for (std::size_t k = 0; k < std::size(kKeys); ++k) keys[i][k] = kKeys[k].of(depths);
  }
  newell::CommonPart work;
  Wrong found;
  for (std::uint32_t a = 0; a < elements.size(); ++a) {
    for (std::uint32_t b = a + 1; b < elements.size(); ++b) {
      const newell::Extents &ea = elements[a].extents, &eb = elements[b].extents;
      if (!ea.overlap(eb, 0) || !ea.overlap(eb, 1) || elements.disjoint(a, b)) continue;
      const newell::Hiding hiding = elements.hiding(a, b, work);
      if (hiding.first == hiding.second) continue;
      ++found.pairs;
      for (std::size_t k = 0; k < std::size(kKeys); ++k)
        found.wrong[k] += hiding.first ? keys[a][k] > keys[b][k] : keys[b][k] > keys[a][k];
    }
  }
  return found;
}

}  // namespace

Result study_slab_order(const StudyRequest&) {
  const PolygonRun slab = study_polygons(screen_before_slab(false)), all = study_polygons(screen_before_slab(true));
  Table table{"Figure 2.66: a slab of four faces behind a screen face",
              {{"order", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"clips", ColumnKind::count},
               {"regions made on the way", ColumnKind::count},
               {"regions seen", ColumnKind::count}}};
  // In far-first order the slab is studied alone, and the screen face clips each of its regions afterwards.
  table.rows.push_back({"far slab first", "four faces compared, three made, all for nothing",
                        slab.counts.clips + slab.regions, slab.regions, all.regions});
  table.rows.push_back(
      {"near slab first", "the others go by a simple test", all.counts.clips, std::uint64_t{0}, all.regions});
  Result result;
  result.finding =
      all.counts.clips < slab.counts.clips + slab.regions && all.regions == 1 ? Finding::holds : Finding::no_longer;
  result.tables.push_back(std::move(table));
  result.sentence =
      "From the near end the screen face clips each hidden face once and nothing of them is ever compared; from the far end regions "
      "are made first that are all hidden.";
  return result;
}

Result study_sort_keys(const StudyRequest& request) {
  Table table{"Pairs of faces of which one hides the other, that the key puts the wrong way round",
              {{"scene", ColumnKind::label},
               {"key", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"pairs", ColumnKind::count},
               {"wrong", ColumnKind::count},
               {"wrong %", ColumnKind::measure}}};
  struct Family {
    const char* name;
    Scene scene;
  };
  const int n = request.pick(20, 200);
  Family families[] = {
      {"figure 2.68", {}}, {"faces that lean alike", leaning_faces(n, 5)}, {"boxes of a city", city(request.pick(3, 8))}};
  // P has the nearest point, but lies behind Q and R where they overlap.
  add_plate(families[0].scene, {0, 14}, {0, 6}, {0, 7});
  add_plate(families[0].scene, {8, 10}, {1, 8}, {2, 2});
  add_plate(families[0].scene, {10, 13}, {-1, 4}, {3, 3});
  std::array<std::uint64_t, std::size(kKeys)> sum{};
  for (Family& f : families) {
    const Wrong found = wrong_pairs(std::move(f.scene));
    for (std::size_t k = 0; k < std::size(kKeys); ++k) {
      sum[k] += found.wrong[k];
      table.rows.push_back({f.name, kKeys[k].name, kKeys[k].thesis, found.pairs, found.wrong[k],
                            found.pairs == 0 ? 0.0 : 100.0 * double(found.wrong[k]) / double(found.pairs)});
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = sum[1] < sum[0] ? Finding::holds : Finding::no_longer;
  result.sentence =
      "The mean of the corners errs less than the nearest point, and the middle of the extent as little; no key is right, so what "
      "the sort says has to be checked with any.";
  return result;
}

Result study_clip_sum(const StudyRequest& request) {
  Table table{"Figure 2.67: n faces of which each shows r parts, slabs not used to leave anything out but by boxes",
              {{"n", ColumnKind::label},
               {"r", ColumnKind::label},
               {"thesis: sum of k r + n - k", ColumnKind::source},
               {"regions seen", ColumnKind::count},
               {"pairs of a list", ColumnKind::count},
               {"clips", ColumnKind::count},
               {"clips over faces", ColumnKind::measure}}};
  Chart chart{"Clips for n faces, each cut by one", "faces", "clips"};
  chart.logarithmic = true;
  double last_growth = 0;
  for (const int r : {2, 3, 5}) {
    chart.curves.push_back({"r = " + std::to_string(r) + ", clips", {}});
    chart.curves.push_back({"r = " + std::to_string(r) + ", thesis", {}});
    std::vector<int> numbers{5, 10};
    if (request.full()) numbers.insert(numbers.end(), {20, 40, 80, 160});
    double before = 0;
    for (const int n : numbers) {
      const PolygonRun run = study_polygons(nested(n, r));
      std::uint64_t sum = 0;
      for (int k = 0; k < n * r; ++k) sum += static_cast<std::uint64_t>(std::max(0, k * r + n - k));
      table.rows.push_back({std::to_string(n), std::to_string(r), std::to_string(sum), run.regions, run.counts.considered,
                            run.counts.clips, double(run.counts.clips) / n});
      chart.curves[chart.curves.size() - 2].points.emplace_back(n, double(run.counts.clips));
      chart.curves.back().points.emplace_back(n, double(sum));
      if (before > 0) last_growth = growth(n / 2.0, before, n, double(run.counts.clips));
      before = double(run.counts.clips);
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.charts.push_back(std::move(chart));
  result.finding = Finding::in_part;
  char e[16];
  std::snprintf(e, sizeof e, "%.2f", last_growth);
  result.sentence = std::string(
                        "The pairs of a list grow with the square of the faces, as the sum says, but a face is one subject "
                        "here however many parts of it are seen, which takes the power of r away, and boxes leave clips "
                        "that grow with n to the ") +
                    e + ".";
  return result;
}

Result study_shadow_cost(const StudyRequest& request) {
  Table table{"Regions seen from the eye, and cut by what a parallel light sees",
              {{"scene", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"regions", ColumnKind::count},
               {"with shadows", ColumnKind::count},
               {"time with over without", ColumnKind::time}}};
  double most = 0;
  const int blocks = request.pick(3, 20), rows = request.pick(6, 60);
  std::vector<NamedScene> scenes;
  scenes.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", city(blocks)});
  scenes.push_back({"a ball of " + std::to_string(2 * rows * (rows - 1)) + " triangles", ball(rows)});
  for (NamedScene& s : scenes) finish(s.scene);
  for (const NamedScene& s : request.models) scenes.push_back(s);
  const Light light{Light::Kind::parallel, {1, 2, -3}};
  for (const NamedScene& s : scenes) {
    const ProjectedScene projected = on_sheet(s.scene, s.view);
    const Topology topology = build_topology(s.scene);
    VisibilityOptions options;
    options.wanted = kRegions;
    std::vector<Region> regions;
    const double alone = least_seconds(request.pick(1, 3),
                                       [&] { regions = *region_method().compute_visibility(projected, options).regions; });
    std::size_t cut = 0;
    const double shadows = least_seconds(request.pick(1, 3), [&] {
      cut = cast_shadows(s.scene, topology, projected.view, std::span(&light, 1), regions).regions.size();
    });
    most = std::max(most, times_as_long(alone + shadows, alone));
    table.rows.push_back(
        {s.name, "twice", std::uint64_t{regions.size()}, std::uint64_t{cut}, times_as_long(alone + shadows, alone)});
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = most < 3 ? Finding::holds : Finding::in_part;
  result.sentence =
      "One light costs a second study, and besides it the regions of the eye have to be cut by those of the light, which the thesis "
      "does not count.";
  return result;
}

}  // namespace ligne::studies
