#include "scene/readers/gltf/gltf_motion.hpp"

#include <array>
#include <string>
#include <string_view>

namespace ligne {
namespace {

/// Largest number of sets of four joints per vertex that are read: more than any exporter writes.
constexpr int kMostJointSets = 8;

bool is_interpolation(std::string_view word) { return word == "LINEAR" || word == "STEP" || word == "CUBICSPLINE"; }

}  // namespace

nlohmann::json checked_targets(const GltfItem& primitive, const GltfCounts& counts) {
  nlohmann::json out = nlohmann::json::array();
  const nlohmann::json* const list = primitive.array("targets");
  if (!list) return out;
  for (const nlohmann::json& value : *list) {
    const GltfItem from(value, primitive.place() + ", target " + std::to_string(out.size()), primitive.file());
    nlohmann::json target = nlohmann::json::object();
    for (const char* key : {"POSITION", "NORMAL"}) {
      if (const auto accessor = from.index(key, counts.accessors)) target[key] = *accessor;
    }
    out.push_back(std::move(target));
  }
  return out;
}

void add_skin_attributes(const GltfItem& attributes, const GltfCounts& counts, nlohmann::json& to) {
  for (int set = 0; set < kMostJointSets; ++set) {
    const std::string joints = "JOINTS_" + std::to_string(set), weights = "WEIGHTS_" + std::to_string(set);
    const auto of_joints = attributes.index(joints.c_str(), counts.accessors);
    const auto of_weights = attributes.index(weights.c_str(), counts.accessors);
    if (!of_joints || !of_weights) return;
    to[joints] = *of_joints;
    to[weights] = *of_weights;
  }
}

nlohmann::json checked_skin(const GltfItem& skin, const GltfCounts& counts) {
  nlohmann::json out{{"joints", skin.indices("joints", counts.nodes)}};
  if (out["joints"].empty()) skin.fail("has no joints");
  if (const auto matrices = skin.index("inverseBindMatrices", counts.accessors)) out["inverseBindMatrices"] = *matrices;
  return out;
}

nlohmann::json checked_animation(const GltfItem& animation, const GltfCounts& counts, Omissions& left_out) {
  nlohmann::json out{
      {"name", animation.text("name")}, {"samplers", nlohmann::json::array()}, {"channels", nlohmann::json::array()}};
  const auto item = [&](const nlohmann::json& value, const char* what, std::size_t i) {
    return GltfItem(value, animation.place() + ", " + what + " " + std::to_string(i), animation.file());
  };
  if (const nlohmann::json* const samplers = animation.array("samplers")) {
    for (const nlohmann::json& value : *samplers) {
      const GltfItem from = item(value, "sampler", out["samplers"].size());
      std::string interpolation = from.text("interpolation");
      if (interpolation.empty()) interpolation = "LINEAR";
      if (!is_interpolation(interpolation)) from.fail("interpolation " + shown(interpolation, '"') + " is not known");
      out["samplers"].push_back({{"input", from.required_index("input", counts.accessors)},
                                 {"output", from.required_index("output", counts.accessors)},
                                 {"interpolation", interpolation}});
    }
  }
  const nlohmann::json* const channels = animation.array("channels");
  if (!channels) return out;
  for (std::size_t i = 0; i < channels->size(); ++i) {
    const GltfItem from = item((*channels)[i], "channel", i), target = from.required_object("target");
    const std::size_t sampler = from.required_index("sampler", out["samplers"].size());
    const std::string path = target.text("path");
    const auto node = target.index("node", counts.nodes);
    constexpr std::array kPaths{"translation", "rotation", "scale", "weights"};
    if (!node || std::find(kPaths.begin(), kPaths.end(), path) == kPaths.end()) {
      left_out.count("channels of animations of " + (path.empty() ? "nothing" : path));
      continue;
    }
    out["channels"].push_back({{"sampler", sampler}, {"target", {{"node", *node}, {"path", path}}}});
  }
  return out;
}

nlohmann::json checked_instancing(const GltfItem& extension, const GltfCounts& counts) {
  nlohmann::json out{{"attributes", nlohmann::json::object()}};
  const GltfItem attributes = extension.required_object("attributes");
  for (const char* key : {"TRANSLATION", "ROTATION", "SCALE"}) {
    if (const auto accessor = attributes.index(key, counts.accessors)) out["attributes"][key] = *accessor;
  }
  return out;
}

}  // namespace ligne
