// The method warnock on the corpus: as many strokes as the default method, whatever the windows; and with a limit of resolution, errors
// that shrink in proportion.

#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "scene/reader.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "visibility/warnock/warnock.hpp"

namespace ligne::test {
namespace {

/// warnock with settings, and the tolerance that goes with them.
class WarnockWith final : public Method {
 public:
  WarnockWith(MethodSettings settings, double tolerance_mm) : settings_(std::move(settings)), traits_(warnock_.traits()) {
    traits_.tolerance_mm = tolerance_mm;
    traits_.exact = tolerance_mm <= 0.001;
  }
  const MethodTraits& traits() const override { return traits_; }
  VisibilityResult study(const ProjectedScene& scene, const StudyOptions& options) const override {
    StudyOptions own = options;
    own.settings = settings_;
    own.wanted = kStrokes;
    return warnock_.study(scene, own);
  }

 private:
  MethodSettings settings_;
  WarnockMethod warnock_;
  MethodTraits traits_;
};

MethodSettings with(std::string_view name, unsigned value) {
  MethodSettings s;
  s.set(name, value);
  return s;
}

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  constexpr std::uintmax_t kLargeBytes = 100'000;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus")) {
    if (entry.path().extension() == ".json" && entry.file_size() <= kLargeBytes) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Scene scene_of(const std::filesystem::path& file) {
  Warnings warnings;
  return read_scene(file, {}, warnings);
}

class WarnockOnCorpus : public testing::TestWithParam<std::filesystem::path> {};

/// Visible and hidden strokes of the drawing, lines drawn once.
std::array<std::size_t, 2> stroke_counts(const ProjectedScene& projected, const Method& method, bool hidden) {
  StrokeModel model = *method.study(projected, {hidden, {}}).strokes;
  remove_coincident_strokes(model, coincidence_mm(projected));
  const auto visible = static_cast<std::size_t>(std::count_if(model.strokes.begin(), model.strokes.end(), [](const Stroke& s) { return s.visible; }));
  return {visible, model.strokes.size() - visible};
}

TEST_P(WarnockOnCorpus, AsManyStrokesAsTheDefaultMethod) {
  const Scene scene = scene_of(GetParam());
  const Topology topology = build_topology(scene);
  for (const StandardView& standard : standard_views(scene)) {
    const View view = make_view(scene, make_camera(standard.camera, scene), {{{10, 10}, {kPageWidth - 10, kPageHeight - 10}}},
                                {{0, 0}, {kPageWidth, kPageHeight}});
    for (const char* edges : {"all", "feature"}) {
      const ProjectedScene projected = project(scene, topology, view, {classes(edges), 30});
      for (const bool hidden : {false, true}) {
        const auto expected = stroke_counts(projected, *find_method("auto"), hidden);
        for (const std::string_view name : {"warnock-window", "warnock-split"}) {
          for (unsigned choice = 0; choice < (name == "warnock-window" ? 3u : 2u); ++choice) {
            const WarnockWith method(with(name, choice), 0.001);
            EXPECT_EQ(stroke_counts(projected, method, hidden), expected)
                << standard.name << " " << standard.options << " " << edges << (hidden ? " hidden " : " ") << name << " " << choice;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, WarnockOnCorpus, testing::ValuesIn(corpus()),
                         [](const auto& info) { return info.param.stem().string(); });

/// Lines drawn although hidden and lines that are missing, mm, over some scenes and views.
double error_mm(unsigned resolution) {
  double sum = 0;
  for (const std::filesystem::path& file : corpus()) {
    const Scene scene = scene_of(file);
    for (const StandardView& view : standard_views(scene)) {
      if (view.name != "odd" && view.name != "near") continue;
      const JudgedView judged(scene, file.stem().string(), view);
      const Verdict verdict = judged.judge(WarnockWith(with("resolution", resolution), 0.001), "all");
      const double e = verdict.drawn_hidden.length_mm + verdict.missing.length_mm;
      if (e > 1) std::cout << resolution << " " << file.stem() << " " << view.name << " " << e << " worst hidden " << verdict.drawn_hidden.worst_mm << " " << verdict.drawn_hidden.place << " missing " << verdict.missing.worst_mm << " " << verdict.missing.place << '\n';
      sum += e;
    }
  }
  return sum;
}

TEST(WarnockResolution, ErrorShrinksInProportion) {
  const double coarse = error_mm(512), middle = error_mm(2048), fine = error_mm(8192);
  std::cout << "error in mm at 512, 2048, 8192: " << coarse << ", " << middle << ", " << fine << '\n';
  EXPECT_LT(middle, coarse / 2.5);
  EXPECT_LT(fine, middle / 2.5);
}

}  // namespace
}  // namespace ligne::test
