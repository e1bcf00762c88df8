#include "cli/commands/plot.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cli/options/idle_options.hpp"
#include "cli/options/options.hpp"
#include "cli/options/page_options.hpp"
#include "picture/pages/frame_names.hpp"
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
  group.add_repeatable_flag_or_value(
      "--hatch-cross", "NAME", take(add_hatch_cross),
      "a second family of strokes across the first, for all fills or, behind =, of a layer or colour; repeatable");
}

void add_part_options(CLI::App& app, LongPlotRequest& parts) {
  OptionGroup group(app, "Long plots");
  group.add(
      "--split", "time|distance|lifts=N", parts.split, parse_split,
      "in parts of time=30min, distance=3m of drawn lines, or lifts=200: files -o part%d.gcode, or pauses in one file");
  group.add("--from-stroke", "N", parts.from_stroke, parse_stroke_number, "begin with the Nth stroke of the plot")
      .standard("1");
  group.add("--from-time", "TIME", parts.from_seconds, parse_duration_s,
            "begin with the stroke that would be drawn at that time: 90s, 30min, 12:30");
  const Option every = group.add("--every", "LEN", parts.every_mm, parse_way_mm,
                                 "an action of the device, at the beginning and before more than LEN is drawn: 3m");
  const Option action =
      group.add("--do", "NAME", parts.action, parse_file_name, "the action, as the device names it: dip, pause");
  group.add("--park", "NAME", parts.park, parse_file_name, "where pens are changed, as the device names it: home");
  every.needs(action);
  action.needs(every);
}

void add_sheet_options(CLI::App& app, PlotDrawingRequest& request) {
  OptionGroup group(app, "Page");
  const Option tile = group.add("--tile", "SIZE", request.tile, parse_page_size,
                                "cut the page into sheets of that size: files -o sheet%d.svg, or pages of a PDF");
  group.add("--overlap", "LEN", request.overlap_mm, parse_min_length, "what neighbouring sheets have in common")
      .standard("5mm")
      .needs(tile);
  group.add("--grid", "CxR", request.grid, parse_grid, "columns and rows: several drawings on one sheet");
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
    throw UsageError("--output", "the sheets need a place for their number: name%d; only a PDF holds them all");
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
  CLI::App& plot = *add_command(app, "plot", "A drawing (JSON or SVG) made ready for pens and plotters", kPlotExamples);
  add_arguments(plot, "DRAWING", options.drawings, true, "ligne-drawing JSON, or an SVG of strokes; - is standard input");
  OptionGroup input(plot, "Input");
  input.add("--skip", "LIST", options.request.skip, parse_skip,
            "what of an SVG may be left out: text, image, fill, clip-path, ...");
  input.add_flag("--strict", options.request.reading.strict,
                 "refuse an SVG of which anything can not be drawn, by name and line, instead of leaving that out");
  input
      .add("--input-dpi", "N", options.request.reading.px_per_inch, parse_dpi,
           "units of an SVG to the inch: 96 by CSS, 72 or 90 by some programs")
      .standard("96");
  input
      .add_text(
          "--fill", "HOW",
          [&options](const std::string& text) { parse_plot_fill(text, options.request.fills, options.request.paint); },
          "filled areas of an SVG: refuse; outline, their contours; hatch, strokes inside too; of a stored drawing that has "
          "an order: material, shade, paper, random, painted as draw --fill does")
      .standard("outline");
  input.add_repeatable(
      "--material", "NAME=COLOUR", [&options](const std::string& text) { parse_material(text, options.request.paint); },
      "with --fill material or shade: another colour for a material; repeatable");
  input
      .add(
          "--min-length", "LEN", options.plotter.choice.request.min_length_mm,
          [](const std::string& t) { return parse_length_mm(t); },
          "leave out strokes that are shorter, after they are joined")
      .standard("0");
  input.add_flag_with_text(
      "--occlude", options.occlude,
      "opaque areas of an SVG hide what lies under them, as white ones always do; =layer: only what is in their layer");
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
