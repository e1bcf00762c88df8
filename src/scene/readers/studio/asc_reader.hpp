#pragma once
/// Reader of 3D Studio's ASCII scenes.

#include <cstddef>
#include <span>
#include <string>

#include "scene/creases/file_shading.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads the tri-meshes, material names and lights of a 3D Studio ASCII file (`Named object:`, `Tri-mesh, Vertices: n
/// Faces: m`). An edge flag AB, BC or CA of 0 marks the edge as kCornerFileHidden. Cameras and page headings are left
/// out. z up; not cleaned yet. Throws InputError with the line. Smoothing groups go to `shading` unless it is null.
Scene read_asc(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings,
               FileShading* shading = nullptr);

}  // namespace ligne
