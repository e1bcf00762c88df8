#pragma once
/// The elements of binary PLY files whose items have one size each, read in blocks by several threads.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "geometry/point.hpp"
#include "scene/readers/ply/ply_header.hpp"

namespace ligne {

/// A value of every item: its type, and its place in the item.
struct PlyField {
  PlyType type = PlyType::float32;
  std::size_t offset = 0;
};

/// Items one after the other from the front of `data`.
struct PlyRecords {
  std::span<const std::byte> data;
  std::endian order = std::endian::native;
  std::size_t count = 0, size = 0;  ///< of items; of an item, in bytes
};

/// Three values of each item of an element without lists, by their properties.
struct PlyTriples {
  PlyRecords records;
  std::array<PlyField, 3> fields;
};
/// Nothing where the element has lists, or the data end before its last item.
std::optional<PlyTriples> ply_triples(std::span<const std::byte> data, std::endian order, const PlyElement& element,
                                      const std::array<std::size_t, 3>& properties);

/// Puts the values of all items into `out`. Gives the largest of their sizes; nothing when one is not finite.
std::optional<double> read_coordinates(const PlyTriples& triples, std::span<Point3> out);

/// The items of an element with the one list `indices`, as far as it may have three corners in each item.
struct PlyTriangles {
  PlyRecords records;
  PlyField length, corners;
};
/// Nothing where the element has other lists, the first list is not one of three, or the data end before the last item.
std::optional<PlyTriangles> ply_triangles(std::span<const std::byte> data, std::endian order, const PlyElement& element,
                                          std::size_t indices);

/// Puts the corners of all items into `out`; false when an item has not three, or a corner is no whole number below kNone.
bool read_corners(const PlyTriangles& triangles, std::span<std::uint32_t> out);

}  // namespace ligne
