#pragma once
/// Reader of PLY, text and binary.

#include <cstddef>
#include <span>
#include <string>

#include "scene/creases/file_shading.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads the elements `vertex` (x, y, z of any type) and `face` (list vertex_indices or vertex_index) as one object.
/// Faces may have any number of corners; other elements and properties are skipped. z up; not cleaned yet. Throws
/// InputError, with the line for text. Normals (nx, ny, nz) go to `shading` unless it is null.
Scene read_ply(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings,
               FileShading* shading = nullptr);

}  // namespace ligne
