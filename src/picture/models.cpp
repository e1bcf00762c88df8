#include "picture/models.hpp"

#include <utility>

#include "scene/clean/clean.hpp"

namespace ligne {
namespace {

/// Of the faces or of the border edges of a file: above that a warning says what was healed.
constexpr double kMuch = 0.1;

char name_of(Axis axis) { return "xyz"[static_cast<unsigned>(axis)]; }

/// A file's scene, healed where clear lines are wanted. `topology` is known afterwards when it had to be found for that.
Scene read(const ModelRequest& request, ModelFile& file, std::optional<Topology>& topology) {
  topology.reset();
  if (request.quality == Quality::exact) {
    return read_scene(file.name, {request.weld_distance.value_or(0), request.merge_coplanar}, file.warnings, &file.report);
  }
  Scene scene = read_scene(file.name, {.shading = true}, file.warnings, &file.report);
  topology = build_topology(scene);
  file.healed = heal(scene, *topology, {request.weld_distance});
  if (request.merge_coplanar) {
    topology.reset();
    merge_coplanar_faces(scene);
  }
  return scene;
}

}  // namespace

LoadedModels load_models(const ModelRequest& request) {
  LoadedModels models;
  for (const std::string& name : request.files) {
    ModelFile& file = models.files.emplace_back();
    file.name = name;
    Scene scene = read(request, file, models.topology);
    if (models.files.size() == 1) {
      models.scene = std::move(scene);
      continue;
    }
    models.topology.reset();
    if (scene.up_axis != models.scene.up_axis) {
      file.remarks.push_back(std::string("its up axis is ") + name_of(scene.up_axis) + ", that of " + models.files[0].name +
                             " is " + name_of(models.scene.up_axis) + ": coordinates are taken as they are");
    }
    const Axis up_axis = models.scene.up_axis;
    append_scene(models.scene, std::move(scene));
    models.scene.up_axis = up_axis;
  }
  return models;
}

void report_healing(const LoadedModels& models, const ModelRequest& request, RunReport& run) {
  std::size_t faces = 0, objects = 0, moved = 0, split = 0, sewn = 0, turned = 0;
  for (const ModelFile& file : models.files) {
    const HealReport& healed = file.healed;
    faces += healed.faces_twice;
    objects += healed.objects_twice;
    moved += healed.vertices_moved;
    split += healed.edges_split;
    sewn += healed.edges_sewn();
    turned += healed.faces_turned;
    std::string text;
    if (healed.faces_twice > 0 &&
        static_cast<double>(healed.faces_twice) >= kMuch * static_cast<double>(file.report.faces)) {
      text = std::to_string(healed.faces_twice) + " faces stored twice are drawn once";
    }
    if (!request.weld_distance && healed.edges_sewn() > 0 &&
        static_cast<double>(healed.edges_sewn()) >= kMuch * static_cast<double>(healed.border_edges)) {
      text += (text.empty() ? "" : "; ") + std::to_string(healed.edges_sewn()) + " of " +
              std::to_string(healed.border_edges) + " border edges were cracks and are sewn";
    }
    if (!text.empty()) run.warnings.push_back({file.name, text + " (--quality exact draws the file as it is)"});
  }
  const auto count = [&](const char* name, std::size_t n) {
    if (n > 0) run.clear.count(name, n);
  };
  count("objects stored twice", objects);
  count("faces stored twice", faces);
  count("border edges sewn", sewn);
  count("border vertices moved", moved);
  count("border edges split", split);
  count("faces turned round", turned);
}

}  // namespace ligne
