#pragma once
/// Reading of model files. The format is decided by content first, by suffix only where content does not decide.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

enum class ModelFormat { gltf, glb, obj, stl_ascii, stl_binary, ply, asc_3d_studio, ligne_scene, ligne_tree };

/// Products of five coordinates stay finite, which is more than any computation here multiplies; float32 files reach 3.4e38.
inline constexpr double kLargestCoordinate = 0x1p200;

/// Name as shown to people, "glTF binary" and the like.
std::string_view to_string(ModelFormat format);

struct ReadOptions {
  double weld_distance = 0;     ///< vertices so near to each other become one (model units); 0: those at one position
  bool merge_coplanar = false;  ///< put coplanar neighbouring faces together into polygons with holes
  bool groups = false;          ///< OBJ without objects: its groups are objects
  bool shading = false;         ///< mark the edges that the file calls smooth or sharp (creases/file_shading.hpp)
};

/// What was in the file, before cleaning.
struct ReadReport {
  ModelFormat format = ModelFormat::obj;
  std::size_t faces = 0;            ///< faces as stored, counted once per use
  std::size_t triangles = 0;        ///< after fan triangulation of every face as stored
  std::size_t vertices = 0;         ///< vertices as stored, before welding
  std::vector<std::string> groups;  ///< OBJ without objects: names of its groups
  InputFiles files;                 ///< opened or named: the model itself, and the buffers of a glTF
};

/// Format of the bytes, by content; `suffix` (".obj", any case, may be empty) decides between formats without a mark of
/// their own. Throws InputError("...: not a model file that is known ...").
ModelFormat detect_format(std::span<const std::byte> bytes, std::string_view suffix, const std::string& name);

/// Reads one model file and cleans it (scene/clean.hpp). Throws InputError; adds to `warnings` what was mended.
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options, Warnings& warnings,
                 ReadReport* report = nullptr);

/// The same from memory. Files that the model names (glTF buffers) are looked up in `folder`; an empty folder means there
/// are none. `name` stands in error messages.
Scene read_scene(std::span<const std::byte> bytes, ModelFormat format, const std::filesystem::path& folder,
                 const std::string& name, const ReadOptions& options, Warnings& warnings, ReadReport* report = nullptr);

/// What reading does with a scene as it stands in its file: checks its coordinates, welds and cleans it. `name` stands in
/// error messages. Throws InputError.
void clean_read_scene(Scene& scene, const std::string& name, const ReadOptions& options, Warnings& warnings);

/// Puts scene `b` behind scene `a` (several models on one command line).
void append_scene(Scene& a, Scene&& b);

}  // namespace ligne
