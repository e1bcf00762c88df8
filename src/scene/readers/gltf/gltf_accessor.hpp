#pragma once
/// Positions and indices of a glTF file.

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/readers/gltf/gltf_document.hpp"

namespace ligne {

/// Elements in the bytes of a buffer.
struct GltfElements {
  const std::byte* data = nullptr;  ///< nullptr: zeros
  std::size_t count = 0;
  std::size_t stride = 0;  ///< bytes from one element to the next
  int component_type = 0;  ///< glTF's number
};

/// An accessor whose bytes are known to be there.
struct GltfAccessor {
  GltfElements elements;
  bool normalized = false;
  GltfElements sparse_indices, sparse_values;  ///< elements that replace others; count 0 when the accessor is not sparse
  std::string place;                           ///< "accessor 3"

  std::size_t count() const { return elements.count; }
  bool is_float() const;
};

/// Checks that an accessor holds positions (VEC3; float, or the integers of KHR_mesh_quantization) or indices (SCALAR;
/// unsigned integers), and that all its bytes lie in their buffer, which is fetched. Throws InputError.
GltfAccessor position_accessor(GltfDocument& document, std::size_t accessor);
GltfAccessor index_accessor(GltfDocument& document, std::size_t accessor);

/// Writes the positions, transformed. Returns the largest coordinate, without sign, before the transform. Throws InputError
/// when one is not finite.
double read_positions(const GltfDocument& document, const GltfAccessor& accessor, const glm::dmat4& transform,
                      std::span<Point3> out);

/// All numbers of an accessor whose elements have so many components, element by element. Throws InputError when its type is
/// another, or a number is not finite.
std::vector<double> read_values(GltfDocument& document, std::size_t accessor, std::size_t components);

/// Writes first_vertex + index. Throws InputError when an index is not below vertex_count.
void read_indices(const GltfDocument& document, const GltfAccessor& accessor, std::uint32_t vertex_count,
                  std::uint32_t first_vertex, std::span<std::uint32_t> out);

}  // namespace ligne
