#include "cli/options/model_options.hpp"

#include "cli/messages.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "files/named_input.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {

void add_model_options(CLI::App& app, ModelRequest& request) {
  add_arguments(app, "MODEL", request.files, true,
                "glTF, OBJ, STL, PLY, OFF, 3MF, 3D Studio or ligne-scene file; several make one scene; - is "
                "standard input");
  OptionGroup group(app, "Lines");
  group
      .add("--weld", "DIST", request.weld_distance, parse_weld,
           "sew borders of one object that lie within DIST of each other, in model units (auto: detect the width of cracks; "
           "off). With --quality exact: merge vertices within DIST; auto is off")
      .standard("auto");
  group.add("--pose", "ANIMATION@SECONDS", request.pose, parse_pose,
            "glTF: the model posed at a time of an animation, which is given by name or by number from 0");
  group
      .add("--subdivide", "SCHEME[:N]", request.subdivision, parse_subdivision,
           "draw the limit surface of control meshes, approximated by N levels of subdivision: loop, catmull-clark (default "
           "N: until edges are shorter than 1/100 of the model)")
      .standard("off");
  group.add_flag("--merge-coplanar", request.merge_coplanar, "merge coplanar neighbouring faces into polygons");
  group
      .add(
          "--assume", "FACT,...", request.assumed, parse_facts,
          "facts about the scene that save tests. no-penetration: no faces pass through each other; convex: every object is "
          "one closed convex body; adjacency: each side of a face is a side of exactly one other face, the other way round")
      .standard("those of the file");
  OptionGroup parts(app, "Parts");
  const auto add_names = [](std::vector<std::string>& target) {
    return [&target](const std::string& text) {
      for (std::string& name : parse_names(text)) target.push_back(std::move(name));
    };
  };
  parts.add_repeatable("--only", "NAME,...", add_names(request.parts.only),
                       "draw only these objects; names may contain the wildcards * ? []; repeatable");
  parts.add_repeatable("--hide", "NAME,...", add_names(request.parts.hide), "do not draw these objects; repeatable");
  parts.add_repeatable(
      "--move", "NAME=X,Y,Z", [&request](const std::string& text) { request.parts.moves.push_back(parse_move(text)); },
      "translate an object, in model units or with a unit, for exploded views; repeatable");
}

void add_part_drawing_options(CLI::App& app, OutputRequest& request) {
  constexpr std::string_view kGroupNames[] = {"none", "object"};
  OptionGroup parts(app, "Parts");
  parts
      .add(
          "--group", "HOW", request.group_objects,
          [kGroupNames](const std::string& text) { return parse_choice(text, kGroupNames) == 1; },
          "none, or object. SVG: divide each layer into groups by object; JSON: store the object of each stroke")
      .standard("none");
  parts.add_repeatable(
      "--color", "NAME=COLOUR", [&request](const std::string& text) { request.colors.push_back(parse_object_color(text)); },
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

}  // namespace ligne
