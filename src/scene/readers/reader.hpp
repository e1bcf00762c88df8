#pragma once
/// Reading of model files. The format is decided by content first, by suffix only where content does not decide.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/model_bytes.hpp"
#include "scene/readers/read_report.hpp"
#include "scene/subdivision/subdivide.hpp"

namespace ligne {

/// Products of five coordinates stay finite, which is more than any computation here multiplies; float32 files reach 3.4e38.
inline constexpr double kLargestCoordinate = 0x1p200;

struct ReadOptions {
  double weld_distance = 0;         ///< vertices so near to each other become one (model units); 0: those at one position
  bool merge_coplanar = false;      ///< put coplanar neighbouring faces together into polygons with holes
  bool groups = false;              ///< OBJ without objects: its groups are objects
  bool shading = false;             ///< mark the edges that the file calls smooth or sharp (creases/file_shading.hpp)
  std::optional<ScenePose> pose{};  ///< glTF: the moment of an animation; without it, the model as it stands
  std::optional<Subdivision> subdivision{};  ///< polygons are control meshes: their limit surfaces take their place
  std::function<bool(const Object&, std::size_t)> is_subdivided{};  ///< by object and number; none: all objects are
};

/// Format of the bytes, by content; `suffix` (".obj", any case, may be empty) decides between formats without a mark of
/// their own. Throws InputError("...: not a model file that is known ...").
ModelFormat detect_format(std::span<const std::byte> bytes, std::string_view suffix, const std::string& name);

/// Reads and cleans a file, or for "-" standard input. Throws InputError; adds to `warnings` what was mended.
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options, Warnings& warnings,
                 ReadReport* report = nullptr);

/// Reads a scene from memory.
Scene read_scene(const ModelBytes& file, ModelFormat format, const ReadOptions& options, Warnings& warnings,
                 ReadReport* report = nullptr);

/// Finishes a scene as it stands in its file: checks its coordinates, welds and cleans it. `name` stands in
/// error messages. Throws InputError. Adds to the report what was subdivided.
void clean_read_scene(Scene& scene, const std::string& name, const ReadOptions& options, Warnings& warnings,
                      ReadReport& report);

/// Puts scene `b` behind scene `a` (several models on one command line).
void append_scene(Scene& a, Scene&& b);

}  // namespace ligne
