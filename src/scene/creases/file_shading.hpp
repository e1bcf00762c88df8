#pragma once
/// Smooth and sharp edges as a file declares them: by vertex normals, or by smoothing groups.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/clean/weld.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Packs a direction into 32 bits, ten per component, accurate to a tenth of a degree. Zero vectors and vectors that
/// are not finite give 0, which means no direction.
std::uint32_t packed_direction(const Point3& direction);
/// The direction of a packed value. Its components are integers, so it does not have unit length.
Point3 unpacked_direction(std::uint32_t packed);

/// The shading data that a reader finds. A list is empty if the file has no such data.
struct FileShading {
  std::vector<std::uint32_t> corner_normals;  ///< per corner: packed_direction() of its normal; 0: none
  std::vector<std::uint32_t> face_groups;     ///< per face: its smoothing groups; 0: none
  bool groups_are_bits = false;               ///< bits, one per group; false: the number of a single group
};

/// Sets kCornerSmooth or kCornerSharp at both corners of the edges that the file declares smooth or sharp. The scene
/// must be as read, before it is cleaned. Only edges of two faces count, where edges are found by equal positions.
/// - By normals: an edge is smooth if both faces have the same normal at one or both of its ends, else sharp. If both
///   faces have their own face normals at all these corners, they are shaded flat, and the edge is not marked.
/// - By groups, if a face has no normals: an edge is smooth if its faces have a group in common. It is sharp if at
///   least one of them is in a group and they have none in common.
///
/// If an object has no sharp edge, its writer may have averaged all normals without regard to its shape. Then only
/// edges with an angle below kAveragedDegrees are marked as smooth. Returns weld_vertices() of the scene, or nothing if the
/// file declares nothing.
std::optional<Weld> mark_smooth_edges(Scene& scene, const FileShading& shading);

}  // namespace ligne
