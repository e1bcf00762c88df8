#pragma once
/// Reading the models of a command line into one scene.

#include <cstddef>
#include <string>
#include <vector>

#include "cli/run_files.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/reader.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct ModelOptions {
  std::vector<std::string> files;
  double weld_distance = 0;  ///< model units
  bool merge_coplanar = false;
};

void add_model_options(CLI::App& app, ModelOptions& options);

/// One file of the command line: what was in it, and what was mended.
struct ModelFile {
  std::string name;
  ReadReport report;
  Warnings warnings;
};

struct LoadedModels {
  Scene scene;  ///< all files, in the order of the command line; the first decides on the up axis
  std::vector<ModelFile> files;
};

/// Reads all files, and tells `files` of them. Throws InputError, UsageError. Unless `quiet`, writes one line per kind of
/// warning to standard error.
LoadedModels load_models(const ModelOptions& options, bool quiet, RunFiles& files);

/// Writes "ligne: PLACE: warning: TEXT" to standard error.
void warn(const std::string& place, const std::string& text);

}  // namespace ligne
