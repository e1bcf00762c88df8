#pragma once
/// Several model files read into one scene.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/heal/heal.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"
#include "scene/subdivision/subdivide.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Objects of that name moved by `units` model units and `mm` of true length.
struct PartMove {
  std::string pattern;
  Point3 units{0, 0, 0}, mm{0, 0, 0};
};

/// Which objects are drawn, by their names (name_fits() in scene/clean/named_objects.hpp), and where.
struct PartRequest {
  std::vector<std::string> only;  ///< empty: all
  std::vector<std::string> hide;
  std::vector<PartMove> moves;  ///< all that fit add up

  bool asked() const { return !only.empty() || !hide.empty() || !moves.empty(); }
};

struct ModelRequest {
  std::vector<std::string> files;
  PartRequest parts{};
  bool tell_parts = false;          ///< parts are told apart in the picture: so are the groups of an OBJ without objects
  std::optional<double> unit_mm{};  ///< true length of a model unit; nothing: the first scene's
  /// Clear lines: borders of one object that lie so near to each other are sewn, model units; nothing: what is a crack is
  /// found out; 0: none. Exact lines: vertices of one object so near to each other become one; nothing: at equal positions.
  std::optional<double> weld_distance{};
  bool merge_coplanar = false;      ///< put coplanar neighbouring faces together into polygons
  std::optional<ScenePose> pose{};  ///< the moment of an animation of glTF files
  Quality quality = Quality::clear;
  std::optional<Subdivision> subdivision{};  ///< polygons are control meshes: their limit surfaces are drawn
  bool shading = true;  ///< clear lines: creases are asked for, so what a file says of smooth and sharp edges counts
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
  std::optional<Topology> topology;                 ///< of the scene, where it is known already
  std::vector<std::string> object_names;            ///< of all files, also of objects that are not drawn
  std::shared_ptr<const CompiledScene> compiled{};  ///< of a file of `ligne compile`, which stands alone; else nullptr
  const Method* compiled_for = nullptr;
};

/// The file that was compiled, where the request names one. Throws RequestError where something else is asked for that
/// would change its model.
const std::string* compiled_file(const ModelRequest& request);

/// Reads all files; what is hidden is left out and what is moved is moved before anything is mended. Throws InputError, and
/// RequestError where no object has a name, or none is left.
LoadedModels load_models(const ModelRequest& request);

/// Loads a scene in memory that is as it would stand in a file; `name` stands in messages.
LoadedModels load_model(const ModelRequest& request, Scene scene, const std::string& name);

/// Throws RequestError of that option where no object fits one of the patterns.
void require_names(const LoadedModels& models, const std::string& option, const std::vector<std::string>& patterns);

/// Throws RequestError where the picture has colours or pens for objects or materials that are not there.
void require_parts(const LoadedModels& models, const PictureRequest& picture);

/// A compiled model keeps what it was compiled with: throws RequestError where one of the method's own options, by their
/// names, is one of `ligne compile`.
void require_no_parameters(const LoadedModels& models, const std::vector<std::string>& names);

/// Puts what was healed into the figures of clear lines, and where it is much, and nobody asked for it, into a warning for
/// each file.
void report_healing(const LoadedModels& models, const ModelRequest& request, RunReport& run);

}  // namespace ligne
