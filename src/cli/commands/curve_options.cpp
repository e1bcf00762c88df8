#include "cli/commands/curve_options.hpp"

#include "cli/options/options.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_terrain.hpp"

namespace ligne {
namespace {

/// A parser that accepts one of the words, which name the values of Enum in order.
template <class Enum, std::size_t N>
auto parse_word(const std::string_view (&words)[N]) {
  return [&words](const std::string& text) { return static_cast<Enum>(parse_choice(text, words)); };
}

constexpr std::string_view kOutlineNames[] = {"off", "on"}, kUndersideNames[] = {"same", "apart", "none"},
                           kHiddenByNames[] = {"surface", "curves"};

}  // namespace

void add_curve_options(CLI::App& app, CurveRequest& request) {
  OptionGroup group(app, "Curves");
  group.add_text(
      "--contours", "N|N:even|Z,...", [&request](const std::string& text) { parse_contours(text, request); },
      "about N contour lines at round heights; N:even: exactly N, equally spaced; Z,...: at these heights (a single one: "
      "Z,)");
  group.add("--contour-step", "DZ", request.contour_step, parse_positive, "contour lines at all multiples of DZ");
  group.add_flag_or_value(
      "--contours-base", "[Z]",
      [&request](const std::string& text) {
        request.contours_base = true;
        if (!text.empty()) request.contour_base = parse_number(text);
      },
      "contour lines on a plane at height Z (default: lowest height minus 30 % of the range); without --contours: 10 lines, "
      "only there");
  group.add("--outline", "on|off", request.outline, parse_word<bool>(kOutlineNames),
            "silhouettes and borders of the surface, in their own layers (default: on)");
  group
      .add("--underside", "same|apart|none", request.underside, parse_word<Underside>(kUndersideNames),
           "curves on the underside: with the others, in layer underside, or not drawn")
      .standard("same");
  group
      .add("--hidden-by", "surface|curves", request.hidden_by, parse_word<HiddenBy>(kHiddenByNames),
           "what hides: the surface with all its samples, or only the drawn curves, as in the classical method")
      .standard("surface");
  group.add_flag_or_value(
      "--ridgeline", "[K]",
      [&request](const std::string& text) {
        request.ridgeline = true;
        if (!text.empty()) request.ridgeline_overlap = parse_number(text);
      },
      "ridgeline plot, as on the cover of Unknown Pleasures; heights span K rows (default: 6)");
}

}  // namespace ligne
