// The method warnock on the corpus and on crowds of boxes: as many strokes as the default method, whatever the windows; and
// with a limit of resolution, errors that shrink in proportion.

#include "main/tier.hpp"
#include "support/corpus_scene.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "visibility/common/opaque_scene.hpp"
#include "visibility/methods.hpp"

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
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override {
    VisibilityOptions own = options;
    own.settings = settings_;
    own.wanted = kStrokes;
    return warnock_.compute_visibility(scene, own);
  }

 private:
  MethodSettings settings_;
  const Method& warnock_ = warnock_method();
  MethodTraits traits_;
};

MethodSettings with(std::string_view name, ParameterValue value) {
  MethodSettings s;
  s.set(name, value);
  return s;
}

class WarnockOnCorpus : public testing::TestWithParam<std::filesystem::path> {};

/// Visible and hidden strokes of the drawing, lines drawn once.
std::array<std::size_t, 2> stroke_counts(const ProjectedScene& projected, const Method& method, bool hidden) {
  StrokeModel model = *method.compute_visibility(projected, {hidden, {}}).strokes;
  remove_coincident_strokes(model, coincidence_mm(projected));
  const auto visible = static_cast<std::size_t>(
      std::count_if(model.strokes.begin(), model.strokes.end(), [](const Stroke& s) { return s.visible; }));
  return {visible, model.strokes.size() - visible};
}

/// In every standard view of the scene, in the first tier in some of them, for every word of the method's options.
void expect_as_many_strokes(const Scene& scene, const std::string& name, bool with_hidden, std::size_t some = 1) {
  const Topology topology = build_topology(scene);
  for (const StandardView& standard : rotated_views(scene, "warnock, " + name, some)) {
    const View view = view_on_a4(scene, standard.camera);
    for (const char* edges : {"all", "feature"}) {
      ProjectedScene projected = project(scene, topology, view, {classes(edges), 30});
      // It leaves glass out, which the default method takes for opaque.
      if (auto opaque = without_transparent_faces(projected)) projected = std::move(opaque->scene);
      for (const bool hidden : {false, true}) {
        if (hidden && !with_hidden) continue;
        const auto expected = stroke_counts(projected, *find_method("auto"), hidden);
        for (const std::string_view name : {"warnock-window", "warnock-split"})
          for (unsigned choice = 0; choice < 3; ++choice) {
            const WarnockWith method(with(name, ParameterWord{choice}), 0.001);
            EXPECT_EQ(stroke_counts(projected, method, hidden), expected)
                << standard.name << " " << standard.options << " " << edges << (hidden ? " hidden " : " ") << name << " "
                << choice;
          }
      }
    }
  }
}

TEST_P(WarnockOnCorpus, AsManyStrokesAsTheDefaultMethod) {
  const bool large = std::filesystem::file_size(GetParam()) > kLargeSceneBytes;
  expect_as_many_strokes(scene_of_file(GetParam()), GetParam().stem().string(),
                         !large);  // of the large ones tens of thousands of strokes, for half a minute
}

INSTANTIATE_TEST_SUITE_P(Corpus, WarnockOnCorpus, testing::ValuesIn(corpus_files()),
                         [](const auto& info) { return info.param.stem().string(); });

/// Windows with few faces are solved at once: most scenes of the corpus are never divided. Here walls hide boxes behind them
/// over many windows.
TEST(WarnockCrowds, AsManyStrokesAsTheDefaultMethod) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-10, 10), side(0.5, 3), angle(-3, 3);
    Scene scene;
    for (int i = 0; i < 80; ++i) {
      const Point3 corner{place(random), place(random), place(random)}, size{side(random), side(random), side(random)};
      add_box(scene, corner, size, seed % 2 == 0 ? kUpright : rotation(angle(random), angle(random), angle(random)));
    }
    for (int i = 0; i < 6; ++i) {
      const Point3 corner{place(random), place(random), place(random)};
      add_box(scene, corner, i % 2 == 0 ? Point3{9, 0.5, 9} : Point3{0.5, 9, 9});
    }
    finish(scene);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_as_many_strokes(scene, "crowd " + std::to_string(seed), true);
  }
}

/// Bars stick through a slanted wall so densely that windows of many faces lie within it. The wall is before the hidden ends
/// of the bars in one corner of such a window and behind the others in another.
TEST(WarnockCrowds, BarsThroughASlantedWallHaveAsManyStrokes) {
  Scene scene;
  add_box(scene, {-10, -0.05, -10}, {20, 0.1, 20}, rotation(0.35, 0, 0.26));
  for (int i = 0; i < 12; ++i) {
    for (int k = 0; k < 12; ++k) {
      const double x = -6 + i, z = -6 + k;
      add_box(scene, {x, -3 + 0.37 * ((i * 5 + k * 3) % 8), z}, {0.4, 2, 0.4});
    }
  }
  finish(scene);
  expect_as_many_strokes(scene, "bars through a wall", false, 7);
}

/// Lines drawn although hidden and lines that are missing, by more than a micrometre, over all scenes and two views.
struct Errors {
  unsigned resolution;
  double sum_mm = 0;
  double worst_of_tolerance = 0;  ///< the longest place over warnock_tolerance_mm()
};

std::vector<Errors> errors(std::initializer_list<unsigned> resolutions, unsigned split) {
  std::vector<Errors> result;
  for (const unsigned resolution : resolutions) result.push_back({resolution});
  for (const std::filesystem::path& file : chosen("errors of warnock", 3, corpus_files())) {
    if (std::filesystem::file_size(file) > kLargeSceneBytes) continue;  // the oracle compares all pairs
    const Scene scene = scene_of_file(file);
    for (const StandardView& view : standard_views(scene)) {
      if (view.name != "odd" && (view.name != "near" || !runs_all())) continue;
      const JudgedView judged(scene, file.stem().string(), view);
      ProjectedScene page;
      page.view = judged.view();
      for (Errors& e : result) {
        MethodSettings settings = with("resolution", e.resolution);
        settings.set("warnock-split", ParameterWord{split});
        const Verdict verdict = judged.judge(WarnockWith(settings, 0.001), "all");
        const double worst = std::max(verdict.drawn_hidden.worst_mm, verdict.missing.worst_mm);
        e.sum_mm += verdict.drawn_hidden.length_mm + verdict.missing.length_mm;
        e.worst_of_tolerance = std::max(e.worst_of_tolerance, worst / warnock_tolerance_mm(page.view.window, e.resolution));
      }
    }
  }
  return result;
}

constexpr unsigned kCentre = 0, kSide = 2;

TEST(WarnockResolution, DivisionAlongSidesLeavesLittleToTheLimit) {
  const Errors centre = errors({512}, kCentre).front(), side = errors({512}, kSide).front();
  std::cout << "error at 512: " << centre.sum_mm << " mm, along sides " << side.sum_mm << " mm\n";
  EXPECT_LE(side.worst_of_tolerance, 1);
  EXPECT_LT(side.sum_mm, centre.sum_mm / 10);
}

TEST(WarnockResolution, ErrorShrinksInProportion) {
  const std::vector<Errors> found = errors({512, 2048, 8192}, kCentre);
  for (const Errors& e : found) {
    std::cout << "error at " << e.resolution << ": " << e.sum_mm << " mm; worst, of the tolerance: " << e.worst_of_tolerance
              << '\n';
    EXPECT_LE(e.worst_of_tolerance, 1) << e.resolution;
  }
  EXPECT_GT(found[0].sum_mm, 0) << "a limit is a limit";
  // Four times the resolution: a quarter, give or take what windows happen to hold.
  EXPECT_LT(found[1].sum_mm, found[0].sum_mm / 3);
  EXPECT_LT(found[2].sum_mm, found[1].sum_mm / 3);
}

}  // namespace
}  // namespace ligne::test
