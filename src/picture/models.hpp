#pragma once
/// Several model files read into one scene.

#include <string>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {

struct ModelRequest {
  std::vector<std::string> files;
  double weld_distance = 0;     ///< vertices of one object so near to each other become one, model units
  bool merge_coplanar = false;  ///< put coplanar neighbouring faces together into polygons
};

/// One of the files: what was in it, and what was mended.
struct ModelFile {
  std::string name;
  ReadReport report;
  Warnings warnings;
  std::vector<std::string> remarks{};  ///< how it goes together with the others
};

struct LoadedModels {
  Scene scene;  ///< all files, in the order of the request; the first decides on the up axis
  std::vector<ModelFile> files;
};

/// Reads all files. Throws InputError.
LoadedModels load_models(const ModelRequest& request);

}  // namespace ligne
