#include "scene/readers/ply/ply_records.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/polygon_faces.hpp"
#include "scene/readers/load_bytes.hpp"

namespace ligne {
namespace {

bool fit(const PlyElement& element, std::size_t size, std::span<const std::byte> data) {
  return size > 0 && element.count < kNone && element.count <= data.size() / size;
}

/// The bits of a corner; nothing if they are not an index.
std::optional<std::uint32_t> load_index(const std::byte* at, NumberType type, std::endian order) {
  if (type == NumberType::int32 || type == NumberType::uint32) {
    const auto index = load_bytes<std::uint32_t>(at, order);
    if (index == kNone || (type == NumberType::int32 && index > 0x7fffffffu)) return std::nullopt;
    return index;
  }
  const double index = load_number(at, type, order);
  if (!(index >= 0 && index < double{kNone} && index == std::trunc(index))) return std::nullopt;
  return static_cast<std::uint32_t>(index);
}

}  // namespace

std::optional<PlyTriples> ply_triples(std::span<const std::byte> data, std::endian order, const PlyElement& element,
                                      const std::array<std::size_t, 3>& properties) {
  PlyTriples triples;
  std::size_t size = 0;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) {
      if (properties[k] == p) triples.fields[k] = {property.type, size};
    }
    size += byte_size(property.type);
  }
  if (!fit(element, size, data)) return std::nullopt;
  triples.records = {data, order, static_cast<std::size_t>(element.count), size};
  return triples;
}

std::optional<double> read_coordinates(const PlyTriples& triples, std::span<Point3> out) {
  const PlyRecords& records = triples.records;
  const auto read_block = [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    bool finite = true;
    for (std::size_t i = begin; i < end; ++i) {
      const std::byte* const item = records.data.data() + i * records.size;
      for (int k = 0; k < 3; ++k) {
        const auto [type, offset] = triples.fields[static_cast<std::size_t>(k)];
        const double value = type == NumberType::float32 ? load_bytes<float>(item + offset, records.order)
                                                         : load_number(item + offset, type, records.order);
        finite = finite && std::isfinite(value);
        largest = std::max(largest, std::abs(value));
        out[i][k] = value;
      }
    }
    return finite ? largest : HUGE_VAL;
  };
  const auto larger = [](double a, double b) { return std::max(a, b); };
  const double largest = parallel_reduce(records.count, kShortWorkBlock, 0.0, read_block, larger);
  return largest == HUGE_VAL ? std::nullopt : std::optional(largest);
}

std::optional<PlyTriangles> ply_triangles(std::span<const std::byte> data, std::endian order, const PlyElement& element,
                                          std::size_t indices) {
  PlyTriangles triangles;
  std::size_t size = 0;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list != (p == indices)) return std::nullopt;
    if (p == indices) {
      triangles.length = {property.count_type, size};
      size += byte_size(property.count_type);
      triangles.corners = {property.type, size};
      size += 3 * byte_size(property.type);
    } else {
      size += byte_size(property.type);
    }
  }
  if (element.count == 0 || !fit(element, size, data)) return std::nullopt;
  if (load_number(data.data() + triangles.length.offset, triangles.length.type, order) != 3) return std::nullopt;
  triangles.records = {data, order, static_cast<std::size_t>(element.count), size};
  return triangles;
}

bool read_corners(const PlyTriangles& triangles, std::span<std::uint32_t> out) {
  const PlyRecords& records = triangles.records;
  const PlyField length = triangles.length, corners = triangles.corners;
  const std::size_t step = byte_size(corners.type);
  std::atomic<bool> all{true};
  parallel_blocks(records.count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::byte* const item = records.data.data() + i * records.size;
      bool good = load_number(item + length.offset, length.type, records.order) == 3;
      for (std::size_t k = 0; good && k < 3; ++k) {
        const auto index = load_index(item + corners.offset + k * step, corners.type, records.order);
        good = index.has_value();
        if (good) out[3 * i + k] = *index;
      }
      if (good) continue;
      all.store(false, std::memory_order_relaxed);
      return;
    }
  });
  return all;
}

}  // namespace ligne
