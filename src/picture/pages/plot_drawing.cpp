#include "picture/pages/plot_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "files/message_text.hpp"
#include "files/named_input.hpp"
#include "files/utf16.hpp"
#include "picture/errors.hpp"
#include "picture/pages/named_layers.hpp"
#include "picture/placement.hpp"
#include "plotting/plot.hpp"
#include "plotting/svg/outline.hpp"
#include "plotting/tiles.hpp"

namespace ligne {
namespace {

/// Largest file that is read, in bytes. A drawing from a larger file would have hundreds of millions of points.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 28;

constexpr double kPenWidthMm = 0.35;

constexpr std::string_view kPaintedWords = "material, shade, paper or random";

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

/// JSON begins with a brace and XML with an angle bracket; the file name does not matter.
ReadDrawing read_drawing(const PlotDrawingRequest& request, const DrawingText& drawing, const FillReading& fills) {
  const std::string_view content = without_mark(drawing.text);
  const char begins = first_character(content);
  const bool paints = request.paint.kind != FillKind::none;
  if (begins == '{') return read_json_drawing(content, drawing.name, paints);
  if (paints) throw RequestError("fill", "paints a ligne-drawing that has an order; " + drawing.name + " is not one");
  if (begins == '<') return read_svg_drawing(drawing.text, drawing.name, request.skip, fills, request.reading);
  if (content.starts_with("\x1f\x8b"))
    throw std::runtime_error(drawing.name + ": is compressed; gzip -dc FILE | ligne plot - reads it");
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff"))
    throw std::runtime_error(drawing.name + ": is UTF-16 text; save it as UTF-8");
  throw std::runtime_error(drawing.name + ": is neither a ligne-drawing nor an SVG");
}

void transform(Drawing& drawing, double scale, Point2 shift) {
  for (Layer& layer : drawing.layers) {
    for (Point2& p : layer.lines.points) p = p * scale + shift;
  }
  for (Fill& fill : drawing.fills) {
    for (std::vector<Point2>& contour : fill.contours) {
      for (Point2& p : contour) p = p * scale + shift;
    }
  }
}

/// The page of a size, turned as requested or as its contents fit better.
Page page_of_size(const PageSize& size, const PlotDrawingRequest& request, const Rect& contents) {
  PageRequest wanted{.size = size, .landscape = request.landscape, .portrait = request.portrait};
  return page_for(wanted, contents);
}

/// Puts the drawing on the requested page: centres its own page there, or scales its lines to fill it. Returns the
/// scale.
double place(const PlotDrawingRequest& request, ReadDrawing& read) {
  const Page own = read.page;
  Page page = own;
  const Rect ink = drawn_bounds(read.drawing);
  if (request.page) {
    page = page_of_size(*request.page, request, !request.scale && !ink.empty() ? ink : own.sheet());
  } else if ((request.landscape && own.height_mm > own.width_mm) || (request.portrait && own.width_mm > own.height_mm)) {
    std::swap(page.width_mm, page.height_mm);
  }
  if (!request.page && request.scale) {
    page.width_mm *= *request.scale;
    page.height_mm *= *request.scale;
  }
  page.margin_mm = request.margin_mm;
  double scale = request.scale.value_or(1);
  Rect from = own.sheet();
  if (!request.scale && !ink.empty() && (ink.width() > 0 || ink.height() > 0)) {
    const Rect area = page.drawable();
    if (!(area.width() > 0 && area.height() > 0))
      throw RequestError("margin", shortest(request.margin_mm) + " mm leaves no drawable area on the page");
    from = ink;
    const double across = ink.width() > 0 ? area.width() / ink.width() : area.height() / ink.height();
    const double down = ink.height() > 0 ? area.height() / ink.height() : across;
    scale = std::min(across, down);
  }
  transform(read.drawing, scale, page.sheet().max * 0.5 - (from.min + from.max) * (0.5 * scale));
  read.page = page;
  return scale;
}

/// Pages smaller than this get a warning: icons measured in pixels, whose details are no wider than a pen.
constexpr double kTinyPageMm = 10;

std::string times(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void warn_of_left_out(const PlotDrawingRequest& request, const std::string& name, const ReadDrawing& read, RunReport& run) {
  const auto warn = [&](std::string text) { run.warnings.push_back({name, std::move(text)}); };
  for (const auto& [kind, count] : read.left_out) warn(std::to_string(count) + " times " + kind + " left out by --skip");
  if (!read.omitted.empty()) {
    const std::string place =
        read.first_omitted_line > 0 ? "; the first in line " + std::to_string(read.first_omitted_line) : "";
    if (read.drawing.layers.empty())
      throw std::runtime_error(message_line(name + ": nothing is left to draw; " + read.omitted.text() + place));
    warn(read.omitted.text() + place);
  }
  if (read.size_assumed) warn("has no size: 1000 px (264.58 mm) assumed, or as far as its lines reach");
  if (!read.paper_of_view_box.empty()) {
    const std::string dpi = shortest(read.paper_dpi);
    warn("has no size; its viewBox is a paper size (" + read.paper_of_view_box + ") at " + dpi + " dpi, and is read at " +
         shortest(request.reading.px_per_inch) + ": --input-dpi " + dpi + " gives that paper");
  }
  const double side = std::max(read.page.width_mm, read.page.height_mm);
  if (!request.page && request.scale == 1.0 && side < kTinyPageMm) {
    warn("has a page of only " + shortest(std::round(side * 100) / 100) + " mm; --page A5 --scale fit enlarges it");
  }
  if (read.outlined > 0 && !request.fills) {
    warn(times(read.outlined, "filled area is", "filled areas are") +
         " drawn by the outline; --fill hatch fills, --skip fill leaves out, --fill outline is silent");
  }
  if (read.simplified_paints > 0) {
    warn(times(read.simplified_paints, "gradient or pattern is", "gradients and patterns are") + " drawn in one colour");
  }
  if (read.boxes > 0) warn(times(read.boxes, "character is", "characters are") + " not in the font: drawn as boxes");
  if (read.drawing.layers.empty()) warn("there is no stroke in the drawing");
}

/// Warns of pens and widths for layers without lines. check_pens() makes it an error if no drawing of the program can
/// have the layer. Files of pens may name all layers there are; names on the command line refer to this drawing.
void warn_of_absent_layers(const PlotDrawingRequest& request, const Drawing& drawing, RunReport& run) {
  for (const std::string& text :
       {absent_pen_layers(request.plotter.asked_pens, drawing), absent_width_layers(request.widths_mm, drawing)}) {
    if (!text.empty()) run.warn(text);
  }
}

/// Returns the drawing in its place. The distance of strokes that fill areas is the pen width on the finished drawing,
/// so the scale must be found first.
ReadDrawing placed_drawing(const PlotDrawingRequest& request, const DrawingText& drawing, double hatch_pen_mm,
                           RunReport& run) {
  const double pen_mm = request.pen_width_mm.value_or(kPenWidthMm);
  const FillReading::How how =
      request.fills.value_or(request.hatches_given ? FillReading::How::hatch : FillReading::How::outline);
  FillReading fills{how, pen_mm, request.occlude, request.own_layer, request.hatches};
  double scale = request.scale.value_or(1);
  if (!request.scale && how == FillReading::How::hatch) {
    FillReading plain = fills;
    plain.how = FillReading::How::outline;
    ReadDrawing contours = read_drawing(request, drawing, plain);
    scale = place(request, contours);
  }
  if (begins_json(drawing.text)) fills.pen_width_mm = hatch_pen_mm;
  fills.pen_width_mm /= scale;
  if (fills.hatches.all.spacing_mm) *fills.hatches.all.spacing_mm /= scale;
  for (auto& [name, spacing] : fills.hatches.spacing_mm_of) spacing /= scale;
  ReadDrawing read = read_drawing(request, drawing, fills);
  if (how == FillReading::How::hatch && begins_json(drawing.text)) {
    try {
      hatch_regions(read, fills);
    } catch (const std::exception& e) {
      throw std::runtime_error(drawing.name + ": " + e.what());
    }
  }
  if (read.order) paint_stored(read, request.paint, run);
  warn_of_left_out(request, drawing.name, read, run);
  place(request, read);
  if (request.pen_width_mm) {
    for (Layer& layer : read.drawing.layers) layer.width_mm.reset();
  }
  return read;
}

/// Width of the pen that hatches the regions of a stored drawing, in mm.
double hatch_pen_mm(const PlotDrawingRequest& request, const PenTable& pens) {
  const double usual = layer_style("hatch", request.pen_width_mm.value_or(kPenWidthMm), false).width_mm;
  return pens.empty() ? usual : pens.pen(pens.pen_of("hatch", "")).width_mm.value_or(usual);
}

/// The style of a layer. In an SVG without layers, layers are named by their colours.
LineStyle style_of_layer(const std::string& layer, double pen_width_mm, bool hidden_solid) {
  LineStyle style = layer_style(layer, pen_width_mm, hidden_solid);
  if (!layer.starts_with('#')) return style;
  try {
    style.color = parse_color(layer);
  } catch (const std::invalid_argument&) {
    // a layer whose name only looks like a colour is black
  }
  return style;
}

/// A drawing on its page.
struct Sheet {
  const Drawing& drawing;
  const Page& page;
  bool dashes_cut;  ///< dashes have been cut into strokes
};

/// Writes one sheet.
Picture write_sheet(const Sheet& sheet, const PlotDrawingRequest& request, const PlotterRequest& plotter, PdfDocument* pages,
                    RunReport& run) {
  const auto& [drawing, page, dashes_cut] = sheet;
  if (request.format == OutputFormat::png) check_png(page, request.dpi, request.memory);
  PlotOptions style{.page = page,
                    .pen_width_mm = request.pen_width_mm.value_or(kPenWidthMm),
                    .widths_mm = request.widths_mm,
                    .hidden_solid = dashes_cut,
                    .dpi = request.dpi,
                    .curves = request.curves,
                    .starts_stay = plotter.by_pens()};
  // Distance by which curves may exceed the chords from reading and simplifying. Polygons of the file have larger
  // angles.
  if (request.paint.kind == FillKind::none) style.curve_rise_mm = svg::kFlatnessMm + plotter.tolerances.simplify_mm;
  style.style = [&](const std::string& layer) { return style_of_layer(layer, style.pen_width_mm, style.hidden_solid); };
  return timed(run.stages, "write", [&] {
    return write_picture(sheet.drawing, style, plotter, {request.format, nullptr, pages}, run);
  });
}

/// Keeps layers of one name together, and merges layers of equal style.
void add_drawing(Drawing& sheet, Drawing drawing, Point2 shift) {
  for (Layer& layer : drawing.layers) {
    for (Point2& p : layer.lines.points) p += shift;
    const auto same_name = [&](const Layer& other) { return other.name == layer.name; };
    const auto alike = std::ranges::find_if(sheet.layers, [&](const Layer& other) {
      return same_name(other) && other.material == layer.material && other.shade == layer.shade &&
             other.object == layer.object && other.color == layer.color && other.width_mm == layer.width_mm;
    });
    if (alike != sheet.layers.end()) {
      append(alike->lines, layer.lines);
      continue;
    }
    const auto last = std::find_if(sheet.layers.rbegin(), sheet.layers.rend(), same_name);
    sheet.layers.insert(last == sheet.layers.rend() ? sheet.layers.end() : last.base(), std::move(layer));
  }
  for (Fill& fill : drawing.fills) {
    for (std::vector<Point2>& contour : fill.contours) {
      for (Point2& p : contour) p += shift;
    }
    sheet.fills.push_back(std::move(fill));
  }
}

/// Places each drawing in the middle of its cell. Drawings at true scale are all reduced by one factor if any is too
/// large.
ReadDrawing drawings_in_grid(std::span<const DrawingText> drawings, const PlotDrawingRequest& request, double pen_mm,
                             RunReport& run) {
  const auto [columns, rows] = *request.grid;
  if (drawings.size() > std::size_t{columns} * rows)
    throw RequestError(
        "grid", "has " + std::to_string(columns * rows) + " cells for " + std::to_string(drawings.size()) + " drawings");
  std::vector<Page> pages;
  for (const DrawingText& drawing : drawings) {
    if (begins_json(drawing.text) != begins_json(drawings.front().text))
      throw RequestError("grid", "an SVG and a ligne-drawing can not share one sheet");
    pages.push_back(read_drawing(request, drawing, {FillReading::How::outline}).page);
  }
  ReadDrawing sheet;
  sheet.page = pages.front();
  if (request.page) {
    const Point2 mosaic{columns * pages.front().width_mm, rows * pages.front().height_mm};
    sheet.page = page_of_size(*request.page, request, {{0, 0}, mosaic});
  }
  sheet.page.margin_mm = request.margin_mm;
  const Rect area = sheet.page.drawable();
  const Point2 cell{(area.width() - (columns - 1) * request.margin_mm) / columns,
                    (area.height() - (rows - 1) * request.margin_mm) / rows};
  if (!(cell.x > 0 && cell.y > 0))
    throw RequestError("margin", shortest(request.margin_mm) + " mm leaves no drawable area in the cells");
  PlotDrawingRequest in_cell = request;
  in_cell.margin_mm = 0;
  in_cell.landscape = in_cell.portrait = false;
  in_cell.page = PageSize{{}, true};
  in_cell.page->page.width_mm = cell.x;
  in_cell.page->page.height_mm = cell.y;
  if (request.scale) {
    for (const Page& own : pages) in_cell.scale = std::min({*in_cell.scale, cell.x / own.width_mm, cell.y / own.height_mm});
  }
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    ReadDrawing read = placed_drawing(in_cell, drawings[i], pen_mm, run);
    sheet.dashes_cut = read.dashes_cut;
    const std::size_t row = i / columns, column = i % columns;
    const Point2 place{static_cast<double>(column) * (cell.x + request.margin_mm),
                       static_cast<double>(row) * (cell.y + request.margin_mm)};
    add_drawing(sheet.drawing, std::move(read.drawing), area.min + place);
  }
  return sheet;
}

/// Writes the sheets of a large page, as files or as pages.
Picture write_tiles(const ReadDrawing& read, const PlotDrawingRequest& request, const PlotterRequest& plotter,
                    bool tile_files, RunReport& run) {
  Page paper = page_of_size(*request.tile, request, read.page.sheet());
  paper.margin_mm = request.margin_mm;
  const double smaller = std::min(paper.drawable().width(), paper.drawable().height());
  if (!(smaller > request.overlap_mm))
    throw RequestError("overlap", shortest(request.overlap_mm) + " mm and the margins leave no drawable area on the paper");
  std::optional<PdfDocument> pages;
  if (request.format == OutputFormat::pdf && !tile_files) pages.emplace();
  Picture all;
  for (const Tile& tile : cut_into_tiles(read.drawing, read.page, paper, request.overlap_mm)) {
    Picture sheet = write_sheet({tile.drawing, paper, read.dashes_cut}, request, plotter, pages ? &*pages : nullptr, run);
    all.plotter_report += sheet.plotter_report;
    if (!pages) all.parts.push_back({std::move(sheet.bytes), static_cast<unsigned>(tile.number), 0});
  }
  if (pages) all.bytes = pages->finish();
  return all;
}

}  // namespace

DrawingText read_drawing_text(const std::string& file, InputFiles& opened) {
  const std::vector<std::byte> bytes = as_utf8(read_named_input(file, opened, kMostBytes));
  return {shown_input(file), std::string(as_characters(bytes))};
}

bool is_svg(const DrawingText& drawing) { return !begins_json(drawing.text); }

void check(const PlotDrawingRequest& request) {
  if (request.format == OutputFormat::json) throw RequestError("format", "plot writes svg, pdf, png, hpgl or gcode");
  if (request.paint.kind != FillKind::none) {
    if (request.plotter.by_pens() && request.format != OutputFormat::png)
      throw RequestError("fill", "pens draw no filled faces; see --hatch");
    if (request.tile) throw RequestError("tile", "can not be combined with --fill " + std::string(kPaintedWords));
  } else if (!request.paint.colors.empty()) {
    throw RequestError("material", "needs --fill material or shade");
  }
  if (!request.tile) return;
  const PlotterRequest& plotter = request.plotter;
  if (plotter.parts.is_requested())
    throw RequestError("tile", "can not be combined with --split, --every, --from-stroke, --from-time or %p");
  if (plotter.preview) throw RequestError("preview", "works for a single sheet only");
}

Picture plot_drawings(std::span<const DrawingText> drawings, const PlotDrawingRequest& request, bool tile_files,
                      RunReport& run) {
  check(request);
  if (drawings.size() > 1 && !request.grid)
    throw RequestError("", "several drawings need --grid CxR, such as 2x2, to share one sheet");
  PlotterRequest plotter = request.plotter;
  plotter.fit_drawing = !request.scale;
  // A drawing painted from an order has the joined lines of the visibility method.
  if (!plotter.by_pens() && !plotter.optimize && request.paint.kind == FillKind::none) plotter.optimize = Optimize::join;
  const double pen_mm = hatch_pen_mm(request, plotter.pens);
  const ReadDrawing read = timed(run.stages, {"read", printable(drawings.front().name, kLongestPath)}, [&] {
    return request.grid ? drawings_in_grid(drawings, request, pen_mm, run)
                        : placed_drawing(request, drawings.front(), pen_mm, run);
  });
  check_pens(plotter.asked_pens, read.drawing);
  warn_of_absent_layers(request, read.drawing, run);
  plotter.asked_pens = {};  // not every sheet has all layers
  if (request.tile) return write_tiles(read, request, plotter, tile_files, run);
  return write_sheet({read.drawing, read.page, read.dashes_cut}, request, plotter, nullptr, run);
}

}  // namespace ligne
