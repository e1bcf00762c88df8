/// Files compared byte by byte with tests/golden/. Run with LIGNE_UPDATE_GOLDENS=1 to write them anew.

#include <gtest/gtest.h>

#include "golden_file.hpp"
#include "plotting/stroke_text.hpp"
#include "sample_drawing.hpp"
#include "view/axes_layout.hpp"
#include "view/axis_lines.hpp"

namespace ligne {
namespace {

std::string sample_svg() {
  PlotOptions options;
  options.title = "A < B & \"C\"";
  return write_svg(sample_drawing(), options);
}

std::string sample_json() {
  const StrokeModel strokes = sample_strokes();
  const std::vector<Region> regions{{3, {{{0, 0}, {10, 0}, {5.0000004, 7.5}}, {{4, 1}, {6, 1}, {5, 2}}}}};
  const PaintOrder order{{{2, {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 4}, {4, 4}}}, {0, 0, 12.5}},
                          {0, {{{1, 1}, {5, 1}, {3.25, 4}}}, {0.5, -0.25, 3}},
                          {2, {{{8, 0}, {9, 0}, {8, 8}}}, {0, 0, 12.5}}}};
  DrawingDocument document;
  document.strokes = &strokes;
  document.regions = &regions;
  document.order = &order;
  document.source = [&](std::uint32_t source) { return sample_source(strokes, source); };
  document.model_to_page[3][0] = 105;
  document.window = {{0, 0}, {210, 297}};
  document.method = "appel";
  document.statistics.count("edges", 2);
  document.statistics.time("total", 1.25);
  return write_json(document, {});
}

/// The axes of a box, as `ligne surface --axes=grid` would draw them, without a surface.
Drawing axes_drawing() {
  AxesRequest request;
  request.style = AxesStyle::grid;
  request.axes[0] = {-12, 12, 1, "x", TickScale::linear};
  request.axes[1] = {0, 20, 1, "Distance (km)", TickScale::linear};
  request.axes[2] = {-0.2, 1, 10, "z", TickScale::linear};
  CameraRequest camera;
  camera.direction = Point3{-0.43, 0.75, -0.5};
  const Scene scene = box_scene(request.box());
  const Rect sheet{{0, 0}, {210, 297}}, area{{30, 30}, {180, 267}};
  const View view = make_view(scene, make_camera(camera, scene), {area}, sheet);
  const AxesPicture axes = lay_out_axes(
      request, view, [](std::string_view text, double height) { return text_extent(text, height, TextStyle::font); });
  Drawing drawing;
  constexpr double kCoincidence = 0.00025;
  drawing.layers.push_back({"axes", axis_lines(axes.lines, view, {}, kCoincidence)});
  for (const auto& mark : axes.marks) add_line(drawing, "axes", {mark[0], mark[1]});
  drawing.texts = axes.texts;
  return drawing;
}

TEST(Golden, Axes) { expect_golden("axes.svg", write_svg(axes_drawing(), {})); }
TEST(Golden, AxesWithTextAsStrokes) {
  Drawing drawing = axes_drawing();
  EXPECT_EQ(draw_texts_as_strokes(drawing), 0u);
  expect_golden("axes-strokes.svg", write_svg(drawing, {}));
}

TEST(Golden, Svg) { expect_golden("sample.svg", sample_svg()); }
TEST(Golden, Json) { expect_golden("sample.json", sample_json()); }

TEST(Golden, TheComparisonCanFail) {
  std::string svg = sample_svg();
  ++svg[svg.size() / 2];
  EXPECT_NE(difference("sample.svg", svg), "");
  EXPECT_NE(difference("sample.svg", sample_svg() + " "), "");
  EXPECT_NE(difference("sample.svg", sample_svg().substr(1)), "");
  EXPECT_NE(difference("no-such-golden.svg", ""), "");
}

}  // namespace
}  // namespace ligne
