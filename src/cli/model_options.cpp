#include "cli/model_options.hpp"

#include "cli/messages.hpp"
#include "cli/options.hpp"
#include "cli/parse.hpp"
#include "files/message_text.hpp"

namespace ligne {

namespace {

std::optional<double> parse_weld(const std::string& text) {
  if (text == "auto") return std::nullopt;
  return text == "off" ? 0 : parse_positive(text);
}

}  // namespace

void add_model_options(CLI::App& app, ModelRequest& request) {
  add_arguments(app, "MODEL", request.files, true,
                "glTF, OBJ, STL, PLY, 3D Studio ASCII or ligne-scene file; several make one scene");
  OptionGroup group(app, "Lines");
  group
      .add(
          "--weld", "DIST", request.weld_distance, parse_weld,
          "borders of one object so near to each other (model units) are sewn: cracks would be drawn as borders; auto: as near "
          "as cracks are, off: none. With --quality exact: vertices so near become one, and auto is off")
      .standard("auto");
  group.add_flag("--merge-coplanar", request.merge_coplanar, "put coplanar neighbouring faces together into polygons");
}

Stage reading_of(const ModelRequest& request) {
  const std::string others = request.files.size() > 1 ? " and " + std::to_string(request.files.size() - 1) + " more" : "";
  return {"read", printable(request.files.front(), kLongestPath) + others};
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
