#pragma once
/// Morph targets and skins: where the vertices of a primitive are for an instance of its mesh.

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/gltf/gltf_draco.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"

namespace ligne {

/// The data of a primitive's vertices beside their positions.
struct GltfDeformation {
  std::vector<std::map<std::string, int>> targets;  ///< accessors by POSITION and NORMAL
  std::vector<double> joints, weights;              ///< `per_vertex` of each for every vertex; empty without a skin
  std::size_t per_vertex = 0;

  bool any() const { return !targets.empty() || !joints.empty(); }
};

/// Reads joints and weights of a primitive of `vertex_count` vertices, and takes its targets; `draco` is its compressed
/// mesh, or nullptr. Throws InputError.
GltfDeformation read_deformation(GltfDocument& document, const tinygltf::Primitive& primitive, std::size_t vertex_count,
                                 const DracoMesh* draco);

/// The matrices of a skin's joints, from the bind pose to the world: world matrix of the joint times its inverse bind matrix
/// (glTF 2.0, section 3.7.3.1).
std::vector<glm::dmat4> joint_matrices(GltfDocument& document, const GltfNodes& nodes, std::size_t skin);

/// An instance of a primitive that is deformed.
class GltfDeformer {
 public:
  /// `weights` are those of the targets; `joints` is empty where the node has no skin, and then `to_world` counts. Throws
  /// InputError when a vertex names a joint that the skin does not have.
  GltfDeformer(GltfDocument& document, const GltfDeformation& deformation, std::span<const double> weights,
               std::span<const glm::dmat4> joints, const glm::dmat4& to_world);

  /// Moves positions as stored into the world. Returns the largest coordinate, without sign, before the last transform.
  double move_positions(std::span<Point3> positions);
  /// Turns normals as stored, of any length.
  void turn_normals(std::span<Point3> normals);

 private:
  /// Adds the targets' differences of an attribute.
  void add_targets(const char* attribute, std::span<Point3> values);
  /// The transform of a vertex.
  glm::dmat4 transform(std::size_t vertex) const;

  GltfDocument& document_;
  const GltfDeformation& deformation_;
  std::span<const double> weights_;
  std::span<const glm::dmat4> joints_;
  glm::dmat4 to_world_;
};

}  // namespace ligne
