#include "cli/fills.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "scene/topology.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

// Adjustable: how dark what no light reaches is, and the hatching.
constexpr double kAmbient = 0.35;
constexpr double kBrightest = 0.92;         ///< what is brighter is not hatched
constexpr double kClosestPens = 2;          ///< distance of lines in pen widths where nothing is seen of any light
constexpr double kShadowDegrees = 135, kLitDegrees = 45;

Material material_of(const Scene& scene, std::uint32_t face) {
  const std::uint32_t m = scene.face_material.empty() ? 0 : scene.face_material[face];
  return m < scene.materials.size() ? scene.materials[m] : Material{};
}

/// Brightness of a face, from kAmbient to 1.
class Shading {
 public:
  Shading(const Scene& scene, const View& view, std::span<const Light> lights) : scene_(scene), camera_(view.camera), lights_(lights) {}

  double of(const Region& region) const {
    const Point3 point = scene_.vertices[scene_.faces.contour(region.face, 0)[0]];
    Point3 normal = face_normal(scene_, region.face);
    const Point3 sight = camera_.perspective ? point - camera_.eye : camera_.forward;
    if (glm::dot(normal, sight) > 0) normal = -normal;
    if (lights_.empty()) return shade(normal, glm::normalize(camera_.forward + 0.5 * camera_.right + 0.7 * camera_.down), 1);
    double sum = kAmbient;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      if (i < 32 && !(region.lights >> i & 1u)) continue;
      const Light& light = lights_[i];
      const Point3 way = light.kind == Light::Kind::parallel ? light.vector : point - light.vector;
      const double share = i < region.light_shares.size() ? region.light_shares[i] : 1;
      if (glm::dot(way, way) > 0) sum += shade(normal, glm::normalize(way), share / static_cast<double>(lights_.size())) - kAmbient;
    }
    return std::clamp(sum, kAmbient, 1.0);
  }

 private:
  static double shade(const Point3& normal, const Point3& way, double part) {
    return kAmbient + part * (1 - kAmbient) * std::max(0.0, -glm::dot(normal, way));
  }

  const Scene& scene_;
  const Camera& camera_;
  std::span<const Light> lights_;
};

/// Lines at a distance of `spacing` through the region, on a raster that is the same for the whole page.
void hatch(const Region& region, double degrees, double spacing, Polylines& out) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  const Point2 along{std::cos(angle), std::sin(angle)}, across{-along.y, along.x};
  double low = 1e300, high = -1e300;
  for (const Point2& p : region.contours[0]) {
    const double v = glm::dot(p, across);
    low = std::min(low, v);
    high = std::max(high, v);
  }
  std::vector<double> crossings;
  for (double k = std::ceil(low / spacing); k * spacing < high; ++k) {
    const double level = k * spacing;
    crossings.clear();
    for (const std::vector<Point2>& contour : region.contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Point2 a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
        const double va = glm::dot(a, across) - level, vb = glm::dot(b, across) - level;
        if ((va < 0) == (vb < 0)) continue;
        crossings.push_back(glm::dot(a + (b - a) * (va / (va - vb)), along));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      if (!(crossings[i] < crossings[i + 1])) continue;
      out.points.push_back(along * crossings[i] + across * level);
      out.points.push_back(along * crossings[i + 1] + across * level);
      out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
    }
  }
}

}  // namespace

void add_fill_options(CLI::App& app, FillOptions& options) {
  add_parsed(
      app, "--fill", "HOW", options.kind, [](const std::string& text) { return static_cast<FillKind>(parse_choice(text, kFillNames)); },
      "fill visible faces: none material shade hatch; by a method that gives regions")
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

const Method& region_method() {
  for (const Method* method : all_methods()) {
    if (method->traits().products & kRegions) return *method;
  }
  return *all_methods().front();
}

std::vector<Light> lights_of(const FillOptions& options, bool shadow_lines, const Scene& scene) {
  std::vector<Light> lights;
  for (const Point3& direction : options.lights) lights.push_back({Light::Kind::parallel, direction});
  const bool shaded = options.kind == FillKind::shade || options.kind == FillKind::hatch;
  if (lights.empty() && (shaded || shadow_lines)) lights = scene.lights;
  return lights;
}

std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions, std::span<const Light> lights,
                               FillKind kind) {
  const Shading shading(scene, view, lights);
  struct Item {
    std::uint32_t level;
    Fill fill;
  };
  std::vector<Item> items;
  for (const Region& region : regions) {
    const Material material = region.material < scene.materials.size() ? scene.materials[region.material] : material_of(scene, region.face);
    const double brightness = kind == FillKind::material ? 1 : shading.of(region);
    Item item{region.level, {region.contours, {}, material.opacity}};
    for (int c = 0; c < 3; ++c) {
      item.fill.color[static_cast<std::size_t>(c)] = std::round(std::clamp(material.color[c] * brightness, 0.0, 1.0) * 255) / 255;
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

Polylines hatch_regions(const Scene& scene, const View& view, const std::vector<Region>& regions, std::span<const Light> lights,
                        double pen_width_mm) {
  const Shading shading(scene, view, lights);
  Polylines lines;
  for (const Region& region : regions) {
    if (region.level > 0) continue;
    const double brightness = shading.of(region);
    if (brightness > kBrightest) continue;
    // Ink covers pen / spacing of the paper. Twelve steps, so that neighbours of nearly one shade have one spacing.
    const double dark = std::ceil((1 - brightness) / (1 - kAmbient) * 12) / 12;
    const double spacing = kClosestPens * std::max(pen_width_mm, 0.05) / dark;
    hatch(region, kLitDegrees, spacing, lines);
    if (!lights.empty() && region.lights == 0) hatch(region, kShadowDegrees, spacing, lines);
  }
  return lines;
}

}  // namespace ligne
