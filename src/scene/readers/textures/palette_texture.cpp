#include "scene/readers/textures/palette_texture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/common.hpp>
#include <map>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel_each.hpp"
#include "files/input_error.hpp"
#include "scene/readers/png_file.hpp"

namespace ligne {
namespace {

/// Largest number of texels of a palette: four times as many as those of game assets have.
constexpr std::size_t kMostTexels = std::size_t{1} << 22;
/// Texels for each byte of the file of a palette, at least. Those of game assets have 20 to 80; photographs about one,
/// and painted textures one to three.
constexpr std::size_t kTexelsPerByte = 4;
/// Files up to this size in bytes may have any number of texels, since they are decoded in no time.
constexpr std::size_t kSmallFile = std::size_t{1} << 14;
/// Largest difference of neighbouring texels of a patch in each channel, of 255. Those of the gradients of game assets
/// differ by 1 or 2.
constexpr int kLargestStep = 6;
/// Two columns of a patch may differ in one of so many texels where they meet.
constexpr std::size_t kUnlikeShare = 4;
/// Triangles whose texels vary, at most one of so many: careless coordinates. Of paintings on fine meshes more lie across
/// the borders of patches.
constexpr std::size_t kVaryingShare = 256;
/// Largest difference in each channel, of 1, of two colours that count as one. Taste: tints of one material.
constexpr double kSameColor = 0.08;
/// Largest number of patches of a material: those of a picture of 8 bits for each texel.
constexpr std::size_t kMostColors = 256;
/// Texels between two samples of a triangle, and the largest number of samples along a side.
constexpr double kSampleDistance = 2;
constexpr int kMostSamples = 8;
/// Distance of the samples from the sides of a triangle, relative to its size: coordinates lie on the very borders of
/// patches.
constexpr double kInward = 1.0 / 16;

double wrapped(double x, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) return std::clamp(x, 0.0, 1.0);
  if (wrap == TextureWrap::repeat) return x - std::floor(x);
  return std::abs(x - 2 * std::floor(x / 2 + 0.5));
}

/// Texels under a triangle.
struct UnderTriangle {
  std::uint32_t patch = kNone;  ///< of the middle
  bool varies = false;          ///< whether some lie in other patches
  Point3 color{0};              ///< mean of those in the patch, times the area
};

/// The colours of the patches in which triangles lie; nothing if there are too many.
std::optional<TriangleColors> merge_patches(std::span<const TexturedTriangle> triangles,
                                            std::span<const UnderTriangle> under) {
  struct PatchColor {
    std::uint32_t patch = kNone;
    Point3 sum{0};
    double area = 0;
  };
  std::map<std::uint32_t, PatchColor> patches;
  for (std::size_t i = 0; i < under.size(); ++i) {
    PatchColor& color = patches[under[i].patch];
    color = {under[i].patch, color.sum + under[i].color, color.area + triangles[i].area};
    if (patches.size() > kMostColors) return {};
  }
  // The patches with the largest triangles decide which colours there are.
  std::vector<PatchColor> order;
  order.reserve(patches.size());
  for (const auto& [patch, color] : patches) order.push_back(color);
  std::ranges::stable_sort(order, std::ranges::greater(), &PatchColor::area);
  TriangleColors out;
  std::map<std::uint32_t, std::uint32_t> color_of;
  for (const auto& [patch, sum, area] : order) {
    const Point3 color = area > 0 ? sum / area : Point3(0);
    const auto same = std::ranges::find_if(out.colors, [&](const Point3& other) {
      const Point3 d = glm::abs(color - other);
      return std::max({d.x, d.y, d.z}) <= kSameColor;
    });
    color_of[patch] = static_cast<std::uint32_t>(same - out.colors.begin());
    if (same == out.colors.end()) out.colors.push_back(color);
  }
  for (const UnderTriangle& triangle : under) out.color_of.push_back(color_of[triangle.patch]);
  return out;
}

}  // namespace

std::shared_ptr<const PaletteTexture> PaletteTexture::read(std::span<const std::byte> bytes) try {
  const std::string name;
  PngFile png(bytes, name);
  png.read_header();
  const std::size_t columns = png.columns(), rows = png.rows();
  if (rows > kMostTexels / columns || bytes.size() > std::max(kSmallFile, columns * rows / kTexelsPerByte)) return nullptr;
  const auto out = std::make_shared<PaletteTexture>();
  out->columns_ = columns;
  out->rows_ = rows;
  out->rgb_.resize(3 * columns * rows);
  for (int passes = png.begin_rows(true); passes > 0; --passes) {
    for (std::size_t y = 0; y < rows; ++y) png.read_row(out->rgb_.data() + 3 * y * columns);
  }
  out->find_patches();
  return out;
} catch (const InputError&) {
  return nullptr;
}

bool PaletteTexture::are_alike(std::size_t a, std::size_t b) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(rgb_[3 * a + k] - rgb_[3 * b + k]) > kLargestStep) return false;
  }
  return true;
}

/// Joins texels above each other that are alike to pieces of columns, and pieces side by side that are alike almost
/// wherever they meet. Patches of a palette that have a colour in common at some place remain apart.
void PaletteTexture::find_patches() {
  const std::size_t n = columns_ * rows_;
  patch_.resize(n);
  std::uint32_t pieces = 0;
  for (std::size_t t = 0; t < n; ++t) {
    patch_[t] = t >= columns_ && are_alike(t, t - columns_) ? patch_[t - columns_] : pieces++;
  }
  DisjointSets sets(pieces);
  struct Contact {
    std::uint32_t left = kNone, right = kNone;
    std::size_t texels = 0, unlike = 0;
  };
  std::vector<Contact> contacts(columns_);
  const auto close = [&](Contact& contact) {
    if (contact.texels > 0 && contact.unlike * kUnlikeShare <= contact.texels) sets.join(contact.left, contact.right);
  };
  for (std::size_t t = 0; t < n; ++t) {
    if (t % columns_ == 0) continue;
    Contact& contact = contacts[t % columns_];
    if (contact.left != patch_[t - 1] || contact.right != patch_[t]) {
      close(contact);
      contact = {patch_[t - 1], patch_[t]};
    }
    ++contact.texels;
    contact.unlike += are_alike(t, t - 1) ? 0 : 1;
  }
  for (Contact& contact : contacts) close(contact);
  for (std::uint32_t& patch : patch_) patch = sets.find(patch);
}

std::optional<TriangleColors> PaletteTexture::colors_of(std::span<const TexturedTriangle> triangles,
                                                        std::array<TextureWrap, 2> wrap) const {
  const glm::dvec2 size(static_cast<double>(columns_), static_cast<double>(rows_));
  const auto texel_at = [&](const glm::dvec2& at) {
    const auto x = static_cast<std::size_t>(wrapped(at.x, wrap[0]) * size.x);
    const auto y = static_cast<std::size_t>(wrapped(at.y, wrap[1]) * size.y);
    return std::min(y, rows_ - 1) * columns_ + std::min(x, columns_ - 1);
  };
  std::vector<UnderTriangle> under(triangles.size());
  parallel_each(triangles.size(), [&](std::size_t i) {
    const auto& [a, b, c] = triangles[i].at;
    const glm::dvec2 middle = (a + b + c) / 3.0, extent = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
    const double texels = std::max(extent.x * size.x, extent.y * size.y);
    const int n = static_cast<int>(std::clamp(std::ceil(texels / kSampleDistance), 1.0, double{kMostSamples}));
    under[i].patch = patch_[texel_at(middle)];
    int samples = 0;
    const auto take = [&](std::size_t texel) {
      if (patch_[texel] == under[i].patch) {
        under[i].color += Point3(rgb_[3 * texel], rgb_[3 * texel + 1], rgb_[3 * texel + 2]) / 255.0;
        ++samples;
      } else {
        under[i].varies = true;
      }
    };
    take(texel_at(middle));
    for (int p = 0; p <= n; ++p) {
      for (int q = 0; p + q <= n; ++q) {
        const glm::dvec2 at =
            a + ((b - a) * static_cast<double>(p) + (c - a) * static_cast<double>(q)) / static_cast<double>(n);
        take(texel_at(at + (middle - at) * kInward));
      }
    }
    under[i].color *= triangles[i].area / samples;
  });
  const auto varying = static_cast<std::size_t>(std::ranges::count(under, true, &UnderTriangle::varies));
  if (varying * kVaryingShare > under.size()) return {};

  return merge_patches(triangles, under);
}

}  // namespace ligne
