/// SVG. Cairo's own SVG surface knows no layers, repeats the style on every path and writes clip paths, so it is not used:
/// the polylines go into Cairo paths, as for every other format, and these are read back and written down here. Chunks of
/// polylines are worked on in parallel and put together in their order. With curves the lines go straight into paths, since
/// Cairo has no arcs.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/parallel.hpp"
#include "plotting/cairo_path.hpp"
#include "plotting/cairo_text.hpp"
#include "plotting/fill_rim.hpp"
#include "plotting/gray_image.hpp"
#include "plotting/number_text.hpp"
#include "plotting/paths/fit_curves.hpp"
#include "plotting/pens.hpp"
#include "plotting/utf8.hpp"
#include "plotting/writers.hpp"
#include "plotting/xml_text.hpp"

namespace ligne {
namespace {

/// Coordinates are written to a tenth of a micrometre.
constexpr int kDecimals = 4;
constexpr double kUnitsPerMm = 10000;

/// Attributes: lengths of pages, pens and dashes.
constexpr int kAttributeDecimals = 6;

/// Finest device unit for Cairo's fixed point: 1/256 of it is a nanometre.
constexpr double kFinestDevice = 4096;

/// Adjustable: points to a chunk; and where curves are found, which is a hundred times the work.
constexpr std::size_t kChunkPoints = 8192, kCurvedChunkPoints = 256;

/// Device units to a millimetre: a power of two that keeps the largest coordinate within Cairo's range.
double device_units(double largest_mm) {
  double units = kFinestDevice;
  while (largest_mm * units > kCairoLimit - 1) units /= 2;
  return units;
}

// ---- Text -----------------------------------------------------------------------------------------------------------

std::string number(double value) {
  std::string text;
  append_rounded(text, value, kAttributeDecimals);
  return text;
}

std::string short_color_code(const std::array<double, 3>& color) {
  const std::string code = color_code(color);
  const bool is_double = code[1] == code[2] && code[3] == code[4] && code[5] == code[6];
  return is_double ? std::string{code[0], code[1], code[3], code[5]} : code;
}

// ---- Paths ----------------------------------------------------------------------------------------------------------

/// A point in units of 10^-kDecimals mm.
struct UnitPoint {
  std::int64_t x, y;
  friend bool operator==(UnitPoint, UnitPoint) = default;
};

/// Writes paths, each in the shorter of the two ways: with absolute points, or relative ones. The relative moves are
/// differences of the rounded absolute points, so that no rounding adds up.
class PathWriter {
 public:
  void begin(Point2 mm) {
    points_.assign(1, units(mm));
    arcs_.assign(1, nullptr);
    start_ = mm;
    stays_ = moves_ = false;
  }
  void line_to(Point2 mm) {
    const UnitPoint p = units(mm);
    (mm == start_ ? stays_ : moves_) = true;
    if (p != points_.back()) add(p, nullptr);
  }
  /// `arc` must live until the end of the path.
  void arc_to(Point2 mm, const EllipticArc& arc) {
    moves_ = true;
    if (units(mm) != points_.back()) add(units(mm), &arc);
  }
  /// A line shorter than a unit is none, but one of no length at all is a dot.
  void end(bool closed) {
    if (closed && points_.size() > 1 && points_.front() == points_.back() && !arcs_.back()) points_.pop_back();
    if (points_.size() > 1) {
      const std::string_view absolute = write(absolute_, false), relative = write(relative_, true);
      out_ += "<path d=\"";
      out_ += absolute.size() <= relative.size() ? absolute : relative;
      out_ += closed ? "Z\"/>\n" : "\"/>\n";
    } else if (stays_ && !moves_) {
      out_ += "<path d=\"";
      out_ += write(absolute_, false);
      out_ += "h0\"/>\n";
    }
    points_.clear();
  }
  std::string take() { return std::move(out_); }

 private:
  static UnitPoint units(Point2 mm) { return {std::llround(mm.x * kUnitsPerMm), std::llround(mm.y * kUnitsPerMm)}; }

  void add(UnitPoint p, const EllipticArc* arc) {
    points_.push_back(p);
    arcs_.push_back(arc);
  }

  /// "rx ry rotation 0 sweep ": an arc of less than half a turn.
  static char* write_arc(char* p, const EllipticArc& arc) {
    const auto decimal = [&p](double value) {
      p = write_fixed(p, std::llround(value * static_cast<double>(power_of_ten(kArcDecimals))), kArcDecimals, true);
      *p++ = ' ';
    };
    decimal(arc.ellipse.radii.x);
    decimal(arc.ellipse.radii.y);
    decimal(arc.ellipse.rotation * 180 / std::numbers::pi);
    *p++ = '0';
    *p++ = ' ';
    *p++ = arc.sweep > 0 ? '1' : '0';
    *p++ = ' ';
    return p;
  }

  /// The path as text in `buffer`, which only grows: to clear it for every path would take longer than to write it.
  std::string_view write(std::vector<char>& buffer, bool relative) {
    const bool is_straight = std::all_of(arcs_.begin(), arcs_.end(), [](const EllipticArc* arc) { return !arc; });
    const std::size_t pairs = is_straight ? 1 : 3;  // of numbers: the point; radii, rotation and flags
    buffer.resize(std::max(buffer.size(), points_.size() * 2 * pairs * kNumberBytes));
    char* p = buffer.data();
    const auto pair = [&p](UnitPoint v) {
      p = write_fixed(p, v.x, kDecimals, true);
      *p++ = ' ';
      p = write_fixed(p, v.y, kDecimals, true);
    };
    *p++ = 'M';
    pair(points_[0]);
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const bool same = i > 1 && !arcs_[i] == !arcs_[i - 1];
      *p++ = same ? ' ' : arcs_[i] ? (relative ? 'a' : 'A') : (relative ? 'l' : 'L');
      if (arcs_[i]) p = write_arc(p, *arcs_[i]);
      const UnitPoint origin = relative ? points_[i - 1] : UnitPoint{0, 0};
      pair({points_[i].x - origin.x, points_[i].y - origin.y});
    }
    return {buffer.data(), static_cast<std::size_t>(p - buffer.data())};
  }

  std::vector<UnitPoint> points_;
  std::vector<const EllipticArc*> arcs_;  ///< that leads to the point of the same index; null: a straight line
  Point2 start_{0, 0};
  bool stays_ = false, moves_ = false;     ///< there are lines to the first point, to others
  std::vector<char> absolute_, relative_;  ///< scratch
  std::string out_;
};

struct Chunk {
  std::size_t first, last;
};

std::vector<Chunk> chunks_of(const Polylines& lines, std::size_t points) {
  std::vector<Chunk> chunks;
  for (std::size_t i = 0; i < lines.size();) {
    const std::size_t first = i;
    while (i < lines.size() && (i == first || lines.begin[i + 1] - lines.begin[first] <= points)) ++i;
    chunks.push_back({first, i});
  }
  return chunks;
}

std::string chunk_text(const Polylines& lines, Chunk chunk, double device) {
  // The surface is never drawn on: only the path is of interest.
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const CairoContext cairo(cairo_create(surface.get()));
  cairo_scale(cairo.get(), device, device);
  add_polylines(cairo.get(), lines, chunk.first, chunk.last);
  const CairoPath path(cairo_copy_path(cairo.get()));
  check_cairo(path->status);

  PathWriter writer;
  bool open = false;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    const cairo_path_data_t* const data = path->data + i;
    switch (data->header.type) {
      case CAIRO_PATH_MOVE_TO:
        if (open) writer.end(false);
        writer.begin({data[1].point.x, data[1].point.y});
        open = true;
        break;
      case CAIRO_PATH_LINE_TO:
        writer.line_to({data[1].point.x, data[1].point.y});
        break;
      case CAIRO_PATH_CLOSE_PATH:
        writer.end(true);
        open = false;
        break;
      case CAIRO_PATH_CURVE_TO:
        break;  // there is none
    }
  }
  if (open) writer.end(false);
  return writer.take();
}

/// The same with arcs, found for the points as they are written.
std::string curved_text(const Polylines& lines, Chunk chunk, const CurveLimits& limits) {
  PathWriter writer;
  std::vector<Point2> points;
  for (std::size_t i = chunk.first; i < chunk.last; ++i) {
    if (lines[i].size() < 2) continue;
    points.clear();
    for (const Point2 p : lines[i]) {
      points.push_back({std::round(p.x * kUnitsPerMm) / kUnitsPerMm, std::round(p.y * kUnitsPerMm) / kUnitsPerMm});
    }
    const CurvedPath path = fit_curves(points, limits);
    writer.begin(path.start);
    for (const PathPiece& piece : path.pieces) piece.arc ? writer.arc_to(piece.to, *piece.arc) : writer.line_to(piece.to);
    writer.end(path.closed);
  }
  return writer.take();
}

/// An id has no blanks and does not begin with a digit or a sign.
std::string id_of(std::string_view layer) {
  std::string id(layer);
  std::replace_if(
      id.begin(), id.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }, '-');
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  };
  return id.empty() || letter(id[0]) ? id : "pen-" + id;
}

std::string group_start(std::string_view layer) {
  return "<g inkscape:groupmode=\"layer\" inkscape:label=\"" + xml_text(layer) + "\" id=\"" + xml_text(id_of(layer)) + "\"";
}

/// Appends the contours of an area to the path at hand.
void add_fill(const Fill& fill, std::string& text) {
  char buffer[2 * kNumberBytes];
  for (const std::vector<Point2>& contour : fill.contours) {
    UnitPoint last{0, 0};
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const UnitPoint p{std::llround(contour[i].x * kUnitsPerMm), std::llround(contour[i].y * kUnitsPerMm)};
      if (i > 0 && p == last) continue;
      text += i == 0 ? "M" : "L";
      char* end = write_fixed(buffer, p.x, kDecimals, true);
      *end++ = ' ';
      end = write_fixed(end, p.y, kDecimals, true);
      text.append(buffer, end);
      last = p;
    }
    text += 'Z';
  }
}

/// One layer. Opaque areas of one colour that follow each other are one path: between two paths the paper would shine
/// through.
std::string fills_text(const std::vector<Fill>& fills) {
  if (fills.empty()) return {};
  std::string text = group_start("fill") + " fill-rule=\"evenodd\" stroke-width=\"" + number(kFillRimMm) +
                     "\" stroke-linejoin=\"round\">\n";
  for (std::size_t i = 0; i < fills.size();) {
    const Fill& first = fills[i];
    const std::string color = short_color_code(first.color);
    text += "<path fill=\"" + color + "\"";
    text += first.opacity < 1 ? " fill-opacity=\"" + number(first.opacity) + "\" d=\"" : " stroke=\"" + color + "\" d=\"";
    do {
      add_fill(fills[i++], text);
    } while (i < fills.size() && first.opacity >= 1 && !first.overlaps && fills[i].color == first.color &&
             fills[i].opacity == first.opacity);
    text += "\"/>\n";
  }
  return text + "</g>\n";
}

/// Gray pixels, in a layer of their own.
std::string gray_text(const GrayPicture& picture) {
  return group_start("shade") + ">\n<image x=\"" + number(picture.corner_mm.x) + "\" y=\"" + number(picture.corner_mm.y) +
         "\" width=\"" + number(picture.width * picture.pixel_mm) + "\" height=\"" +
         number(picture.height * picture.pixel_mm) + "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
         base64(gray_png(picture)) + "\"/>\n</g>\n";
}

std::string layer_start(const Layer& layer, const LineStyle& style) {
  const bool dashed = !style.dashes_mm.empty();
  std::string text = group_start(layer.name) + " fill=\"none\" stroke=\"" + short_color_code(style.color) +
                     "\" stroke-width=\"" + number(style.width_mm) + "\" stroke-linecap=\"" + (dashed ? "butt" : "round") +
                     "\" stroke-linejoin=\"round\"";
  for (std::size_t i = 0; i < style.dashes_mm.size(); ++i) {
    text += i == 0 ? " stroke-dasharray=\"" : " ";
    text += number(style.dashes_mm[i]);
  }
  return text + (dashed ? "\">\n" : ">\n");
}

/// Ids of groups of objects: what is no letter, digit or one of -_. is an underscore, and every id is there once.
class ObjectIds {
 public:
  explicit ObjectIds(const Drawing& drawing) {
    for (const char* own : {"fill", "shade", "text"}) used_.insert(own);
    for (const Layer& layer : drawing.layers) used_.insert(id_of(layer.name));
  }
  std::string id(const Layer& layer) {
    std::string plain = id_of(layer.name) + "-" + layer.object;
    for (char& c : plain) {
      const auto byte = static_cast<unsigned char>(c);
      const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!letter && c != '-' && c != '_' && c != '.' && byte < 0x80) c = '_';
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
  if (layer.color) text += " stroke=\"" + short_color_code(*layer.color) + "\"";
  if (layer.width_mm) text += " stroke-width=\"" + number(style.width_mm) + "\"";
  return text + ">\n";
}

/// Texts in a layer of their own, in a typeface.
std::string text_layer(std::span<const TextItem> items) {
  std::string text = group_start("text") + " fill=\"#000\" stroke=\"none\" font-family=\"'" + kTypeface +
                     "', Verdana, Arial, sans-serif\">\n";
  for (const TextItem& item : items) {
    const Point2 base = base_point(item);
    const std::string x = number(base.x), y = number(base.y);
    text += "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + number(item.height_mm / kCapitalsOfSize) + "\"";
    if (item.across == TextAcross::center) text += " text-anchor=\"middle\"";
    if (item.across == TextAcross::right) text += " text-anchor=\"end\"";
    if (item.rotation_degrees != 0)
      text += " transform=\"rotate(" + number(-item.rotation_degrees) + " " + x + " " + y + ")\"";
    text += ">" + xml_text(clean_utf8(item.text)) + "</text>\n";
  }
  return text + "</g>\n";
}

}  // namespace

std::string write_svg(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under) {
  const std::string width = number(options.page.width_mm), height = number(options.page.height_mm);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "version=\"1.1\" width=\"" +
      width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n";
  if (!options.title.empty()) svg += "<title>" + xml_text(options.title) + "</title>\n";

  const double device = device_units(largest_coordinate(drawing, options.page));
  if (under && !under->gray.empty()) svg += gray_text(*under);
  svg += fills_text(drawing.fills);
  ObjectIds ids(drawing);
  for (std::size_t l = 0; l < drawing.layers.size(); ++l) {
    const Layer& layer = drawing.layers[l];
    const auto is_part = [](const Layer& of) { return !of.object.empty() || of.color || of.width_mm; };
    const auto continues = [&](std::size_t a, std::size_t b) {
      if (b >= drawing.layers.size()) return false;
      const Layer &first = drawing.layers[a], &second = drawing.layers[b];
      return first.name == second.name && (is_part(first) || is_part(second));
    };
    const bool begins = l == 0 || !continues(l - 1, l), ends = !continues(l, l + 1);
    // The look of a part that is alone in its layer is that of the layer.
    const bool alone = layer.object.empty() && begins && ends;
    const std::optional<CurveLimits> curves = options.curves_of(layer);
    const std::vector<Chunk> chunks = chunks_of(layer.lines, curves ? kCurvedChunkPoints : kChunkPoints);
    std::vector<std::string> texts(chunks.size());
    parallel_for(chunks.size(), [&](std::size_t i) {
      texts[i] = curves ? curved_text(layer.lines, chunks[i], *curves) : chunk_text(layer.lines, chunks[i], device);
    });
    std::size_t size = svg.size();
    for (const std::string& text : texts) size += text.size();
    svg.reserve(size);
    if (begins) svg += layer_start(layer, alone ? options.style_of(layer) : options.style_of(layer.name));
    if (is_part(layer) && !alone) svg += part_start(layer, options.style_of(layer), ids);
    for (const std::string& text : texts) svg += text;
    if (is_part(layer) && !alone) svg += "</g>\n";
    if (ends) svg += "</g>\n";
  }
  if (!drawing.texts.empty()) svg += text_layer(drawing.texts);
  return svg + "</svg>\n";
}

}  // namespace ligne
