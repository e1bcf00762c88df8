#pragma once
/// Fast reading of binary PLY elements in which all items have the same size. Several threads read them in blocks.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

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
  std::endian order = std::endian::native;
  std::size_t count = 0, size = 0;  ///< number of items; bytes of one item
};

/// Three scalar properties of every item of an element, such as x, y and z of each vertex.
struct PlyTriples {
  PlyRecords records;
  std::array<PlyField, 3> fields;
};
/// Locates three properties in the items of an element. `data` starts at the first item; `properties` are three indices
/// into `element.properties`. Returns nothing if the element has lists or the data end before its last item.
std::optional<PlyTriples> ply_triples(std::span<const std::byte> data, std::endian order, const PlyElement& element,
                                      const std::array<std::size_t, 3>& properties);

/// Writes the three values of item i to out[i], and returns the largest absolute value. Returns nothing if a value is
/// not finite.
std::optional<double> read_coordinates(const PlyTriples& triples, std::span<Point3> out);

/// The items of a face element, on the assumption that each of its lists has three corners: only then all items have
/// the same size. read_corners() checks the assumption.
struct PlyTriangles {
  PlyRecords records;
  PlyField length, corners;  ///< of the list; its first corner, which the other two follow
};
/// Locates the corner lists in the items of an element. `indices` is the index of the list in `element.properties`.
/// Returns nothing if the element has further lists or no item, if the first item has not three corners, or if the data
/// end before the last item.
std::optional<PlyTriangles> ply_triangles(std::span<const std::byte> data, std::endian order, const PlyElement& element,
                                          std::size_t indices);

/// Writes the corners of item i to out[3 i] and the two elements after it. Returns false if an item has not three
/// corners, or if a corner is not a whole number from 0 to kNone - 1.
bool read_corners(const PlyTriangles& triangles, std::span<std::uint32_t> out);

}  // namespace ligne
