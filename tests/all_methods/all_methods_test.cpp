// Every method of the registry on every scene of the corpus, in every standard view and with vertices on the border of what
// is drawn, against the oracle: nothing hidden is drawn, nothing visible is missing, nothing is drawn twice. The scenes are
// found when the program starts: a new one is a new test.

#include "main/tier.hpp"
#include "report/stroke_difference.hpp"
#include "support/comparison.hpp"
#include "support/corpus_scene.hpp"
#include "support/round_bodies.hpp"
#include "support/scenes.hpp"
#include "support/variants.hpp"
#include "view/cull.hpp"

namespace ligne::test {
namespace {

/// The oracle leaves open at most this part of the lines of a scene. Seen along an axis whole bodies lie exactly behind
/// their own rims, as the back edges of a cube; elsewhere hardly anything does (over the corpus: 21 % from the front, 0.8 %
/// in the other views on the average).
/// On a sheet that is cut through a scene one such line may be half of what is left.
double largest_undecided_share(std::string_view view) { return view == "front" || view.starts_with("sheet") ? 0.9 : 0.4; }

using Case = std::tuple<std::filesystem::path, std::string>;

/// The oracle and the judge hold everything against everything: a scene of thousands of faces takes seconds for each method.
/// It gets two views, and methods as they are by default.
bool is_large(const std::filesystem::path& file) { return std::filesystem::file_size(file) > kLargeSceneBytes; }

std::vector<Case> cases() {
  std::vector<Case> result;
  for (const std::filesystem::path& file : corpus_files()) {
    for (const char* view : {"odd", "near"}) result.emplace_back(file, view);
    if (is_large(file)) continue;
    for (const char* view : {"iso", "dimetric", "front", "far", "inside", "sheet_front", "sheet_iso", "fov_border"})
      result.emplace_back(file, view);
  }
  return result;
}

/// The place of the case among those of its family of scenes.
std::size_t place_in_family(const Case& wanted) {
  static const std::map<Case, std::size_t> places = [] {
    std::map<Case, std::size_t> result;
    std::map<std::string, std::size_t> counts;
    for (const Case& each : cases()) result[each] = counts[family_of(std::get<0>(each))]++;
    return result;
  }();
  return places.at(wanted);
}

/// The sets of edges with which the variant is judged. The first tier takes one of the two, in turns: for methods as they
/// are by default in every fourth case, for their other variants in every tenth, so that each variant meets each family of
/// scenes: the smallest family has more than forty cases. It leaves out what shows a debug layer and draws the same lines.
std::vector<const char*> edge_sets(const Case& judged, const Variant& variant) {
  if (runs_all()) return {"all", "feature"};
  if (variant.is_show) return {};
  constexpr std::size_t kDefaultOneIn = 4, kOneIn = 10;
  const std::size_t one_in = variant.is_default ? kDefaultOneIn : kOneIn;
  const std::string key = family_of(std::get<0>(judged)) + ", " + variant.name;
  // A scene has ten cases: from one scene to the next a variant turns to the next view.
  const std::size_t place = place_in_family(judged), turn = place + place / 10 + rotation_of(key) % (2 * kOneIn);
  if (turn % one_in != 0) return {};
  return {turn / one_in % 2 == 0 ? "all" : "feature"};
}

class AllMethods : public testing::TestWithParam<Case> {};

TEST_P(AllMethods, AgreeWithTheOracle) {
  const std::filesystem::path& file = std::get<0>(GetParam());
  const std::string& view_name = std::get<1>(GetParam());
  const Scene scene = scene_of_file(file);
  std::vector<StandardView> views = standard_views(scene);
  for (StandardView& v : border_views(scene)) views.push_back(std::move(v));
  const auto view = std::find_if(views.begin(), views.end(), [&](const StandardView& v) { return v.name == view_name; });
  ASSERT_NE(view, views.end());
  const JudgedView judged(scene, file.stem().string(), *view);
  int skipped = 0;
  for (const Variant& variant : variants()) {
    if (is_large(file) && !variant.is_default) continue;
    for (const char* edges : edge_sets(GetParam(), variant)) {
      const Verdict verdict = judged.judge(*variant.method, edges, variant.settings);
      if (!verdict.skipped.empty()) {
        std::cout << variant.name << " skipped: " << verdict.skipped << '\n';
        ++skipped;
        break;
      }
      EXPECT_TRUE(verdict.passes()) << variant.name << '\n' << verdict.faults;
      // Elsewhere the default method stands for all: warnock_test.cpp.
      if (has_glass(scene)) {
        const Verdict culled = judged.judge(*variant.method, edges, variant.settings, Cull::on);
        EXPECT_TRUE(culled.skipped.empty() && culled.passes()) << variant.name << '\n' << culled.skipped << culled.faults;
      }
      if (verdict.line_mm > 0) {
        const double share = verdict.undecided_mm / verdict.line_mm;
        RecordProperty("undecided_permille", static_cast<int>(1000 * share));
        EXPECT_LE(share, largest_undecided_share(view_name)) << file.stem() << ", view " << view_name;
      }
    }
  }
  RecordProperty("methods_skipped", skipped);
}

TEST(AllMethodsRotation, BringsEachVariantToEachFamily) {
  std::map<std::string, std::map<std::string, int>> judged;
  for (const Case& each : cases())
    for (const Variant& variant : variants()) {
      if (variant.is_show || (is_large(std::get<0>(each)) && !variant.is_default)) continue;
      judged[variant.name][family_of(std::get<0>(each))] += static_cast<int>(edge_sets(each, variant).size());
    }
  EXPECT_GT(judged.size(), 10u);
  for (const auto& [variant, families] : judged) {
    EXPECT_EQ(families.size(), 7u) << variant;
    for (const auto& [family, count] : families) EXPECT_GT(count, 0) << variant << ", " << family;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, AllMethods, testing::ValuesIn(cases()), [](const auto& info) {
  return std::get<0>(info.param).stem().string() + "_" + std::get<1>(info.param);
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(AllMethods);

// Methods that take a number of scan lines or of rows of pixels, on the corpus, with 512, 2048 and 8192 of them: what is
// larger than the lines can tell apart must be as the oracle says.

constexpr double kPageHeightMm = 210;
/// Largest error of a drawing by lines, in distances of lines: things between two lines are seen by neither.
constexpr double kLines = 2;

constexpr std::uintmax_t kMostBytes = 20'000;

/// A method with no tolerance of its own: that of the lines alone counts.
class ByLines final : public Method {
 public:
  explicit ByLines(const Method& method) : method_(method), traits_(method.traits()) { traits_.tolerance_mm = 0; }
  const MethodTraits& traits() const override { return traits_; }
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override {
    return method_.compute_visibility(scene, options);
  }

 private:
  const Method& method_;
  MethodTraits traits_;
};

bool shows_fine_pixels(const std::filesystem::path& file) {
  const auto names = chosen("fine pixels", 4, {"crumpled_ball", "cyclic_3", "bricks", "two_prisms_penetrating"});
  return std::ranges::find(names, file.stem().string()) != names.end();
}

class LimitedMethods : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LimitedMethods, AgreeWithTheOracleWithinTheirLines) {
  const Scene scene = scene_of_file(GetParam());
  const std::string scene_name = GetParam().stem().string();
  std::size_t turn = 0;
  for (const unsigned lines : {512u, 2048u, 8192u}) {
    for (const StandardView& view : standard_views(scene)) {
      const std::string name = view.name;
      if (name != "odd" && name != "iso" && name != "near") continue;
      // Nine pairs of a number of lines and a view, of which the first tier takes one for each scene.
      if (!is_chosen("limited, " + scene_name, turn++, 9)) continue;
      const JudgedView judged(scene, scene_name, view, kLines * kPageHeightMm / lines);
      for (const Method* method : all_methods()) {
        const auto own = method->traits().parameters;
        if (std::none_of(own.begin(), own.end(), [](const MethodParameter& p) { return p.name == "lines"; })) continue;
        // 8192 rows are 100 million pixels: enough for a few scenes.
        if (lines > 2048 && (method->traits().products & kPixels) && !shows_fine_pixels(GetParam())) continue;
        MethodSettings settings;
        settings.set("lines", lines);
        const std::string key = "edges, " + scene_name + std::string(method->traits().name);
        for (const char* edges : chosen(key, 2, {"all", "feature"})) {
          const Verdict verdict = judged.judge(ByLines(*method), edges, settings);
          EXPECT_TRUE(verdict.passes()) << "--lines " << lines << '\n' << verdict.faults;
        }
        if (lines > 512) continue;
        for (const MethodParameter& p : own) {  // the other ways in which it can work
          for (unsigned word = 0; p.high == 0 && !p.is_imprecise && word < p.words.size(); ++word) {
            if (p.words[word] == p.standard) continue;
            MethodSettings other = settings;
            other.set(p.name, ParameterWord{word});
            const Verdict verdict = judged.judge(ByLines(*method), "all", other);
            EXPECT_TRUE(verdict.passes()) << "--lines " << lines << " --" << p.name << ' ' << p.words[word] << '\n'
                                          << verdict.faults;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, LimitedMethods, testing::ValuesIn(corpus_files(kMostBytes)),
                         [](const auto& info) { return info.param.stem().string(); });

// Culling changes no drawing: every scene of the corpus in every standard view, and random closed surfaces that penetrate
// themselves, drawn with and without their back faces.

struct Drawings {
  StrokeModel all, culled;
  std::size_t faces = 0;  ///< left out
};

Drawings drawings(const Scene& scene, const CameraRequest& request, const char* method = "auto") {
  const Topology topology = build_topology(scene);
  const View view = view_on_a4(scene, request);
  ProjectedScene projected = project(scene, topology, view, {classes("all"), 30});
  const auto strokes = [&] {
    VisibilityOptions options;
    options.wanted = kStrokes;
    StrokeModel model = *find_method(method)->compute_visibility(projected, options).strokes;
    remove_coincident_strokes(model, coincidence_mm(projected));
    return model;
  };
  Drawings result;
  result.all = strokes();
  const BackFaces back_faces = find_back_faces(scene, topology, view);
  cull(projected, back_faces);
  result.faces = back_faces.faces;
  result.culled = strokes();
  return result;
}

/// Lines seen in one drawing and not in the other, in words.
std::string missing(const StrokeModel& from, const StrokeModel& in, const char* where) {
  std::string faults;
  for (const Segment& open : parts_missing(from, in, kSameLineMm, true)) faults += where + words(open) + '\n';
  return faults;
}

std::string differences(const Drawings& d) {
  return missing(d.all, d.culled, "lost by culling: ") + missing(d.culled, d.all, "only when culled: ");
}

TEST(CullDrawing, ChangesNoSceneOfTheCorpus) {
  std::size_t faces = 0;
  for (const std::filesystem::path& file : corpus_files()) {
    const Scene scene = scene_of_file(file);
    for (const StandardView& view : rotated_views(scene, "cull, " + file.stem().string(), 2)) {
      const Drawings d = drawings(scene, view.camera);
      faces += d.faces;
      EXPECT_EQ(differences(d), "") << file.stem() << ", view " << view.name;
    }
  }
  EXPECT_GT(faces, 1000u);
}

/// A ball whose corners move in and out.
Scene rough_ball(unsigned seed, double least, double most) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(least, most);
  Scene scene = ball(8, 5, [&](auto, auto) { return radius(random); });
  finish(scene);
  return scene;
}

TEST(CullDrawing, ChangesNoBall) {
  std::size_t culled = 0, kept = 0;
  for (unsigned seed = 0; seed < 400; seed += runs_all() ? 1 : 2) {
    // From dented ones to some that are inside out here and there.
    const Scene scene = rough_ball(seed, 1 - 0.006 * seed, 1);
    const auto views = standard_views(scene);
    const StandardView& view = views[seed % views.size()];
    const Drawings d = drawings(scene, view.camera);
    ++(d.faces > 0 ? culled : kept);
    EXPECT_EQ(differences(d), "") << "seed " << seed << ", view " << view.name;
  }
  EXPECT_GT(culled, 50u);
  EXPECT_GT(kept, 50u);
}

/// All edges of the inner cube that it does not hide itself are seen through the outer one, whose own back edges are seen as
/// well; by every method that sees through glass.
TEST(CullDrawing, ACubeInACubeOfGlass) {
  const Scene scene = corpus_scene("cube_in_glass");
  std::size_t methods = 0;
  for (const Method* each : all_methods()) {
    if (each->traits().transparency != TransparencyMode::seen_through) continue;
    ++methods;
    const std::string method(each->traits().name);
    const Drawings d = drawings(scene, along({-0.37, 0.83, -0.41}), method.c_str());
    EXPECT_EQ(d.faces, 3u) << "of the inner cube; " << method;
    EXPECT_EQ(differences(d), "") << method;
    EXPECT_EQ(d.culled.strokes.size(), d.all.strokes.size()) << method;
    std::set<std::uint32_t> edges;
    for (const Stroke& s : d.culled.strokes) edges.insert(s.source);
    EXPECT_EQ(edges.size(), 12u + 9u) << "edges of the outer cube, and those of the inner one that it does not hide itself";
  }
  EXPECT_EQ(methods, 4u);
}

TEST(CullDrawing, ChangesNoSceneWithGlass) {
  const std::filesystem::path folder = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/atherton_weiler/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Scene scene = scene_of_file(entry.path());
    for (const StandardView& view : standard_views(scene)) {
      const Drawings d = drawings(scene, view.camera, "atherton-weiler");
      EXPECT_EQ(differences(d), "") << entry.path().stem() << ", view " << view.name;
    }
  }
}

TEST(CullDrawing, ChangesNothingBehindGlass) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    Scene scene;
    for (int i = 0; i < 8; ++i) {
      const Point3 middle = Point3{u(random), u(random), u(random)} * 3.0,
                   turns = Point3{u(random), u(random), u(random)} * 3.0;
      add_box(scene, middle, {3, 2.5, 2}, rotation(turns.x, turns.y, turns.z));
    }
    scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"glass", {0.5, 0.7, 0.9}, 0.4}};
    // Boxes of glass, of stone, and some with a pane.
    for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
      const std::uint32_t o = f / 6;
      scene.face_material.push_back(o % 3 == 0 || (o % 3 == 1 && f % 6 == seed % 6));
    }
    const Drawings d = drawings(scene, along({-1, 2, -1}), "atherton-weiler");
    EXPECT_GT(d.faces, 0u);
    EXPECT_EQ(differences(d), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace ligne::test
