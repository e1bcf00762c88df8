/// The checker itself: right drawings pass, and each kind of fault is found and measured.

#include "check.hpp"
#include "cli/program.hpp"
#include "main/script.hpp"
#include "page_map.hpp"
#include "scene/readers/reader.hpp"
#include "scene/surfaces/mesh_writer.hpp"
#include "support/scene_parts.hpp"

namespace ligne::check {
namespace {

struct Box {
  Point3 low{0, 0, 0}, high{1, 1, 1};
};

const char* const kOblique = "--direction=-1,2,-0.7";
const char* const kPerspective = "--eye=4,-3,2.5 --target=0.5,0.5,0.5";
/// Sampled lengths are right to a sample at each end.
constexpr double kSampling = 0.25;

double stroke_length(const DrawnStroke& s) { return glm::distance(s.points[0], s.points[1]); }

Scene box_scene(const std::vector<Box>& boxes) {
  Scene scene;
  for (const Box& box : boxes) test::add_box(scene, box.low, box.high - box.low);
  return scene;
}

/// The boxes as the program draws them. The oracle and the known answers hold such drawings right to a micrometre.
DrawingFile draw_boxes(const std::vector<Box>& boxes, const std::string& options) {
  const test::TemporaryFolder folder;
  folder.write("boxes.json", write_ligne_scene(box_scene(boxes)));
  const std::string command = "draw boxes.json --quality exact -o drawn.json " + options;
  const test::Outcome outcome = test::run_ligne(folder, command.c_str());
  EXPECT_EQ(outcome.status, test::kDone) << outcome.err;
  return parse_drawing(test::bytes_of_file(folder / "drawn.json"));
}

Point2 page_point(const DrawingFile& drawing, const Point3& p) {
  return PageMap(drawing.model_to_page, {}, drawing.window, drawing.near_distance).page(p);
}

/// Draws the part of the edge on the page that its ends and its interval say.
void place_points(const DrawingFile& drawing, DrawnStroke& stroke) {
  for (std::size_t k = 0; k < 2; ++k)
    stroke.points[k] = page_point(drawing, stroke.ends[0] + (stroke.ends[1] - stroke.ends[0]) * stroke.interval[k]);
}

/// A whole edge, drawn.
DrawnStroke stroke_between(const DrawingFile& drawing, LineKind kind, const Point3& a, const Point3& b) {
  DrawnStroke stroke;
  stroke.kind = kind;
  stroke.ends = {a, b};
  place_points(drawing, stroke);
  return stroke;
}

void expect_right(const std::vector<Box>& boxes, const char* view) {
  const Scene scene = box_scene(boxes);
  const Report report = check_drawing(scene, draw_boxes(boxes, view), {});
  EXPECT_GT(report.drawn, 100);
  EXPECT_EQ(report.drawn_wrong(), 0) << to_text(report, 10);
  EXPECT_EQ(report.not_drawn(), 0) << to_text(report, 10);
  // Only samples next to the ends of strokes cannot be told.
  EXPECT_LT(report.share(report.drawn_undecided + report.missing_undecided), 0.005) << to_text(report, 10);
}

const std::vector<Box> kCube{{}};
const std::vector<Box> kApart{{}, {{-1.5, 0.7, -0.4}, {-0.3, 1.4, 0.6}}, {{0.2, -2, -1}, {0.4, -1.2, 1.7}}};
const std::vector<Box> kTouching{{}, {{1, 0, 0}, {2, 1, 1}}, {{0, 0, 1}, {1, 1, 2}}, {{0.25, -0.5, 0.25}, {0.75, 0, 0.75}}};

TEST(EmbreeCheck, RightDrawingsPass) {
  for (const char* const view : {kOblique, kPerspective}) {
    expect_right(kCube, view);
    expect_right(kApart, view);
    expect_right(kTouching, view);
  }
}

TEST(EmbreeCheck, RightDrawingsPassFarFromTheOrigin) {
  std::vector<Box> boxes = kApart;
  const Point3 far{559705, 4380220, 1700};
  for (Box& box : boxes) box.low += far, box.high += far;
  expect_right(boxes, kOblique);
}

TEST(EmbreeCheck, FindsAHiddenEdgeThatIsDrawn) {
  for (const char* const view : {kOblique, kPerspective}) {
    DrawingFile drawing = draw_boxes(kCube, view);
    ASSERT_EQ(drawing.strokes.size(), 9u);
    // (0, 1, 0) is the corner that neither viewer sees.
    const DrawnStroke hidden = stroke_between(drawing, kCrease, {0, 1, 0}, {0, 0, 0});
    drawing.strokes.push_back(hidden);
    const Report report = check_drawing(box_scene(kCube), drawing, {});
    EXPECT_NEAR(report.hidden_drawn, stroke_length(hidden), kSampling) << to_text(report, 10);
    EXPECT_EQ(report.not_drawn(), 0);
    ASSERT_EQ(report.findings.size(), 1u);
    EXPECT_EQ(report.findings[0].a, hidden.ends[0]);
  }
}

TEST(EmbreeCheck, FindsAVisibleEdgeThatIsNotDrawn) {
  for (const char* const view : {kOblique, kPerspective})
    for (std::size_t i = 0; i < 9; ++i) {
      DrawingFile drawing = draw_boxes(kCube, view);
      const double length = stroke_length(drawing.strokes[i]);
      drawing.strokes.erase(drawing.strokes.begin() + static_cast<std::ptrdiff_t>(i));
      const Report report = check_drawing(box_scene(kCube), drawing, {});
      EXPECT_NEAR(report.missing, length, kSampling) << to_text(report, 10);
      EXPECT_EQ(report.drawn_wrong(), 0);
    }
}

TEST(EmbreeCheck, FindsStrokesThatAreTooLongOrTooShort) {
  DrawingFile drawing = draw_boxes(kApart, kOblique);
  const auto cut = std::find_if(drawing.strokes.begin(), drawing.strokes.end(),
                                [](const DrawnStroke& s) { return s.interval[1] < 0.9 && s.interval[0] == 0; });
  ASSERT_NE(cut, drawing.strokes.end());
  const double unit = glm::distance(page_point(drawing, cut->ends[0]), page_point(drawing, cut->ends[1]));
  for (const double change_mm : {+2.0, -2.0}) {
    DrawingFile wrong = drawing;
    DrawnStroke& s = wrong.strokes[static_cast<std::size_t>(cut - drawing.strokes.begin())];
    s.interval[1] += change_mm / unit;
    place_points(wrong, s);
    const Report report = check_drawing(box_scene(kApart), wrong, {});
    EXPECT_NEAR(report.hidden_drawn, change_mm > 0 ? 2 : 0, kSampling) << to_text(report, 10);
    EXPECT_NEAR(report.missing, change_mm > 0 ? 0 : 2, kSampling) << to_text(report, 10);
  }
}

TEST(EmbreeCheck, FindsStrokesAtTheWrongPlace) {
  DrawingFile drawing = draw_boxes(kCube, kOblique);
  for (const double offset_mm : {0.01, 0.05}) {
    DrawingFile moved = drawing;
    for (DrawnStroke& s : moved.strokes) s.points[0].x += offset_mm, s.points[1].x += offset_mm;
    const Report report = check_drawing(box_scene(kCube), moved, {});
    EXPECT_NEAR(report.misplaced, offset_mm > 0.02 ? report.drawn : 0, 1e-6) << to_text(report, 10);
    if (offset_mm < 0.02) {
      EXPECT_EQ(report.missing, 0) << to_text(report, 10);
    } else {
      EXPECT_GT(report.missing, 0.5 * report.drawn);  // lines along x hide their offset
    }
  }
}

TEST(EmbreeCheck, FindsLinesThatAreNone) {
  DrawingFile drawing = draw_boxes(kCube, kOblique);
  drawing.strokes[0].kind = kMesh;
  const DrawnStroke diagonal = stroke_between(drawing, kCrease, {1, 0, 0}, {0, 0, 1});
  drawing.strokes.push_back(diagonal);
  CheckOptions options;
  options.kinds = kAllKinds;
  const Report report = check_drawing(box_scene(kCube), drawing, options);
  EXPECT_NEAR(report.no_line, stroke_length(drawing.strokes[0]) + stroke_length(diagonal), 1e-6) << to_text(report, 10);
  EXPECT_EQ(report.hidden_drawn, 0);
}

TEST(EmbreeCheck, FindsIntersectionsThatAreNotDrawn) {
  const std::vector<Box> boxes{{}, {{0.3, -0.5, 0.3}, {0.7, 0.5, 0.7}}};
  const Scene scene = box_scene(boxes);
  DrawingFile drawing = draw_boxes(boxes, std::string(kOblique) + " --edges outline,crease,border");
  const Report without = check_drawing(scene, drawing, {});
  EXPECT_EQ(without.drawn_wrong() + without.missing, 0) << to_text(without, 10);

  // The bar pierces the face y = 0 in a square; the bar hides two of its sides.
  const Point3 square[4] = {{0.3, 0, 0.3}, {0.7, 0, 0.3}, {0.7, 0, 0.7}, {0.3, 0, 0.7}};
  const DrawingFile bare = drawing;
  double length = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const DrawnStroke side = stroke_between(drawing, kIntersection, square[k], square[(k + 1) % 4]);
    DrawingFile alone = bare;
    alone.strokes = {side};
    if (check_drawing(scene, alone, {}).hidden_drawn > 0) continue;
    length += stroke_length(side);
    drawing.strokes.push_back(side);
  }
  EXPECT_EQ(drawing.strokes.size(), bare.strokes.size() + 2);
  EXPECT_NEAR(without.intersections_missing, length, 0.3 * length) << to_text(without, 10);
  const Report with = check_drawing(scene, drawing, {});
  EXPECT_EQ(with.drawn_wrong() + with.not_drawn(), 0) << to_text(with, 10);
}

TEST(EmbreeCheck, ReadsDrawings) {
  const DrawingFile drawing = parse_drawing(R"({"format":"ligne-drawing","version":2,
    "view":{"matrix":[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16],"perspective":true,"window":[1,2,30,40],"near":0.5},
    "strokes":[{"class":"border","visible":false,"source":{"edge":7,"ends":[[1,2,3],[4,5,6]],"faces":[3,null]},
    "interval":[0.25,0.5],"points":[[10,20],[30,40]]},
    {"class":"intersection","visible":true,"source":{"edge":null,"ends":[[1,2,3],[4,5,6]],"faces":[3,4]},
    "interval":[0,1],"points":[[1,2],[3,4]]}]})");
  EXPECT_EQ(drawing.window.max.y, 40);
  EXPECT_EQ(drawing.near_distance, 0.5);
  EXPECT_EQ(drawing.model_to_page[2][1], 10);
  ASSERT_EQ(drawing.strokes.size(), 2u);
  EXPECT_EQ(drawing.strokes[0].kind, kBorder);
  EXPECT_EQ(drawing.strokes[0].edge, 7u);
  EXPECT_FALSE(drawing.strokes[0].visible);
  EXPECT_EQ(drawing.strokes[0].interval[1], 0.5);
  EXPECT_EQ(drawing.strokes[1].points[1].y, 4);
  EXPECT_FALSE(drawing.strokes[1].edge.has_value());
  EXPECT_THROW(parse_drawing("{"), std::runtime_error);
  EXPECT_THROW(parse_drawing(R"({"format":"ligne-scene","version":1})"), std::runtime_error);
}

// Drawings that the program itself makes of real models, checked by rays. By default a few views of each; all of them with
// LIGNE_CHECK_ALL=1 in the environment.

/// Largest part of the drawn length that may be wrong, and that may be not drawn.
constexpr double kLimit = 0.0005;
const bool kEverything = std::getenv("LIGNE_CHECK_ALL") != nullptr;

/// "EDGES MODEL OPTIONS"
void expect_right(const std::string& text) {
  std::string_view rest = text;
  const std::string edges = test::take_word(rest), name = test::take_word(rest), options_of_view(rest);
  const std::filesystem::path model = std::filesystem::path(LIGNE_MODELS_DIR) / name;
  const test::TemporaryFolder folder;
  const std::filesystem::path drawing = folder / "drawing.json";
  const std::string fov = rest.starts_with("--eye") ? " --fov 50" : "";
  const std::string command = std::string("\"") + LIGNE_PROGRAM + "\" draw -q \"" + model.string() + "\" " +
                              options_of_view + fov + " --quality exact --edges " + edges + " -o \"" + drawing.string() +
                              "\"";
  CheckOptions options;
  options.kinds = edges == "all" ? kAllKinds : kFeatureKinds;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  Warnings warnings;
  const Scene scene = read_scene(model, {}, warnings);
  const Report report = check_drawing(scene, parse_drawing(test::bytes_of_file(drawing)), options);
  const std::string found = command + "\n" + to_text(report, 10);
  EXPECT_GT(report.drawn, 500) << found;
  EXPECT_LE(report.share(report.drawn_wrong()), kLimit) << found;
  EXPECT_LE(report.share(report.not_drawn()), kLimit) << found;
  EXPECT_LE(report.share(report.drawn_undecided + report.missing_undecided), 10 * kLimit) << found;
  if (kEverything) std::fputs(found.c_str(), stdout);
}

/// Steps: "draw EDGES MODEL OPTIONS", and "more ...", which is done where all is asked for.
[[maybe_unused]] const bool models_are_added =
    test::add_scripts(LIGNE_SOURCE_DIR "/tests/embree_check/models", [](const test::Script& script) {
      if (!std::filesystem::exists(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
      for (const test::ScriptStep& step : script.steps)
        if (kEverything || step.line.starts_with("draw ")) expect_right(step.line.substr(5));
    });

}  // namespace
}  // namespace ligne::check
