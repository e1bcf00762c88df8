// Experiments on the study of polygons and its clip: [Boulle1980] 2.4.2.4, 2.4.3.2 and 3.2.3.4.

#include <algorithm>

#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/scenes/generators.hpp"
#include "view/tolerances.hpp"
#include "visibility/atherton_weiler/polygon_study.hpp"

namespace ligne::studies {
namespace {

using atherton_weiler::ClipKind;
using atherton_weiler::InsideTest;
using atherton_weiler::PolygonCounts;
using atherton_weiler::PolygonOptions;
using atherton_weiler::ZoneTest;

/// A scene on the sheet with its facets.
struct StudiedScene {
  std::string name;
  ProjectedScene scene;
  std::vector<Facet> facets;
};

struct ClipRun {
  PolygonCounts counts;
  std::vector<Region> regions;
};

ClipRun run_study(const StudiedScene& s, const PolygonOptions& options) {
  ClipRun run;
  run.regions = atherton_weiler::study_polygons(s.scene, s.facets, options, {}, run.counts).regions;
  return run;
}

/// Whether two runs see the same area of each face, to a millionth of the page.
bool same_areas(const ClipRun& a, const ClipRun& b, const StudiedScene& s) {
  std::vector<double> difference;
  const auto add = [&](const std::vector<Region>& regions, double sign) {
    for (const Region& r : regions) {
      if (difference.size() <= r.face) difference.resize(r.face + 1, 0);
      for (const std::vector<Point2>& contour : r.contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
          const Point2 p = contour[i], q = contour[i + 1 == contour.size() ? 0 : i + 1];
          difference[r.face] += sign * (p.x * q.y - p.y * q.x) / 2;
        }
      }
    }
  };
  add(a.regions, 1);
  add(b.regions, -1);
  const Rect& page = s.scene.view.window;
  const double tolerance = 1e-6 * (page.max.x - page.min.x) * (page.max.y - page.min.y);
  return std::all_of(difference.begin(), difference.end(), [&](double d) { return std::abs(d) <= tolerance; });
}

std::vector<StudiedScene> studied_scenes(const StudyRequest& request, std::vector<NamedScene> more = {}) {
  const int blocks = request.pick(3, 12), rows = request.pick(6, 20), boxes = request.pick(6, 40),
            faces = request.pick(20, 200), combs = request.pick(5, 40);
  std::vector<NamedScene> scenes = std::move(more);
  scenes.push_back({"a ring of 9 bars", ring(9), "front"});
  scenes.push_back({std::to_string(combs) + " combs in a stair", nested(combs, 3), "front"});
  scenes.push_back({std::to_string(faces) + " faces that lean alike", leaning_faces(faces, 5), "front"});
  scenes.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", city(blocks)});
  scenes.push_back({"a ball of " + std::to_string(2 * rows * (rows - 1)) + " triangles", ball(rows)});
  scenes.push_back({std::to_string(boxes) + " boxes that penetrate", penetrating_boxes(boxes)});
  for (NamedScene& s : scenes) finish(s.scene);
  scenes.insert(scenes.end(), request.models.begin(), request.models.end());
  std::vector<StudiedScene> studied;
  for (const NamedScene& s : scenes) {
    StudiedScene& one = studied.emplace_back();
    one.name = s.name;
    one.scene = on_sheet(s.scene, s.view);
    one.facets = make_facets(one.scene, coincidence_mm(one.scene) / one.scene.lattice.step_mm).facets;
  }
  return studied;
}

double quotient(std::uint64_t a, std::uint64_t b) { return double(a) / double(std::max<std::uint64_t>(b, 1)); }

}  // namespace

Result study_inside_at_once(const StudyRequest& request) {
  Table table{"Faces inside a clip face and nearer than it: each takes its place after all clips, or at once",
              {{"scene", ColumnKind::label},
               {"taken", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"pairs of a list", ColumnKind::count},
               {"clips", ColumnKind::count},
               {"wrong sorts", ColumnKind::count},
               {"given up at once", ColumnKind::count},
               {"deepest", ColumnKind::count},
               {"signs", ColumnKind::count},
               {"signs, of those after all clips", ColumnKind::measure}}};
  bool alike = true, fewer = true;
  for (const StudiedScene& s : studied_scenes(request)) {
    PolygonOptions options;
    const ClipRun after = run_study(s, options);
    options.inside = InsideTest::at_once;
    const ClipRun at_once = run_study(s, options);
    for (const ClipRun* r : {&after, &at_once}) {
      const PolygonCounts& c = r->counts;
      table.rows.push_back({s.name, r == &after ? "after all clips" : "at once",
                            r == &after ? "clips in vain where the sort is wrong" : "chosen: it spares clips in vain",
                            c.considered, c.clips, c.wrong_sorts, c.exchanges, c.deepest, c.signs,
                            quotient(c.signs, after.counts.signs)});
    }
    alike = alike && same_areas(after, at_once, s);
    fewer = fewer && at_once.counts.clips <= after.counts.clips;
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = !alike ? Finding::no_longer : fewer ? Finding::holds : Finding::in_part;
  result.sentence =
      "Both ways see the same. At once spares the clips behind a wrong clip face where few sorts are wrong, but the nearer face "
      "then clips the whole list, and after all clips only what is inside: where faces are nearer in turn, as on bodies that "
      "penetrate, that takes more clips.";
  return result;
}

Result study_zone_tests(const StudyRequest& request) {
  struct Kind {
    ZoneTest test;
    const char *name, *thesis;
  };
  constexpr Kind kKinds[] = {{ZoneTest::boxes, "boxes along the axes", "used: it tells few apart"},
                             {ZoneTest::octagons, "and along the diagonals", "costlier, better: not tried"},
                             {ZoneTest::hulls, "convex hulls", "costlier, better: not tried"},
                             {ZoneTest::contours, "contours between zones", "costlier, better: not tried"}};
  Table table{"What tells faces apart on the page, between zones and before a clip",
              {{"scene", ColumnKind::label},
               {"test", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"zones", ColumnKind::count},
               {"pairs tested for zones", ColumnKind::count},
               {"pairs tested before clips", ColumnKind::count},
               {"clips", ColumnKind::count},
               {"clips in vain", ColumnKind::count},
               {"signs of tests", ColumnKind::count},
               {"signs of clips", ColumnKind::count},
               {"all signs, of boxes", ColumnKind::measure},
               {"by the clip of any contours", ColumnKind::measure}}};
  const int n = request.pick(4, 24);
  bool alike = true, spared = true;
  std::vector<NamedScene> made;
  made.push_back({std::to_string(n) + " bars that lean", leaning_bars(n), "front"});
  made.push_back({std::to_string(n) + " angles in each other", nested_angles(n), "front"});
  for (const StudiedScene& s : studied_scenes(request, std::move(made))) {
    ClipRun by_boxes;
    std::uint64_t of_any_by_boxes = 0;
    for (const Kind& kind : kKinds) {
      PolygonOptions options;
      options.zones = kind.test;
      const ClipRun now = run_study(s, options);
      const PolygonCounts& c = now.counts;
      options.clip = ClipKind::general;
      const PolygonCounts any = run_study(s, options).counts;
      if (kind.test == ZoneTest::boxes) {
        by_boxes = now;
        of_any_by_boxes = any.signs;
      }
      table.rows.push_back({s.name, kind.name, kind.thesis, c.zones, c.zone_tests, c.pair_tests, c.clips, c.empty_clips,
                            c.test_signs, c.signs, quotient(c.test_signs + c.signs, by_boxes.counts.signs),
                            quotient(any.test_signs + any.signs, of_any_by_boxes)});
      alike = alike && same_areas(by_boxes, now, s);
      spared = spared && c.clips <= by_boxes.counts.clips && c.zones >= by_boxes.counts.zones;
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = alike && spared ? Finding::holds : Finding::no_longer;
  result.sentence =
      "Each test spares clips and none changes what is seen. Boxes along the diagonals cost no signs; hulls spare nearly all "
      "clips in vain of faces without notches; contours divide scenes of faces in the notches of others. The clip of convex "
      "contours ends early for the pairs that the tests would spare, so that with it less is gained.";
  return result;
}

Result study_convex_clip(const StudyRequest& request) {
  Table signs{"Faces clipped by faces: any contours, and convex ones by codes of their corners",
              {{"scene", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"clips", ColumnKind::count},
               {"signs, any", ColumnKind::count},
               {"signs, convex", ColumnKind::count},
               {"of those, %", ColumnKind::measure},
               {"time, convex over any", ColumnKind::time}}};
  Table kept{"Pairs of convex contours, and what of them stays convex",
             {{"scene", ColumnKind::label},
              {"thesis", ColumnKind::source},
              {"pairs", ColumnKind::count},
              {"apart", ColumnKind::count},
              {"within", ColumnKind::count},
              {"parts outside", ColumnKind::count},
              {"of them convex", ColumnKind::count},
              {"clips left to any contours", ColumnKind::count}}};
  bool alike = true, fewer = true;
  for (const StudiedScene& s : studied_scenes(request)) {
    PolygonOptions options;
    options.clip = ClipKind::general;
    ClipRun any, convex;
    const double of_any = least_seconds(request.pick(1, 3), [&] { any = run_study(s, options); });
    options.clip = ClipKind::convex;
    const double of_convex = least_seconds(request.pick(1, 3), [&] { convex = run_study(s, options); });
    const PolygonCounts& c = convex.counts;
    signs.rows.push_back({s.name, "faster ways for convex contours", c.clips, any.counts.signs, c.signs,
                          100 * quotient(c.signs, any.counts.signs), times_as_long(of_convex, of_any)});
    kept.rows.push_back({s.name, "the intersection is; outside, if one side cuts it off", c.convex_pairs, c.convex_apart,
                         c.convex_within, c.parts_outside, c.convex_outside, c.general_clips});
    alike = alike && same_areas(any, convex, s) && any.counts.clips == c.clips;
    fewer = fewer && c.signs <= any.counts.signs;
  }
  Result result;
  result.tables.push_back(std::move(signs));
  result.tables.push_back(std::move(kept));
  result.finding = alike && fewer ? Finding::holds : Finding::no_longer;
  result.sentence =
      "The same clips with the same results take fewer signs, since most pairs are convex and most of these lie apart, which "
      "few codes tell; parts outside stay convex where one side cuts them off, and what a corner is cut out of does not.";
  return result;
}

}  // namespace ligne::studies
