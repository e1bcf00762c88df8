#include "cli/options/axes_options.hpp"

#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "picture/parse/parse.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

constexpr std::string_view kAxesStyleNames[] = {"back", "grid", "box", "base"};
constexpr std::string_view kTextStyleNames[] = {"font", "stroke"};
constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr double kHighestTextMm = 1000;

double parse_text_height(const std::string& text) {
  const double height = parse_length_mm(text);
  if (!(height > 0 && height <= kHighestTextMm)) {
    throw std::invalid_argument(printable(text) + " is not above 0 and at most 1000 mm");
  }
  return height;
}

}  // namespace

void add_axes_options(CLI::App& app, AxesChoice& choice, std::string& style) {
  OptionGroup group(app, "Axes");
  group.add_flag_with_text(
      "--axes", style,
      "axes with ticks and numbers, and the back edges of the plot box; --axes=grid: also grid lines, --axes=box: all "
      "edges, --axes=base: only edges of the ground");
  const auto as_written = [](const std::string& text) { return text; };
  for (int k = 0; k < 3; ++k) {
    const std::string axis = kAxisNames[k];
    group.add("--" + axis + "-label", "TEXT", choice.names[k], as_written, "name of the " + axis + " axis; empty for none")
        .standard(axis);
  }
  group
      .add(
          "--text", "font|stroke", choice.text,
          [](const std::string& t) { return static_cast<TextStyle>(parse_choice(t, kTextStyleNames)); },
          "text in an outline font, or in a single-stroke font for pens")
      .standard("font");
  group.add("--text-height", "LEN", choice.text_height_mm, parse_text_height, "height of capital letters")
      .standard("2.5mm on A4");
}

void check_axes(AxesChoice& choice, const std::string& style) {
  if (style.empty()) {
    for (int k = 0; k < 3; ++k) {
      if (choice.names[k]) throw UsageError("--" + std::string(kAxisNames[k]) + "-label", "needs --axes");
    }
    return;
  }
  try {
    choice.style = style == "true" ? AxesStyle::back : static_cast<AxesStyle>(parse_choice(style, kAxesStyleNames));
  } catch (const std::invalid_argument& e) {
    throw UsageError("--axes", e.what());
  }
}

}  // namespace ligne
