#include "cli/commands/terrain_options.hpp"

#include <string>
#include <vector>

#include "cli/options/options.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parse/parse_terrain.hpp"

namespace ligne {

void add_terrain_options(CLI::App& surface, SurfaceRequest& request) {
  CurveRequest& curves = request.curves;
  TerrainRequest& terrain = request.terrain;
  AxesChoice& axes = request.picture.axes;
  OptionGroup group(surface, "Terrain");
  group.add_flag_or_value(
      "--contour-labels", "[index|all]", [&curves](const std::string& text) { curves.labels = parse_contour_labels(text); },
      "label contour lines with their heights: index contours only, or all");
  group
      .add("--index-contours", "N", curves.index_contours, parse_index_contours,
           "draw every Nth contour line wider, in layer contour-index; 0: none")
      .standard("5 with --contour-step, else 0");
  group.add_text(
      "--water", "Z|nodata", [&terrain](const std::string& text) { parse_water(text, terrain); },
      "treat areas below Z as water, or areas of a grid without heights; the shoreline is layer shore");
  group
      .add("--water-fill", "blank|hatch", terrain.water_fill, parse_water_fill,
           "leave water blank, or hatch it with horizontal strokes in layer water")
      .standard("blank");
  group
      .add("--hachures", "none|contour|slope", terrain.hachures, parse_hachures,
           "hill shading by hachures along contour lines or down the slope, in layer hatch")
      .standard("none");
  group
      .add("--hachure-spacing", "LEN", terrain.hachure_mm, parse_hatch_spacing,
           "distance between strokes in the darkest tone")
      .standard("2.2 pen widths");
  group
      .add_text(
          "--sun", "AZIMUTH[:ALTITUDE]", [&terrain](const std::string& text) { parse_sun(text, terrain); },
          "direction of the light for hachures: degrees clockwise from north (y), and degrees above the ground")
      .standard("315:45");
  group.add_flag_or_value(
      "--scale-bar", "[UNIT]",
      [&axes](const std::string& text) {
        axes.scale_bar = true;
        axes.scale_unit = text;
      },
      "a scale bar below the picture, in UNIT (default: metres if the ground is in metres, else units of x)");
  group.add_flag("--north-arrow", axes.north_arrow, "an arrow that points north, the direction of y");
}

void add_annotation_options(CLI::App& surface, SurfaceRequest& request) {
  OptionGroup group(surface, "Annotation");
  group.add_repeatable_tuple(
      "--curve", "X Y Z", 3,
      [&request](const std::vector<std::string>& xyz) {
        request.space_curves.push_back({xyz[0], xyz[1], xyz[2]});
      },
      "a space curve given by three formulas in t; surfaces can hide it; Z may be the word surface: on the surface "
      "(repeatable)");
  group
      .add_repeatable(
          "-t", "A:B[:N]", [&request](const std::string& text) { request.t.push_back(parse_range(text)); },
          "range of t and number of segments (repeatable: for the next curve)")
      .standard("0:2*pi:600");
  group.add_repeatable(
      "--points", "FILE", [&request](const std::string& file) { request.point_files.push_back(file); },
      "markers at the visible points of a table or of arrays: x, y, optional z (default: on the surface), optional label "
      "(repeatable)");
  group.add_repeatable(
      "--path", "FILE", [&request](const std::string& file) { request.line_files.push_back(file); },
      "polylines through the points of a table, separated by blank lines (repeatable)");
  group.add_text(
      "--colors", "COLOUR,...", [&request](const std::string& text) { request.colors = parse_colors(text); },
      "colours of the surfaces in their order, or of the bands");
  group.add_text(
      "--bands", "N|Z,...", [&request](const std::string& text) { request.bands = parse_bands(text); },
      "colours by height: N bands of equal height, or bands between the heights Z");
  group.add_flag("--legend", request.legend, "a legend of the surfaces, curves or bands below the picture");
  group.add_repeatable(
      "--name", "TEXT", [&request](const std::string& text) { request.names.push_back(text); },
      "text of the next legend entry (repeatable)");
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    auto& names = request.picture.axes.categories[static_cast<std::size_t>(k)];
    group.add_text(
        "--" + axis + "-names", "TEXT,...", [&names](const std::string& text) { names = parse_words(text); },
        "names in place of the numbers 0, 1, 2, ... on the " + axis + " axis");
  }
}

}  // namespace ligne
