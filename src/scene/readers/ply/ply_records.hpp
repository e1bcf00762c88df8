#pragma once
/// Fast reading of binary PLY elements in which all items have the same size. Several threads read them in blocks.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/no_index.hpp"
#include "geometry/point.hpp"
#include "scene/readers/ply/ply_header.hpp"

namespace ligne {

/// A scalar value that every item has.
struct PlyField {
  NumberType type = NumberType::float32;
  std::size_t offset = 0;  ///< bytes from the start of the item
};

/// Items of equal size, one after the other from the start of `data`.
struct PlyRecords {
  std::span<const std::byte> data;
  std::endian order = std::endian::little;
  std::size_t count = 0, size = 0;  ///< number of items; bytes of one item

  /// Sets the number of items. False if the data end before the last one.
  bool take(std::uint64_t items) {
    count = static_cast<std::size_t>(items);
    return size > 0 && items <= data.size() / size;
  }
  const std::byte* item(std::size_t i) const { return data.data() + i * size; }
};

/// Three scalar properties of every item of an element, such as x, y and z of each vertex.
struct PlyTriples {
  PlyRecords records;
  std::array<PlyField, 3> fields;

  /// The values of an item; `shift` bytes are added to their offsets.
  Point3 point(std::size_t i, std::size_t shift = 0) const {
    Point3 p;
    for (int k = 0; k < 3; ++k) {
      const auto [type, offset] = fields[static_cast<std::size_t>(k)];
      const std::byte* const at = records.item(i) + offset + shift;
      p[k] = type == NumberType::float32 ? load_bytes<float>(at, records.order) : load_number(at, type, records.order);
    }
    return p;
  }
};
/// Sets the size of the items and the fields, which are three indices into `element.properties`. Returns an empty text, or
/// why the items have no such fields, as a phrase.
std::string locate_triples(const PlyElement& element, const std::array<std::size_t, 3>& properties, PlyTriples& triples);

/// Writes the three values of item i to out[i], and returns the largest absolute value. Returns nothing if a value is
/// not finite.
std::optional<double> read_coordinates(const PlyTriples& triples, std::span<Point3> out);

/// The items of a face element, on the assumption that each of its lists has three corners: only then all items have
/// the same size.
struct PlyTriangles {
  PlyRecords records;
  PlyField length, corners;  ///< of the list; its first corner, which the other two follow

  bool is_triangle(std::size_t i) const {
    const std::byte* const at = records.item(i) + length.offset;
    return length.type == NumberType::uint8 ? *at == std::byte{3} : load_number(at, length.type, records.order) == 3;
  }
  /// A corner of an item; kNone if it is not a whole number from 0 to kNone - 1.
  std::uint32_t corner(std::size_t i, std::size_t k) const {
    const std::byte* const first = records.item(i) + corners.offset;
    if (corners.type != NumberType::int32 && corners.type != NumberType::uint32)
      return index_at(first + k * byte_size(corners.type), corners.type, records.order);
    const auto index = load_bytes<std::uint32_t>(first + k * sizeof(std::uint32_t), records.order);
    return corners.type == NumberType::int32 && index > 0x7fffffffu ? kNone : index;
  }

 private:
  static std::uint32_t index_at(const std::byte* at, NumberType type, std::endian order);
};
/// Sets the size of the items and the fields. `indices` is the index of the list in `element.properties`. Returns an empty
/// text, or why the items have no such fields, as a phrase.
std::string locate_triangles(const PlyElement& element, std::size_t indices, PlyTriangles& triangles);

/// Writes the corners of item i to out[3 i] and the two elements after it. Returns false if an item has not three
/// corners, or if a corner is no index.
bool read_corners(const PlyTriangles& triangles, std::span<std::uint32_t> out);

}  // namespace ligne
