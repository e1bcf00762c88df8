#include "cli/page_options.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/parse.hpp"
#include "drawing/drawing.hpp"
#include "files/message_text.hpp"

namespace ligne {
namespace {

constexpr double kWidestPenMm = 50;

}  // namespace

double parse_pen_width(const std::string& text) {
  const double width = parse_length_mm(text);
  if (!(width > 0 && width <= kWidestPenMm)) {
    throw std::invalid_argument(printable(text) + " is not above 0 and at most " + shortest(kWidestPenMm) + " mm");
  }
  return width;
}

LineWidths parse_widths(const std::string& text) {
  LineWidths widths;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos || equals == 0) throw std::invalid_argument(shown(part, '"') + " is not CLASS=LEN");
    widths[part.substr(0, equals)] = parse_pen_width(part.substr(equals + 1));
    begin = end + 1;
  }
  return widths;
}

void require_layers(const LineWidths& widths) {
  std::vector<std::string_view> names{"hatch", "underside", "contour-base", "text", "debug"};
  for (std::size_t l = kStrokeLayerCount; l > 0; --l) names.insert(names.end() - 5, stroke_layer_name(l - 1));
  for (const auto& [name, width] : widths) parse_choice(name, names);
}

PageSize parse_page_size(const std::string& text) {
  PageSize size;
  size.page = parse_page(text);
  const unsigned char first = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  size.explicit_size = !std::isalpha(first);
  return size;
}

void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers) {
  OptionGroup(app, "Page")
      .add_repeatable(
          "--width", "CLASS=LEN,...",
          [&widths, own_layers](const std::string& text) {
            for (const auto& [layer, width] : parse_widths(text)) widths[layer] = width;
            if (own_layers) require_layers(widths);
          },
          "widths of lines by class, such as profile=0.7,crease=0.25; repeatable")
      .standard("of the pen width: profile 1.4, outline and border 1, crease and intersection 0.7, others 0.5");
}

void add_page_options(CLI::App& app, PageRequest& request) {
  OptionGroup group(app, "Page");
  group
      .add("--page", "SIZE", request.size, parse_page_size,
           "A0 to A6, letter, legal, tabloid, or WxH with units, such as 20cmx15cm")
      .standard("A4");
  const Option landscape =
      group.add_flag("--landscape", request.landscape, "page lies on its long side (default: as it fits)");
  const Option portrait = group.add_flag("--portrait", request.portrait, "page stands on its short side");
  group
      .add(
          "--margin", "LEN", request.margin_mm, [](const std::string& t) { return parse_length_mm(t); },
          "empty rim of the page: mm, cm, in or pt, bare is mm")
      .standard("10mm");
  group.add("--pen-width", "LEN", request.pen_width_mm, parse_pen_width, "width of outlines").standard("0.35mm");
  add_width_option(app, request.widths_mm, true);
  group.add("--scale", "fit|N:M", request.scale, parse_scale, "fill the page, or a true scale").standard("fit");
  group
      .add("--unit", "UNIT", request.unit_mm, parse_unit_mm,
           "length of a model unit for a true scale: mm, cm, m, in, or a number of mm")
      .standard("m for glTF, else mm");
  landscape.excludes({portrait});
}

}  // namespace ligne
