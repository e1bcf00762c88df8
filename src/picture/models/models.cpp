#include "picture/models/models.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "files/message_text.hpp"
#include "files/named_input.hpp"
#include "picture/errors.hpp"
#include "picture/models/compiled_model.hpp"
#include "scene/clean/clean.hpp"
#include "scene/clean/named_objects.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {
namespace {

/// Part of the faces or border edges of a file above which a warning reports the healing.
constexpr double kReportedPart = 0.1;

char name_of(Axis axis) { return "xyz"[static_cast<unsigned>(axis)]; }

/// Largest number of objects that a message lists.
constexpr std::size_t kMostListed = 12;

bool any_fits(const std::vector<std::string>& patterns, const std::string& name) {
  return std::ranges::any_of(patterns, [&](const std::string& p) { return name_fits(p, name); });
}

bool is_drawn(const PartRequest& parts, const std::string& name) {
  return (parts.only.empty() || any_fits(parts.only, name)) && !any_fits(parts.hide, name);
}

/// Removes and moves objects, which are numbered from `first_number`.
void choose_parts(Scene& scene, const PartRequest& parts, std::size_t first_number, double unit_mm) {
  std::vector<std::uint8_t> keep(scene.objects.size());
  for (std::size_t i = 0; i < keep.size(); ++i) {
    const std::string name = object_name(scene.objects[i], first_number + i);
    keep[i] = is_drawn(parts, name);
    Point3 by{0, 0, 0};
    for (const PartMove& move : parts.moves) {
      if (name_fits(move.pattern, name)) by += move.units + move.mm / unit_mm;
    }
    if (by == Point3{0, 0, 0}) continue;
    move_object(scene, i, by);
    scene.stated.forget_relations();
  }
  if (std::ranges::find(keep, 0) != keep.end()) keep_objects(scene, keep, first_number);
}

/// The name of a file without its folders and its suffix.
std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

/// Names the only object of one of several files after the file, if it has no name, or one of an STL. Programs write the
/// same words into every STL.
void name_after_file(Scene& scene, const std::string& file, ModelFormat format) {
  const bool is_stl = format == ModelFormat::stl_ascii || format == ModelFormat::stl_binary;
  if (scene.objects.size() == 1 && (is_stl || scene.objects[0].name.empty())) scene.objects[0].name = stem_of(file);
}

/// Options for the next file. `first_number`: number of its first object. The request must outlive the options.
ReadOptions read_options(const ModelRequest& request, std::size_t first_number, const std::string& file) {
  ReadOptions options{.groups = request.tell_parts || request.parts.is_requested(),
                      .shading = request.quality == Quality::clear && request.shading,
                      .pose = request.pose};
  if (request.quality == Quality::exact) {
    options.weld_distance = request.weld_distance.value_or(0);
    options.merge_coplanar = request.merge_coplanar;
  }
  options.subdivision = request.subdivision;
  if (request.parts.is_requested()) {
    options.is_subdivided = [&request, first_number, stem = stem_of(file)](const Object& object, std::size_t i) {
      return is_drawn(request.parts, object_name(object, first_number + i)) || is_drawn(request.parts, stem);
    };
  }
  return options;
}

/// Returns a file's scene with the objects that are drawn, healed for clear lines. Sets `topology` if healing had to
/// build it.
Scene choose_and_heal(const ModelRequest& request, ModelFile& file, LoadedModels& models, Scene scene) {
  std::optional<Topology>& topology = models.topology;
  topology.reset();
  const std::size_t first = models.object_names.size();
  for (const Object& object : scene.objects) models.object_names.push_back(object_name(object, models.object_names.size()));
  const double scene_unit_mm = models.files.size() > 1 ? models.scene.unit_mm : scene.unit_mm;
  choose_parts(scene, request.parts, first, request.unit_mm.value_or(scene_unit_mm));
  if (request.subdivision) scene.stated = {};  // the limit surface is another shape
  scene.stated.bits |= request.assumed.bits;
  if (request.quality == Quality::exact || scene.objects.empty()) return scene;
  topology.emplace();
  file.healed = heal(scene, *topology, {request.weld_distance});
  if (request.merge_coplanar) {
    topology.reset();
    merge_coplanar_faces(scene);
  }
  return scene;
}

void check_parts(const LoadedModels& models, const PartRequest& parts) {
  require_names(models, "only", parts.only);
  require_names(models, "hide", parts.hide);
  for (const PartMove& move : parts.moves) require_names(models, "move", {move.pattern});
  if (models.scene.objects.empty()) {
    throw RequestError(parts.hide.empty() ? "only" : "hide", "no object is left to draw");
  }
}

}  // namespace

const std::string* compiled_file(const ModelRequest& request) {
  const auto found = std::ranges::find_if(request.files, [](const std::string& name) { return method_of_compiled(name); });
  if (found == request.files.end()) return nullptr;
  const std::string whole = printable(*found, kLongestPath) + " is compiled: use this option with ligne compile";
  if (request.files.size() > 1)
    throw RequestError("", printable(*found, kLongestPath) + " is a compiled model and must be the only one");
  const PartRequest& parts = request.parts;
  if (parts.is_requested()) throw RequestError(!parts.only.empty() ? "only" : !parts.hide.empty() ? "hide" : "move", whole);
  if (request.weld_distance) throw RequestError("weld", whole);
  if (request.merge_coplanar) throw RequestError("merge-coplanar", whole);
  if (request.subdivision) throw RequestError("subdivide", whole);
  return &*found;
}

namespace {

LoadedModels load_compiled(const std::string& name, const StatedFacts& assumed) {
  LoadedModels models;
  ModelFile& file = models.files.emplace_back();
  file.name = name;
  CompiledModel model = read_compiled_model(read_input(name, name, file.report.files), name);
  file.report.format = ModelFormat::ligne_tree;
  file.report.faces = model.scene.faces.size();
  for (std::size_t f = 0; f < model.scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < model.scene.faces.contour_count(f); ++c) {
      file.report.triangles += model.scene.faces.contour(f, c).size() - 2;
    }
  }
  file.report.vertices = model.scene.vertices.size();
  for (const Object& object : model.scene.objects) {
    models.object_names.push_back(object_name(object, models.object_names.size()));
  }
  models.scene = std::move(model.scene);
  models.scene.stated.bits |= assumed.bits;
  models.compiled = std::move(model.compiled);
  models.compiled_for = model.method;
  return models;
}

}  // namespace

LoadedModels load_models(const ModelRequest& request) {
  if (const std::string* name = compiled_file(request)) return load_compiled(*name, request.assumed);
  LoadedModels models;
  for (const std::string& name : request.files) {
    ModelFile& file = models.files.emplace_back();
    file.name = shown_input(name);
    Scene scene = read_scene(name, read_options(request, models.object_names.size(), name), file.warnings, &file.report);
    if (request.files.size() > 1) name_after_file(scene, name, file.report.format);
    scene = choose_and_heal(request, file, models, std::move(scene));
    if (models.files.size() == 1) {
      models.scene = std::move(scene);
      continue;
    }
    models.topology.reset();
    if (scene.up_axis != models.scene.up_axis) {
      file.remarks.push_back(std::string("its up axis is ") + name_of(scene.up_axis) + ", that of " + models.files[0].name +
                             " is " + name_of(models.scene.up_axis) + ": coordinates are used unchanged");
    }
    if (scene.unit_mm != models.scene.unit_mm) {
      file.remarks.push_back("its unit is " + shortest(scene.unit_mm) + " mm, that of " + models.files[0].name + " is " +
                             shortest(models.scene.unit_mm) + " mm: coordinates are used unchanged");
    }
    const Axis up_axis = models.scene.up_axis;
    const double unit_mm = models.scene.unit_mm;
    append_scene(models.scene, std::move(scene));
    models.scene.up_axis = up_axis;
    models.scene.unit_mm = unit_mm;
  }
  check_parts(models, request.parts);
  models.scene.stated.bits |= request.assumed.bits;
  return models;
}

LoadedModels load_model(const ModelRequest& request, Scene scene, const std::string& name) {
  LoadedModels models;
  ModelFile& file = models.files.emplace_back();
  file.name = name;
  file.report.faces = scene.faces.size();
  file.report.vertices = scene.vertices.size();
  clean_read_scene(scene, name, read_options(request, 0, name), file.warnings, file.report);
  models.scene = choose_and_heal(request, file, models, std::move(scene));
  check_parts(models, request.parts);
  models.scene.stated.bits |= request.assumed.bits;
  return models;
}

void require_names(const LoadedModels& models, const std::string& option, const std::vector<std::string>& patterns) {
  const std::vector<std::string>& names = models.object_names;
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(names, [&](const std::string& name) { return name_fits(pattern, name); })) continue;
    std::string list;
    std::vector<std::string> listed;
    for (const std::string& name : names) {
      if (listed.size() < kMostListed && std::ranges::find(listed, name) == listed.end()) {
        listed.push_back(name);
        list += (list.empty() ? "" : ", ") + printable(name);
      }
    }
    const bool all =
        std::ranges::all_of(names, [&](const std::string& name) { return std::ranges::find(listed, name) != listed.end(); });
    throw RequestError(option, "no object is called " + shown(pattern, '"') + "; there " +
                                   (listed.size() == 1 ? "is " : "are ") + list +
                                   (all ? "" : " and more: ligne info --json lists all"));
  }
}

namespace {

/// Throws RequestError if a pen is for a material that the scene does not have.
void require_materials(const Scene& scene, const PenTable& pens) {
  for (const auto& [material, number] : pens.pen_of_material) {
    if (std::ranges::find(scene.materials, material, &Material::name) != scene.materials.end()) continue;
    constexpr std::size_t kMostListed = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(scene.materials.size(), kMostListed); ++i)
      list += (i > 0 ? ", " : "") + printable(scene.materials[i].name);
    throw RequestError("pen", "no material is called " + shown(material, '"') +
                                  (list.empty() ? "; the scene has none" : "; there are " + list) +
                                  (scene.materials.size() > kMostListed ? " and more: ligne info --json lists all" : ""));
  }
}

}  // namespace

void require_parts(const LoadedModels& models, const PictureRequest& picture) {
  for (const ObjectColor& color : picture.output.colors) require_names(models, "color", {color.pattern});
  for (const auto& [pattern, number] : picture.plotter.pens.pen_of_object) require_names(models, "pen", {pattern});
  require_materials(models.scene, picture.plotter.asked_pens);
}

void require_no_parameters(const LoadedModels& models, const std::vector<std::string>& names) {
  for (const MethodParameter& parameter : models.compiled_for->traits().parameters) {
    if (!parameter.of_compile || std::ranges::find(names, parameter.name) == names.end()) continue;
    throw SettingError(std::string(parameter.name), printable(models.files.front().name, kLongestPath) +
                                                        " is compiled: use this option with ligne compile");
  }
}

void report_healing(const LoadedModels& models, const ModelRequest& request, RunReport& run) {
  std::size_t collapsed = 0, steps = 0, faces = 0, objects = 0, moved = 0, split = 0, sewn = 0, turned = 0;
  for (const ModelFile& file : models.files) {
    const HealReport& healed = file.healed;
    collapsed += healed.vertices_collapsed;
    steps += healed.vertices_at_steps;
    faces += healed.faces_twice;
    objects += healed.objects_twice;
    moved += healed.vertices_moved;
    split += healed.edges_split;
    sewn += healed.edges_sewn();
    turned += healed.faces_turned;
    std::string text;
    if (healed.faces_twice > 0 &&
        static_cast<double>(healed.faces_twice) >= kReportedPart * static_cast<double>(file.report.faces)) {
      text = std::to_string(healed.faces_twice) + " faces stored twice are drawn once";
    }
    if (!request.weld_distance && healed.edges_sewn() > 0 &&
        static_cast<double>(healed.edges_sewn()) >= kReportedPart * static_cast<double>(healed.border_edges)) {
      text += (text.empty() ? "" : "; ") + std::to_string(healed.edges_sewn()) + " of " +
              std::to_string(healed.border_edges) + " border edges were cracks and are sewn";
    }
    if (!text.empty()) run.warnings.push_back({file.name, text + " (--quality exact draws the file as it is)"});
  }
  run.count_clear("vertices collapsed", collapsed);
  run.count_clear("vertices merged at steps", steps);
  run.count_clear("objects stored twice", objects);
  run.count_clear("faces stored twice", faces);
  run.count_clear("border edges sewn", sewn);
  run.count_clear("border vertices moved", moved);
  run.count_clear("border edges split", split);
  run.count_clear("faces turned round", turned);
}

}  // namespace ligne
