#pragma once
/// The header of a PLY file (G. Turk, "The PLY Polygon File Format", 1994).

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/readers/load_bytes.hpp"

namespace ligne {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  NumberType type = NumberType::float32;
  bool is_list = false;
  NumberType count_type = NumberType::uint8;  ///< type of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Index of the first property with one of the names, or properties.size().
  std::size_t find(std::initializer_list<const char*> names) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> remarks;  ///< first words of lines before the first element that are not statements
  std::size_t bytes = 0;             ///< start of the data
  std::size_t lines = 0;             ///< number of lines of the header; the first line of data is lines + 1
};

/// Throws InputError with the line. Lines end like the line 'ply'. Some writers put a remark after the format without
/// the word "comment". After the first element any other line may be a mistyped statement, and is refused.
PlyHeader read_ply_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace ligne
