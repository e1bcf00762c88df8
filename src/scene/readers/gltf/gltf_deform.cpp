#include "scene/readers/gltf/gltf_deform.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "scene/readers/gltf/gltf_accessor.hpp"

namespace ligne {
namespace {

constexpr std::size_t kJointsInSet = 4;

}  // namespace

GltfDeformation read_deformation(GltfDocument& document, const tinygltf::Primitive& primitive, std::size_t vertex_count,
                                 const DracoMesh* draco) {
  GltfDeformation out;
  out.targets = primitive.targets;
  // Values of an attribute for every vertex; empty if the primitive does not have it.
  const auto values_of = [&](const std::string& key) {
    if (draco) return draco->joints.contains(key) ? draco->joints.at(key) : std::vector<double>();
    const auto accessor = primitive.attributes.find(key);
    if (accessor == primitive.attributes.end()) return std::vector<double>();
    std::vector<double> values = read_values(document, static_cast<std::size_t>(accessor->second), kJointsInSet);
    if (values.size() == kJointsInSet * vertex_count) return values;
    document.fail("accessor " + std::to_string(accessor->second),
                  "does not have an element for each of the " + std::to_string(vertex_count) + " vertices");
  };
  std::vector<std::vector<double>> joints, weights;
  for (int set = 0;; ++set) {
    std::vector<double> of_joints = values_of("JOINTS_" + std::to_string(set)),
                        of_weights = values_of("WEIGHTS_" + std::to_string(set));
    if (of_joints.empty() || of_weights.empty()) break;
    joints.push_back(std::move(of_joints));
    weights.push_back(std::move(of_weights));
  }
  out.per_vertex = kJointsInSet * joints.size();
  for (std::size_t v = 0; v < vertex_count; ++v) {
    for (std::size_t set = 0; set < joints.size(); ++set) {
      const auto from = static_cast<std::ptrdiff_t>(kJointsInSet * v), to = from + static_cast<std::ptrdiff_t>(kJointsInSet);
      out.joints.insert(out.joints.end(), joints[set].begin() + from, joints[set].begin() + to);
      out.weights.insert(out.weights.end(), weights[set].begin() + from, weights[set].begin() + to);
    }
  }
  return out;
}

std::vector<glm::dmat4> joint_matrices(GltfDocument& document, const GltfNodes& nodes, std::size_t skin) {
  const tinygltf::Skin& from = document.model.skins[skin];
  std::vector<double> inverse;
  if (from.inverseBindMatrices >= 0) {
    inverse = read_values(document, static_cast<std::size_t>(from.inverseBindMatrices), 16);
    if (inverse.size() < 16 * from.joints.size()) {
      document.fail("skin " + std::to_string(skin), "has fewer inverse bind matrices than joints");
    }
  }
  std::vector<glm::dmat4> matrices;
  for (std::size_t j = 0; j < from.joints.size(); ++j) {
    glm::dmat4 bind(1);
    for (std::size_t i = 0; i < 16 && !inverse.empty(); ++i) {
      bind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = inverse[16 * j + i];
    }
    matrices.push_back(nodes.to_world[static_cast<std::size_t>(from.joints[j])] * bind);
  }
  return matrices;
}

GltfDeformer::GltfDeformer(GltfDocument& document, const GltfDeformation& deformation, std::span<const double> weights,
                           std::span<const glm::dmat4> joints, const glm::dmat4& to_world)
    : document_(document), deformation_(deformation), weights_(weights), joints_(joints), to_world_(to_world) {
  if (joints_.empty()) return;
  for (const double joint : deformation_.joints) {
    if (joint >= 0 && joint < static_cast<double>(joints_.size())) continue;
    document_.fail("skin", "a vertex names joint " + std::to_string(static_cast<long>(joint)) + " of " +
                               std::to_string(joints_.size()));
  }
}

void GltfDeformer::add_targets(const char* attribute, std::span<Point3> values) {
  for (std::size_t t = 0; t < std::min(weights_.size(), deformation_.targets.size()); ++t) {
    const auto accessor = deformation_.targets[t].find(attribute);
    if (weights_[t] == 0 || accessor == deformation_.targets[t].end()) continue;
    const std::vector<double> differences = read_values(document_, static_cast<std::size_t>(accessor->second), 3);
    if (differences.size() != 3 * values.size()) {
      document_.fail("accessor " + std::to_string(accessor->second),
                     "does not have a difference for each of the " + std::to_string(values.size()) + " vertices");
    }
    for (std::size_t v = 0; v < values.size(); ++v) {
      values[v] += weights_[t] * Point3(differences[3 * v], differences[3 * v + 1], differences[3 * v + 2]);
    }
  }
}

glm::dmat4 GltfDeformer::transform(std::size_t vertex) const {
  if (joints_.empty() || deformation_.joints.empty()) return to_world_;
  const std::size_t first = vertex * deformation_.per_vertex;
  glm::dmat4 sum(0);
  double total = 0;
  for (std::size_t k = first; k < first + deformation_.per_vertex; ++k) {
    const double weight = deformation_.weights[k];
    if (weight == 0) continue;
    sum += weight * joints_[static_cast<std::size_t>(deformation_.joints[k])];
    total += weight;
  }
  // Weights should sum to one, but quantised ones do so only nearly. If all are zero, the first joint gets all.
  return total > 0 ? sum / total : joints_[static_cast<std::size_t>(deformation_.joints[first])];
}

double GltfDeformer::move_positions(std::span<Point3> positions) {
  add_targets("POSITION", positions);
  double largest = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    Point3& p = positions[v];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    p = Point3(transform(v) * glm::dvec4(p, 1));
  }
  return largest;
}

void GltfDeformer::turn_normals(std::span<Point3> normals) {
  add_targets("NORMAL", normals);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const glm::dmat3 linear(transform(v));
    // The matrix of cofactors turns normals like the transposed inverse, but also exists for flat transforms.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    normals[v] = cofactors * normals[v];
  }
}

}  // namespace ligne
