#pragma once
/// Reads model files. The content decides the format; the suffix decides only if the content does not.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"
#include "scene/subdivision/subdivide.hpp"

namespace ligne {

/// Largest absolute coordinate: products of five coordinates stay finite, more than any computation multiplies. float32
/// files reach 3.4e38.
inline constexpr double kLargestCoordinate = 0x1p200;

struct ReadOptions {
  double weld_distance = 0;         ///< vertices this close are merged, model units; 0: only those at one position
  bool merge_coplanar = false;      ///< merge coplanar neighbouring faces into polygons with holes
  bool groups = false;              ///< OBJ without objects: its groups are objects
  bool shading = false;             ///< mark the edges that the file calls smooth or sharp (creases/file_shading.hpp)
  std::optional<ScenePose> pose{};  ///< glTF: the moment of an animation; nothing: the model as stored
  std::optional<Subdivision> subdivision{};  ///< replace polygons, as control meshes, by their limit surfaces
  std::function<bool(const Object&, std::size_t)> is_subdivided{};  ///< by object and its number; empty: all objects
};

/// The format of the bytes. Content decides first; `suffix` (".obj", any case, may be empty) decides between formats
/// without a magic number. Throws InputError("...: not a model file that is known ...").
ModelFormat detect_format(std::span<const std::byte> bytes, std::string_view suffix, const std::string& name);

/// Reads and cleans a file, or standard input for "-". Throws InputError; adds repairs to `warnings`.
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options, Warnings& warnings,
                 ReadReport* report = nullptr);

/// Reads a scene from memory.
Scene read_scene(const ModelBytes& file, ModelFormat format, const ReadOptions& options, Warnings& warnings,
                 ReadReport* report = nullptr);

/// Finishes a scene that was read: checks its coordinates, welds and cleans it. `name` is used in error messages.
/// Throws InputError. Adds subdivisions to the report.
void clean_read_scene(Scene& scene, const std::string& name, const ReadOptions& options, Warnings& warnings,
                      ReadReport& report);

/// Appends scene `b` to scene `a` (several models on one command line).
void append_scene(Scene& a, Scene&& b);

}  // namespace ligne
