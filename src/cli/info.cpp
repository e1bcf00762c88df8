#include "cli/info.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/messages.hpp"
#include "cli/methods.hpp"
#include "cli/options.hpp"
#include "cli/page_options.hpp"
#include "cli/view_options.hpp"
#include "files/message_text.hpp"
#include "geometry/parallel.hpp"
#include "picture/clear_creases.hpp"
#include "picture/culling.hpp"
#include "picture/draw_scene.hpp"
#include "picture/parse.hpp"
#include "picture/placement.hpp"
#include "picture/scene_facts.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

using Json = nlohmann::ordered_json;

/// Objects named one by one in the text; the JSON names them all.
constexpr std::size_t kMostObjectLines = 20;
/// Bytes of a name in the text; the JSON has all of it.
constexpr std::size_t kLongestName = 120;

struct Info {
  LoadedModels models;
  SceneFacts scene;
  ViewFacts view;
  std::optional<BackFaces> culled;  ///< when that was asked for
  Placement placement;
  Axis up_axis = Axis::z;
  const Method* method = nullptr;
};

std::string point_text(const Point3& p) { return rounded(p.x) + ", " + rounded(p.y) + ", " + rounded(p.z); }

std::string axis_name(Axis axis) { return std::string(1, "xyz"[static_cast<unsigned>(axis)]); }

/// A label in a column of its own.
std::string line(const std::string& label, const std::string& value) {
  constexpr std::size_t width = 15;
  return "  " + label + std::string(label.size() < width ? width - label.size() : 1, ' ') + value + "\n";
}

std::size_t sum(const SceneFacts& scene, std::size_t ObjectFacts::*member) {
  std::size_t n = 0;
  for (const ObjectFacts& object : scene.objects) n += object.*member;
  return n;
}

std::string closedness(const ObjectFacts& object) {
  if (object.solid()) return "closed, windings agree";
  if (object.closed()) return "closed, windings disagree at " + std::to_string(object.unlike_wound_edges) + " edges";
  if (object.faces == 0) return "no faces";
  return "open: " + std::to_string(object.border_edges) + " border edges, " + std::to_string(object.many_face_edges) +
         " edges of more than two faces";
}

/// What the scene means for a method, as far as its traits say.
std::string meaning(const MethodTraits& traits) {
  std::string text = precision_name(traits);
  text += traits.penetration ? "; faces that penetrate each other are drawn right"
                             : "; faces that penetrate each other are not drawn right";
  if (!traits.only_for.empty()) text += "; only for " + std::string(traits.only_for);
  if (!(traits.products & kStrokes)) text += "; gives no lines";
  return text;
}

/// Objects whose borders were sewn are named one by one up to this number.
constexpr std::size_t kMostSewnLines = 5;

/// What was healed, and why.
std::string healed_text(const ModelFile& file) {
  const HealReport& healed = file.healed;
  std::string text;
  const auto add = [&](const std::string& what) { text += line("healed", what); };
  if (healed.objects_twice > 0) add(std::to_string(healed.objects_twice) + " objects lie exactly on another one: left out");
  if (healed.faces_twice > 0)
    add(std::to_string(healed.faces_twice) + " faces have the same vertices as another one: drawn once, from both sides");
  if (healed.faces_turned > 0)
    add(std::to_string(healed.faces_turned) + " faces turned round to agree with their neighbours");
  if (healed.sewn.empty()) return text;
  add(std::to_string(healed.edges_sewn()) + " of " + std::to_string(healed.border_edges) +
      " border edges sewn: " + std::to_string(healed.vertices_moved) + " vertices moved onto another, edges split at " +
      std::to_string(healed.edges_split));
  for (std::size_t i = 0; i < std::min(healed.sewn.size(), kMostSewnLines); ++i) {
    const SewnBorders& sewn = healed.sewn[i];
    text += line("", "object " + std::to_string(sewn.object) + ": " + std::to_string(sewn.vertices_near) +
                         " vertices lie within " + rounded(sewn.distance, 3) + " of another border, the others " +
                         (sewn.next_gap > 0 ? "from " + rounded(sewn.next_gap, 3) + " on" : "much farther"));
  }
  if (healed.sewn.size() > kMostSewnLines) {
    text += line("", "and " + std::to_string(healed.sewn.size() - kMostSewnLines) + " objects more");
  }
  return text;
}

Json healed_json(const HealReport& healed) {
  Json json{{"objects_twice", healed.objects_twice},   {"faces_twice", healed.faces_twice},
            {"border_edges", healed.border_edges},     {"border_edges_sewn", healed.edges_sewn()},
            {"vertices_moved", healed.vertices_moved}, {"edges_split", healed.edges_split},
            {"faces_turned", healed.faces_turned}};
  json["sewn"] = Json::array();
  for (const SewnBorders& sewn : healed.sewn) {
    json["sewn"].push_back(Json{{"object", sewn.object},
                                {"distance", sewn.distance},
                                {"border_edges", sewn.edges},
                                {"border_edges_left", sewn.edges_left},
                                {"vertices_near", sewn.vertices_near},
                                {"next_gap", sewn.next_gap > 0 ? Json(sewn.next_gap) : Json(nullptr)}});
  }
  return json;
}

/// Groups of an OBJ are parts where parts are told apart.
std::string groups_text(const std::vector<std::string>& groups) {
  std::string text;
  for (std::size_t i = 0; i < std::min(groups.size(), kMostObjectLines); ++i) {
    text += (i > 0 ? ", " : "") + printable(groups[i], kLongestName);
  }
  if (groups.size() > kMostObjectLines) text += " and " + std::to_string(groups.size() - kMostObjectLines) + " more";
  return text + " (objects for --only, --hide, --move, --group, --color)";
}

std::string file_text(const ModelFile& file) {
  std::string text = file.name + "\n";
  text += line("format", std::string(to_string(file.report.format)));
  text += line("as stored", std::to_string(file.report.faces) + " faces, " + std::to_string(file.report.triangles) +
                                " triangles, " + std::to_string(file.report.vertices) + " vertices");
  if (!file.report.groups.empty()) text += line("groups", groups_text(file.report.groups));
  for (const auto& [kind, count] : file.warnings.counts()) text += line("mended", std::to_string(count) + " " + kind);
  text += healed_text(file);
  return text;
}

/// "#c0c0c0".
std::string color_code(const Point3& color) {
  char text[16];
  const auto level = [](double v) { return static_cast<unsigned>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", level(color.x), level(color.y), level(color.z));
  return text;
}

std::string material_text(const MaterialFacts& material, std::size_t number) {
  return (material.name.empty() ? "material " + std::to_string(number) : printable(material.name, kLongestName)) + " " +
         color_code(material.color);
}

/// The colours of an object, by its materials.
std::string colors_of(const SceneFacts& scene, const ObjectFacts& object) {
  constexpr std::size_t kMostNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(object.materials.size(), kMostNamed); ++i)
    text += ", " + material_text(scene.materials[object.materials[i]], object.materials[i]);
  if (object.materials.size() > kMostNamed)
    text += " and " + std::to_string(object.materials.size() - kMostNamed) + " materials more";
  return text;
}

/// Their names are those for --pen material:NAME.
std::string materials_text(const SceneFacts& scene) {
  std::string text;
  for (std::size_t i = 0; i < std::min(scene.materials.size(), kMostObjectLines); ++i) {
    const MaterialFacts& material = scene.materials[i];
    std::string value = material_text(material, i) + ": " + std::to_string(material.faces) + " faces";
    if (material.opacity < 1) value += ", opacity " + rounded(material.opacity, 3);
    text += line(i == 0 ? "materials" : "", value);
  }
  if (scene.materials.size() > kMostObjectLines)
    text += line("", "and " + std::to_string(scene.materials.size() - kMostObjectLines) + " more");
  return text;
}

std::string objects_text(const SceneFacts& scene) {
  std::size_t closed = 0, solid = 0;
  for (const ObjectFacts& object : scene.objects) {
    closed += object.closed();
    solid += object.solid();
  }
  std::string text = line("objects", std::to_string(scene.objects.size()) + ", " + std::to_string(closed) + " closed, " +
                                         std::to_string(solid) + " of them with windings that agree");
  for (std::size_t i = 0; i < std::min(scene.objects.size(), kMostObjectLines); ++i) {
    const ObjectFacts& object = scene.objects[i];
    text += line("", (object.name.empty() ? "object " + std::to_string(i) : printable(object.name, kLongestName)) + ": " +
                         std::to_string(object.faces) + " faces, " + closedness(object) + colors_of(scene, object));
  }
  if (scene.objects.size() > kMostObjectLines) {
    text += line("", "and " + std::to_string(scene.objects.size() - kMostObjectLines) + " more");
  }
  return text;
}

std::string text_of(const Info& info) {
  std::string text;
  for (const ModelFile& file : info.models.files) text += file_text(file);
  const SceneFacts& scene = info.scene;
  text += "scene\n" + objects_text(scene);
  text += materials_text(scene);
  text += line("vertices", std::to_string(scene.vertices));
  text += line("faces", std::to_string(scene.faces) + ", " + std::to_string(scene.faces_with_holes) + " with holes");
  text += line("triangles", std::to_string(scene.triangles));
  text +=
      line("edges", std::to_string(scene.edges) + ", " + std::to_string(sum(scene, &ObjectFacts::border_edges)) +
                        " border, " + std::to_string(sum(scene, &ObjectFacts::many_face_edges)) + " of more than two faces");
  text += line("bounding box", point_text(scene.bounds[0]) + " to " + point_text(scene.bounds[1]));
  text += line("up axis", axis_name(info.up_axis));
  std::string cameras;
  for (const SceneCamera& c : info.models.scene.cameras) cameras += (cameras.empty() ? "" : ", ") + printable(c.name);
  if (!cameras.empty()) text += line("cameras", cameras);
  text += line("unit", shortest(info.models.scene.unit_mm) + " mm");
  text += line("precision", rounded(scene.precision, 3) + " model units");

  text += "view\n";
  for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
    // The lines where faces penetrate each other are not edges of the scene: a method finds them.
    if (static_cast<LineClass>(c) == LineClass::intersection) continue;
    text += line(std::string(kLineClassNames[c]), std::to_string(info.view.edges[c]) + " edges");
  }
  if (info.culled) {
    text += line("back faces", std::to_string(info.culled->faces) + " left out, of " +
                                   std::to_string(info.culled->objects - info.culled->kept_objects) + " of " +
                                   std::to_string(info.culled->objects) + " objects");
  }
  text += line("depth", rounded(info.view.nearest) + " to " + rounded(info.view.farthest) + " along the line of sight");
  const Page& page = info.placement.page;
  text += line("page", rounded(page.width_mm) + " x " + rounded(page.height_mm) + " mm");
  text += line("picture", info.placement.picture.empty()
                              ? "nothing is in view"
                              : rounded(info.placement.picture.width(), 4) + " x " +
                                    rounded(info.placement.picture.height(), 4) + " mm, " +
                                    rounded(info.placement.view.scale, 4) + " mm per model unit" +
                                    (info.placement.larger_than_page() ? ", larger than the page" : ""));
  text += "methods\n";
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    text += line(std::string(traits.name), meaning(traits) + (method == info.method ? " (chosen)" : ""));
  }
  return text;
}

Json json_of(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

Json file_json(const ModelFile& file) {
  Json json;
  json["file"] = file.name;
  json["format"] = to_string(file.report.format);
  json["stored"] = {{"faces", file.report.faces}, {"triangles", file.report.triangles}, {"vertices", file.report.vertices}};
  if (!file.report.groups.empty()) json["groups"] = file.report.groups;
  json["warnings"] = Json::object();
  for (const auto& [kind, count] : file.warnings.counts()) json["warnings"][kind] = count;
  if (!file.healed.nothing()) json["healed"] = healed_json(file.healed);
  return json;
}

Json object_json(const SceneFacts& scene, const ObjectFacts& object) {
  Json json;
  json["name"] = object.name;
  json["vertices"] = object.vertices;
  json["faces"] = object.faces;
  json["materials"] = Json::array();
  for (const std::size_t material : object.materials) json["materials"].push_back(scene.materials[material].name);
  json["border_edges"] = object.border_edges;
  json["many_face_edges"] = object.many_face_edges;
  json["unlike_wound_edges"] = object.unlike_wound_edges;
  json["closed"] = object.closed();
  json["windings_agree"] = object.unlike_wound_edges == 0;
  return json;
}

std::string json_of(const Info& info) {
  Json json{{"format", "ligne-info"}, {"version", 1}};
  json["files"] = Json::array();
  for (const ModelFile& file : info.models.files) json["files"].push_back(file_json(file));

  const SceneFacts& facts = info.scene;
  Json scene;
  scene["vertices"] = facts.vertices;
  scene["faces"] = facts.faces;
  scene["faces_with_holes"] = facts.faces_with_holes;
  scene["triangles"] = facts.triangles;
  scene["edges"] = facts.edges;
  scene["border_edges"] = sum(facts, &ObjectFacts::border_edges);
  scene["many_face_edges"] = sum(facts, &ObjectFacts::many_face_edges);
  scene["bounds"] = Json::array({json_of(facts.bounds[0]), json_of(facts.bounds[1])});
  scene["up_axis"] = axis_name(info.up_axis);
  scene["cameras"] = Json::array();
  for (const SceneCamera& c : info.models.scene.cameras) scene["cameras"].push_back(c.name);
  scene["unit_mm"] = info.models.scene.unit_mm;
  scene["precision"] = facts.precision;
  scene["objects"] = Json::array();
  for (const ObjectFacts& object : facts.objects) scene["objects"].push_back(object_json(facts, object));
  scene["materials"] = Json::array();
  for (const MaterialFacts& material : facts.materials) {
    scene["materials"].push_back(Json{{"name", material.name},
                                      {"color", color_code(material.color)},
                                      {"opacity", material.opacity},
                                      {"faces", material.faces}});
  }
  json["scene"] = std::move(scene);

  Json view;
  view["edges"] = Json::object();
  for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
    if (static_cast<LineClass>(c) != LineClass::intersection)
      view["edges"][std::string(kLineClassNames[c])] = info.view.edges[c];
  }
  if (info.culled) {
    view["culled"] = {{"faces", info.culled->faces},
                      {"objects", info.culled->objects - info.culled->kept_objects},
                      {"kept_objects", info.culled->kept_objects}};
  }
  view["depth"] = Json::array({info.view.nearest, info.view.farthest});
  view["perspective"] = info.placement.view.camera.perspective;
  view["page_mm"] = Json::array({info.placement.page.width_mm, info.placement.page.height_mm});
  view["picture_mm"] = info.placement.picture.empty()
                           ? Json(nullptr)
                           : Json::array({info.placement.picture.width(), info.placement.picture.height()});
  view["mm_per_unit"] = info.placement.view.scale;
  json["view"] = std::move(view);

  json["methods"] = Json::array();
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    json["methods"].push_back(Json{{"name", traits.name}, {"chosen", method == info.method}, {"meaning", meaning(traits)}});
  }
  // Names come from the file as they are, UTF-8 or not.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void check(const InfoOptions& options) {
  check(options.page);
  if (options.output.format && *options.output.format != OutputFormat::json) {
    throw UsageError("--format", "info is written as text, or as json");
  }
}

void inform(const InfoOptions& options) {
  const std::string output = options.output.file.value_or("-");
  RunFiles files;
  files.will_write("--output", output);
  files.will_write("--stats-json", options.run.stats_json);
  Info info;
  RunReport run;
  PictureRequest request;
  request.lines = options.lines;
  info.method = &method_of(request);
  settings_of(options.method, *info.method);
  ModelRequest model = options.model;
  model.quality = options.lines.quality;
  model.unit_mm = options.page.unit_mm;
  info.models = timed(run.stages, reading_of(options.model), [&] { return load_models(model, options.run.quiet, files); });
  const Scene& scene = info.models.scene;
  info.up_axis = options.view.up_axis.value_or(scene.up_axis);
  const Topology topology = timed(run.stages, "topology", [&] {
    return info.models.topology ? std::move(*info.models.topology) : build_topology(scene);
  });
  info.scene = scene_facts(scene, topology);
  timed(run.stages, "project", [&] {
    info.placement = place(scene, camera_of(options.view, scene), options.page);
    std::vector<std::uint8_t> creases;
    const EdgeSelection all = select_edges(scene, topology, options.lines, parse_edges("all"), creases, run);
    ProjectedScene projected = project(scene, topology, info.placement.view, all);
    if (options.lines.cull) {
      info.culled = cull_back_faces(scene, topology, projected, run);
    }
    info.view = view_facts(scene, projected);
  });
  if (!options.run.quiet) {
    for (const RunWarning& w : run.warnings) warn(options.model.files.front(), w.text);
  }
  const bool json = options.json || options.output.format.has_value();
  files.write(output, json ? json_of(info) : text_of(info));
  finish(options.run, run, files);
}

}  // namespace

void setup_info(CLI::App& app, InfoOptions& options) {
  CLI::App& info =
      *add_command(app, "info", "What a scene contains, and what that means for each method",
                   "Examples:\n  ligne info gearbox.obj\n  ligne info flange.glb --view top --json -o flange.json");
  add_model_options(info, options.model);
  OptionGroup(info, "Output").add_flag("--json", options.json, "as JSON");
  add_view_options(info, options.view);
  add_line_options(info, options.lines, options.method);
  add_page_options(info, options.page);
  add_output_options(info, options.output, "json (default: text)");
  add_run_options(info, options.run);
}

void run_info(const InfoOptions& options) {
  check(options);
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { inform(options); });
}

}  // namespace ligne
