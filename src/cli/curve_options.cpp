#include "cli/curve_options.hpp"

#include <cmath>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"

namespace ligne {
namespace {

constexpr unsigned kMostContours = 10'000, kContours = 10;
/// How far below the lowest height the contours of the base lie, as a part of the range of heights.
constexpr double kBaseDepth = 0.3;
constexpr double kOverlap = 6;

const char* const kGroup = "Curves";

/// An option that may stand alone or with a number.
template <class Number>
void add_flag_with_number(CLI::App& app, const std::string& name, const std::string& kind, bool& given, Number& number,
                          const std::string& help) {
  app.add_option_function<std::vector<std::string>>(
         name,
         [&given, &number, name](const std::vector<std::string>& values) {
           given = true;
           try {
             if (!values.empty() && !values[0].empty()) number = parse_number(values[0]);
           } catch (const std::invalid_argument& e) {
             throw UsageError(name, e.what());
           }
         },
         help)
      ->expected(0, 1)
      ->type_name(kind)
      ->group(kGroup);
}

}  // namespace

void add_curve_options(CLI::App& app, CurveOptions& options) {
  add_parsed(
      app, "--contours", "N", options.contours, [](const std::string& t) { return parse_count(t, 1, kMostContours); },
      "N contour lines on the surface, at equal distances in height")
      ->group(kGroup);
  add_parsed(app, "--contour-step", "DZ", options.contour_step, parse_positive, "or contour lines at all multiples of DZ")
      ->group(kGroup);
  add_flag_with_number(
      app, "--contours-base", "[Z]", options.contours_base, options.contour_base,
      "contour lines on a plane at the height Z (default: 30 % of the range of heights below the lowest); alone: only there, 10 of them");
  add_parsed(
      app, "--outline", "on|off", options.outline,
      [](const std::string& t) {
        constexpr std::string_view kNames[] = {"off", "on"};
        return parse_choice(t, kNames) == 1;
      },
      "silhouette and rims of the surface between the curves, in layers of their own (default: on)")
      ->group(kGroup);
  add_parsed(
      app, "--underside", "same|apart|none", options.underside,
      [](const std::string& t) {
        constexpr std::string_view kNames[] = {"same", "apart", "none"};
        return static_cast<Underside>(parse_choice(t, kNames));
      },
      "curves on the side that looks down: with the others, in the layer underside, or not drawn")
      ->default_str("same")
      ->group(kGroup);
  add_parsed(
      app, "--hidden-by", "surface|curves", options.hidden_by,
      [](const std::string& t) {
        constexpr std::string_view kNames[] = {"surface", "curves"};
        return static_cast<HiddenBy>(parse_choice(t, kNames));
      },
      "what hides: the surface with all its samples, or, as in the classical method, the curves that are drawn")
      ->default_str("surface")
      ->group(kGroup);
  options.ridgeline_overlap = kOverlap;
  add_flag_with_number(
      app, "--ridgeline", "[K]", options.ridgeline, options.ridgeline_overlap,
      "rows lifted one above the other, as on the cover of Unknown Pleasures; heights reach over K rows (default: 6)");
}

void check(const CurveOptions& options) {
  if (options.contours && options.contour_step) throw UsageError("--contours, --contour-step", "do not go together");
  const bool contours = options.contours || options.contour_step || options.contours_base;
  if (options.hidden_by == HiddenBy::curves && contours)
    throw UsageError("--hidden-by", "curves knows no surface for contours to lie on");
  if (options.hidden_by == HiddenBy::curves && options.outline.value_or(false))
    throw UsageError("--hidden-by", "curves knows no surface that has an outline");
  if (options.ridgeline && (contours || options.outline.value_or(false)))
    throw UsageError("--ridgeline", "is made of rows alone");
  if (options.ridgeline && !(options.ridgeline_overlap > 0)) throw UsageError("--ridgeline", "the overlap is not above 0");
}

std::string needs_horizon(const CurveOptions& options) {
  if (options.ridgeline) return "--ridgeline";
  if (options.contours_base) return "--contours-base";
  if (options.underside != Underside::same) return "--underside";
  if (options.hidden_by != HiddenBy::surface) return "--hidden-by curves";
  return "";
}

std::vector<double> contour_levels(const CurveOptions& options, double low, double high) {
  std::vector<double> levels;
  if (options.contour_step) {
    const double step = *options.contour_step, first = std::ceil(low / step);
    if (!((high - low) / step < kMostContours)) {
      throw UsageError("--contour-step", "gives more than " + std::to_string(kMostContours) + " contour lines");
    }
    for (double k = first; k * step <= high; ++k) levels.push_back(k * step);
  } else if (options.contours || options.contours_base) {
    const unsigned n = options.contours.value_or(kContours);
    for (unsigned k = 1; k <= n; ++k) levels.push_back(low + (high - low) * k / (n + 1));
  }
  return levels;
}

double contour_base_of(const CurveOptions& options, double low, double high) {
  return options.contour_base.value_or(low - kBaseDepth * (high - low));
}

}  // namespace ligne
