#include "picture/models.hpp"

#include <utility>

namespace ligne {
namespace {

char name_of(Axis axis) { return "xyz"[static_cast<unsigned>(axis)]; }

}  // namespace

LoadedModels load_models(const ModelRequest& request) {
  LoadedModels models;
  for (const std::string& name : request.files) {
    ModelFile& file = models.files.emplace_back();
    file.name = name;
    Scene scene = read_scene(name, {request.weld_distance, request.merge_coplanar}, file.warnings, &file.report);
    if (models.files.size() == 1) {
      models.scene = std::move(scene);
      continue;
    }
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

}  // namespace ligne
