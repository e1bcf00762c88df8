#pragma once
/// Reader of STL, text and binary.

#include <cstddef>
#include <span>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Number of triangles that a binary STL file of these bytes claims; 0 when it is too short for a header.
std::size_t stl_triangle_count(std::span<const std::byte> bytes);
/// True when the size is that of a binary STL file with as many triangles as it claims. Its header may begin with "solid".
bool is_binary_stl(std::span<const std::byte> bytes);

/// Reads STL text: one object per `solid`, three vertices of their own per facet. Normals are not looked at. z up; not
/// cleaned yet. Throws InputError, with the line.
Scene read_stl_ascii(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

/// Reads binary STL as one object. Throws InputError when the size and the number of triangles disagree.
Scene read_stl_binary(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

}  // namespace ligne
