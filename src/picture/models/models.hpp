#pragma once
/// Reads model files into one scene.

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

/// A displacement of the objects whose names fit a pattern: `units` model units plus `mm` millimetres of true length.
struct PartMove {
  std::string pattern;
  Point3 units{0, 0, 0}, mm{0, 0, 0};
};

/// Selection and displacement of objects by patterns of their names (name_fits() in scene/clean/named_objects.hpp).
struct PartRequest {
  std::vector<std::string> only;  ///< objects to draw; empty: all
  std::vector<std::string> hide;  ///< objects to omit
  std::vector<PartMove> moves;    ///< an object moves by the sum of all moves that fit it

  bool is_requested() const { return !only.empty() || !hide.empty() || !moves.empty(); }
};

struct ModelRequest {
  std::vector<std::string> files;
  PartRequest parts{};
  bool tell_parts = false;          ///< the picture distinguishes objects: groups of an OBJ may be objects
  std::optional<double> unit_mm{};  ///< true length of a model unit in mm; none: as in the first file
  /// A distance in model units. For clear lines, borders of one object within this distance are sewn; none: the width
  /// of cracks is detected; 0: no border is sewn. For exact lines, vertices of one object within this distance are
  /// welded; none: only vertices at equal positions.
  std::optional<double> weld_distance{};
  bool merge_coplanar = false;      ///< merge adjacent coplanar faces into polygons
  std::optional<ScenePose> pose{};  ///< the moment of an animation of glTF files
  Quality quality = Quality::clear;
  /// If set, polygons are control meshes, and their limit surfaces are drawn.
  std::optional<Subdivision> subdivision{};
  StatedFacts assumed{};  ///< facts that the user states in addition to those of the files; without planes
  bool shading = true;    ///< clear lines: read the smooth and sharp edges of the file, since creases are requested
};

/// A report on one of the files: its contents, and the repairs.
struct ModelFile {
  std::string name;
  ReadReport report;
  Warnings warnings;
  std::vector<std::string> remarks{};  ///< about its combination with the other files, such as different units
  HealReport healed{};                 ///< clear lines: faults found and repaired
};

struct LoadedModels {
  Scene scene;  ///< the objects of all files, in the order of the request; the up axis is that of the first file
  std::vector<ModelFile> files;
  std::optional<Topology> topology;                 ///< of the scene, if it was built already
  std::vector<std::string> object_names;            ///< of all files, also of objects that are not drawn
  std::shared_ptr<const CompiledScene> compiled{};  ///< tree of a compiled model, which is the only file; else nullptr
  const Method* compiled_for = nullptr;             ///< the method that made the tree
};

/// The name of the compiled model in the request, or null if there is none. Throws RequestError if the request has a
/// further file, or an option that would change the model.
const std::string* compiled_file(const ModelRequest& request);

/// Reads all files. Objects are omitted and moved before anything is repaired. Throws InputError; throws RequestError
/// if no object fits a pattern, or if none is left.
LoadedModels load_models(const ModelRequest& request);

/// Like load_models(), for a scene in memory that was not cleaned yet. `name` is for messages.
LoadedModels load_model(const ModelRequest& request, Scene scene, const std::string& name);

/// Throws RequestError for that option if no object fits one of the patterns.
void require_names(const LoadedModels& models, const std::string& option, const std::vector<std::string>& patterns);

/// Throws RequestError if the picture has colours or pens for objects or materials that do not exist.
void require_parts(const LoadedModels& models, const PictureRequest& picture);

/// Throws RequestError if one of the named options of the method would have to be given to `ligne compile`, since it
/// changes the tree of the compiled model.
void require_no_parameters(const LoadedModels& models, const std::vector<std::string>& names);

/// Adds the repairs of healing to RunReport::clear. Warns once per file if there are many and the user did not ask for
/// them.
void report_healing(const LoadedModels& models, const ModelRequest& request, RunReport& run);

}  // namespace ligne
