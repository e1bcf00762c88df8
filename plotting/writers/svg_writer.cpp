/// SVG. Cairo's SVG surface draws the lines, areas and gray pixels. It knows no layers, repeats the style on every
/// path, and makes one path of everything that is stroked at once, so each layer, or a chunk of a large one, is a
/// document of its own. These are taken apart (svg_canvas.hpp) and put together as layers with one path for each
/// polyline. Chunks are worked on in parallel and put together in their order.

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "base/parallel.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/page.hpp"
#include "plotting/readers/utf8.hpp"
#include "plotting/writers/cairo_path.hpp"
#include "plotting/writers/svg_canvas.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

/// Points per chunk, and points that a call for an area counts as: Cairo takes time with the square of the number of
/// calls on a surface. Adjustable.
constexpr std::size_t kChunkPoints = 2048, kCallPoints = 16;

/// Items [first, last) of a layer.
struct Chunk {
  std::size_t layer, first, last;
};

/// Divides [0, count) into chunks. `skip` moves an index past the items that must stay together, and returns their number of
/// points.
template <typename Skip>
void add_chunks(std::vector<Chunk>& chunks, std::size_t layer, std::size_t count, Skip skip) {
  for (std::size_t i = 0; i < count;) {
    const std::size_t first = i;
    for (std::size_t points = 0; i < count && points < kChunkPoints;) points += skip(i);
    chunks.push_back({layer, first, i});
  }
}

/// The texts of chunks, computed in parallel.
template <typename TextOf>
std::vector<std::string> texts_of(const std::vector<Chunk>& chunks, TextOf text_of) {
  std::vector<std::string> texts(chunks.size());
  parallel_tasks(chunks.size(), [&](std::size_t i) { texts[i] = text_of(chunks[i]); });
  return texts;
}

void append_texts(std::string& svg, std::span<const std::string> texts) {
  std::size_t size = svg.size();
  for (const std::string& text : texts) size += text.size();
  svg.reserve(size);
  for (const std::string& text : texts) svg += text;
}

/// A line shorter than a unit is left out, but one of no length at all is a dot.
std::string lines_text(const Polylines& lines, std::size_t first, std::size_t last, const LineStyle& style,
                       const std::optional<CurveLimits>& curves, const SvgCanvas& canvas) {
  const auto is_point = [](std::span<const Point2> line) {
    return std::ranges::all_of(line, [&](Point2 p) { return p == line[0]; });
  };
  const auto rounded = [](double mm) { return std::round(mm * kSvgUnitsPerMm) / kSvgUnitsPerMm; };
  Polylines chunk;
  std::vector<Point2> points;
  for (std::size_t i = first; i < last; ++i) {
    points.clear();
    for (const Point2 p : lines[i]) points.push_back({rounded(p.x), rounded(p.y)});
    if (points.size() > 1 && (!is_point(points) || is_point(lines[i]))) chunk.add(points);
  }
  // The group gives its dashes; on the surface they would only take the time to compute the outlines of all of them.
  LineStyle solid = style;
  solid.dashes_mm.clear();
  return canvas.paths(
      [&](cairo_t* cairo, double units_per_mm) {
        stroke_polylines(cairo, chunk, solid, {units_per_mm, 0, curves});
      },
      style.width_mm);
}

void add_line_chunks(std::vector<Chunk>& chunks, std::size_t layer, const Polylines& lines) {
  add_chunks(chunks, layer, lines.size(), [&](std::size_t& i) { return lines[i++].size(); });
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80; }

/// An id has no blanks and does not begin with a digit or a sign.
std::string id_of(std::string_view layer) {
  std::string id(layer);
  std::replace_if(
      id.begin(), id.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }, '-');
  return id.empty() || is_letter(id[0]) ? id : "pen-" + id;
}

std::string group_start(std::string_view layer) {
  return "<g inkscape:groupmode=\"layer\" inkscape:label=\"" + xml_text(layer) + "\" id=\"" + xml_text(id_of(layer)) + "\"";
}

/// All areas, in a layer of their own.
void append_fills(std::string& svg, const std::vector<Fill>& fills, const SvgCanvas& canvas) {
  if (fills.empty()) return;
  svg += group_start("fill") + " fill-rule=\"evenodd\" stroke-width=\"" + svg_number(kFillRimMm) +
         "\" stroke-linejoin=\"round\">\n";
  const auto skip_area = [&](std::size_t& i) {
    std::size_t points = kCallPoints;
    for (const std::size_t last = end_of_area(fills, i); i < last; ++i) {
      for (const auto& contour : fills[i].contours) points += contour.size();
    }
    return points;
  };
  std::vector<Chunk> chunks;
  add_chunks(chunks, 0, fills.size(), skip_area);
  append_texts(svg, texts_of(chunks, [&](const Chunk& chunk) {
                 const auto at = [&](std::size_t i) { return fills.begin() + static_cast<std::ptrdiff_t>(i); };
                 const std::vector<Fill> part{at(chunk.first), at(chunk.last)};
                 return canvas.paths([&](cairo_t* cairo, double units_per_mm) { paint_fills(cairo, part, units_per_mm); },
                                     kFillRimMm);
               }));
  svg += "</g>\n";
}

std::string layer_start(const Layer& layer, const LineStyle& style) {
  const bool dashed = !style.dashes_mm.empty();
  std::string text = group_start(layer.name) + " fill=\"none\" stroke=\"" + short_color(color_code(style.color)) +
                     "\" stroke-width=\"" + svg_number(style.width_mm) + "\" stroke-linecap=\"" +
                     (dashed ? "butt" : "round") + "\" stroke-linejoin=\"round\"";
  for (std::size_t i = 0; i < style.dashes_mm.size(); ++i) {
    text += i == 0 ? " stroke-dasharray=\"" : " ";
    text += svg_number(style.dashes_mm[i]);
  }
  return text + (dashed ? "\">\n" : ">\n");
}

/// Makes ids for groups of objects: unique, with underscores for characters other than letters, digits and -_.
class ObjectIds {
 public:
  explicit ObjectIds(const Drawing& drawing) {
    for (const char* own : {"fill", "shade", "text"}) used_.insert(own);
    for (const Layer& layer : drawing.layers) used_.insert(id_of(layer.name));
  }
  std::string id(const Layer& layer) {
    std::string plain = id_of(layer.name) + "-" + layer.object;
    for (char& c : plain) {
      if (!is_letter(c) && !(c >= '0' && c <= '9') && c != '-' && c != '.') c = '_';
    }
    std::string id = plain;
    for (std::size_t n = 2; !used_.insert(id).second; ++n) id = plain + "-" + std::to_string(n);
    return id;
  }

 private:
  std::set<std::string> used_;
};

/// The lines of one object, colour or width inside a layer.
std::string part_start(const Layer& layer, const LineStyle& style, ObjectIds& ids) {
  std::string text = "<g";
  if (!layer.object.empty()) {
    text += " inkscape:label=\"" + xml_text(layer.object) + "\" id=\"" + xml_text(ids.id(layer)) + "\"";
  }
  if (layer.color) text += " stroke=\"" + short_color(color_code(*layer.color)) + "\"";
  if (layer.width_mm) text += " stroke-width=\"" + svg_number(style.width_mm) + "\"";
  return text + ">\n";
}

/// Texts in a layer of their own, in a typeface.
std::string text_layer(std::span<const TextItem> items) {
  std::string text = group_start("text") + " fill=\"#000\" stroke=\"none\" font-family=\"'" + kTypeface +
                     "', Verdana, Arial, sans-serif\">\n";
  for (const TextItem& item : items) {
    const Point2 base = base_point(item);
    const std::string x = svg_number(base.x), y = svg_number(base.y);
    text += "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + svg_number(item.height_mm / kCapitalsOfSize) + "\"";
    if (item.across == TextAcross::center) text += " text-anchor=\"middle\"";
    if (item.across == TextAcross::right) text += " text-anchor=\"end\"";
    if (item.rotation_degrees != 0)
      text += " transform=\"rotate(" + svg_number(-item.rotation_degrees) + " " + x + " " + y + ")\"";
    if (item.halo_mm > 0)  // one element that paints its rim below its letters, so that a pen plots it once
      text += " stroke=\"#fff\" stroke-width=\"" + svg_number(2 * item.halo_mm) +
              "\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    text += ">" + xml_text(clean_utf8(item.text)) + "</text>\n";
  }
  return text + "</g>\n";
}

}  // namespace

std::string svg_paths(const Polylines& lines) {
  const SvgCanvas canvas(std::max(1.0, largest_coordinate(lines.points)));
  std::vector<Chunk> chunks;
  add_line_chunks(chunks, 0, lines);
  std::string paths;
  append_texts(paths, texts_of(chunks, [&](const Chunk& chunk) {
                 return lines_text(lines, chunk.first, chunk.last, {}, {}, canvas);
               }));
  return paths;
}

std::string write_svg(const Drawing& drawing, const PlotOptions& options, const FacePicture* under) {
  const std::string width = svg_number(options.page.width_mm), height = svg_number(options.page.height_mm);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "version=\"1.1\" width=\"" +
      width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n";
  if (!options.title.empty()) svg += "<title>" + xml_text(options.title) + "</title>\n";

  const SvgCanvas canvas(largest_coordinate(drawing, options.page));
  if (under && !under->empty()) svg += group_start("shade") + ">\n" + canvas.image(*under) + "</g>\n";
  append_fills(svg, drawing.fills, canvas);
  // The chunks of all layers at once, since most layers have few.
  std::vector<Chunk> chunks;
  for (std::size_t l = 0; l < drawing.layers.size(); ++l) add_line_chunks(chunks, l, drawing.layers[l].lines);
  const std::vector<std::string> texts = texts_of(chunks, [&](const Chunk& chunk) {
    const Layer& layer = drawing.layers[chunk.layer];
    return lines_text(layer.lines, chunk.first, chunk.last, options.style_of(layer), options.curves_of(layer), canvas);
  });
  ObjectIds ids(drawing);
  for (std::size_t l = 0, chunk = 0; l < drawing.layers.size(); ++l) {
    const Layer& layer = drawing.layers[l];
    const auto is_part = [](const Layer& of) { return !of.object.empty() || of.color || of.width_mm; };
    const auto continues = [&](std::size_t a, std::size_t b) {
      if (b >= drawing.layers.size()) return false;
      const Layer &first = drawing.layers[a], &second = drawing.layers[b];
      return first.name == second.name && (is_part(first) || is_part(second));
    };
    const bool begins = l == 0 || !continues(l - 1, l), ends = !continues(l, l + 1);
    // A part that is alone in its layer gives the layer its look.
    const bool alone = layer.object.empty() && begins && ends;
    const LineStyle style = options.style_of(layer);
    if (begins) svg += layer_start(layer, alone ? style : options.style_of(layer.name));
    if (is_part(layer) && !alone) svg += part_start(layer, style, ids);
    const std::size_t first_chunk = chunk;
    while (chunk < chunks.size() && chunks[chunk].layer == l) ++chunk;
    append_texts(svg, std::span(texts).subspan(first_chunk, chunk - first_chunk));
    if (is_part(layer) && !alone) svg += "</g>\n";
    if (ends) svg += "</g>\n";
  }
  if (!drawing.texts.empty()) svg += text_layer(drawing.texts);
  return svg + "</svg>\n";
}

}  // namespace ligne
