#include "cli/hatch_options.hpp"

#include <stdexcept>
#include <string>

#include "cli/options.hpp"
#include "cli/parse.hpp"
#include "files/message_text.hpp"
#include "plotting/page.hpp"

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

}  // namespace

void add_hatch_options(CLI::App& app, HatchRequest& request) {
  OptionGroup group(app, "Faces");
  const Option hatch = group
                           .add("--hatch", "HOW", request.kind, parse_hatch,
                                "hatch visible faces: none shade material plain; by a method that gives regions or spans")
                           .standard("none");
  group.add("--hatch-spacing", "LEN", request.spacing_mm, parse_spacing, "distance of the closest strokes")
      .standard("4 widths of the pen that hatches")
      .needs(hatch);
  group
      .add("--hatch-angle", "DEG|face", request.direction, parse_direction,
           "direction of the strokes, counter-clockwise; face: on each face its own")
      .standard("45")
      .needs(hatch);
  group
      .add("--hatch-levels", "N", request.levels, parse_levels,
           "degrees of darkness, 1 to 4, each with twice the distance of the one before; or continuous")
      .standard("4")
      .needs(hatch);
  group.add_flag("--hatch-cross", request.cross, "a second family of strokes across the first").needs(hatch);
}

}  // namespace ligne
