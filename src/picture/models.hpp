#pragma once
/// Several model files read into one scene.

#include <optional>
#include <string>
#include <vector>

#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/heal/heal.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {

struct ModelRequest {
  std::vector<std::string> files;
  /// Clear lines: borders of one object that lie so near to each other are sewn, model units; nothing: what is a crack is
  /// found out; 0: none. Exact lines: vertices of one object so near to each other become one; nothing: at equal positions.
  std::optional<double> weld_distance{};
  bool merge_coplanar = false;  ///< put coplanar neighbouring faces together into polygons
  Quality quality = Quality::clear;
};

/// One of the files: what was in it, and what was mended.
struct ModelFile {
  std::string name;
  ReadReport report;
  Warnings warnings;
  std::vector<std::string> remarks{};  ///< how it goes together with the others
  HealReport healed{};                 ///< clear lines: what was found and done
};

struct LoadedModels {
  Scene scene;  ///< all files, in the order of the request; the first decides on the up axis
  std::vector<ModelFile> files;
  std::optional<Topology> topology;  ///< of the scene, where it is known already
};

/// Reads all files. Throws InputError.
LoadedModels load_models(const ModelRequest& request);

/// Puts what was healed into the figures of clear lines, and where it is much, and nobody asked for it, into a warning for
/// each file.
void report_healing(const LoadedModels& models, const ModelRequest& request, RunReport& run);

}  // namespace ligne
