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
      "heights set into the contour lines: into index contours, or into all");
  group
      .add("--index-contours", "N", curves.index_contours, parse_index_contours,
           "every Nth contour line heavier, in the layer contour-index; 0 for none")
      .standard("5 with --contour-step, else 0");
  group.add_text(
      "--water", "Z|nodata", [&terrain](const std::string& text) { parse_water(text, terrain); },
      "what is lower than Z is water, or where a grid has no height; its shore is the layer shore");
  group
      .add("--water-fill", "blank|hatch", terrain.water_fill, parse_water_fill,
           "water as a blank area, or with level strokes, in the layer water")
      .standard("blank");
  group
      .add("--hachures", "none|contour|slope", terrain.hachures, parse_hachures,
           "hill shading by strokes on the surface, along its level lines or down its slope, in the layer hatch")
      .standard("none");
  group.add("--hachure-spacing", "LEN", terrain.hachure_mm, parse_hatch_spacing, "distance of the closest strokes")
      .standard("2.2 widths of the pen");
  group
      .add_text(
          "--sun", "AZIMUTH[:ALTITUDE]", [&terrain](const std::string& text) { parse_sun(text, terrain); },
          "where the light of hachures comes from: degrees clockwise from north (y), and above the ground")
      .standard("315:45");
  group.add_flag_or_value(
      "--scale-bar", "[UNIT]",
      [&axes](const std::string& text) {
        axes.scale_bar = true;
        axes.scale_unit = text;
      },
      "a scale bar below the picture; in metres where the ground has them, else in numbers of x, or in UNIT");
  group.add_flag("--north-arrow", axes.north_arrow, "an arrow in the direction of y");
}

void add_annotation_options(CLI::App& surface, SurfaceRequest& request) {
  OptionGroup group(surface, "Annotation");
  group.add_repeatable_tuple(
      "--curve", "X Y Z", 3,
      [&request](const std::vector<std::string>& xyz) {
        request.space_curves.push_back({xyz[0], xyz[1], xyz[2]});
      },
      "a curve as three formulas in t, hidden by the surfaces; Z may be the word surface: on it (repeatable)");
  group
      .add_repeatable(
          "-t", "A:B[:N]", [&request](const std::string& text) { request.t.push_back(parse_range(text)); },
          "range of t and number of its pieces (repeatable: of the next curve)")
      .standard("0:2*pi:600");
  group.add_repeatable(
      "--points", "FILE", [&request](const std::string& file) { request.point_files.push_back(file); },
      "marks at the rows of a table or of arrays with x, y, perhaps z, and a label, where they are seen; without z on the surface "
      "(repeatable)");
  group.add_repeatable(
      "--path", "FILE", [&request](const std::string& file) { request.line_files.push_back(file); },
      "lines through such rows, which end at blank lines, as curves (repeatable)");
  group.add_text(
      "--colors", "COLOUR,...", [&request](const std::string& text) { request.colors = parse_colors(text); },
      "colours of the surfaces in their order, or of bands");
  group.add_text(
      "--bands", "N|Z,...", [&request](const std::string& text) { request.bands = parse_bands(text); },
      "colours by height: N bands of equal height, or bands between the heights Z");
  group.add_flag("--legend", request.legend,
                 "names of the surfaces, curves or bands below the picture, with a sample of each");
  group.add_repeatable(
      "--name", "TEXT", [&request](const std::string& text) { request.names.push_back(text); },
      "what the legend calls the next of them (repeatable)");
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    auto& names = request.picture.axes.categories[static_cast<std::size_t>(k)];
    group.add_text(
        "--" + axis + "-names", "TEXT,...", [&names](const std::string& text) { names = parse_words(text); },
        "names in place of the numbers 0, 1, 2 ... on the " + axis + " axis");
  }
}

}  // namespace ligne
