#include "plotting/writers/svg_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <cairo-svg.h>

#include "plotting/writers/cairo_path.hpp"
#include "plotting/writers/cairo_svg_parts.hpp"
#include "plotting/writers/number_text.hpp"

namespace ligne {
namespace {

/// Unit in which Cairo draws, mm. Cairo writes six decimals, and the last is the last of kSvgDecimals. So each number
/// is as short as can be; numbers take most of Cairo's time.
constexpr double kCairoUnitMm = 100;

/// Decimals of lengths in attributes.
constexpr int kAttributeDecimals = 6;

/// A point in units of 10^-kSvgDecimals mm.
struct UnitPoint {
  std::int64_t x, y;
  friend bool operator==(UnitPoint, UnitPoint) = default;
};

UnitPoint in_units(Point2 mm) {
  // As std::llround, without its call.
  const auto nearest = [](double value) { return static_cast<std::int64_t>(value < 0 ? value - 0.5 : value + 0.5); };
  return {nearest(mm.x * kSvgUnitsPerMm), nearest(mm.y * kSvgUnitsPerMm)};
}

/// Largest deviation, in units of 10^-kSvgDecimals mm, of a curve's first handle from the continuation of the handle
/// before. Up to it the handle is left out ("S"): each of the three points involved was rounded.
constexpr std::int64_t kSmoothUnits = 2;

/// Writes the lines of a path, each in the shorter of the two ways: with absolute points, or relative ones. The relative
/// moves are differences of the rounded absolute points, so that no rounding adds up.
class PathWriter {
 public:
  /// `before` and `behind` are written around each line.
  PathWriter(const SvgCanvas& canvas, std::string_view before, std::string_view behind, std::string& out)
      : canvas_(canvas), before_(before), behind_(behind), out_(out) {}

  /// Takes the next command of Cairo.
  void take(char command, const Point2* device) {
    if (command == 'M' || command == 'Z') end(command == 'Z');
    if (command == 'Z') return;
    const UnitPoint p = in_units(canvas_.to_mm(*device));
    if (command == 'M') {
      points_.assign(1, p);
    } else if (command == 'L') {
      is_line_ = true;
      if (p != points_.back()) add('L', p);
    } else {
      const UnitPoint b = in_units(canvas_.to_mm(device[1])), c = in_units(canvas_.to_mm(device[2]));
      goes_on(p) ? add('S', b, c) : add('C', p, b, c);
    }
  }

  /// Writes the line that ends here. A line of no length is a dot.
  void end(bool closed = false) {
    if (closed && pieces_.size() > 1 && points_.front() == points_.back() && pieces_.back() == 'L') {
      points_.pop_back();
      pieces_.pop_back();
    }
    if (!pieces_.empty() || is_line_) {
      out_ += before_;
      const std::string_view relative = write(relative_, true, std::numeric_limits<std::ptrdiff_t>::max());
      const std::string_view absolute = write(absolute_, false, std::ssize(relative));
      out_ += absolute.size() <= relative.size() ? absolute : relative;
      out_ += pieces_.empty() ? "h0" : closed ? "Z" : "";
      out_ += behind_;
    }
    pieces_.clear();
    is_line_ = false;
  }

 private:
  template <typename... Points>
  void add(char piece, Points... points) {
    (points_.push_back(points), ...);
    pieces_.push_back(piece);
  }

  bool goes_on(UnitPoint handle) const {
    if (pieces_.empty() || pieces_.back() == 'L') return false;
    const UnitPoint before = points_[points_.size() - 2], at = points_.back();
    return std::abs(handle.x - 2 * at.x + before.x) <= kSmoothUnits &&
           std::abs(handle.y - 2 * at.y + before.y) <= kSmoothUnits;
  }

  /// The line as text in `buffer`, or a beginning of it that is longer than `limit`. The buffer only grows, since
  /// clearing it for every line would take longer than writing.
  std::string_view write(std::vector<char>& buffer, bool relative, std::ptrdiff_t limit) {
    buffer.resize(std::max(buffer.size(), points_.size() * 2 * kNumberBytes));
    char* p = buffer.data();
    const auto number = [&p](std::int64_t value, bool blank) {
      if (blank) *p++ = ' ';
      p = write_fixed(p, value, kSvgDecimals, true);
    };
    *p++ = 'M';
    number(points_[0].x, false);
    number(points_[0].y, true);
    const UnitPoint* next = points_.data() + 1;
    for (std::size_t i = 0; i < pieces_.size() && p - buffer.data() <= limit; ++i) {
      const char piece = pieces_[i];
      const UnitPoint origin = relative ? next[-1] : UnitPoint{0, 0};
      bool first = i == 0 || piece != pieces_[i - 1];
      if (first) *p++ = static_cast<char>(relative ? piece - 'A' + 'a' : piece);
      for (int k = piece == 'L' ? 1 : piece == 'S' ? 2 : 3; k > 0; --k, ++next, first = false) {
        const UnitPoint v{next->x - origin.x, next->y - origin.y};
        // Curves have many numbers, so a minus sign replaces the blank.
        number(v.x, !first && (piece == 'L' || v.x >= 0));
        number(v.y, piece == 'L' || v.y >= 0);
      }
    }
    return {buffer.data(), static_cast<std::size_t>(p - buffer.data())};
  }

  const SvgCanvas& canvas_;
  std::string_view before_, behind_;
  std::string& out_;
  std::vector<UnitPoint> points_;
  std::vector<char> pieces_;               ///< L, C or S, as in SVG: with one point, three or two
  bool is_line_ = false;                   ///< there is an L, though perhaps of no length
  std::vector<char> absolute_, relative_;  ///< scratch
};

/// Tolerance of a surface, in widths of the pen. Cairo finds the outline of every stroke, only to know whether it meets the
/// surface, and a coarse tolerance makes that cheap. From twice the width of the pen on there is no outline: Cairo 1.16
/// writes the stroke all the same, and takes a quarter less time; 1.18 leaves it out.
double tolerance_pens() { return cairo_version() < CAIRO_VERSION_ENCODE(1, 17, 0) ? 4 : 1; }

}  // namespace

std::string svg_number(double value) { return decimal_text(value, kAttributeDecimals); }

std::string short_color(const std::string& code) {
  const bool is_double = code[1] == code[2] && code[3] == code[4] && code[5] == code[6];
  return is_double ? std::string{code[0], code[1], code[3], code[5]} : code;
}

SvgCanvas::SvgCanvas(double largest_mm) : reach_mm_(std::ceil(largest_mm)) {
  while (size() > kCairoLimit / 2) device_per_mm_ /= 10;
}

std::string SvgCanvas::document(FunctionRef<void(cairo_t*, double)> draw, double pen_mm) const {
  std::string svg;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append_to_string, &svg, size(), size()));
  check_cairo(cairo_surface_status(surface.get()));
  const CairoContext cairo(cairo_create(surface.get()));
  cairo_translate(cairo.get(), size() / 2, size() / 2);
  cairo_scale(cairo.get(), device_per_mm_ * kCairoUnitMm, device_per_mm_ * kCairoUnitMm);
  cairo_set_tolerance(cairo.get(), tolerance_pens() * pen_mm * device_per_mm_);
  draw(cairo.get(), 1 / kCairoUnitMm);
  check_cairo(cairo_status(cairo.get()));
  cairo_surface_finish(surface.get());
  check_cairo(cairo_surface_status(surface.get()));
  return svg;
}

std::string SvgCanvas::paths(FunctionRef<void(cairo_t*, double)> draw, double pen_mm) const {
  std::string svg = document(draw, pen_mm), text;
  for (const CairoSvgPart& part : cairo_svg_parts(svg, size())) {
    if (part.fill) {
      text += "<path fill=\"" + short_color(*part.fill) + "\"";
      if (part.fill_opacity < 1) text += " fill-opacity=\"" + svg_number(part.fill_opacity) + "\"";
      if (part.stroke) text += " stroke=\"" + short_color(*part.stroke) + "\"";
      text += " d=\"";
    }
    PathWriter writer(*this, part.fill ? "" : "<path d=\"", part.fill ? "" : "\"/>\n", text);
    for_each_command(part, [&](char command, const Point2* points) { writer.take(command, points); });
    writer.end();
    if (part.fill) text += "\"/>\n";
  }
  return text;
}

std::string SvgCanvas::image(const FacePicture& picture) const {
  std::string svg = document([&](cairo_t* cairo, double units_per_mm) { paint_faces(cairo, picture, units_per_mm); }, 1);
  const std::vector<CairoSvgPart> parts = cairo_svg_parts(svg, size());
  if (parts.size() != 1) throw std::runtime_error("cairo: an SVG with other than one image");
  const Point2 corner = to_mm(parts[0].to_document({0, 0})), end = to_mm(parts[0].to_document(parts[0].pixels));
  return "<image x=\"" + svg_number(corner.x) + "\" y=\"" + svg_number(corner.y) + "\" width=\"" +
         svg_number(end.x - corner.x) + "\" height=\"" + svg_number(end.y - corner.y) +
         "\" preserveAspectRatio=\"none\" href=\"" + std::string(parts[0].image) + "\"/>\n";
}

}  // namespace ligne
