// The experiments of [Boulle1980] on scan lines (2.3.3 to 2.3.5), made again: tables as Markdown on standard output, charts
// into a folder.
//
//   ligne_watkins_experiments FOLDER [MODEL...]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>

#include "chart.hpp"
#include "scene/readers/reader.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/watkins/line_study.hpp"
#include "visibility/watkins/span_method.hpp"

namespace ligne::bench {
namespace {

using namespace watkins;

constexpr SpanMethodKind kKinds[] = {SpanMethodKind::merge, SpanMethodKind::stack, SpanMethodKind::box,
                                     SpanMethodKind::point};
constexpr double kPi = 3.14159265358979323846;

const char* name_of(SpanMethodKind kind) { return kSpanMethodNames[static_cast<std::size_t>(kind)].data(); }

/// Figure 2.52: n squares of side 2 along a diagonal, the scan plane seen from below; sides along the sight are no segments.
template <class X>
std::vector<ScanSegment<X>> squares(int n, double degrees, double steps_per_unit) {
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  std::vector<ScanSegment<X>> segments;
  for (int i = 0; i < n; ++i) {
    const double corner[4][2] = {
        {3.0 * i, 3.0 * i}, {3.0 * i + 2, 3.0 * i}, {3.0 * i + 2, 3.0 * i + 2}, {3.0 * i, 3.0 * i + 2}};
    for (int k = 0; k < 4; ++k) {
      const auto x = [&](int v) { return std::round((corner[v % 4][0] * c - corner[v % 4][1] * s) * steps_per_unit); };
      const auto z = [&](int v) { return (corner[v % 4][0] * s + corner[v % 4][1] * c) * steps_per_unit; };
      if (x(k) == x(k + 1)) continue;
      const int l = x(k) < x(k + 1) ? k : k + 1, r = l == k ? k + 1 : k;
      segments.push_back(
          {static_cast<X>(x(l)), static_cast<X>(x(r)), z(l), z(r), static_cast<std::uint32_t>(segments.size())});
    }
  }
  return segments;
}

/// Operations of one study. The segments come sorted by the full key, or in the order of their squares.
template <class X>
SpanCounts operations(SpanMethodKind kind, std::vector<ScanSegment<X>> segments, bool sorted) {
  if (sorted) std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) { return comes_before(a, b); });
  const auto method = make_span_method<X>(kind);
  std::vector<VisibleSpan> out;
  method->study(segments, out);
  return method->counts();
}

double seconds(int times, const std::function<void()>& work) {
  double best = 1e300;
  for (int i = 0; i < times; ++i) {
    const std::clock_t start = std::clock();  // of the processor: the machine may have other work
    work();
    best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

void square_tables(const std::filesystem::path& folder) {
  constexpr double kScreen = 512.0 / 400;  // the steps of a side: 100 squares at 512 columns
  std::printf(
      "### n squares, operations by study\n\n| angle | n | merge | stack | box | point | box / stack |\n|---|---|---|---|---|---|---|\n");
  for (const double angle : {0.0, 15.0, 30.0, 45.0, 60.0}) {
    Chart chart{"n squares, turned by " + std::to_string(static_cast<int>(angle)) + " degrees", "squares", "operations", {}};
    for (const SpanMethodKind kind : kKinds) {
      if (kind != SpanMethodKind::point) chart.curves.push_back({name_of(kind), {}});
    }
    for (const int n : {1, 2, 3, 4, 5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100}) {
      const auto segments = squares<double>(n, angle, kScreen * 1024);
      std::uint64_t total[4];
      for (std::size_t k = 0; k < 4; ++k) {
        total[k] = operations(kKinds[k], segments, true).total();
        if (k < 3) chart.curves[k].points.emplace_back(n, static_cast<double>(total[k]));
      }
      if (n <= 5 || n % 50 == 0) {
        std::printf("| %g | %d | %llu | %llu | %llu | %llu | %.2f |\n", angle, n, static_cast<unsigned long long>(total[0]),
                    static_cast<unsigned long long>(total[1]), static_cast<unsigned long long>(total[2]),
                    static_cast<unsigned long long>(total[3]), double(total[2]) / double(total[1]));
      }
    }
    write_chart(folder / ("watkins-squares-" + std::to_string(static_cast<int>(angle)) + ".svg"), chart);
  }
  std::printf(
      "\n### The sort, on the squares: operations without it over operations with it\n\n| angle | n | merge | stack | box |\n|---|---|---|---|---|\n");
  for (const double angle : {0.0, 30.0, 45.0, 60.0}) {
    for (const int n : {5, 100}) {
      const auto segments = squares<double>(n, angle, kScreen * 1024);
      std::printf("| %g | %d |", angle, n);
      for (std::size_t k = 0; k < 3; ++k) {
        auto backwards = segments;
        std::reverse(backwards.begin(), backwards.end());
        std::printf(" %.2f |", double(operations(kKinds[k], backwards, false).total()) /
                                   double(operations(kKinds[k], segments, true).total()));
      }
      std::printf("\n");
    }
  }
}

struct Model {
  std::string name;
  ProjectedScene scene;
  std::vector<Facet> facets;
  std::vector<SweepLine> lines;
};

Model load(const std::filesystem::path& file) {
  Warnings warnings;
  const Scene scene = read_scene(file, {}, warnings);
  const Topology topology = build_topology(scene);
  CameraRequest request;
  request.up_axis = scene.up_axis;
  const Rect sheet{{0, 0}, {297, 210}};
  const View view = make_view(scene, make_camera(request, scene), Frame{{{10, 10}, {287, 200}}}, sheet);
  EdgeSelection selection;
  for (const LineClass c : {LineClass::outline, LineClass::border, LineClass::crease}) selection.classes.add(c);
  Model model{file.stem().string(), project(scene, topology, view, selection), {}, {}};
  model.facets = make_facets(model.scene, coincidence_mm(model.scene) / model.scene.lattice.step_mm).facets;
  for (const ProjectedEdge& e : model.scene.edges)
    model.lines.push_back({model.scene.vertices[e.v0], model.scene.vertices[e.v1], e.face0, e.face1});
  ExactOptions exact;
  exact.penetrations = true;
  ExactResult found = study_exactly(model.scene.vertices, model.facets, {}, exact);
  for (const Intersection& i :
       take_intersections(found, model.scene.vertices, model.facets, kLeastPartMm / model.scene.lattice.step_mm)) {
    model.lines.push_back({i.from, i.to, i.face0, i.face1});
  }
  return model;
}

/// What a scan of the whole page by one group of lines costs; no seam breaks the coherence.
struct Cost {
  double seconds = 0;  ///< of the scan alone, the best of some
  ScanCounts scan;
  SpanCounts spans;
};

class Nobody final : public LineListener {
 public:
  void line(const LineScan&, std::uint32_t, bool) override {}
  void ended(const LineScan&, std::uint32_t) override {}
  void hidden_point(const LineScan&, std::uint32_t, std::uint32_t) override {}
};

Cost study(const Model& model, std::uint32_t lines, bool whole, const ScanOptions& options, int times = 5) {
  LineGrid grid = grid_of_lines(model.scene, lines);
  grid.whole = whole;
  const double thin_steps = coincidence_mm(model.scene) / model.scene.lattice.step_mm;
  const ScanScene scene = make_scan_scene(model.scene, model.facets, model.lines, grid, thin_steps);
  Cost cost;
  cost.seconds = seconds(times, [&] {
    Nobody nobody;
    LineScan scan(scene, model.scene.vertices, model.facets, model.lines, options, nobody);
    scan.scan(0, lines);
    cost.scan = scan.counts();
    cost.spans = scan.span_counts();
  });
  return cost;
}

void model_tables(const std::vector<Model>& models) {
  constexpr std::uint32_t kLines = 512;
  std::printf(
      "\n### Methods on models, %u lines, every line studied: ms, and operations in thousands\n\n| model | segments by line | merge | stack | box | point |\n|---|---|---|---|---|---|\n",
      kLines);
  for (const Model& model : models) {
    std::printf("| %s |", model.name.c_str());
    for (std::size_t k = 0; k < 4; ++k) {
      ScanOptions scan{kKinds[k], false, false, true};
      const Cost r = study(model, kLines, false, scan);
      if (k == 0) std::printf(" %.0f |", double(r.scan.segments) / double(std::max<std::uint64_t>(1, r.scan.studied)));
      std::printf(" %.1f; %.0f |", 1e3 * r.seconds, double(r.spans.total()) / 1e3);
    }
    std::printf("\n");
  }
  std::printf(
      "\n### The sort by the full key on models: without it over with it, time (operations)\n\n| model | merge | stack | box |\n|---|---|---|---|\n");
  for (const Model& model : models) {
    std::printf("| %s |", model.name.c_str());
    for (std::size_t k = 0; k < 3; ++k) {
      const Cost with = study(model, kLines, false, {kKinds[k], false, false, true});
      const Cost without = study(model, kLines, false, {kKinds[k], false, false, false});
      std::printf(" %.2f (%.2f) |", without.seconds / with.seconds,
                  double(without.spans.total()) / double(with.spans.total()));
    }
    std::printf("\n");
  }
  std::printf(
      "\n### Whole numbers against reals, %u lines: reals over whole, time (operations)\n\n| model | merge | stack | box | boxes, real | boxes, whole |\n|---|---|---|---|---|---|\n",
      kLines);
  for (const Model& model : models) {
    std::printf("| %s |", model.name.c_str());
    std::uint64_t boxes[2] = {0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const Cost real = study(model, kLines, false, {kKinds[k], false, false, true}),
                 whole = study(model, kLines, true, {kKinds[k], false, false, true});
      std::printf(" %.2f (%.2f) |", real.seconds / whole.seconds, double(real.spans.total()) / double(whole.spans.total()));
      boxes[0] = real.spans.boxes;
      boxes[1] = whole.spans.boxes;
    }
    std::printf(" %llu | %llu |\n", static_cast<unsigned long long>(boxes[0]), static_cast<unsigned long long>(boxes[1]));
  }
}

void coherence_tables(const std::vector<Model>& models) {
  std::printf(
      "\n### Coherence, stack: lines studied, time in ms\n\n| model | lines | every line | where edges enter, end, cross | and it can be seen | gain |\n|---|---|---|---|---|---|\n");
  for (const Model& model : models) {
    for (const std::uint32_t lines : {512u, 2048u, 8192u, 32768u}) {
      Cost r[3];
      for (int k = 0; k < 3; ++k) r[k] = study(model, lines, false, {SpanMethodKind::stack, k > 0, k > 1, true});
      std::printf("| %s | %u | %llu; %.1f | %llu; %.1f | %llu; %.1f | %.2f |\n", model.name.c_str(), lines,
                  static_cast<unsigned long long>(r[0].scan.studied), 1e3 * r[0].seconds,
                  static_cast<unsigned long long>(r[1].scan.studied), 1e3 * r[1].seconds,
                  static_cast<unsigned long long>(r[2].scan.studied), 1e3 * r[2].seconds, r[0].seconds / r[2].seconds);
    }
  }
}

/// Studies rise with the lines until no two changes share one: then there are as many as changes that can be seen.
void studies_table(const std::filesystem::path& folder, const std::vector<Model>& models) {
  constexpr std::uint32_t kFirst = 1000, kDoublings = 10, kInChart = 32'000;
  Chart chart{"Lines studied", "scan lines", "studied", {}};
  std::printf("\n### Lines studied against lines of the page\n\n| model | facets | intersections |");
  for (std::uint32_t k = 0; k <= kDoublings; ++k) std::printf(" %u |", kFirst << k);
  std::printf(" exchanges | ends | edges met with %u lines | with %u |\n|---|---|---|", kInChart, kFirst << kDoublings);
  for (std::uint32_t k = 0; k <= kDoublings + 4; ++k) std::printf("---|");
  std::printf("\n");
  for (const Model& model : models) {
    std::printf("| %s | %zu | %zu |", model.name.c_str(), model.facets.size(),
                model.lines.size() - model.scene.edges.size());
    Curve curve{model.name, {}};
    ScanCounts scan;
    std::uint64_t met = 0;
    for (std::uint32_t k = 0; k <= kDoublings; ++k) {
      const std::uint32_t n = kFirst << k;
      scan = study(model, n, false, {SpanMethodKind::stack, true, true, true}, 1).scan;
      std::printf(" %llu |", static_cast<unsigned long long>(scan.studied));
      if (n <= kInChart) {
        curve.points.emplace_back(n, static_cast<double>(scan.studied));
        met = scan.entered;
      }
    }
    std::printf(" %llu | %llu | %llu | %llu |\n", static_cast<unsigned long long>(scan.studied_exchanges),
                static_cast<unsigned long long>(scan.studied_ends), static_cast<unsigned long long>(met),
                static_cast<unsigned long long>(scan.entered));
    std::fflush(stdout);
    if (model.facets.size() < 10'000) chart.curves.push_back(std::move(curve));
  }
  write_chart(folder / "watkins-lines-studied.svg", chart);
}

}  // namespace
}  // namespace ligne::bench

int main(int argc, char** argv) {
  using namespace ligne::bench;
  if (argc < 2) {
    std::fprintf(stderr, "usage: ligne_watkins_experiments FOLDER [MODEL...]\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    square_tables(folder);
    std::vector<Model> models;
    for (int i = 2; i < argc; ++i) models.push_back(load(argv[i]));
    model_tables(models);
    coherence_tables(models);
    studies_table(folder, models);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "ligne_watkins_experiments: %s\n", e.what());
    return 1;
  }
  return 0;
}
