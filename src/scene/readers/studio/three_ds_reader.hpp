#pragma once
/// Reader of 3D Studio's binary scenes (3DS).

#include <cstddef>
#include <span>
#include <string>

#include "scene/creases/file_shading.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Whether the file has 3D Studio's binary chunks: the first one, 0x4d4d, has the length of the file, or some bytes less.
bool is_3ds(std::span<const std::byte> bytes);

/// Reads the meshes, materials, lights and cameras of a binary 3D Studio file. An edge that is marked as not visible is
/// kCornerFileHidden, unless no edge of its mesh is visible. Meshes lie where they are stored; one that the keyframes
/// place several times, as instances, is placed as in the first frame. Smoothing groups go to `shading` unless it is
/// null. z up; not cleaned yet. Throws InputError with the byte.
Scene read_3ds(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings,
               FileShading* shading = nullptr);

}  // namespace ligne
