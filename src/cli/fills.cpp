#include "cli/fills.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
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

void add_fill_options(CLI::App& app, FillOptions& options) {
  add_parsed(
      app, "--fill", "HOW", options.kind,
      [](const std::string& text) { return static_cast<FillKind>(parse_choice(text, kFillNames)); },
      "fill visible faces with colour: none material shade; by a method that gives regions")
      ->default_str("none")
      ->group("Fills");
  app.add_option_function<std::vector<std::string>>(
         "--light",
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             try {
               options.lights.push_back(parse_vector(text));
             } catch (const std::invalid_argument& e) {
               throw UsageError("--light", e.what());
             }
           }
         },
         "parallel light that travels in this direction and casts shadows; repeatable")
      ->type_name("X,Y,Z")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Fills");
}

Material material_of(const Scene& scene, std::uint32_t face) {
  const std::uint32_t m = scene.face_material.empty() ? 0 : scene.face_material[face];
  return m < scene.materials.size() ? scene.materials[m] : Material{};
}

Material material_of(const Scene& scene, const Region& region) {
  return region.material < scene.materials.size() ? scene.materials[region.material] : material_of(scene, region.face);
}

std::vector<Light> lights_of(const FillOptions& options, const Scene& scene, bool cast) {
  std::vector<Light> lights;
  for (const Point3& direction : options.lights) lights.push_back({Light::Kind::parallel, direction});
  if (lights.empty() && cast) lights = scene.lights;
  return lights;
}

std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions,
                               std::span<const Light> lights, FillKind kind) {
  const Light shoulder = light_over_the_shoulder(view.camera);
  const FaceLight light(scene, view.camera, lights.empty() ? std::span(&shoulder, 1) : lights);
  struct Item {
    std::uint32_t level;
    Fill fill;
  };
  std::vector<Item> items;
  for (const Region& region : regions) {
    const Material material = material_of(scene, region);
    const double brightness = kind == FillKind::material
                                  ? 1
                                  : kAmbient + (1 - kAmbient) * light.of(region.face, region.lights, region.light_shares);
    Item item{region.level, {region.contours, {}, material.opacity}};
    for (int c = 0; c < 3; ++c) {
      item.fill.color[static_cast<std::size_t>(c)] =
          std::round(std::clamp(material.color[c] * brightness, 0.0, 1.0) * 255) / 255;
    }
    items.push_back(std::move(item));
  }
  // Within a level nothing overlaps, so colours may be put together.
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    if (a.level != b.level) return a.level > b.level;
    return std::tie(a.fill.opacity, a.fill.color) > std::tie(b.fill.opacity, b.fill.color);
  });
  std::vector<Fill> fills;
  fills.reserve(items.size());
  for (Item& item : items) fills.push_back(std::move(item.fill));
  return fills;
}

}  // namespace ligne
