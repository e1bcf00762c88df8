#pragma once
/// Reader of our own scene format, docs/scene-format.md.

#include <cstddef>
#include <span>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Reads a JSON scene of `"format": "ligne-scene", "version": 1`; not cleaned yet. Unknown keys are errors. Throws
/// InputError with the place: "objects[2].faces[5].outer[1]: vertex 99 of 8".
Scene read_ligne_scene(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

}  // namespace ligne
