#pragma once
/// Reads positions and indices of a glTF file.

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
  std::size_t stride = 0;  ///< distance between elements in bytes
  int component_type = 0;  ///< component type as numbered in glTF
};

/// An accessor whose bytes were checked to exist.
struct GltfAccessor {
  GltfElements elements;
  bool normalized = false;
  GltfElements sparse_indices, sparse_values;  ///< elements that replace others; count 0 if the accessor is not sparse
  std::string place;                           ///< "accessor 3"

  std::size_t count() const { return elements.count; }
  bool is_float() const;
  /// Distance of successive positions whose largest coordinate is given, if they are integers that stand for rounded
  /// coordinates; 0 if they are exact, or floats.
  double rounding_step(double largest) const;
};

/// Checks that an accessor holds positions (VEC3; float, or the integers of KHR_mesh_quantization) or indices (SCALAR;
/// unsigned integers), and that all its bytes are within their buffer, which is fetched. Throws InputError.
GltfAccessor position_accessor(GltfDocument& document, std::size_t accessor);
GltfAccessor index_accessor(GltfDocument& document, std::size_t accessor);

/// Writes the transformed positions. Returns the largest absolute coordinate before the transform. Throws InputError if
/// a coordinate is not finite.
double read_positions(const GltfDocument& document, const GltfAccessor& accessor, const glm::dmat4& transform,
                      std::span<Point3> out);

/// All numbers of an accessor whose elements have `components` components, element by element. Throws InputError if it
/// has another type, or a number is not finite.
std::vector<double> read_values(GltfDocument& document, std::size_t accessor, std::size_t components);

/// Writes first_vertex + index. Throws InputError if an index is not below vertex_count.
void read_indices(const GltfDocument& document, const GltfAccessor& accessor, std::uint32_t vertex_count,
                  std::uint32_t first_vertex, std::span<std::uint32_t> out);

}  // namespace ligne
