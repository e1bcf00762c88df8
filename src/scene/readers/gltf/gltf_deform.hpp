#pragma once
/// Morph targets and skins: the positions of a primitive's vertices for an instance of its mesh.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "geometry/point.hpp"
#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/gltf/gltf_draco.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Data of a primitive's vertices in addition to their positions.
struct GltfDeformation {
  std::vector<std::map<std::string, int>> targets;  ///< accessors, by POSITION and NORMAL
  std::vector<double> joints, weights;              ///< `per_vertex` of each per vertex; empty without a skin
  std::size_t per_vertex = 0;

  bool any() const { return !targets.empty() || !joints.empty(); }
};

/// Reads joints and weights of a primitive of `vertex_count` vertices, and its targets. `draco` is its compressed mesh,
/// or null. Throws InputError.
GltfDeformation read_deformation(GltfDocument& document, const tinygltf::Primitive& primitive, std::size_t vertex_count,
                                 const DracoMesh* draco);

/// The matrices of a skin's joints from the bind pose to the world: world matrix of the joint times its inverse bind
/// matrix (glTF 2.0, section 3.7.3.1).
std::vector<glm::dmat4> joint_matrices(GltfDocument& document, const GltfNodes& nodes, std::size_t skin);

/// Deforms an instance of a primitive.
class GltfDeformer {
 public:
  /// `weights` are those of the targets. `joints` is empty if the node has no skin; then `to_world` applies. Throws
  /// InputError if a vertex refers to a joint that the skin does not have.
  GltfDeformer(GltfDocument& document, const GltfDeformation& deformation, std::span<const double> weights,
               std::span<const glm::dmat4> joints, const glm::dmat4& to_world);

  /// Moves stored positions into the world. Returns the largest absolute coordinate before the last transform.
  double move_positions(std::span<Point3> positions);
  /// Turns stored normals of any length.
  void turn_normals(std::span<Point3> normals);

 private:
  /// Adds the differences of the targets to an attribute.
  void add_targets(const char* attribute, std::span<Point3> values);
  /// The transform of a vertex.
  glm::dmat4 transform(std::size_t vertex) const;

  GltfDocument& document_;
  const GltfDeformation& deformation_;
  std::span<const double> weights_;
  std::span<const glm::dmat4> joints_;
  glm::dmat4 to_world_;
};

/// Applies a moment of an animation of a glTF file.

/// Sets the translations, rotations, scales and weights of the nodes at that time. Before the first key of a channel
/// its first value applies, after the last key its last value. Throws InputError if the file has no such animation.
/// Source: Khronos glTF 2.0, section 3.11 and appendix C.
void apply_pose(GltfDocument& document, const ScenePose& pose);

}  // namespace ligne
