#include "cli/plot.hpp"

#include <utility>

#include "cli/options.hpp"
#include "cli/page_options.hpp"
#include "picture/parse.hpp"
#include "picture/parse_options.hpp"
#include "picture/parse_plot.hpp"

namespace ligne {
namespace {

constexpr const char* kExamples = R"(Examples:
  ligne plot sombrero.svg --device hp7475a --report -o sombrero.hpgl
  ligne plot gearbox.json --pen outline=1,black,0.5 --pen rest=2,blue,0.25 -o gearbox.gcode
  ligne plot poster.svg --page A3 --scale fit --preview way.svg -o poster-ready.svg)";

void add_placing_options(CLI::App& app, PlotDrawingRequest& options) {
  OptionGroup group(app, "Page");
  group
      .add("--page", "SIZE", options.page, parse_page_size,
           "A0 to A6, letter, legal, tabloid, or WxH; the drawing's own page comes into its middle")
      .standard("the drawing's");
  const Option landscape = group.add_flag("--landscape", options.landscape, "page lies on its long side");
  const Option portrait = group.add_flag("--portrait", options.portrait, "page stands on its short side");
  group
      .add(
          "--margin", "LEN", options.margin_mm, [](const std::string& t) { return parse_length_mm(t); },
          "empty rim of the page when the drawing is to fit")
      .standard("10mm");
  group.add("--pen-width", "LEN", options.pen_width_mm, parse_pen_width, "width of the lines, where no pen has its own")
      .standard("the drawing's");
  add_width_option(app, options.widths_mm, false);
  group
      .add("--scale", "fit|N:M", options.scale, parse_scale,
           "true to scale, larger or smaller, or what is drawn fills the page")
      .standard("1:1");
  landscape.excludes({portrait});
}

void add_fill_hatch_options(CLI::App& app, PlotDrawingRequest& request) {
  OptionGroup group(app, "Hatching");
  const auto take = [&request](void (*add)(FillHatches&, const std::string&)) {
    return [&request, add](const std::string& text) {
      add(request.hatches, text);
      request.hatches_given = true;
    };
  };
  group.add_text(
      "--hatch", "HOW",
      take([](FillHatches& hatches, const std::string& text) { hatches.all.tone = parse_fill_tone(text); }),
      "fills with strokes, of an SVG or of the regions of a stored drawing: plain, or shade, the darker the closer");
  group.add_repeatable("--hatch-spacing", "[NAME=]LEN", take(add_hatch_spacing),
                       "distance of the strokes, of all fills or of a layer or colour; repeatable");
  group.add_repeatable("--hatch-angle", "[NAME=]DEG", take(add_hatch_angle),
                       "their direction, counter-clockwise; repeatable");
  group.add_flag_or_value("--hatch-cross", "NAME", take(add_hatch_cross),
                          "a second family of strokes across the first, for all fills or a layer or colour");
}

void plot(const PlotCommandOptions& options, const MemoryLimit& memory) {
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  PlotDrawingRequest request = options.request;
  request.format = format_of(options.output);
  request.memory = memory;
  check(request);
  RunReport run;
  request.plotter = plotter_request(options.plotter.choice, request.format, run.files);
  const DrawingText drawing = read_drawing_text(options.drawing, run.files);
  files.were_read(run.files);
  Picture picture = plot_drawing(drawing, request, run);
  deliver(std::move(picture), *options.output.file, options.plotter.preview, options.drawing, options.run, run, files);
}

}  // namespace

void setup_plot(CLI::App& app, PlotCommandOptions& options) {
  CLI::App& plot = *add_command(app, "plot", "A drawing (JSON or SVG) made ready for pens and plotters", kExamples);
  add_argument(plot, "DRAWING", options.drawing, "ligne-drawing JSON, or an SVG of strokes");
  OptionGroup input(plot, "Input");
  input.add("--skip", "LIST", options.request.skip, parse_skip,
            "what of an SVG may be left out: text, image, fill, clip-path, ...");
  input
      .add("--fill", "HOW", options.request.fills, parse_fill_reading,
           "filled areas of an SVG: refuse; outline, their contours; hatch, strokes inside too")
      .standard("outline");
  input
      .add(
          "--min-length", "LEN", options.plotter.choice.request.min_length_mm,
          [](const std::string& t) { return parse_length_mm(t); },
          "leave out strokes that are shorter, after they are joined")
      .standard("0");
  input.add_flag("--occlude", options.request.occlude,
                 "opaque areas of an SVG hide what lies under them, as white ones always do");
  add_fill_hatch_options(plot, options.request);
  add_placing_options(plot, options.request);
  add_output_options(plot, options.output, "svg pdf png hpgl gcode (default: by the suffix)");
  add_dpi_option(plot, options.request.dpi);
  add_plotter_options(plot, options.plotter);
  add_run_options(plot, options.run);
}

void run_plot(const PlotCommandOptions& options) {
  format_of(options.output);
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { plot(options, memory); });
}

}  // namespace ligne
