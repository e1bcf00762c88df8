#include "cli/options/page_options.hpp"

#include "cli/options/options.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {

void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers) {
  OptionGroup(app, "Page")
      .add_repeatable(
          "--width", "CLASS=LEN,...",
          [&widths, own_layers](const std::string& text) {
            for (const auto& [layer, width] : parse_widths(text)) widths[layer] = width;
            if (own_layers) require_layers(widths);
          },
          "widths of lines by class, such as profile=0.7,crease=0.25; repeatable")
      .standard("in pen widths: profile 1.4, outline and border 1, crease, intersection and shape lines 0.7, others 0.5");
}

void add_page_options(CLI::App& app, PageRequest& request) {
  OptionGroup group(app, "Page");
  group
      .add("--page", "SIZE", request.size, parse_page_size,
           "A0 to A6, letter, legal, tabloid, or WxH with units, such as 20cmx15cm")
      .standard("A4");
  const Option landscape =
      group.add_flag("--landscape", request.landscape, "landscape page (default: the orientation that fits better)");
  const Option portrait = group.add_flag("--portrait", request.portrait, "portrait page");
  group
      .add(
          "--margin", "LEN", request.margin_mm, [](const std::string& t) { return parse_length_mm(t); },
          "page margin in mm, cm, in or pt (mm if no unit is given)")
      .standard("10mm");
  group.add("--pen-width", "LEN", request.pen_width_mm, parse_pen_width, "width of outlines").standard("0.35mm");
  add_width_option(app, request.widths_mm, true);
  group.add("--scale", "fit|N:M", request.scale, parse_scale, "fit the picture to the page, or a scale such as 1:2")
      .standard("fit");
  group.add("--unit", "UNIT", request.unit_mm, parse_unit_mm, "length of one model unit: mm, cm, m, in, or a number of mm")
      .standard("m for glTF, else mm");
  landscape.excludes({portrait});
}

}  // namespace ligne
