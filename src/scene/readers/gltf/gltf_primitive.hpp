#pragma once
/// Triangles of a mesh of a glTF file.

#include <cstddef>
#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/no_index.hpp"
#include "scene/readers/gltf/gltf_accessor.hpp"
#include "scene/readers/gltf/gltf_deform.hpp"
#include "scene/readers/gltf/gltf_draco.hpp"

namespace ligne {

/// A primitive whose data were checked to exist.
struct GltfPrimitive {
  std::size_t position_accessor = 0;
  GltfAccessor positions{};               ///< unused with Draco
  std::optional<GltfAccessor> indices{};  ///< without: the positions in order
  std::optional<GltfAccessor> normals{};  ///< one per position, if requested
  const DracoMesh* draco = nullptr;
  GltfDeformation deformation{};
  int mode = TINYGLTF_MODE_TRIANGLES;
  int material = -1;
  int coordinate_accessor = -1;  ///< of the texture of the base colour, if it is a palette

  std::size_t vertex_count() const { return draco ? draco->positions.size() : positions.count(); }
  std::size_t corner_count() const { return draco ? draco->corners.size() : indices ? indices->count() : positions.count(); }
  std::size_t triangle_count() const {
    const std::size_t n = corner_count();
    if (draco || mode == TINYGLTF_MODE_TRIANGLES) return n / 3;
    return n < 3 ? 0 : n - 2;
  }
  /// Whether the primitive has its own vertices. Consecutive primitives often share their positions: `last_positions` is
  /// the previous accessor, kNone at first.
  bool has_own_vertices(std::size_t& last_positions) const {
    const bool alone = draco || deformation.any();
    const bool own = alone || position_accessor != last_positions;
    last_positions = alone ? kNone : position_accessor;
    return own;
  }
  /// Whether the normals of an instance are known.
  bool has_normals(const glm::dmat4& to_world) const {
    return normals && (deformation.any() || glm::determinant(glm::dmat3(to_world)) != 0);
  }
};

/// An instance of a primitive in the scene.
struct GltfPart {
  const GltfPrimitive* primitive;
  std::uint32_t first_face, first_vertex;
};

}  // namespace ligne
