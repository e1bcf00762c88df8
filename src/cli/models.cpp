#include "cli/models.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "cli/text.hpp"

namespace ligne {
namespace {

char name_of(Axis axis) { return "xyz"[static_cast<unsigned>(axis)]; }

}  // namespace

void add_model_options(CLI::App& app, ModelOptions& options) {
  app.add_option("MODEL", options.files, "glTF, OBJ, STL, PLY, 3D Studio ASCII or ligne-scene file; several make one scene")
      ->required()
      ->type_name("");
  add_parsed(app, "--weld", "DIST", options.weld_distance, parse_positive,
             "vertices of one object that are so near to each other (model units) become one: closes seams that would "
             "be drawn as borders")
      ->default_str("0, equal positions")
      ->group("Lines");
  app.add_flag("--merge-coplanar", options.merge_coplanar, "put coplanar neighbouring faces together into polygons")
      ->group("Lines");
}

void warn(const std::string& place, const std::string& text) { say(place + ": warning: " + text); }

LoadedModels load_models(const ModelOptions& options, bool quiet, RunFiles& files) {
  LoadedModels models;
  for (const std::string& name : options.files) {
    ModelFile& file = models.files.emplace_back();
    file.name = name;
    Scene scene = read_scene(name, {options.weld_distance, options.merge_coplanar}, file.warnings, &file.report);
    files.were_read(file.report.files);
    if (!quiet) {
      for (const auto& [kind, count] : file.warnings.counts()) warn(name, std::to_string(count) + " " + kind);
    }
    if (models.files.size() == 1) {
      models.scene = std::move(scene);
      continue;
    }
    if (scene.up_axis != models.scene.up_axis && !quiet) {
      warn(name, std::string("its up axis is ") + name_of(scene.up_axis) + ", that of " + models.files[0].name + " is " +
                     name_of(models.scene.up_axis) + ": coordinates are taken as they are");
    }
    const Axis up_axis = models.scene.up_axis;
    append_scene(models.scene, std::move(scene));
    models.scene.up_axis = up_axis;
  }
  return models;
}

}  // namespace ligne
