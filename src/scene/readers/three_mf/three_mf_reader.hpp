#pragma once
/// Reader of 3MF.

#include <cstddef>
#include <span>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

class ZipArchive;

/// Whether an archive holds a 3MF model.
bool is_three_mf(const ZipArchive& archive);

/// Reads the build of a 3MF file: meshes and components with their transforms, including other parts of the archive
/// (production extension); base materials and colour groups as materials. Supports, textures and unknown elements are
/// left out and counted. z up, with the unit of the file; not cleaned yet. Throws InputError.
/// Source: 3MF Consortium, Core Specification 1.3, Materials and Properties 1.2, Production Extension 1.1.
Scene read_three_mf(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

}  // namespace ligne
