#include "picture/fills.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "view/brightness.hpp"

namespace ligne {
namespace {

// Adjustable: how dark what no light reaches is.
constexpr double kAmbient = 0.35;

/// Behind the viewer, to the upper left: for scenes without a light.
Light light_over_the_shoulder(const Camera& camera) {
  return {Light::Kind::parallel, camera.forward + 0.5 * camera.right + 0.7 * camera.down};
}

}  // namespace

Material material_of(const Scene& scene, std::uint32_t face) {
  const std::uint32_t m = scene.face_material.empty() ? 0 : scene.face_material[face];
  return m < scene.materials.size() ? scene.materials[m] : Material{};
}

Material material_of(const Scene& scene, const Region& region) {
  return region.material < scene.materials.size() ? scene.materials[region.material] : material_of(scene, region.face);
}

std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions,
                               std::span<const Light> lights, FillKind kind) {
  const Light shoulder = light_over_the_shoulder(view.camera);
  const FaceLight light(scene, view.camera, lights.empty() ? std::span(&shoulder, 1) : lights);
  struct LeveledFill {
    std::uint32_t level;
    Fill fill;
  };
  std::vector<LeveledFill> found;
  for (const Region& region : regions) {
    const Material material = material_of(scene, region);
    const double brightness = kind == FillKind::material
                                  ? 1
                                  : kAmbient + (1 - kAmbient) * light.of(region.face, region.lights, region.light_shares);
    LeveledFill one{region.level, {region.contours, {}, material.opacity}};
    for (int c = 0; c < 3; ++c) {
      one.fill.color[static_cast<std::size_t>(c)] =
          std::round(std::clamp(material.color[c] * brightness, 0.0, 1.0) * 255) / 255;
    }
    found.push_back(std::move(one));
  }
  // Within a level nothing overlaps, so colours may be put together.
  std::stable_sort(found.begin(), found.end(), [](const LeveledFill& a, const LeveledFill& b) {
    if (a.level != b.level) return a.level > b.level;
    return std::tie(a.fill.opacity, a.fill.color) > std::tie(b.fill.opacity, b.fill.color);
  });
  std::vector<Fill> fills;
  fills.reserve(found.size());
  for (LeveledFill& one : found) fills.push_back(std::move(one.fill));
  return fills;
}

}  // namespace ligne
