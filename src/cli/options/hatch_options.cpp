#include "cli/options/hatch_options.hpp"

#include "cli/options/options.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {

void add_hatch_options(CLI::App& app, HatchRequest& request) {
  OptionGroup group(app, "Faces");
  const Option hatch = group
                           .add("--hatch", "HOW", request.kind, parse_hatch,
                                "hatch visible faces: none shade material plain; needs a method that gives regions or spans")
                           .standard("none");
  group
      .add("--hatch-spacing", "LEN", request.spacing_mm, parse_hatch_spacing, "distance between strokes in the darkest tone")
      .standard("4 widths of the hatching pen")
      .needs(hatch);
  group
      .add(
          "--hatch-angle", "DEG|HOW", request.direction, parse_hatch_direction,
          "direction of the strokes, counter-clockwise; face: one direction per face; curvature: along the curvature of the "
          "form; iso: along the curves of a surface")
      .standard("45")
      .needs(hatch);
  group
      .add("--hatch-levels", "N", request.levels, parse_hatch_levels,
           "number of tones, 1 to 4, each with twice the stroke distance of the darker one; or continuous")
      .standard("4; continuous with --hatch-angle curvature or iso")
      .needs(hatch);
  group.add_flag("--hatch-cross", request.cross, "a second family of strokes across the first").needs(hatch);
}

}  // namespace ligne
