#include "picture/fills.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "base/hash.hpp"
#include "geometry/polygons/merge_contours.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

// Adjustable: brightness of faces without light.
constexpr double kAmbient = 0.35;

constexpr std::uint32_t kAllLights = 0xffffffffu;

/// A light behind the viewer, to the upper left, for scenes without lights.
Light light_over_the_shoulder(const Camera& camera) {
  return {Light::Kind::parallel, camera.forward + 0.5 * camera.right + 0.7 * camera.down};
}

/// Whether the region is narrower, on average, than the rims that its neighbours paint over it. The normals of slivers
/// say little about the surface, so their own colours would be streaks.
bool is_narrow(const Region& region) {
  double twice_area = 0, length = 0;
  for (const std::vector<Point2>& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 p = contour[i], q = contour[i + 1 == contour.size() ? 0 : i + 1];
      twice_area += p.x * q.y - p.y * q.x;
      length += std::hypot(q.x - p.x, q.y - p.y);
    }
  }
  return std::abs(twice_area) < kFillRimMm / 2 * length;
}

/// A colour of middle brightness from the number of a face, by a multiplicative hash (Knuth), of which three bytes are
/// used.
std::array<double, 3> random_color(std::uint32_t face) {
  const std::uint64_t hash = (std::uint64_t{face} + 1) * kGoldenRatio;
  std::array<double, 3> color{};
  constexpr unsigned kDarkest = 80, kRange = 176;
  for (unsigned c = 0; c < 3; ++c) {
    const std::uint64_t level = kDarkest + (hash >> (40 + 8 * c) & 0xff) * kRange / 256;  // of 255
    color[c] = static_cast<double>(level) / 255;
  }
  return color;
}

double brightness_of(double light) { return kAmbient + (1 - kAmbient) * light; }

std::array<double, 3> lit(const Point3& color, double brightness) {
  return {color.x * brightness, color.y * brightness, color.z * brightness};
}

/// The colour in steps of 1/255.
std::array<double, 3> rounded(std::array<double, 3> color) {
  for (double& component : color) component = std::round(std::clamp(component, 0.0, 1.0) * 255) / 255;
  return color;
}

/// The colour of a face before it is rounded.
std::array<double, 3> exact_color(const Point3& material, double light, std::uint32_t face, FillKind kind) {
  if (kind == FillKind::paper) return {1, 1, 1};
  if (kind == FillKind::random) return random_color(face);
  return lit(material, kind == FillKind::material ? 1 : brightness_of(light));
}

/// The colour of each face, before it is rounded.
class FillColors {
 public:
  FillColors(const Scene& scene, const View& view, std::span<const Light> lights, FillKind kind)
      : shoulder_(light_over_the_shoulder(view.camera)),
        light_(scene, view.camera, lights.empty() ? std::span(&shoulder_, 1) : lights),
        kind_(kind) {}

  std::array<double, 3> of(const Material& material, std::uint32_t face, std::uint32_t lights,
                           const std::vector<double>& shares) const {
    const double light = kind_ == FillKind::shade ? light_.of(face, lights, shares) : 1;
    return exact_color(material.color, light, face, kind_);
  }
  double light_on(std::uint32_t face) const { return light_.of(face, kAllLights, {}); }

 private:
  Light shoulder_;
  FaceLight light_;
  FillKind kind_;
};

struct LeveledFill {
  std::uint32_t level;
  bool narrow;
  Fill fill;
};

/// Sorts fills by level, narrow ones first, then by colour. Within a level only rims overlap, and rims hide narrow
/// fills. So fills of one colour may be adjacent, and become one.
std::vector<Fill> in_painting_order(std::vector<LeveledFill> found) {
  std::stable_sort(found.begin(), found.end(), [](const LeveledFill& a, const LeveledFill& b) {
    if (a.level != b.level) return a.level > b.level;
    if (a.narrow != b.narrow) return a.narrow;
    return std::tie(a.fill.opacity, a.fill.color) > std::tie(b.fill.opacity, b.fill.color);
  });
  std::vector<Fill> fills;
  for (std::size_t i = 0; i < found.size();) {
    const LeveledFill& first = found[i];
    Fill& fill = fills.emplace_back(Fill{{}, first.fill.color, first.fill.opacity});
    do {
      std::ranges::move(found[i].fill.contours, std::back_inserter(fill.contours));
    } while (++i < found.size() && fill.opacity >= 1 && found[i].fill.opacity >= 1 && found[i].level == first.level &&
             found[i].narrow == first.narrow && found[i].fill.color == fill.color);
    if (fill.opacity >= 1) fill.contours = merge_contours(fill.contours);
  }
  return fills;
}

}  // namespace

const Material& material_of(const Scene& scene, std::uint32_t face) {
  static const Material standard{};
  const std::uint32_t m = scene.face_material.empty() ? 0 : scene.face_material[face];
  return m < scene.materials.size() ? scene.materials[m] : standard;
}

const Material& material_of(const Scene& scene, const Region& region) {
  return region.material < scene.materials.size() ? scene.materials[region.material] : material_of(scene, region.face);
}

std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions,
                               std::span<const Light> lights, FillKind kind) {
  const FillColors colors(scene, view, lights, kind);
  std::vector<LeveledFill> found;
  for (const Region& region : regions) {
    const Material& material = material_of(scene, region);
    const auto color = rounded(colors.of(material, region.face, region.lights, region.light_shares));
    const bool narrow = kind == FillKind::shade && is_narrow(region);
    found.push_back({region.level, narrow, {region.contours, color, material.opacity}});
  }
  return in_painting_order(std::move(found));
}

std::array<double, 3> fill_color(const Point3& material, double light, std::uint32_t face, FillKind kind) {
  return rounded(exact_color(material, light, face, kind));
}

std::vector<double> lights_of_pieces(const Scene& scene, const View& view, const PaintOrder& order,
                                     std::span<const Light> lights) {
  const FillColors colors(scene, view, lights, FillKind::shade);
  std::vector<double> found;
  found.reserve(order.pieces.size());
  for (const PaintPiece& piece : order.pieces) found.push_back(colors.light_on(piece.face));
  return found;
}

/// Fills the areas of faces seen through transparent ones. color_of(face) is the colour of a face.
template <class ColorOf>
static std::vector<Fill> fills_seen(const Scene& scene, const std::vector<Region>& areas, const TransparentLayers& layers,
                                    const ColorOf& color_of) {
  const auto opacity_of = [&](std::uint32_t face) { return material_of(scene, face).opacity; };
  std::vector<LeveledFill> found;
  found.reserve(areas.size());
  for (const Region& area : areas) {
    const auto color = rounded(seen_color<3>(layers, {area.face, area.in_front}, color_of, opacity_of));
    found.push_back({0, is_narrow(area), {area.contours, color, 1}});
  }
  return in_painting_order(std::move(found));
}

std::vector<Fill> fill_areas(const Scene& scene, const View& view, const std::vector<Region>& areas,
                             const TransparentLayers& layers, std::span<const Light> lights, FillKind kind) {
  const FillColors colors(scene, view, lights, kind);
  return fills_seen(scene, areas, layers,
                    [&](std::uint32_t face) { return colors.of(material_of(scene, face), face, kAllLights, {}); });
}

std::vector<Fill> fill_gray(const Scene& scene, const std::vector<Region>& areas, const TransparentLayers& layers,
                            const std::vector<double>& brightness) {
  return fills_seen(scene, areas, layers, [&](std::uint32_t face) {
    const double gray = face < brightness.size() ? brightness[face] : 1;
    return std::array{gray, gray, gray};
  });
}

SmoothFillColors::SmoothFillColors(const Scene& scene, const Camera& camera, std::span<const Light> lights)
    : scene_(scene),
      shoulder_(light_over_the_shoulder(camera)),
      light_(scene, camera, lights.empty() ? std::span<const Light>(&shoulder_, 1) : lights) {}

std::array<double, 3> SmoothFillColors::of(std::uint32_t face, const std::optional<SurfacePoint>& surface) const {
  const double light = surface ? light_.at(surface->point, surface->normal) : light_.of(face);
  return lit(material_of(scene_, face).color, brightness_of(light));
}

std::vector<Fill> fill_pieces(const Scene& scene, const View& view, const PaintOrder& order, std::span<const Light> lights,
                              FillKind kind) {
  const FillColors colors(scene, view, lights, kind);
  std::vector<Fill> fills;
  fills.reserve(order.pieces.size());
  for (const PaintPiece& piece : order.pieces) {
    const Material& material = material_of(scene, piece.face);
    fills.push_back({piece.contours, rounded(colors.of(material, piece.face, kAllLights, {})), material.opacity, true});
  }
  return fills;
}

}  // namespace ligne
