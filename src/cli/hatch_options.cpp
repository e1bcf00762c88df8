#include "cli/hatch_options.hpp"

#include <stdexcept>
#include <string>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "files/message_text.hpp"
#include "plotting/page.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

HatchKind parse_hatch(const std::string& text) {
  bool length = true;
  try {
    parse_length_mm(text);
  } catch (const std::invalid_argument&) {
    length = false;
  }
  if (length)
    throw std::invalid_argument(shown(text, '"') + " is not one of " + list_of(kHatchNames) +
                                "; the distance of the strokes is --hatch-spacing");
  return static_cast<HatchKind>(parse_choice(text, kHatchNames));
}

double parse_spacing(const std::string& text) {
  const double mm = parse_length_mm(text);
  if (!(mm > 0)) throw std::invalid_argument(shown(text, '"') + " is not a length above zero");
  return mm;
}

HatchDirection parse_direction(const std::string& text) {
  HatchDirection direction;
  if (text == "face") {
    direction.by_face = true;
  } else {
    direction.degrees = parse_within(text, -360, 360, "degrees");
  }
  return direction;
}

unsigned parse_levels(const std::string& text) { return text == "continuous" ? 0 : parse_count(text, 1, kMostShades); }

/// The methods that give one of the products.
std::string methods_with(std::uint8_t products) {
  std::string names;
  for (const Method* method : all_methods()) {
    if (method->traits().products & products) names += (names.empty() ? "" : ", ") + std::string(method->traits().name);
  }
  return names;
}

}  // namespace

void add_hatch_options(CLI::App& app, HatchRequest& options) {
  CLI::Option* hatch = add_parsed(app, "--hatch", "HOW", options.kind, parse_hatch,
                                  "hatch visible faces: none shade material plain; by a method that gives regions or spans")
                           ->default_str("none");
  CLI::Option* spacing =
      add_parsed(app, "--hatch-spacing", "LEN", options.spacing_mm, parse_spacing, "distance of the closest strokes")
          ->default_str("4 widths of the pen that hatches");
  CLI::Option* angle = add_parsed(app, "--hatch-angle", "DEG|face", options.direction, parse_direction,
                                  "direction of the strokes, counter-clockwise; face: on each face its own")
                           ->default_str("45");
  CLI::Option* levels =
      add_parsed(app, "--hatch-levels", "N", options.levels, parse_levels,
                 "degrees of darkness, 1 to 4, each with twice the distance of the one before; or continuous")
          ->default_str("4");
  CLI::Option* cross = app.add_flag("--hatch-cross", options.cross, "a second family of strokes across the first");
  for (CLI::Option* option : {hatch, spacing, angle, levels, cross}) option->group("Faces");
  for (CLI::Option* option : {spacing, angle, levels, cross}) option->needs(hatch);
}

void check(const HatchRequest& options, OutputFormat format, const Method& method) {
  if (!options.asked()) return;
  if (format == OutputFormat::json) throw UsageError("--hatch", "a JSON drawing has no hatching");
  if (method.traits().products & (kRegions | kSpans)) return;
  refuse_hatching(method.traits().name);
}

void refuse_hatching(std::string_view method) {
  throw UsageError("--hatch", "method " + std::string(method) + " gives neither regions nor spans; regions: " +
                                  methods_with(kRegions) + "; spans: " + methods_with(kSpans));
}

const Method& region_method() {
  for (const Method* method : all_methods()) {
    if (method->traits().products & kRegions) return *method;
  }
  return *all_methods().front();
}

}  // namespace ligne
