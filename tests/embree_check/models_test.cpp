/// Drawings that the program itself makes of real models, checked by rays. By default a few views of each; all of them with
/// LIGNE_CHECK_ALL=1 in the environment.

#include "check.hpp"
#include "main/tier.hpp"
#include "scene/readers/reader.hpp"
#include "support/test.hpp"

namespace ligne::check {
namespace {

/// Largest part of the drawn length that may be wrong, and that may be not drawn.
constexpr double kLimit = 0.0005;

struct View {
  const char* name;
  const char* options;
};

struct Model {
  const char* file;
  std::vector<View> views;  ///< eyes are of the model: two from outside, one close
};

const View kParallel[] = {{"iso", "--view iso"}, {"front", "--view front"}, {"oblique", "--direction 1,2,-0.7"}};

const Model kModels[] = {
    {"teapot.obj", {{"eye_1", "--eye 5,4,9"}, {"eye_2", "--eye -9,1,-4"}, {"close", "--eye 1,3.4,2.6 --target 0,1.5,0"}}},
    {"quadknot.obj",
     {{"eye_1", "--eye 150,120,250"}, {"eye_2", "--eye -400,-100,-80"}, {"close", "--eye -60,30,40 --target -64,0,-76"}}},
    {"beetle.obj",
     {{"eye_1", "--eye 1,1,1.5"}, {"eye_2", "--eye -1.5,0.5,-1"}, {"close", "--eye 0.3,0.6,0.75 --target 0,0.45,0.3"}}},
    {"CITY.ASC",
     {{"eye_1", "--eye 7000,-9000,5000"},
      {"eye_2", "--eye -6000,-2000,700"},
      {"close", "--eye 600,-5200,300 --target 600,-2000,300"}}},
    {"lantern/Lantern.gltf",
     {{"eye_1", "--eye 30,20,40"}, {"eye_2", "--eye -25,10,20"}, {"close", "--eye 10,22,6 --target 6,20,0"}}},
    {"featuretype.stl",
     {{"eye_1", "--eye 6,-7,5"}, {"eye_2", "--eye -5,4,3"}, {"close", "--eye 1.5,-2,2.2 --target 0,0,0.7"}}},
    {"stanford-bunny.obj",
     {{"eye_1", "--eye 0.2,0.25,0.4"},
      {"eye_2", "--eye -0.4,0.1,-0.2"},
      {"close", "--eye -0.02,0.16,0.15 --target -0.03,0.12,0"}}},
    {"2CylinderEngine.glb",
     {{"eye_1", "--eye 600,500,900"}, {"eye_2", "--eye -900,100,-500"}, {"close", "--eye 100,150,300 --target 0,0,0"}}},
};

struct Case {
  const Model* model;
  View view;
  const char* edges;
};

std::string name_of_case(const Case& c) {
  std::string name = std::filesystem::path(c.model->file).stem().string() + "_" + c.view.name + "_" + c.edges;
  for (char& ch : name)
    if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
  return name;
}

void PrintTo(const Case& c, std::ostream* out) { *out << name_of_case(c); }

/// By default every model has one parallel view with all edges and one perspective with the features; in the first tier one
/// of the two.
std::vector<Case> cases() {
  const bool everything = std::getenv("LIGNE_CHECK_ALL") != nullptr;
  std::vector<Case> cases;
  for (const Model& model : kModels) {
    std::vector<View> views(std::begin(kParallel), std::end(kParallel));
    views.insert(views.end(), model.views.begin(), model.views.end());
    for (std::size_t v = 0; v < views.size(); ++v)
      for (const char* edges : {"feature", "all"}) {
        const bool all_edges = std::string_view(edges) == "all";
        const bool is_usual = (v == 2 && all_edges) || (v == 5 && !all_edges);
        if (everything || (is_usual && test::is_chosen(std::string("rays, ") + model.file, v / 3, 2)))
          cases.push_back({&model, views[v], edges});
      }
  }
  return cases;
}

class ModelDrawing : public testing::TestWithParam<Case> {};

TEST_P(ModelDrawing, IsRight) {
  const Case& c = GetParam();
  const std::filesystem::path model = std::filesystem::path(LIGNE_MODELS_DIR) / c.model->file;
  if (!std::filesystem::exists(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
  const test::TemporaryFolder folder;
  const std::filesystem::path drawing = folder / (name_of_case(c) + ".json");
  const std::string fov = std::string_view(c.view.options).starts_with("--eye") ? " --fov 50" : "";
  const std::string command = std::string("\"") + LIGNE_PROGRAM + "\" draw -q \"" + model.string() + "\" " + c.view.options +
                              fov + " --quality exact --edges " + c.edges + " -o \"" + drawing.string() + "\"";
  CheckOptions options;
  options.kinds = std::string_view(c.edges) == "all" ? kAllKinds : kFeatureKinds;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  Warnings warnings;
  const Scene scene = read_scene(model, {}, warnings);
  const Report report = check_drawing(scene, read_drawing(drawing), options);
  const std::string text = command + "\n" + to_text(report, 10);
  EXPECT_GT(report.drawn, 500) << text;
  EXPECT_LE(report.share(report.drawn_wrong()), kLimit) << text;
  EXPECT_LE(report.share(report.not_drawn()), kLimit) << text;
  EXPECT_LE(report.share(report.drawn_undecided + report.missing_undecided), 10 * kLimit) << text;
  if (std::getenv("LIGNE_CHECK_ALL") != nullptr) std::fputs(text.c_str(), stdout);
}

INSTANTIATE_TEST_SUITE_P(Models, ModelDrawing, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& info) { return name_of_case(info.param); });

}  // namespace
}  // namespace ligne::check
