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
      "about N contour lines on the surface, at round heights; N:even: exactly N, at equal distances; or at the heights Z "
      "(one: Z,)");
  group.add("--contour-step", "DZ", request.contour_step, parse_positive, "or contour lines at all multiples of DZ");
  group.add_flag_or_value(
      "--contours-base", "[Z]",
      [&request](const std::string& text) {
        request.contours_base = true;
        if (!text.empty()) request.contour_base = parse_number(text);
      },
      "contour lines on a plane at the height Z (default: 30 % of the range of heights below the lowest); alone: only there, 10 of them");
  group.add("--outline", "on|off", request.outline, parse_word<bool>(kOutlineNames),
            "silhouette and rims of the surface between the curves, in layers of their own (default: on)");
  group
      .add("--underside", "same|apart|none", request.underside, parse_word<Underside>(kUndersideNames),
           "curves on the side that looks down: with the others, in the layer underside, or not drawn")
      .standard("same");
  group
      .add("--hidden-by", "surface|curves", request.hidden_by, parse_word<HiddenBy>(kHiddenByNames),
           "what hides: the surface with all its samples, or, as in the classical method, the curves that are drawn")
      .standard("surface");
  group.add_flag_or_value(
      "--ridgeline", "[K]",
      [&request](const std::string& text) {
        request.ridgeline = true;
        if (!text.empty()) request.ridgeline_overlap = parse_number(text);
      },
      "rows lifted one above the other, as on the cover of Unknown Pleasures; heights reach over K rows (default: 6)");
}

}  // namespace ligne
