#include "cli/model_options.hpp"

#include "cli/messages.hpp"
#include "cli/options.hpp"
#include "cli/parse.hpp"

namespace ligne {

void add_model_options(CLI::App& app, ModelRequest& request) {
  add_arguments(app, "MODEL", request.files, true,
                "glTF, OBJ, STL, PLY, 3D Studio ASCII or ligne-scene file; several make one scene");
  OptionGroup group(app, "Lines");
  group
      .add(
          "--weld", "DIST", request.weld_distance, parse_positive,
          "vertices of one object that are so near to each other (model units) become one: closes seams that would be drawn "
          "as borders")
      .standard("0, equal positions");
  group.add_flag("--merge-coplanar", request.merge_coplanar, "put coplanar neighbouring faces together into polygons");
}

LoadedModels load_models(const ModelRequest& request, bool quiet, RunFiles& files) {
  LoadedModels models = load_models(request);
  for (const ModelFile& file : models.files) {
    files.were_read(file.report.files);
    if (quiet) continue;
    warn(file.name, file.warnings);
    for (const std::string& remark : file.remarks) warn(file.name, remark);
  }
  return models;
}

}  // namespace ligne
