#include "scene/readers/gltf/gltf_deform.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "scene/readers/gltf/gltf_accessor.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr std::size_t kJointsInSet = 4;

/// The animation with the requested name, or else with that number, from 0.
const tinygltf::Animation& find_animation(const GltfDocument& document, const std::string& wanted) {
  const std::vector<tinygltf::Animation>& all = document.model.animations;
  const auto named = std::ranges::find(all, wanted, &tinygltf::Animation::name);
  if (named != all.end()) return *named;
  const std::optional<std::int64_t> number = parse_integer(wanted);
  if (number && *number >= 0 && *number < static_cast<std::int64_t>(all.size()))
    return all[static_cast<std::size_t>(*number)];
  std::string list;
  constexpr std::size_t kMostListed = 12;
  for (std::size_t i = 0; i < std::min(all.size(), kMostListed); ++i) {
    list += (i > 0 ? ", " : "") + std::to_string(i) + (all[i].name.empty() ? "" : " " + printable(all[i].name));
  }
  throw InputError(document.name, "has no animation " + shown(wanted, '"') +
                                      (all.empty() ? ": it has none at all" : "; there are " + list) +
                                      (all.size() > kMostListed ? " and more" : ""));
}

/// The keys of a channel with `width` numbers each. With cubic splines there are three times as many, since every key
/// has a tangent before and after it.
struct Keys {
  std::vector<double> times, values;
  std::size_t width = 0;
  bool is_step = false, is_cubic = false;

  std::span<const double> value(std::size_t key) const {
    return std::span(values).subspan((is_cubic ? 3 * key + 1 : key) * width, width);
  }
  std::span<const double> tangent_before(std::size_t key) const { return std::span(values).subspan(3 * key * width, width); }
  std::span<const double> tangent_after(std::size_t key) const {
    return std::span(values).subspan((3 * key + 2) * width, width);
  }
};

/// Sine of the angle of two quaternions below which linear interpolation equals the one on the sphere: their weights
/// differ by less than a sixth of its square, which is below the last place of a double.
constexpr double kStraightSine = 1e-9;

/// Interpolates two rotations along the shorter way on the sphere (appendix C.4).
std::vector<double> between_rotations(std::span<const double> a, std::span<const double> b, double t) {
  double cosine = 0;
  for (std::size_t k = 0; k < 4; ++k) cosine += a[k] * b[k];
  const double sign = cosine < 0 ? -1 : 1, angle = std::acos(std::min(std::abs(cosine), 1.0)), sine = std::sin(angle);
  const bool is_straight = sine < kStraightSine;
  const double from = is_straight ? 1 - t : std::sin((1 - t) * angle) / sine;
  const double to = sign * (is_straight ? t : std::sin(t * angle) / sine);
  std::vector<double> out(4);
  for (std::size_t k = 0; k < 4; ++k) out[k] = from * a[k] + to * b[k];
  return out;
}

/// Value of a channel at a time.
std::vector<double> value_at(const Keys& keys, double time, bool is_rotation) {
  const auto as_list = [](std::span<const double> values) { return std::vector<double>(values.begin(), values.end()); };
  const auto after = std::ranges::upper_bound(keys.times, time);
  if (after == keys.times.begin()) return as_list(keys.value(0));
  const auto next = static_cast<std::size_t>(after - keys.times.begin());
  if (next == keys.times.size() || keys.is_step) return as_list(keys.value(next - 1));
  const std::size_t last = next - 1;
  const double span = keys.times[next] - keys.times[last], t = (time - keys.times[last]) / span;
  const std::span<const double> a = keys.value(last), b = keys.value(next);
  if (!keys.is_cubic && is_rotation) return between_rotations(a, b, t);
  std::vector<double> out(keys.width);
  for (std::size_t k = 0; k < keys.width; ++k) {
    out[k] = a[k] + t * (b[k] - a[k]);
    if (!keys.is_cubic) continue;
    // Hermite's polynomials; the tangents are per second (appendix C.5).
    const double t2 = t * t, t3 = t2 * t;
    out[k] = (2 * t3 - 3 * t2 + 1) * a[k] + span * (t3 - 2 * t2 + t) * keys.tangent_after(last)[k] +
             (3 * t2 - 2 * t3) * b[k] + span * (t3 - t2) * keys.tangent_before(next)[k];
  }
  return out;
}

/// Number of morph targets of a node's mesh.
std::size_t target_count(const tinygltf::Model& model, const tinygltf::Node& node) {
  std::size_t n = 0;
  if (node.mesh < 0) return n;
  for (const auto& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
    n = std::max(n, primitive.targets.size());
  }
  return n;
}

Keys read_keys(GltfDocument& document, const tinygltf::AnimationSampler& sampler, std::size_t width, bool is_scalar,
               const std::string& place) {
  Keys keys{.times = read_values(document, static_cast<std::size_t>(sampler.input), 1),
            .values = read_values(document, static_cast<std::size_t>(sampler.output), is_scalar ? 1 : width),
            .width = width,
            .is_step = sampler.interpolation == "STEP",
            .is_cubic = sampler.interpolation == "CUBICSPLINE"};
  const std::size_t needed = keys.times.size() * width * (keys.is_cubic ? 3 : 1);
  if (keys.times.empty()) document.fail(place, "has no keys");
  if (keys.values.size() != needed) {
    document.fail(place,
                  "has " + std::to_string(keys.values.size()) + " numbers for its keys, needs " + std::to_string(needed));
  }
  if (!std::ranges::is_sorted(keys.times)) document.fail(place, "its times do not ascend");
  return keys;
}

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

void apply_pose(GltfDocument& document, const ScenePose& pose) {
  if (!document.animation_error.empty()) throw InputError(document.animation_error);
  tinygltf::Model& model = document.model;
  const tinygltf::Animation& animation = find_animation(document, pose.animation);
  for (std::size_t c = 0; c < animation.channels.size(); ++c) {
    const tinygltf::AnimationChannel& channel = animation.channels[c];
    tinygltf::Node& node = model.nodes[static_cast<std::size_t>(channel.target_node)];
    const bool is_rotation = channel.target_path == "rotation", is_weights = channel.target_path == "weights";
    const std::size_t width = is_rotation ? 4 : is_weights ? target_count(model, node) : 3;
    if (width == 0) continue;  // there are no weights
    const std::string place =
        "animation " + std::to_string(&animation - model.animations.data()) + ", channel " + std::to_string(c);
    const Keys keys =
        read_keys(document, animation.samplers[static_cast<std::size_t>(channel.sampler)], width, is_weights, place);
    std::vector<double> value = value_at(keys, pose.seconds, is_rotation);
    if (is_weights) {
      node.weights = std::move(value);
      continue;
    }
    // An animated node must not have a matrix (section 3.5.3).
    if (!node.matrix.empty()) document.fail(place, "moves a node that has a matrix");
    (is_rotation ? node.rotation : channel.target_path == "scale" ? node.scale : node.translation) = std::move(value);
  }
  for (const auto& [what, n] : document.animation_left_out.counts()) document.left_out.count(what, n);
}

}  // namespace ligne
