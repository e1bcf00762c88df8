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

/// Reads the materials of a library into `materials`, by name: `Kd` is their colour, `d` or `Tr` their opacity. Textures and
/// words that are not known are left out and counted; what only changes how a material shines is passed over. Throws
/// InputError, with the line, where a number is none.
void read_mtl(std::string_view text, const std::string& name, std::map<std::string, Material>& materials,
              Warnings& warnings);

/// Gives materials what the libraries, as `mtllib` names them, say of their names. A library that is not in the folder is
/// counted as left out. Adds the files to `opened`.
void apply_libraries(const std::vector<std::string>& libraries, const std::filesystem::path& folder,
                     std::vector<Material>& materials, InputFiles& opened, Warnings& warnings);

}  // namespace ligne
