#pragma once
/// A reader's report on its file, in addition to the scene.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "scene/subdivision/subdivide.hpp"

namespace ligne {

enum class ModelFormat {
  gltf,
  glb,
  obj,
  stl_ascii,
  stl_binary,
  ply,
  asc_3d_studio,
  three_ds,
  off,
  three_mf,
  ligne_scene,
  ligne_tree
};

/// Name as shown to people, such as "glTF binary".
std::string_view to_string(ModelFormat format);

/// The contents of the file before cleaning.
struct ReadReport {
  ModelFormat format = ModelFormat::obj;
  std::size_t faces = 0;            ///< faces as stored, counted once per use
  std::size_t triangles = 0;        ///< after fan triangulation of every face as stored
  std::size_t vertices = 0;         ///< vertices as stored, before welding
  std::vector<std::string> groups;  ///< OBJ without objects: names of its groups
  SubdivisionReport subdivision{};  ///< the subdivision of control meshes, if requested
  InputFiles files;                 ///< opened or referred to: the model itself, and the buffers of a glTF
};

/// A moment of an animation of a file.
struct ScenePose {
  std::string animation;  ///< its name, or its number from 0
  double seconds = 0;
};

/// A model file in memory.
struct ModelBytes {
  std::span<const std::byte> bytes;
  std::string name;  ///< for error messages
  std::filesystem::path folder =
      {};  ///< the only folder in which files that the model refers to are looked up; empty: there are none
};

}  // namespace ligne
