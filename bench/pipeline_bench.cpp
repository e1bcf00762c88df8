/// Times of the stages of a run: every scene of the inputs folder, every method of the registry. See README.md.
///
///   ligne_bench [Google Benchmark's options] [FOLDER]

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drawing/drawing.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "plotting/page.hpp"
#include "plotting/writers/writers.hpp"
#include "scene/model/topology.hpp"
#include "scene/readers/reader.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "view/view.hpp"
#include "visibility/registry.hpp"

namespace {

using namespace ligne;

struct Selection {
  const char* name;
  LineClasses classes;
};

std::vector<Selection> selections() {
  Selection feature{"feature", {}}, all{"all", {}};
  for (const LineClass c :
       {LineClass::outline, LineClass::border, LineClass::intersection, LineClass::crease, LineClass::mesh}) {
    if (c != LineClass::mesh) feature.classes.add(c);
    all.classes.add(c);
  }
  return {feature, all};
}

/// A scene on the way to the study. Made when first asked for; one scene is kept at a time.
struct Prepared {
  std::string file, selection;
  Scene scene;
  Topology topology;
  Page page;
  View view;
  ProjectedScene projected;
};

View isometric_view(const Scene& scene, const Page& page) {
  CameraRequest request;
  request.up_axis = scene.up_axis;
  return make_view(scene, make_camera(request, scene), {page.drawable()}, page.sheet());
}

const Prepared& prepared(const std::filesystem::path& file, const Selection& selection) {
  static std::unique_ptr<Prepared> kept;
  if (!kept || kept->file != file.string()) {
    kept = std::make_unique<Prepared>();
    Warnings warnings;
    kept->file = file.string();
    kept->scene = read_scene(file, {}, warnings);
    kept->topology = build_topology(kept->scene);
    kept->view = isometric_view(kept->scene, kept->page);
  }
  if (kept->selection != selection.name) {
    kept->selection = selection.name;
    kept->projected = project(kept->scene, kept->topology, kept->view, {selection.classes});
  }
  return *kept;
}

void read_stage(benchmark::State& state, const std::filesystem::path& file) {
  for (auto _ : state) {
    Warnings warnings;
    benchmark::DoNotOptimize(read_scene(file, {}, warnings));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(std::filesystem::file_size(file)) * state.iterations());
}

void topology_stage(benchmark::State& state, const std::filesystem::path& file, const Selection& selection) {
  const Prepared& p = prepared(file, selection);
  for (auto _ : state) benchmark::DoNotOptimize(build_topology(p.scene));
  state.counters["triangles"] = static_cast<double>(p.topology.triangles.size());
}

void project_stage(benchmark::State& state, const std::filesystem::path& file, const Selection& selection) {
  const Prepared& p = prepared(file, selection);
  for (auto _ : state) {
    const View view = isometric_view(p.scene, p.page);
    benchmark::DoNotOptimize(project(p.scene, p.topology, view, {selection.classes}));
  }
  state.counters["edges"] = static_cast<double>(p.projected.edges.size());
}

void study_stage(benchmark::State& state, const std::filesystem::path& file, const Selection& selection,
                 const Method& method) {
  const Prepared& p = prepared(file, selection);
  std::size_t strokes = 0;
  for (auto _ : state) {
    const VisibilityResult result = method.compute_visibility(p.projected, {});
    strokes = result.strokes ? result.strokes->strokes.size() : 0;
  }
  state.counters["strokes"] = static_cast<double>(strokes);
}

void drawing_stage(benchmark::State& state, const std::filesystem::path& file, const Selection& selection,
                   const Method& method) {
  const Prepared& p = prepared(file, selection);
  const VisibilityResult result = method.compute_visibility(p.projected, {});
  if (!result.strokes) return state.SkipWithError("the method gives no strokes");
  for (auto _ : state) {
    state.PauseTiming();
    StrokeModel strokes = *result.strokes;
    state.ResumeTiming();
    remove_coincident_strokes(strokes, coincidence_mm(p.projected));
    benchmark::DoNotOptimize(make_drawing(strokes));
  }
}

void write_stage(benchmark::State& state, const std::filesystem::path& file, const Selection& selection,
                 const Method& method) {
  const Prepared& p = prepared(file, selection);
  VisibilityResult result = method.compute_visibility(p.projected, {});
  if (!result.strokes) return state.SkipWithError("the method gives no strokes");
  remove_coincident_strokes(*result.strokes, coincidence_mm(p.projected));
  const Drawing drawing = make_drawing(*result.strokes);
  PlotOptions plot;
  plot.page = p.page;
  std::size_t bytes = 0;
  for (auto _ : state) bytes = write_svg(drawing, plot).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}

/// Stages of one scene stand together, so that it is read once.
void register_scene(const std::filesystem::path& file) {
  const std::string scene = file.filename().string();
  const auto add = [](const std::string& name, auto stage) {
    benchmark::RegisterBenchmark(name.c_str(), std::move(stage))->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  add(scene + "/read", [=](benchmark::State& s) { read_stage(s, file); });
  for (const Selection& selection : selections()) {
    const std::string prefix = scene + "/" + selection.name + "/";
    if (selection.name == selections().front().name) {
      add(scene + "/topology", [=](benchmark::State& s) { topology_stage(s, file, selection); });
    }
    add(prefix + "project", [=](benchmark::State& s) { project_stage(s, file, selection); });
    for (const Method* method : all_methods()) {
      if (!(method->traits().products & kStrokes)) continue;
      const std::string name = prefix + std::string(method->traits().name);
      add(name + "/study", [=](benchmark::State& s) { study_stage(s, file, selection, *method); });
      add(name + "/drawing", [=](benchmark::State& s) { drawing_stage(s, file, selection, *method); });
      add(name + "/write", [=](benchmark::State& s) { write_stage(s, file, selection, *method); });
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const std::filesystem::path folder = argc > 1 ? argv[1] : LIGNE_BENCH_INPUTS;
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) files.push_back(entry.path());
  if (files.empty()) {
    std::fprintf(stderr, "ligne_bench: %s: no inputs; make them with ligne_bench_inputs\n", folder.c_str());
    return 1;
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) register_scene(file);
  benchmark::RunSpecifiedBenchmarks();
}
