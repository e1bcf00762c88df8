#include "scene/readers/gltf/gltf_extensions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/model/diagnostics.hpp"

namespace ligne {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 7> kRead{"KHR_mesh_quantization", kDracoExtension,      kMeshoptExtension,
                                                kInstancingExtension,    kVisibilityExtension, kTransmissionExtension,
                                                kGlossinessExtension};

/// Prefixes of extensions that change the shine of a surface, textures, animations or notes, but no line.
constexpr std::array<std::string_view, 16> kHarmlessPrefixes{"KHR_materials_",
                                                             "KHR_texture_",
                                                             "EXT_texture_",
                                                             "MSFT_texture_",
                                                             "ADOBE_materials_",
                                                             "KHR_technique",
                                                             "KHR_animation_",
                                                             "KHR_xmp",
                                                             "KHR_audio",
                                                             "EXT_structural_",
                                                             "EXT_mesh_features",
                                                             "EXT_instance_features",
                                                             "KHR_node_selectability",
                                                             "KHR_node_hoverability",
                                                             "KHR_interactivity",
                                                             "AGI_"};
/// Prefixes of light extensions. Lights are not read, but geometry does not need them.
constexpr std::array<std::string_view, 2> kLightPrefixes{"KHR_lights_", "EXT_lights_"};

template <class Prefixes>
bool begins_with_one(std::string_view extension, const Prefixes& prefixes) {
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return extension.starts_with(prefix); });
}

bool is_read(std::string_view extension) { return std::ranges::find(kRead, extension) != kRead.end(); }

constexpr char kWholeFile[] = "files";

/// Number of uses per extension and per kind of object that uses it.
using Uses = std::map<std::string, std::map<std::string, std::size_t>>;

/// Collects uses. check_depth() in gltf_json.cpp bounds the depth.
void collect(const json& value, const std::string& kind, Uses& uses) {
  if (value.is_array()) {
    for (const json& item : value) collect(item, kind, uses);
  }
  if (!value.is_object()) return;
  for (const auto& [key, item] : value.items()) {
    if (key == "extensions" && item.is_object()) {
      for (const auto& [extension, unused] : item.items()) ++uses[extension][kind];
    } else if (key != "extras" && key != "extensions") {
      collect(item, kind == kWholeFile || key == "primitives" ? key : kind, uses);
    }
  }
}

}  // namespace

void check_required_extension(const std::string& extension, const std::string& name) {
  if (extension == kDracoExtension) {
#ifdef LIGNE_HAVE_DRACO
    return;
#else
    throw InputError(name, "needs the glTF extension " + extension + ", and this program was built without libdraco");
#endif
  }
  if (is_read(extension) || begins_with_one(extension, kHarmlessPrefixes) || begins_with_one(extension, kLightPrefixes))
    return;
  throw InputError(name, "needs the glTF extension " + printable(extension) + ", which is not known here");
}

void count_extensions(const json& root, Omissions& left_out) {
  Uses uses;
  collect(root, kWholeFile, uses);
  for (const auto& [extension, kinds] : uses) {
    if (is_read(extension) || begins_with_one(extension, kHarmlessPrefixes)) continue;
    for (const auto& [kind, n] : kinds) {
      // The file as a whole only lists the extensions that other objects use.
      if (kind != kWholeFile || kinds.size() == 1) left_out.count(kind + " with " + extension, n);
    }
  }
}

}  // namespace ligne
