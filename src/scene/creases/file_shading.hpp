#pragma once
/// The edges over which a file says that its surfaces run smoothly: by normals, or by smoothing groups.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// A direction in 32 bits: three times ten, right to a tenth of a degree. Zero and what is not finite become 0, no
/// direction. Unpacked it has whole coordinates, and not the length 1.
std::uint32_t packed_direction(const Point3& direction);
Point3 unpacked_direction(std::uint32_t packed);

/// The findings of a reader. Empty where the file says nothing; otherwise one entry for each corner, or each face, of the
/// scene.
struct FileShading {
  std::vector<std::uint32_t> corner_normals;  ///< packed_direction(); 0: none
  std::vector<std::uint32_t> face_groups;     ///< smoothing groups of a face; 0: none
  bool groups_are_bits = false;               ///< a face may be in several groups, each a bit; otherwise in one, a number
};

/// Marks the edges of a scene, as read and not yet cleaned, of which its file speaks, with kCornerSmooth or kCornerSharp at
/// both of their corners. An edge has two faces, by equal positions, and
/// - by normals: it is smooth when both faces have the same normal at one of its ends or at both, else sharp. Where both
/// faces
///   have their own normals at all of these corners, they are shaded flat, and nothing is said;
/// - by groups, where a face has no normals: it is smooth when its faces have a group in common, and sharp when one of them
/// is in
///   a group and they have none in common.
/// An object without any sharp edge may be shaded smoothly by a writer that knows nothing of its shape: there only edges
/// that bend by less than kAveragedDegrees are smooth.
void mark_smooth_edges(Scene& scene, const FileShading& shading);

}  // namespace ligne
