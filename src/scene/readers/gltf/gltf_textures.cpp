#include "scene/readers/gltf/gltf_textures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

constexpr char kTransform[] = "KHR_texture_transform";
/// Largest number of texels of a file's textures together after which no more are decoded: a second of work.
constexpr std::size_t kMostDecoded = std::size_t{1} << 24;
/// Largest texture coordinate. Numbers of float32 this large tell no texels apart.
constexpr double kFarthest = 1e6;
constexpr std::string_view kPngData = "data:image/png;base64,";

glm::dmat3x2 coordinate_transform(const GltfItem& extension) {
  const nlohmann::json offset = extension.numbers("offset", 2), scale = extension.numbers("scale", 2);
  const nlohmann::json* const angle = extension.find("rotation");
  const double turn = angle && angle->is_number() ? angle->get<double>() : 0;
  const double sx = scale.is_null() ? 1 : scale[0].get<double>(), sy = scale.is_null() ? 1 : scale[1].get<double>();
  glm::dmat3x2 out{sx * std::cos(turn), -sx * std::sin(turn), sy * std::sin(turn), sy * std::cos(turn), 0, 0};
  if (!offset.is_null()) out[2] = {offset[0].get<double>(), offset[1].get<double>()};
  return out;
}

std::shared_ptr<const PaletteTexture> read_palette(GltfDocument& document, const GltfTexture& texture, InputFiles& opened) {
  if (texture.view) return PaletteTexture::read(document.view_bytes(*texture.view));
  if (texture.uri.starts_with(kPngData)) {
    const auto bytes = decode_base64(std::string_view(texture.uri).substr(kPngData.size()));
    return bytes ? PaletteTexture::read(*bytes) : nullptr;
  }
  const auto file = document.buffers.file_of(texture.uri);
  std::error_code error;
  // Reading a pipe or a device might never end.
  if (!file || !std::filesystem::is_regular_file(*file, error)) return {};
  return PaletteTexture::read(read_input(*file, document.name, opened, kLargestPaletteFile));
}

/// Texture coordinates of a primitive's vertices, transformed; empty if they are missing or broken.
std::vector<glm::dvec2> texture_coordinates(GltfDocument& document, const GltfPrimitive& primitive,
                                            const GltfTexture& texture) {
  std::vector<double> values;
  try {
    if (primitive.draco) {
      values = primitive.draco->coordinates;
    } else if (primitive.coordinate_accessor >= 0) {
      values = read_values(document, static_cast<std::size_t>(primitive.coordinate_accessor), 2);
    }
  } catch (const InputError&) {
    return {};
  }
  if (values.size() != 2 * primitive.vertex_count()) return {};
  std::vector<glm::dvec2> out(primitive.vertex_count());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = texture.transform * glm::dvec3(values[2 * i], values[2 * i + 1], 1);
    if (!(std::abs(out[i].x) <= kFarthest && std::abs(out[i].y) <= kFarthest)) return {};
  }
  return out;
}

}  // namespace

std::optional<GltfTexture> find_palette(const GltfItem& root, const GltfItem& info, std::size_t views) {
  try {
    const auto item = [&](const char* list, std::size_t index) {
      const nlohmann::json* const items = root.array(list);
      if (!items || index >= items->size()) info.fail("names a missing item");
      return GltfItem((*items)[index], list, root.file());
    };
    GltfTexture out;
    out.number = info.required_whole("index");
    const GltfItem texture = item("textures", out.number), image = item("images", texture.required_whole("source"));
    const std::string type = image.text("mimeType");
    const nlohmann::json* const uri = image.find("uri");
    out.view = image.index("bufferView", views);
    if ((!type.empty() && type != "image/png") || (!out.view && !uri)) return {};
    if (!out.view) {
      // The text of a photograph is not copied.
      const auto& text = uri->get_ref<const std::string&>();
      if (text.size() > 2 * kLargestPaletteFile || (text.starts_with("data:") && !text.starts_with(kPngData))) return {};
      out.uri = text;
    }
    out.coordinates = info.whole("texCoord").value_or(0);
    if (const auto sampler = texture.whole("sampler")) {
      const GltfItem from = item("samplers", *sampler);
      const char* const keys[] = {"wrapS", "wrapT"};
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t wrap = from.whole(keys[k]).value_or(0);
        for (const TextureWrap known : {TextureWrap::clamp, TextureWrap::mirror}) {
          if (wrap == static_cast<std::size_t>(known)) out.wrap[k] = known;
        }
      }
    }
    const auto extensions = info.object("extensions");
    if (const auto extension = extensions ? extensions->object(kTransform) : std::nullopt) {
      out.transform = coordinate_transform(*extension);
      if (const auto set = extension->whole("texCoord")) out.coordinates = *set;
    }
    return out;
  } catch (const InputError&) {
    return {};
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

std::vector<std::shared_ptr<const PaletteTexture>> read_palettes(GltfDocument& document, InputFiles& opened) {
  std::vector<std::shared_ptr<const PaletteTexture>> out(document.textures.size());
  std::map<std::pair<std::optional<std::size_t>, std::string>, std::shared_ptr<const PaletteTexture>> known;
  std::size_t texels = 0;
  for (std::size_t m = 0; m < out.size(); ++m) {
    const std::optional<GltfTexture>& texture = document.textures[m];
    if (!texture || texels > kMostDecoded) continue;
    const auto [entry, is_new] = known.try_emplace({texture->view, texture->uri});
    if (is_new) {
      try {
        entry->second = read_palette(document, *texture, opened);
      } catch (const InputError&) {  // a missing picture is no reason to refuse a model
      }
      texels += entry->second ? entry->second->texel_count() : 0;
    }
    out[m] = entry->second;
  }
  return out;
}

void color_faces(GltfDocument& document, const PaletteTexture& palette, std::uint32_t material,
                 std::span<const GltfPart> parts, Scene& scene) {
  const GltfTexture& texture = *document.textures[material];
  std::map<const GltfPrimitive*, std::uint32_t> first_triangle;  // instances have equal colours
  std::vector<TexturedTriangle> triangles;
  const auto corners = std::as_const(scene.faces).corners();
  for (const GltfPart& part : parts) {
    if (!first_triangle.try_emplace(part.primitive, static_cast<std::uint32_t>(triangles.size())).second) continue;
    const std::vector<glm::dvec2> coordinates = texture_coordinates(document, *part.primitive, texture);
    if (coordinates.empty()) return;
    for (std::size_t f = part.first_face; f < part.first_face + part.primitive->triangle_count(); ++f) {
      const auto at = [&](std::size_t k) { return coordinates[corners[3 * f + k] - part.first_vertex]; };
      triangles.push_back({{at(0), at(1), at(2)}, glm::length(double_area(scene, static_cast<std::uint32_t>(f)))});
    }
  }
  const std::optional<TriangleColors> found = palette.colors_of(triangles, texture.wrap);
  if (!found || found->colors.empty()) return;
  document.color_textures.erase(texture.number);
  const Material untextured = scene.materials[material];
  std::vector<std::uint32_t> material_of;  // by colour
  for (const Point3& color : found->colors) {
    const bool is_first = material_of.empty();
    material_of.push_back(is_first ? material : static_cast<std::uint32_t>(scene.materials.size()));
    if (!is_first) scene.materials.push_back(untextured);
    scene.materials[material_of.back()].color = untextured.color * color;
  }
  for (const auto& [primitive, first_face, first_vertex] : parts) {
    const std::uint32_t first = first_triangle[primitive];
    for (std::size_t i = 0; i < primitive->triangle_count(); ++i) {
      scene.face_material[first_face + i] = material_of[found->color_of[first + i]];
    }
  }
}

}  // namespace ligne
