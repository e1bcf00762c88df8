#pragma once
/// Material libraries (MTL) of OBJ files.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Reads the materials of a library into `materials`, by name: `Kd` is their colour, `d` or `Tr` their opacity.
/// Textures and unknown words are left out and counted; words that only change the shine are skipped. Throws InputError
/// with the line for a word where a number is required.
void read_mtl(std::string_view text, const std::string& name, std::map<std::string, Material>& materials,
              Warnings& warnings);

/// Gives materials the properties that the libraries named by `mtllib` define for them. A library that is not in the
/// folder is counted as left out. Adds the files to `opened`.
void apply_libraries(const std::vector<std::string>& libraries, const std::filesystem::path& folder,
                     std::vector<Material>& materials, InputFiles& opened, Warnings& warnings);

}  // namespace ligne
