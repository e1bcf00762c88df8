/// Cairo draws the lines and areas of every picture: its functions are taken over here, counted, and called.

#include <cairo.h>
#include <dlfcn.h>
#include <atomic>

#include "sample_drawing.hpp"

namespace {

/// Strokes are counted by the lines of their paths, as threads may share the lines of a layer.
std::atomic<int> stroked_lines, stroke_calls, fill_calls;

using Paint = void (*)(cairo_t*);
void call(const char* name, cairo_t* cairo) { reinterpret_cast<Paint>(dlsym(RTLD_NEXT, name))(cairo); }

int lines_of(cairo_t* cairo) {
  cairo_path_t* const path = cairo_copy_path(cairo);
  int count = 0, moves = 0;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    // A path that is closed ends with a move that leads nowhere.
    const bool is_move = path->data[i].header.type == CAIRO_PATH_MOVE_TO;
    count += !is_move && moves > 0;
    moves = is_move ? 1 : 0;
  }
  cairo_path_destroy(path);
  return count;
}

}  // namespace

extern "C" {
void cairo_stroke(cairo_t* cairo) {
  ++stroke_calls;
  stroked_lines += lines_of(cairo);
  call("cairo_stroke", cairo);
}
void cairo_fill(cairo_t* cairo) {
  ++fill_calls;
  call("cairo_fill", cairo);
}
void cairo_fill_preserve(cairo_t* cairo) {
  ++fill_calls;
  call("cairo_fill_preserve", cairo);
}
}

namespace ligne {
namespace {

struct Counts {
  int lines, strokes, fills;
};

template <typename Write>
Counts counts_of(Write write, const Drawing& drawing) {
  stroked_lines = stroke_calls = fill_calls = 0;
  EXPECT_FALSE(write(drawing, PlotOptions{}, nullptr).empty());
  return {stroked_lines, stroke_calls, fill_calls};
}

TEST(CairoCalls, EveryLineIsStrokedInEveryFormat) {
  for (const auto write : {write_svg, write_pdf, write_png}) {
    const Counts sample = counts_of(write, sample_drawing());
    EXPECT_EQ(sample.lines, 5);
    EXPECT_EQ(sample.strokes, 3) << "one call a layer";
    EXPECT_EQ(sample.fills, 0);
    EXPECT_EQ(counts_of(write, {}).strokes, 0);
  }
}

TEST(CairoCalls, PathsForAnotherDocumentAreStrokedToo) {
  Polylines lines;
  lines.add(std::vector<Point2>{{-3, 4}, {10, 4.00004}, {10, 20}});
  lines.add(std::vector<Point2>{{0, 0}, {0, 0}});
  stroked_lines = stroke_calls = 0;
  EXPECT_EQ(svg_paths(lines), "<path d=\"M-3 4l13 0 0 16\"/>\n<path d=\"M0 0h0\"/>\n");
  EXPECT_EQ(stroked_lines, 2);
  EXPECT_EQ(stroke_calls, 1);
  EXPECT_EQ(svg_paths({}), "");
}

TEST(CairoCalls, ALargeLayerIsStrokedInParts) {
  Drawing drawing;
  for (int i = 0; i < 20000; ++i) add_line(drawing, "mesh", {{i * 0.01, 1}, {i * 0.01, 2 + i % 7}});
  const Counts svg = counts_of(write_svg, drawing), pdf = counts_of(write_pdf, drawing);
  EXPECT_EQ(svg.lines, 20000);
  EXPECT_EQ(svg.strokes, 20) << "parts of 2048 points";
  EXPECT_EQ(pdf.lines, 20000);
  EXPECT_EQ(pdf.strokes, 1);
}

TEST(CairoCalls, EveryAreaIsFilledInEveryFormat) {
  Drawing drawing;
  const std::vector<Point2> square{{10, 10}, {20, 10}, {20, 20}, {10, 20}};
  for (const double red : {0.0, 0.0, 0.5}) drawing.fills.push_back({{square}, {red, 0, 0}});
  drawing.fills.push_back({{square}, {0, 1, 0}, 0.5});
  for (const auto write : {write_svg, write_pdf, write_png}) {
    const Counts counts = counts_of(write, drawing);
    EXPECT_EQ(counts.fills, 3) << "neighbours of one colour at once";
    EXPECT_EQ(counts.strokes, 2) << "rims of the opaque ones";
  }
}

}  // namespace
}  // namespace ligne
