#pragma once
/// Reader of STL, text and binary.

#include <cstddef>
#include <span>
#include <string>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Number of triangles in the header of a binary STL file; 0 if it is too short for a header.
std::size_t stl_triangle_count(std::span<const std::byte> bytes);
/// Whether the size is that of a binary STL file with the number of triangles in its header, which may begin with
/// "solid".
bool is_binary_stl(std::span<const std::byte> bytes);

/// Reads STL text: one object per `solid`, three separate vertices per facet. Normals are ignored. z up; not cleaned
/// yet. Throws InputError with the line.
Scene read_stl_ascii(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

/// Reads binary STL as one object. Bytes behind the triangles are left out; a number of 0 or 0xFFFFFFFF stands for as many
/// as the file holds. Throws InputError if the file is shorter than its number of triangles says, or if the number does not
/// fit and the coordinates show that the bytes are no triangles.
Scene read_stl_binary(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings);

}  // namespace ligne
