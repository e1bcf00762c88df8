#include "cli/page_options.hpp"

#include <cctype>

#include "cli/options.hpp"
#include "cli/parse.hpp"
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

PageSize parse_page_size(const std::string& text) {
  PageSize size;
  size.page = parse_page(text);
  const unsigned char first = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  size.explicit_size = !std::isalpha(first);
  return size;
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
  group.add("--pen-width", "LEN", request.pen_width_mm, parse_pen_width, "width of the widest lines").standard("0.35mm");
  group.add("--scale", "fit|N:M", request.scale, parse_scale, "fill the page, or a true scale").standard("fit");
  group
      .add("--unit", "UNIT", request.unit_mm, parse_unit_mm,
           "length of a model unit for a true scale: mm, cm, m, in, or a number of mm")
      .standard("mm");
  landscape.excludes({portrait});
}

}  // namespace ligne
