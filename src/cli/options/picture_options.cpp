#include <vector>

#include "cli/console.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "files/named_input.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

constexpr std::string_view kAxesStyleNames[] = {"back", "grid", "box", "base"};
constexpr std::string_view kGroupNames[] = {"none", "object"};
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

void add_model_options(CLI::App& app, ModelRequest& request) {
  add_arguments(app, "MODEL", request.files, true,
                "glTF, OBJ, STL, PLY, OFF, 3MF, 3D Studio or ligne-scene file; several make one scene; - is "
                "standard input");
  OptionGroup group(app, "Lines");
  group.add(
      "--weld", "DIST", request.weld_distance, parse_weld,
      "sew borders of one object that lie within DIST of each other, in model units (auto: detect the width of cracks; "
      "off). With --quality exact: merge vertices within DIST; auto is off",
      "auto");
  group.add("--pose", "ANIMATION@SECONDS", request.pose, parse_pose,
            "glTF: the model posed at a time of an animation, which is given by name or by number from 0");
  group.add(
      "--subdivide", "SCHEME[:N]", request.subdivision, parse_subdivision,
      "draw the limit surface of control meshes, approximated by N levels of subdivision: loop, catmull-clark (default "
      "N: until edges are shorter than 1/100 of the model)",
      "off");
  group.add_flag("--merge-coplanar", request.merge_coplanar, "merge coplanar neighbouring faces into polygons");
  group.add(
      "--assume", "FACT,...", request.assumed, parse_facts,
      "facts about the scene that save tests. no-penetration: no faces pass through each other; convex: every object is "
      "one closed convex body; adjacency: each side of a face is a side of exactly one other face, the other way round",
      "those of the file");
  OptionGroup parts(app, "Parts");
  const auto add_names = [](std::vector<std::string>& target) {
    return [&target](const std::string& text) {
      for (std::string& name : parse_names(text)) target.push_back(std::move(name));
    };
  };
  parts.add_repeatable("--only", "NAME,...", add_names(request.parts.only),
                       "draw only these objects; names may contain the wildcards * ? []; repeatable");
  parts.add_repeatable("--hide", "NAME,...", add_names(request.parts.hide), "do not draw these objects; repeatable");
  parts.add_each("--move", "NAME=X,Y,Z", request.parts.moves, parse_move,
                 "translate an object, in model units or with a unit, for exploded views; repeatable");
}

void add_part_drawing_options(CLI::App& app, OutputRequest& request) {
  OptionGroup parts(app, "Parts");
  parts.add("--group", "HOW", request.group_objects, parse_word<bool>(kGroupNames),
            "none, or object. SVG: divide each layer into groups by object; JSON: store the object of each stroke", "none");
  parts.add_each("--color", "NAME=COLOUR", request.colors, parse_object_color,
                 "colour of the lines of an object: #rrggbb, or a name such as red; repeatable");
}

Stage reading_of(const ModelRequest& request) {
  const std::string others = request.files.size() > 1 ? " and " + std::to_string(request.files.size() - 1) + " more" : "";
  return {"read", printable(shown_input(request.files.front()), kLongestPath) + others};
}

LoadedModels load_models(const ModelRequest& request, bool quiet, RunFiles& files, bool with_areas) {
  LoadedModels models = load_models(request);
  for (const ModelFile& file : models.files) {
    files.were_read(file.report.files);
    if (quiet) continue;
    warn(file.name, file.warnings, with_areas);
    for (const std::string& remark : file.remarks) warn(file.name, remark);
  }
  return models;
}

void add_view_options(CLI::App& app, ViewRequest& request, const std::string& standard) {
  OptionGroup group(app, "View");
  const auto take_view = [&request](const std::string& text) { parse_view(text, request); };
  const auto parse_fov = [](const std::string& text) { return parse_between(text, 0, 180, "degrees"); };

  const Option view = group.add_text(
      "--view", "NAME", take_view,
      "front back left right top bottom iso dimetric trimetric, or camera[:NAME] for a camera of the file", standard);
  const Option direction = group.add("--direction", "X,Y,Z", request.direction, parse_vector,
                                     "view direction, into the scene (parallel projection)");
  const Option eye = group.add("--eye", "X,Y,Z", request.eye, parse_point, "position of the eye (perspective projection)");
  const Option target = group.add("--target", "X,Y,Z", request.target, parse_point,
                                  "point at which the eye looks (default: centre of the model)");
  const Option fov = group.add("--fov", "DEG", request.fov_degrees, parse_fov, "vertical angle of view from the eye", "35");
  group.add("--up", "X,Y,Z", request.up, parse_vector, "direction that points up on the page (default: the up axis)");
  group.add("--up-axis", "x|y|z", request.up_axis, parse_axis,
            "vertical axis of the model (default: y for glTF and OBJ, else z)");

  view.excludes({direction, eye});
  direction.excludes({eye});
  target.needs(eye);
  fov.needs(eye);
}

void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers) {
  OptionGroup(app, "Page")
      .add_repeatable(
          "--width", "CLASS=LEN,...",
          [&widths, own_layers](const std::string& text) {
            for (const auto& [layer, width] : parse_widths(text)) widths[layer] = width;
            if (own_layers) require_layers(widths);
          },
          "widths of lines by class, such as profile=0.7,crease=0.25; repeatable",
          "in pen widths: profile 1.4, outline and border 1, crease, intersection and shape lines 0.7, others 0.5");
}

void add_page_options(CLI::App& app, PageRequest& request) {
  OptionGroup group(app, "Page");
  group.add("--page", "SIZE", request.size, parse_page_size,
            "A0 to A6, letter, legal, tabloid, or WxH with units, such as 20cmx15cm", "A4");
  const Option landscape =
      group.add_flag("--landscape", request.landscape, "landscape page (default: the orientation that fits better)");
  const Option portrait = group.add_flag("--portrait", request.portrait, "portrait page");
  group.add("--margin", "LEN", request.margin_mm, parse_length_mm,
            "page margin in mm, cm, in or pt (mm if no unit is given)", "10mm");
  group.add("--pen-width", "LEN", request.pen_width_mm, parse_pen_width, "width of outlines", "0.35mm");
  add_width_option(app, request.widths_mm, true);
  group.add("--scale", "fit|N:M", request.scale, parse_scale, "fit the picture to the page, or a scale such as 1:2", "fit");
  group.add("--unit", "UNIT", request.unit_mm, parse_unit_mm, "length of one model unit: mm, cm, m, in, or a number of mm",
            "m for glTF, else mm");
  landscape.excludes({portrait});
}

void add_fill_options(CLI::App& app, FillRequest& request) {
  OptionGroup group(app, "Fills");
  group.add("--fill", "HOW", request.kind, parse_fill,
            "fill visible faces: none material shade paper random; needs a method that gives regions, an order, spans or "
            "pixels",
            "none");
  group.add_each("--light", "X,Y,Z", request.lights, parse_vector,
                 "direction of a parallel light that casts shadows; repeatable");
}

void add_hatch_options(CLI::App& app, HatchRequest& request) {
  OptionGroup group(app, "Faces");
  const Option hatch =
      group.add("--hatch", "HOW", request.kind, parse_hatch,
                "hatch visible faces: none shade material plain; needs a method that gives regions or spans", "none");
  group
      .add("--hatch-spacing", "LEN", request.spacing_mm, parse_hatch_spacing, "distance between strokes in the darkest tone",
           "4 widths of the hatching pen")
      .needs(hatch);
  group
      .add(
          "--hatch-angle", "DEG|HOW", request.direction, parse_hatch_direction,
          "direction of the strokes, counter-clockwise; face: one direction per face; curvature: along the curvature of the "
          "form; iso: along the curves of a surface",
          "45")
      .needs(hatch);
  group
      .add("--hatch-levels", "N", request.levels, parse_hatch_levels,
           "number of tones, 1 to 4, each with twice the stroke distance of the darker one; or continuous",
           "4; continuous with --hatch-angle curvature or iso")
      .needs(hatch);
  group.add_flag("--hatch-cross", request.cross, "a second family of strokes across the first").needs(hatch);
}

void add_axes_options(CLI::App& app, AxesChoice& choice, std::string& style) {
  OptionGroup group(app, "Axes");
  group.add_flag_with_text(
      "--axes", style,
      "axes with ticks and numbers, and the back edges of the plot box; --axes=grid: also grid lines, --axes=box: all "
      "edges, --axes=base: only edges of the ground");
  for (int k = 0; k < 3; ++k) {
    const std::string axis = kAxisNames[k];
    group.add("--" + axis + "-label", "TEXT", choice.names[k], std::identity(),
              "name of the " + axis + " axis; empty for none", axis);
  }
  group.add("--text", "font|stroke", choice.text, parse_word<TextStyle>(kTextStyleNames),
            "text in an outline font, or in a single-stroke font for pens", "font");
  group.add("--text-height", "LEN", choice.text_height_mm, parse_text_height, "height of capital letters", "2.5mm on A4");
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

void add_parametric(OptionGroup& group, SurfaceRequest& request, const std::string& help) {
  const auto take = [&request](const std::vector<std::string>& xyz) {
    request.parametric.push_back({xyz[0], xyz[1], xyz[2]});
  };
  group.add_repeatable_tuple("--parametric", "X Y Z", 3, take, help);
}

void add_parameter_ranges(OptionGroup& group, SurfaceRequest& request) {
  group.add_each("-u", "A:B[:N]", request.u, parse_range,
                 "range of u of a parametric surface and number of curves (repeatable: for the next surface)", "0:2*pi:40");
  group.add_each("-v", "A:B[:N]", request.v, parse_range, "range of v, likewise", "0:2*pi:40");
}

}  // namespace ligne
