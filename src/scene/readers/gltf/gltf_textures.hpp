#pragma once
/// Textures of base colours of glTF files.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/gltf/gltf_item.hpp"
#include "scene/readers/gltf/gltf_primitive.hpp"

namespace ligne {

/// The PNG texture that an object such as baseColorTexture names; nothing if it is broken or can not be a palette. `root`
/// is the whole file, `views` its number of bufferViews.
std::optional<GltfTexture> find_palette(const GltfItem& root, const GltfItem& info, std::size_t views);

/// The decoded textures of the materials; null without a texture, and if it is missing, broken or no palette. Adds their
/// files to `opened`.
std::vector<std::shared_ptr<const PaletteTexture>> read_palettes(GltfDocument& document, InputFiles& opened);

/// Gives all faces of a material the colours of its palette: the material itself the first one, and materials at the end of
/// the list the others. Does nothing if the texture is no palette for them, or coordinates are missing or broken.
void color_faces(GltfDocument& document, const PaletteTexture& palette, std::uint32_t material,
                 std::span<const GltfPart> parts, Scene& scene);

}  // namespace ligne
