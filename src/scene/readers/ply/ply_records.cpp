#include "scene/readers/ply/ply_records.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.hpp"

namespace ligne {

std::string locate_triples(const PlyElement& element, const std::array<std::size_t, 3>& properties, PlyTriples& triples) {
  std::size_t& size = triples.records.size;
  size = 0;
  std::size_t found = 0;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list) return "its vertices have lists";
    for (std::size_t k = 0; k < 3; ++k) {
      if (properties[k] != p) continue;
      triples.fields[k] = {property.type, size};
      ++found;
    }
    size += byte_size(property.type);
  }
  return found == 3 ? "" : "its vertices have no coordinates";
}

std::optional<double> read_coordinates(const PlyTriples& triples, std::span<Point3> out) {
  const auto read_block = [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    bool finite = true;
    for (std::size_t i = begin; i < end; ++i) {
      const Point3 p = out[i] = triples.point(i);
      for (int k = 0; k < 3; ++k) {
        finite = finite && std::isfinite(p[k]);
        largest = std::max(largest, std::abs(p[k]));
      }
    }
    return finite ? largest : HUGE_VAL;
  };
  const auto larger = [](double a, double b) { return std::max(a, b); };
  const double largest = parallel_reduce(triples.records.count, kShortWorkBlock, 0.0, read_block, larger);
  return largest == HUGE_VAL ? std::nullopt : std::optional(largest);
}

std::uint32_t PlyTriangles::index_at(const std::byte* at, NumberType type, std::endian order) {
  const double index = load_number(at, type, order);
  return index >= 0 && index < double{kNone} && index == std::trunc(index) ? static_cast<std::uint32_t>(index) : kNone;
}

std::string locate_triangles(const PlyElement& element, std::size_t indices, PlyTriangles& triangles) {
  std::size_t& size = triangles.records.size;
  size = 0;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list != (p == indices)) return "its faces have lists other than vertex_indices";
    if (p == indices) {
      triangles.length = {property.count_type, size};
      size += byte_size(property.count_type);
      triangles.corners = {property.type, size};
    }
    size += (p == indices ? 3 : 1) * byte_size(property.type);
  }
  return indices < element.properties.size() ? "" : "its faces have no corners";
}

bool read_corners(const PlyTriangles& of, std::span<std::uint32_t> out) {
  std::atomic<bool> all{true};
  parallel_blocks(of.records.count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    const PlyTriangles triangles = of;  // stays in registers, whatever the loop writes
    for (std::size_t i = begin; i < end; ++i) {
      bool good = triangles.is_triangle(i);
      for (std::size_t k = 0; good && k < 3; ++k) good = (out[3 * i + k] = triangles.corner(i, k)) != kNone;
      if (good) continue;
      all.store(false, std::memory_order_relaxed);
      return;
    }
  });
  return all;
}

}  // namespace ligne
