#include "cli/plot.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cli/messages.hpp"
#include "cli/options.hpp"
#include "cli/page_options.hpp"
#include "files/message_text.hpp"
#include "picture/parse.hpp"
#include "picture/parse_options.hpp"
#include "picture/placement.hpp"
#include "picture/write_picture.hpp"
#include "plotting/drawing_reader.hpp"
#include "plotting/plot.hpp"

namespace ligne {
namespace {

/// A larger file is refused before it is read: a drawing of it would have hundreds of millions of points.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 28;

constexpr double kPenWidthMm = 0.35;
constexpr std::string_view kFillHatchNames[] = {"plain", "shade"};

constexpr const char* kExamples = R"(Examples:
  ligne plot sombrero.svg --device hp7475a --report -o sombrero.hpgl
  ligne plot gearbox.json --pen outline=1,black,0.5 --pen rest=2,blue,0.25 -o gearbox.gcode
  ligne plot poster.svg --page A3 --scale fit --preview way.svg -o poster-ready.svg)";

std::string_view without_mark(std::string_view text) {
  const std::string_view bom = "\xef\xbb\xbf";
  if (text.starts_with(bom)) text.remove_prefix(bom.size());
  return text;
}

char first_character(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? '\0' : text[first];
}

bool begins_json(std::string_view text) { return first_character(without_mark(text)) == '{'; }

/// JSON begins with a brace, XML with an angle bracket, whatever the name says.
ReadDrawing read_drawing(const PlotCommandOptions& options, std::string_view text, const FillReading& fills) {
  const std::string_view content = without_mark(text);
  const char begins = first_character(content);
  if (begins == '{') return read_json_drawing(content, options.drawing);
  if (begins == '<') return read_svg_drawing(text, options.drawing, options.skip, fills);
  throw std::runtime_error(options.drawing + ": is neither a ligne-drawing nor an SVG");
}

void transform(Drawing& drawing, double scale, Point2 shift) {
  for (Layer& layer : drawing.layers) {
    for (Point2& p : layer.lines.points) p = p * scale + shift;
  }
}

/// Puts the drawing on the page that is asked for: its own page in the middle of that, or what it shows made to fill it.
/// Gives the scale.
double place(const PlotCommandOptions& options, ReadDrawing& read) {
  const Page own = read.page;
  Page page = own;
  const Rect ink = ink_of(read.drawing);
  if (options.page) {
    PageRequest wanted;
    wanted.size = *options.page;
    wanted.landscape = options.landscape;
    wanted.portrait = options.portrait;
    page = page_for(wanted, options.fit && !ink.empty() ? ink : own.sheet());
  } else if ((options.landscape && own.height_mm > own.width_mm) || (options.portrait && own.width_mm > own.height_mm)) {
    std::swap(page.width_mm, page.height_mm);
  }
  if (!options.page && !options.fit) {
    page.width_mm *= options.scale;
    page.height_mm *= options.scale;
  }
  page.margin_mm = options.margin_mm;
  double scale = options.scale;
  Rect from = own.sheet();
  if (options.fit && !ink.empty() && (ink.width() > 0 || ink.height() > 0)) {
    const Rect area = page.drawable();
    if (!(area.width() > 0 && area.height() > 0))
      throw UsageError("--margin", shortest(options.margin_mm) + " mm leaves nothing of the page");
    from = ink;
    const double across = ink.width() > 0 ? area.width() / ink.width() : area.height() / ink.height();
    const double down = ink.height() > 0 ? area.height() / ink.height() : across;
    scale = std::min(across, down);
  }
  transform(read.drawing, scale, page.sheet().max * 0.5 - (from.min + from.max) * (0.5 * scale));
  read.page = page;
  return scale;
}

std::string times(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void warn_of_left_out(const PlotCommandOptions& options, const ReadDrawing& read) {
  if (options.run.quiet) return;
  for (const auto& [name, count] : read.left_out)
    warn(options.drawing, std::to_string(count) + " times " + name + " left out, as asked");
  if (!read.unknown.empty()) {
    std::string names;
    for (const auto& [name, count] : read.unknown)
      names += (names.empty() ? "" : ", ") + name + (count > 1 ? " (" + std::to_string(count) + " times)" : "");
    warn(options.drawing, "elements that SVG does not know are left out: " + names);
  }
  if (read.size_assumed) warn(options.drawing, "tells no size: taken as 1000 px where it does not, 264.58 mm");
  if (read.outlined > 0 && !options.fills) {
    warn(options.drawing, times(read.outlined, "filled area is", "filled areas are") +
                              " drawn by the outline; --fill hatch fills, --skip fill leaves out, --fill outline is silent");
  }
  if (read.simplified_paints > 0) {
    warn(options.drawing,
         times(read.simplified_paints, "gradient or pattern is", "gradients and patterns are") + " drawn in one colour");
  }
  if (read.filters > 0)
    warn(options.drawing, times(read.filters, "filter is", "filters are") + " not applied; lines are drawn without");
  if (read.boxes > 0)
    warn(options.drawing, times(read.boxes, "character is", "characters are") + " not in the font: drawn as boxes");
  if (read.drawing.layers.empty()) warn(options.drawing, "there is no stroke in the drawing");
}

/// The drawing in its place. Strokes that fill an area lie as far apart as the pen is wide on the drawing as it comes out,
/// so its scale must be known before.
ReadDrawing placed_drawing(const PlotCommandOptions& options, double hatch_pen_mm, RunFiles& files) {
  InputFiles opened;
  const std::vector<std::byte> bytes = read_input(options.drawing, options.drawing, opened, kMostBytes);
  files.were_read(opened);
  const std::string_view text = as_characters(bytes);
  const double pen_mm = options.pen_width_mm.value_or(kPenWidthMm);
  const FillReading::How how =
      options.fills.value_or(options.hatches_given ? FillReading::How::hatch : FillReading::How::outline);
  FillReading fills{how, pen_mm, options.occlude, options.hatches};
  double scale = options.scale;
  if (options.fit && how == FillReading::How::hatch) {
    FillReading plain = fills;
    plain.how = FillReading::How::outline;
    ReadDrawing contours = read_drawing(options, text, plain);
    scale = place(options, contours);
  }
  if (begins_json(text)) fills.pen_width_mm = hatch_pen_mm;
  fills.pen_width_mm /= scale;
  if (fills.hatches.all.spacing_mm) *fills.hatches.all.spacing_mm /= scale;
  for (auto& [name, spacing] : fills.hatches.spacing_mm_of) spacing /= scale;
  ReadDrawing read = read_drawing(options, text, fills);
  if (how == FillReading::How::hatch && begins_json(text)) {
    try {
      hatch_regions(read, fills);
    } catch (const std::exception& e) {
      throw std::runtime_error(options.drawing + ": " + e.what());
    }
  }
  warn_of_left_out(options, read);
  place(options, read);
  if (options.pen_width_mm) {
    for (Layer& layer : read.drawing.layers) layer.width_mm.reset();
  }
  return read;
}

/// Width of the pen that hatches the regions of a stored drawing.
double hatch_pen_mm(const PlotCommandOptions& options, const PenTable& pens) {
  const double usual = layer_style("hatch", options.pen_width_mm.value_or(kPenWidthMm), false).width_mm;
  return pens.empty() ? usual : pens.pen(pens.pen_of("hatch", "")).width_mm.value_or(usual);
}

/// Layers of an SVG without layers are named by their colours.
LineStyle style_of_layer(const std::string& layer, double pen_width_mm, bool hidden_solid) {
  LineStyle style = layer_style(layer, pen_width_mm, hidden_solid);
  if (!layer.starts_with('#')) return style;
  try {
    style.color = parse_color(layer);
  } catch (const std::invalid_argument&) {
    // A layer that only looks like a colour is drawn in black.
  }
  return style;
}

void plot(const PlotCommandOptions& options, const MemoryLimit& memory) {
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  const OutputFormat format = format_of(options.output);
  if (format == OutputFormat::json) throw UsageError("--format", "plot writes svg, pdf, png, hpgl or gcode");
  RunReport run;
  PlotterRequest plotter = plotter_request(options.plotter.choice, format, run.files);
  files.were_read(run.files);
  plotter.fit_drawing = options.fit;
  if (!plotter.by_pens() && !plotter.optimize) plotter.optimize = Optimize::join;
  const ReadDrawing read = timed(run.stages, {"read", printable(options.drawing, kLongestPath)},
                                 [&] { return placed_drawing(options, hatch_pen_mm(options, plotter.pens), files); });
  if (format == OutputFormat::png) check_png(read.page, options.dpi, memory);
  PlotOptions style;
  style.page = read.page;
  style.pen_width_mm = options.pen_width_mm.value_or(kPenWidthMm);
  style.widths_mm = options.widths_mm;
  style.hidden_solid = read.dashes_cut;
  style.dpi = options.dpi;
  style.style = [&](const std::string& layer) { return style_of_layer(layer, style.pen_width_mm, style.hidden_solid); };
  Picture picture = timed(run.stages, "write", [&] { return write_picture(read.drawing, style, plotter, format, run); });
  deliver(std::move(picture), *options.output.file, options.plotter.preview, options.drawing, options.run, run, files);
}

void add_placing_options(CLI::App& app, PlotCommandOptions& options) {
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
  const auto parse_scale_or_fit = [&options](const std::string& t) {
    const std::optional<double> ratio = parse_scale(t);
    options.fit = !ratio;
    return ratio.value_or(1);
  };
  group
      .add("--scale", "fit|N:M", options.scale, parse_scale_or_fit,
           "true to scale, larger or smaller, or what is drawn fills the page")
      .standard("1:1");
  landscape.excludes({portrait});
}

std::set<std::string> parse_skip(const std::string& text) {
  std::set<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    parse_choice(name, kSkippable);
    names.insert(name);
    begin = end + 1;
  }
  return names;
}

/// "VALUE" for all fills, "NAME=VALUE" for those of a layer or a colour.
std::pair<std::string, std::string> split_name(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) return {"", text};
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// A colour by its code, as the layers of a drawing without layers are named; another name as it stands.
std::string layer_or_color(const std::string& name) {
  try {
    return color_code(parse_color(name));
  } catch (const std::invalid_argument&) {
    return name;
  }
}

void add_fill_hatch_options(CLI::App& app, PlotCommandOptions& options) {
  OptionGroup group(app, "Hatching");
  FillHatches& hatches = options.hatches;
  group.add_text(
      "--hatch", "HOW",
      [&options](const std::string& text) {
        options.hatches.all.tone = parse_choice(text, kFillHatchNames) == 1;
        options.hatches_given = true;
      },
      "fills with strokes, of an SVG or of the regions of a stored drawing: plain, or shade, the darker the closer");
  group.add_repeatable(
      "--hatch-spacing", "[NAME=]LEN",
      [&options, &hatches](const std::string& text) {
        const auto [name, value] = split_name(text);
        const double spacing = parse_length_mm(value);
        if (!(spacing > 0)) throw std::invalid_argument("is not above 0");
        options.hatches_given = true;
        name.empty() ? void(hatches.all.spacing_mm = spacing) : void(hatches.spacing_mm_of[layer_or_color(name)] = spacing);
      },
      "distance of the strokes, of all fills or of a layer or colour; repeatable");
  group.add_repeatable(
      "--hatch-angle", "[NAME=]DEG",
      [&options, &hatches](const std::string& text) {
        const auto [name, value] = split_name(text);
        const double degrees = parse_number(value);
        options.hatches_given = true;
        name.empty() ? void(hatches.all.angle_degrees = degrees) : void(hatches.degrees_of[layer_or_color(name)] = degrees);
      },
      "their direction, counter-clockwise; repeatable");
  group.add_flag_or_value(
      "--hatch-cross", "NAME",
      [&options, &hatches](const std::string& name) {
        options.hatches_given = true;
        name.empty() ? void(hatches.all.cross = true) : void(hatches.crossed.insert(layer_or_color(name)));
      },
      "a second family of strokes across the first, for all fills or a layer or colour");
}

}  // namespace

void setup_plot(CLI::App& app, PlotCommandOptions& options) {
  CLI::App& plot = *add_command(app, "plot", "A drawing (JSON or SVG) made ready for pens and plotters", kExamples);
  add_argument(plot, "DRAWING", options.drawing, "ligne-drawing JSON, or an SVG of strokes");
  OptionGroup input(plot, "Input");
  input.add("--skip", "LIST", options.skip, parse_skip, "what of an SVG may be left out: text, image, fill, clip-path, ...");
  input
      .add(
          "--fill", "HOW", options.fills,
          [](const std::string& text) { return static_cast<FillReading::How>(parse_choice(text, kFillReadingNames)); },
          "filled areas of an SVG: refuse; outline, their contours; hatch, strokes inside too")
      .standard("outline");
  input
      .add(
          "--min-length", "LEN", options.plotter.choice.request.min_length_mm,
          [](const std::string& t) { return parse_length_mm(t); },
          "leave out strokes that are shorter, after they are joined")
      .standard("0");
  input.add_flag("--occlude", options.occlude, "opaque areas of an SVG hide what lies under them, as white ones always do");
  add_fill_hatch_options(plot, options);
  add_placing_options(plot, options);
  add_output_options(plot, options.output, "svg pdf png hpgl gcode (default: by the suffix)");
  add_dpi_option(plot, options.dpi);
  add_plotter_options(plot, options.plotter);
  add_run_options(plot, options.run);
}

void run_plot(const PlotCommandOptions& options) {
  format_of(options.output);
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { plot(options, memory); });
}

}  // namespace ligne
