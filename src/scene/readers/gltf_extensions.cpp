#include "scene/readers/gltf_extensions.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/model/diagnostics.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Families and names that change materials, textures, lights, animations or notes, but no geometry.
constexpr std::array<std::string_view, 13> kHarmlessPrefixes{"KHR_materials_",
                                                             "KHR_texture_",
                                                             "EXT_texture_",
                                                             "MSFT_texture_",
                                                             "KHR_lights_",
                                                             "EXT_lights_",
                                                             "ADOBE_materials_",
                                                             "KHR_techniques_",
                                                             "KHR_animation_",
                                                             "KHR_xmp",
                                                             "KHR_audio",
                                                             "EXT_structural_",
                                                             "AGI_"};

}  // namespace

void check_required_extension(const std::string& extension, const std::string& name) {
  if (extension == "KHR_mesh_quantization") return;
  if (extension == kDracoExtension) {
#ifdef LIGNE_HAVE_DRACO
    return;
#else
    throw InputError(name, "needs the glTF extension " + extension + ", and this program was built without libdraco");
#endif
  }
  const bool harmless = std::any_of(kHarmlessPrefixes.begin(), kHarmlessPrefixes.end(),
                                    [&](std::string_view prefix) { return extension.starts_with(prefix); });
  if (!harmless) throw InputError(name, "needs the glTF extension " + printable(extension) + ", which is not known here");
}

}  // namespace ligne
