#pragma once
/// Colours of faces from textures that are palettes: patches of one colour, or of a gradient, to which the texture
/// coordinates of the faces point.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "geometry/point.hpp"

namespace ligne {

/// Largest size of the file of a palette in bytes: a quarter of a byte for each texel of the largest texture.
inline constexpr std::size_t kLargestPaletteFile = std::size_t{1} << 20;

/// How coordinates outside of [0, 1] are brought into it, as glTF numbers it.
enum class TextureWrap { repeat = 10497, clamp = 33071, mirror = 33648 };

/// A triangle with its texture coordinates; (0, 0) is the upper left corner of the texture.
struct TexturedTriangle {
  std::array<glm::dvec2, 3> at{};
  double area = 0;  ///< weight of its colour among those of the patch
};

/// Colours of the triangles of a material.
struct TriangleColors {
  std::vector<Point3> colors;             ///< red, green, blue in [0, 1]; no two are alike
  std::vector<std::uint32_t> color_of{};  ///< by triangle
};

/// A decoded texture, divided into patches.
class PaletteTexture {
 public:
  /// Null if the bytes are no PNG, or one that is broken or can not be a palette: photographs and painted textures take
  /// many bytes for each texel, and are not decoded.
  static std::shared_ptr<const PaletteTexture> read(std::span<const std::byte> png);

  std::size_t texel_count() const { return patch_.size(); }

  /// The colours of the texels under all triangles of a material: the mean of those in one patch. Patches that look alike
  /// share the colour of the largest. Nothing if the texels under a triangle vary, but for a few, or the triangles lie in
  /// too many patches: then it is no palette. Takes O(1) for a triangle.
  std::optional<TriangleColors> colors_of(std::span<const TexturedTriangle> triangles,
                                          std::array<TextureWrap, 2> wrap) const;

 private:
  void find_patches();
  bool are_alike(std::size_t a, std::size_t b) const;

  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> rgb_;     ///< three per texel
  std::vector<std::uint32_t> patch_;  ///< per texel
};

}  // namespace ligne
