#pragma once
/// Reader of OFF (Object File Format).

#include <cstddef>
#include <span>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Whether a text begins with the format's word: OFF, or one with letters for the properties of vertices, such as COFF.
bool is_off_word(std::string_view word);

/// Reads OFF text: polygons, and their colours as materials. Normals, colours and texture coordinates of vertices are
/// skipped. z up; not cleaned yet. Throws InputError with the line, and for binary files and other dimensions.
Scene read_off(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

}  // namespace ligne
