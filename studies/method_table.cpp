// Four methods compared by nine properties, [Boulle1980] 2.6, figure 2.88.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "picture/models/memory.hpp"
#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/scenes/generators.hpp"
#include "view/tolerances.hpp"
#include "visibility/atherton_weiler/clip_units.hpp"
#include "visibility/newell/paint_elements.hpp"
#include "visibility/registry.hpp"
#include "visibility/warnock/faces.hpp"
#include "visibility/watkins/exact/line_study.hpp"

namespace ligne::studies {
namespace {

constexpr const char* kMethods[] = {"warnock", "watkins", "atherton-weiler", "newell"};

/// Rows of figure 2.88, one entry per method. Memory and behaviour have tables of their own.
struct Property {
  const char* name;
  std::array<const char*, 4> thesis;
  std::array<const char*, 4> ours;
};
constexpr Property kProperties[] = {
    {"scenes",
     {"no holes; penetration", "holes; penetration with box", "holes; penetration", "holes; penetration"},
     {"holes; penetration", "holes; penetration with every span method", "holes; penetration", "holes; penetration"}},
    {"image",
     {"middling", "good", "good", "good"},
     {"exact areas", "spans line by line, gray faces", "exact areas, transparency, shadows", "an order to paint in"}},
    {"drawing",
     {"bad", "middling", "good", "bad"},
     {"to a micrometre, one stroke an edge", "to a micrometre", "to a micrometre",
      "to a micrometre: the order only says what can hide"}},
    {"lines of intersection", {"yes", "no", "no", "no"}, {"yes", "yes", "yes", "yes"}},
    {"transparency",
     {"no", "possible", "possible", "yes"},
     {"no", "yes, in areas", "yes, lines and areas by level", "areas, when they are painted"}},
    {"programming",
     {"simple", "complex", "middling", "simple"},
     {"five modules", "two scans, four span methods", "a clip without singular cases, three studies",
      "a list, zones and slabs nested"}},
};
constexpr std::array<const char*, 4> kThesisFilling{"middling: many contours", "good: as television scans",
                                                    "good: the fewest contours", "bad: many contours"};
constexpr std::array<const char*, 4> kThesisBehaviour{"bad", "good, stack better than box", "middling", "middling"};
/// Words of memory in the thesis: per vertex and per face.
constexpr std::array<std::array<std::uint64_t, 2>, 4> kThesisWords{{{3, 37}, {3, 33}, {5, 40}, {3, 40}}};

VisibilityResult run(std::size_t method, const ProjectedScene& scene, std::uint8_t wanted) {
  VisibilityOptions options;
  options.wanted = wanted;
  return find_method(kMethods[method])->compute_visibility(scene, options);
}

std::uint64_t areas_to_fill(std::size_t method, const ProjectedScene& scene) {
  if (method == 1) {
    VisibilityOptions options;
    options.wanted = kSpans;
    options.settings.set("lines", 512u);
    return find_method(kMethods[1])->compute_visibility(scene, options).spans->spans.size();
  }
  const VisibilityResult result = run(method, scene, method == 3 ? kOrder : kRegions);
  return method == 3 ? result.order->pieces.size() : result.regions->size();
}

template <class T>
std::uint64_t bytes(const std::vector<T>& v) {
  return v.size() * sizeof(T);
}

/// Bytes of the description model that the method has before it begins.
std::uint64_t description_bytes(std::size_t method, const ProjectedScene& scene) {
  const double step = scene.lattice.step_mm, coincidence = coincidence_mm(scene) / step;
  const Facets facets = make_facets(scene, coincidence);
  const std::uint64_t common = bytes(scene.vertices) + bytes(scene.edges) + bytes(facets.facets);
  if (method == 0) {
    const warnock::FaceTable table = warnock::make_faces(scene, facets.facets, {});
    return common + bytes(table.faces) + bytes(table.by_depth) + bytes(table.facet_order) + bytes(table.sides);
  }
  if (method == 1) {
    std::vector<watkins::SweepLine> lines;
    for (const ProjectedEdge& e : scene.edges)
      lines.push_back({scene.vertices[e.v0], scene.vertices[e.v1], e.face0, e.face1});
    const watkins::ScanScene scan =
        watkins::make_scan_scene(scene, facets.facets, lines, watkins::grid_of_lines(scene, 512), coincidence);
    return common + bytes(scan.edges) + bytes(scan.first_of_line) + bytes(scan.edge_faces) + bytes(scan.edge_lines) +
           bytes(scan.planes) + bytes(scan.depth_tolerance);
  }
  if (method == 2) {
    std::uint64_t sum = common;
    for (const atherton_weiler::ClipUnit& unit : atherton_weiler::clip_units(scene, facets.facets, false)) {
      sum += sizeof unit;
      for (const atherton_weiler::UnitFace& f : unit.faces) sum += sizeof f + bytes(f.facets);
      for (const ContourFace& f : unit.outline) {
        for (const EdgeLoop& loop : f.contours) sum += bytes(loop);
      }
    }
    return sum;
  }
  const newell::PaintElements elements(scene);
  std::uint64_t sum = common + elements.size() * sizeof(newell::Element);
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    sum += bytes(elements[i].parts) + elements[i].parts.size() * (sizeof(ModelPiece) + sizeof(newell::Extents));
  }
  return sum;
}

/// Peak memory of the method in words of 4 bytes, beyond the projected scene; empty if the system does not report it.
Cell words_at_peak(std::size_t method, const ProjectedScene& scene) {
  const PeakMemory memory;
  run(method, scene, kStrokes);
  const std::optional<double> peak = memory.bytes();
  return peak ? Cell(*peak / 4) : Cell();
}

Table properties(const ProjectedScene& crossing, const ProjectedScene& town) {
  Table table{"Figure 2.88: what can be said in words",
              {{"method", ColumnKind::label},
               {"property", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"ours", ColumnKind::words},
               {"counted", ColumnKind::count}}};
  for (std::size_t m = 0; m < 4; ++m) {
    for (const Property& p : kProperties) {
      Cell counted;
      if (std::string_view(p.name) == "lines of intersection") {
        std::uint64_t strokes = 0;
        const VisibilityResult found = run(m, crossing, kStrokes);
        for (const Stroke& s : found.strokes->strokes) strokes += s.line_class == LineClass::intersection;
        counted = strokes;
      }
      table.rows.push_back({kMethods[m], p.name, p.thesis[m], p.ours[m], counted});
    }
    table.rows.push_back({kMethods[m], "areas to fill", kThesisFilling[m],
                          m == 1   ? "spans of 512 lines"
                          : m == 3 ? "pieces to paint"
                                   : "visible areas",
                          areas_to_fill(m, town)});
  }
  return table;
}

}  // namespace

Result study_four_methods(const StudyRequest& request) {
  const int blocks = request.pick(3, 16);
  Scene town = city(blocks), twice = city(2 * blocks), crossing;
  add_plate(crossing, {0, 10}, {0, 10}, {8, 0});
  add_plate(crossing, {0, 10}, {2, 8}, {0, 8});
  for (Scene* s : {&town, &twice, &crossing}) finish(*s);
  ProjectedScene seen = on_sheet(town, "iso"), seen_twice = on_sheet(twice, "iso"), seen_crossing = on_sheet(crossing);
  seen_crossing.with_intersections = true;
  Result result;
  result.tables.push_back(properties(seen_crossing, seen));

  const std::uint64_t vertices = twice.vertices.size(), faces = twice.faces.size();
  Table memory{"Memory, in words of four bytes: a city of " + std::to_string(4 * blocks * blocks) + " boxes, " +
                   std::to_string(vertices) + " vertices, " + std::to_string(faces) + " faces",
               {{"method", ColumnKind::label},
                {"thesis", ColumnKind::source},
                {"thesis, words", ColumnKind::count},
                {"ours, words", ColumnKind::count},
                {"ours over thesis", ColumnKind::measure},
                {"peak of the study, words", ColumnKind::time}}};
  Table behaviour{"Behaviour: time over that of four times the boxes",
                  {{"method", ColumnKind::label},
                   {"thesis", ColumnKind::source},
                   {"strokes", ColumnKind::count},
                   {"ms", ColumnKind::time},
                   {"ms, four times", ColumnKind::time},
                   {"exponent", ColumnKind::time}}};
  double largest = 0;
  for (std::size_t m = 0; m < 4; ++m) {
    const auto [a, b] = kThesisWords[m];
    const std::uint64_t theirs = a * vertices + b * faces, ours = description_bytes(m, seen_twice) / 4;
    memory.rows.push_back({kMethods[m], std::to_string(a) + " nbsom + " + std::to_string(b) + " nbfaces", theirs, ours,
                           double(ours) / double(theirs), words_at_peak(m, seen_twice)});
    std::uint64_t strokes = 0;
    const int times = request.pick(1, 3);
    const double once = least_seconds(times, [&] { strokes = run(m, seen, kStrokes).strokes->strokes.size(); });
    const double four = least_seconds(times, [&] { run(m, seen_twice, kStrokes); });
    const double exponent = std::log(times_as_long(four, once)) / std::log(4.0);
    largest = std::max(largest, exponent);
    behaviour.rows.push_back({kMethods[m], kThesisBehaviour[m], strokes, 1e3 * once, 1e3 * four, exponent});
  }
  result.tables.push_back(std::move(memory));
  result.tables.push_back(std::move(behaviour));
  result.finding = Finding::in_part;
  result.sentence =
      "There is still no best method, but no longer a worst one: all four draw the same lines to a micrometre and show where faces "
      "penetrate, and what tells them apart is what they give beside lines and how their time grows.";
  return result;
}

}  // namespace ligne::studies
