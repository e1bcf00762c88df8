#include "cli/page_options.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "cli/text.hpp"
#include "files/message_text.hpp"

namespace ligne {
namespace {

constexpr double kWidestPenMm = 50;

Page turned(Page page) {
  std::swap(page.width_mm, page.height_mm);
  return page;
}

/// Scale at which the extent fills the drawable part of the page.
double fitting_scale(const Page& page, const Rect& extent) {
  if (extent.empty()) return 0;
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const Rect area = page.drawable();
  const double across = extent.width() > 0 ? area.width() / extent.width() : unbounded;
  const double down = extent.height() > 0 ? area.height() / extent.height() : unbounded;
  return std::min(across, down);
}

double parse_pen_width(const std::string& text) {
  const double width = parse_length_mm(text);
  if (!(width > 0 && width <= kWidestPenMm)) {
    throw std::invalid_argument(printable(text) + " is not above 0 and at most " + shortest(kWidestPenMm) + " mm");
  }
  return width;
}

}  // namespace

PageSize parse_page_size(const std::string& text) {
  PageSize size;
  size.page = parse_page(text);
  const unsigned char first = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  size.explicit_size = !std::isalpha(first);
  return size;
}

void add_page_options(CLI::App& app, PageOptions& options) {
  CLI::Option* page = add_parsed(app, "--page", "SIZE", options.size, parse_page_size,
                                 "A0 to A6, letter, legal, tabloid, or WxH with units, such as 20cmx15cm")
                          ->default_str("A4");
  CLI::Option* landscape =
      app.add_flag("--landscape", options.landscape, "page lies on its long side (default: as it fits)");
  CLI::Option* portrait = app.add_flag("--portrait", options.portrait, "page stands on its short side");
  CLI::Option* margin =
      add_parsed(
          app, "--margin", "LEN", options.margin_mm, [](const std::string& t) { return parse_length_mm(t); },
          "empty rim of the page: mm, cm, in or pt, bare is mm")
          ->default_str("10mm");
  CLI::Option* pen =
      add_parsed(app, "--pen-width", "LEN", options.pen_width_mm, parse_pen_width, "width of the widest lines")
          ->default_str("0.35mm");
  CLI::Option* scale = add_parsed(app, "--scale", "fit|N:M", options.scale, parse_scale, "fill the page, or a true scale")
                           ->default_str("fit");
  CLI::Option* unit = add_parsed(app, "--unit", "UNIT", options.unit_mm, parse_unit_mm,
                                 "length of a model unit for a true scale: mm, cm, m, in, or a number of mm")
                          ->default_str("mm");
  landscape->excludes(portrait);
  for (CLI::Option* option : {page, landscape, portrait, margin, pen, scale, unit}) option->group("Page");
}

void check(const PageOptions& options) {
  Page page = options.size.page;
  page.margin_mm = options.margin_mm;
  if (!(page.drawable().width() > 0 && page.drawable().height() > 0)) {
    throw UsageError("--margin", shortest(options.margin_mm) + " mm leaves nothing of a page of " + shortest(page.width_mm) +
                                     " x " + shortest(page.height_mm) + " mm");
  }
}

Page page_for(const PageOptions& options, const Rect& extent) {
  Page page = options.size.page;
  page.margin_mm = options.margin_mm;
  const bool lies = page.width_mm > page.height_mm;
  if (options.landscape) return lies ? page : turned(page);
  if (options.portrait) return lies ? turned(page) : page;
  if (options.size.explicit_size) return page;
  return fitting_scale(turned(page), extent) > fitting_scale(page, extent) ? turned(page) : page;
}

}  // namespace ligne
