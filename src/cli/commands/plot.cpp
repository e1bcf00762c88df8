#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cli/commands.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "picture/pages/frames.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parse/parse_plot.hpp"

namespace ligne {
namespace {

constexpr const char* kPlotExamples = R"(Examples:
  ligne plot sombrero.svg --device hp7475a --report -o sombrero.hpgl
  ligne plot gearbox.json --pen outline=1,black,0.5 --pen rest=2,blue,0.25 -o gearbox.gcode
  ligne plot long.svg --device grbl-servo --split time=30min -o 'part%d.gcode'
  ligne plot a.svg b.svg --grid 2x1 --page A4 -o both.svg
  ligne plot poster.svg --page A3 --scale fit --preview way.svg -o poster-ready.svg)";

void add_placing_options(CLI::App& app, PlotDrawingRequest& options) {
  OptionGroup group(app, "Page");
  group.add("--page", "SIZE", options.page, parse_page_size,
            "A0 to A6, letter, legal, tabloid, or WxH; the drawing is centred on it", "the drawing's");
  const Option landscape = group.add_flag("--landscape", options.landscape, "landscape page");
  const Option portrait = group.add_flag("--portrait", options.portrait, "portrait page");
  group.add("--margin", "LEN", options.margin_mm, parse_length_mm, "page margin, with --scale fit", "10mm");
  group.add("--pen-width", "LEN", options.pen_width_mm, parse_pen_width, "line width, unless a pen has its own",
            "the drawing's");
  add_width_option(app, options.widths_mm, false);
  group.add("--scale", "fit|N:M", options.scale, parse_scale, "scale factor, or fit the drawing to the page", "1:1");
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
      "hatch fills of an SVG or regions of a ligne-drawing. plain: one distance; shade: closer strokes for darker colours");
  group.add_repeatable("--hatch-spacing", "[NAME=]LEN", take(add_hatch_spacing),
                       "distance between strokes, for all fills or for a layer or colour; repeatable");
  group.add_repeatable("--hatch-angle", "[NAME=]DEG", take(add_hatch_angle),
                       "direction of the strokes, counter-clockwise, for all fills or for a layer or colour; repeatable");
  group.add_repeatable_flag_or_value(
      "--hatch-cross", "NAME", take(add_hatch_cross),
      "a second family of strokes across the first, for all fills or for a layer or colour; repeatable");
}

void add_part_options(CLI::App& app, LongPlotRequest& parts) {
  OptionGroup group(app, "Long plots");
  group.add(
      "--split", "time|distance|lifts=N", parts.split, parse_split,
      "divide the plot into parts of time=30min, distance=3m of drawn lines, or lifts=200: files -o part%d.gcode, or pauses "
      "in one file");
  group.add("--from-stroke", "N", parts.from_stroke, parse_stroke_number, "begin with the Nth stroke of the plot", "1");
  group.add("--from-time", "TIME", parts.from_seconds, parse_duration_s,
            "begin with the stroke that the plot would draw at this time: 90s, 30min, 12:30");
  const Option every =
      group.add("--every", "LEN", parts.every_mm, parse_drawn_length_mm,
                "run the action of --do at the beginning and at least every LEN of drawn lines, such as 3m");
  const Option action =
      group.add("--do", "NAME", parts.action, parse_file_name, "the action for --every, as named by the device: dip, pause");
  group.add("--park", "NAME", parts.park, parse_file_name, "position for pen changes, as named by the device: home");
  every.needs(action);
  action.needs(every);
}

void add_sheet_options(CLI::App& app, PlotDrawingRequest& request) {
  OptionGroup group(app, "Page");
  const Option tile = group.add("--tile", "SIZE", request.tile, parse_page_size,
                                "cut the page into sheets of that size: files -o sheet%d.svg, or pages of a PDF");
  group.add("--overlap", "LEN", request.overlap_mm, parse_min_length, "overlap of neighbouring sheets", "5mm").needs(tile);
  group.add("--grid", "CxR", request.grid, parse_grid, "columns and rows for several drawings on one sheet");
}

void plot(const PlotCommandOptions& options, const MemoryLimit& memory) {
  const std::string& output = *options.output.file;
  RunFiles files;
  files.will_write("--output", output);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  PlotDrawingRequest request = options.request;
  request.format = format_of(options.output);
  request.memory = memory;
  request.occlude = !options.occlude.empty();
  try {
    request.own_layer = request.occlude && options.occlude != "true" && parse_own_layer(options.occlude);
  } catch (const std::invalid_argument& e) {
    throw UsageError("--occlude", e.what());
  }
  RunReport run;
  request.plotter = plotter_request(options.plotter.choice, request.format, run.files);
  request.curves = options.curves.value_or(false);
  const bool numbered = has_number_place(output);
  request.plotter.parts.split_files = numbered;
  request.plotter.parts.pen_files = has_number_place(output, 'p');
  check(request);
  if (request.tile && !numbered && request.format != OutputFormat::pdf)
    throw UsageError("--output", "several sheets need a number in the file name, such as name%d, or a PDF");
  std::vector<DrawingText> drawings;
  for (const std::string& file : options.drawings) drawings.push_back(read_drawing_text(file, run.files));
  files.were_read(run.files);
  Picture picture = plot_drawings(drawings, request, numbered, run);
  if (!options.run.quiet) {
    warn_of_suffix(options.output);
    warn_of_idle_options(
        {"plot", options.run.given, request.format, request.plotter.by_pens(), std::ranges::any_of(drawings, is_svg)});
  }
  deliver(std::move(picture), {output, options.plotter.preview, options.drawings.front()}, options.run, run, files);
}

}  // namespace

void setup_plot(CLI::App& app, PlotCommandOptions& options) {
  CLI::App& plot = *add_command(app, "plot", "Prepare a drawing (JSON or SVG) for pens and plotters", kPlotExamples);
  add_arguments(plot, "DRAWING", options.drawings, true, "ligne-drawing (JSON) or SVG; - is standard input");
  OptionGroup input(plot, "Input");
  input.add("--skip", "LIST", options.request.skip, parse_skip,
            "SVG features to leave out: text, image, fill, clip-path, ...");
  input.add_flag("--strict", options.request.reading.strict,
                 "stop with an error at the first SVG feature that can not be drawn, instead of leaving it out");
  input.add("--input-dpi", "N", options.request.reading.px_per_inch, parse_dpi,
            "SVG user units per inch: 96 (CSS); 72 or 90 in files of some programs", "96");
  input.add_text(
      "--fill", "HOW",
      [&options](const std::string& text) { parse_plot_fill(text, options.request.fills, options.request.paint); },
      "fills of an SVG. refuse: stop with an error; outline: draw contours; hatch: contours and hatching. Faces of a "
      "ligne-drawing that has an order: material, shade, paper, random, as in draw --fill",
      "outline");
  input.add_repeatable(
      "--material", "NAME=COLOUR", [&options](const std::string& text) { parse_material(text, options.request.paint); },
      "with --fill material or shade: replace the colour of a material; repeatable");
  input.add("--min-length", "LEN", options.plotter.choice.request.min_length_mm, parse_length_mm,
            "omit strokes shorter than LEN, after joining", "0");
  input.add_flag_with_text(
      "--occlude", options.occlude,
      "opaque SVG areas hide strokes below them, as white areas always do; =layer: only strokes of their own layer");
  add_fill_hatch_options(plot, options.request);
  add_placing_options(plot, options.request);
  add_sheet_options(plot, options.request);
  add_output_options(plot, options.output, "svg pdf png hpgl gcode (default: by the suffix)");
  add_dpi_option(plot, options.request.dpi);
  add_curves_option(plot, options.curves, "off");
  add_plotter_options(plot, options.plotter);
  add_part_options(plot, options.plotter.choice.request.parts);
  add_run_options(plot, options.run);
}

void run_plot(const PlotCommandOptions& options) {
  format_of(options.output);
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { plot(options, memory); });
}

}  // namespace ligne
