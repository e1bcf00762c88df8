#include "picture/hatching/form_hatching.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "picture/errors.hpp"
#include "picture/fills.hpp"
#include "picture/hatching/form_strokes.hpp"
#include "picture/hatching/hatch_layers.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

// Adjustable.
constexpr double kSmoothSpacings = 12;  ///< smoothing distance of directions, in closest stroke distances
constexpr double kCrossedFrom = 0.6;    ///< darkness from which strokes are crossed without request

/// The first direction at a node of a surface without curvature: its level line, or on level surfaces the direction of
/// straight strokes on the page.
Point3 flat_direction(const FormMesh& mesh, const HatchScene& hatch, std::uint32_t node) {
  constexpr double kLevel = 1e-3;  // sine of the slope below which a surface counts as level
  Point3 up{0, 0, 0};
  up[static_cast<int>(hatch.prepared.scene.up_axis)] = 1;
  const Point3 normal = mesh.normals[node], level = glm::cross(normal, up);
  const double length = glm::length(level);
  if (length > kLevel) return level / length;
  const Camera& camera = hatch.prepared.view().camera;
  const double angle = hatch.request().direction.degrees * std::acos(-1.0) / 180;
  const Point3 way = camera.right * std::cos(angle) - camera.down * std::sin(angle);
  const Point3 sight = camera.perspective ? mesh.points[node] - camera.eye : camera.forward;
  const double rise = glm::dot(normal, sight);
  const Point3 flat = rise != 0 ? way - sight * (glm::dot(normal, way) / rise) : glm::cross(normal, sight);
  const double size = glm::length(flat);
  return size > 0 ? flat / size : Point3{0, 0, 0};
}

FormField field_of(const HatchScene& hatch, double length) {
  if (hatch.request().direction.form == FormLines::iso) {
    const SurfaceCurves* curves = hatch.prepared.request.iso.get();
    if (!curves) throw RequestError("hatch-angle", "iso is for surfaces; curvature follows the form of a mesh");
    return curve_field(hatch.form, *curves);
  }
  return curvature_field(hatch.form, length, [&](std::uint32_t node) { return flat_direction(hatch.form, hatch, node); });
}

/// The light of faces, interpolated over smooth surfaces, and the share that reaches their regions.
class FormLight {
 public:
  FormLight(const HatchScene& hatch, const FormMesh& mesh)
      : light_(hatch.prepared.scene, hatch.prepared.view().camera, hatch.prepared.lights),
        mesh_(mesh),
        of_node_(mesh.points.size(), 0) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const double share = glm::length(mesh.area_vector(t)) / 6 * light_.of(mesh.triangles[t].face);
      for (const std::uint32_t node : mesh.triangles[t].node) of_node_[node] += share;
    }
    for (std::size_t n = 0; n < of_node_.size(); ++n) of_node_[n] = mesh.areas[n] > 0 ? of_node_[n] / mesh.areas[n] : 0;
  }

  double at(const FormPlace& place, const Region& region) const {
    double light = 0;
    for (std::size_t k = 0; k < 3; ++k) light += place.weights[k] * of_node_[mesh_.triangles[place.triangle].node[k]];
    if (region.lights != 0xffffffffu || !region.light_shares.empty()) {
      const double whole = light_.of(region.face);
      light = whole > 0 ? light * light_.of(region.face, region.lights, region.light_shares) / whole : 0;
    }
    return std::clamp(light, 0.0, 1.0);
  }

 private:
  FaceLight light_;
  const FormMesh& mesh_;
  std::vector<double> of_node_;
};

/// Darkness of a place: 1 with the closest strokes, 0 with none; and the darkness of the strokes across.
struct Darkness {
  double first = 1, second = 0;
};

Darkness darkness_of(const HatchRequest& request, double light, unsigned shade) {
  Darkness darkness;
  if (request.kind == HatchKind::material) {
    darkness.first = 1.0 / shade;
  } else if (request.kind == HatchKind::shade && request.levels.value_or(0) > 0) {
    darkness.first = std::ldexp(1.0, 1 - static_cast<int>(shade));
  } else if (request.kind == HatchKind::shade) {
    darkness.first = light > kBrightestHatched ? 0 : std::max(1 - light, 1 / kSparsest);
    darkness.second = std::max(0.0, (1 - light - kCrossedFrom) / (1 - kCrossedFrom));
  }
  if (request.cross) darkness.second = darkness.first;
  return darkness;
}

double spacing_of(double darkness, double closest_mm) {
  return darkness * kSparsest >= 1 ? closest_mm / darkness : FormTone::kNoStrokes;
}

/// Throws RequestError if strokes would need too many points.
void check_points(const PictureRequest& request, const std::vector<Region>& regions, double closest_mm, double most) {
  double area = 0;
  for (const Region& region : regions) {
    if (region.level > 0) continue;
    const auto& contour = region.contours.front();
    double twice = 0;
    for (std::size_t i = 0, before = contour.size() - 1; i < contour.size(); before = i++) {
      twice += contour[before].x * contour[i].y - contour[before].y * contour[i].x;
    }
    area += std::abs(twice) / 2;
  }
  const double points = area / (closest_mm * kFormStep * closest_mm);
  if (points > most) throw RequestError("hatch-spacing", "the strokes are too dense");
  request.memory.require(points * kFormPointBytes, {"hatch", "strokes that follow the form"});
}

}  // namespace

std::vector<Layer> hatch_form(const HatchScene& hatch, const std::vector<Region>& regions) {
  const PreparedScene& prepared = hatch.prepared;
  const HatchRequest& request = hatch.request();
  const View& view = prepared.view();
  HatchLayers layers(hatch);
  const double pen_mm = layers.pen_mm(0, ""), closest_mm = closest_strokes_mm(request, pen_mm);
  FormStrokeOptions options{.closest_mm = closest_mm, .shortest_mm = prepared.request.lines.least_mm.value_or(0)};
  check_points(prepared.request, regions, closest_mm, options.most_points);
  const FormField field = field_of(hatch, kSmoothSpacings * closest_mm / view.scale);
  const FormRegions seen(prepared.scene, hatch.form, view, regions, closest_mm);
  const FormWalk walk(hatch.form, view, seen);
  const FormLight light(hatch, hatch.form);
  const auto tone = [&](const FormPlace& place) {
    FormTone tone;
    const Region& region = seen[seen.region_near(hatch.form.triangles[place.triangle].face, place.page)];
    const Material& material = material_of(prepared.scene, region);
    const double lit = light.at(place, region);
    const unsigned levels = request.levels.value_or(0), shades = levels == 0 ? kMostShades : levels;
    unsigned shade = 1;
    if (request.kind == HatchKind::shade) shade += std::min(shades - 1, static_cast<unsigned>(lit * shades));
    if (request.kind == HatchKind::material) {
      const double luminance = glm::dot(material.color, Point3{0.2126, 0.7152, 0.0722});  // ITU-R BT.709
      shade += static_cast<unsigned>(std::clamp(luminance, 0.0, 0.99) * kMostShades);
    }
    Darkness darkness = darkness_of(request, lit, shade);
    if (!prepared.lights.empty() && region.lights == 0) darkness.second = darkness.first;
    tone.spacing_mm = {spacing_of(darkness.first, closest_mm), spacing_of(darkness.second, closest_mm)};
    tone.layer = layers.number(shade, material.name);
    tone.pen_mm = layers.pen_mm(layers.all()[tone.layer]);
    return tone;
  };
  try {
    for (const FormStroke& stroke :
         form_strokes({hatch.form, field, walk, seen, hatch.patches.of_face}, regions, tone, options)) {
      layers.all()[stroke.layer].lines.add(stroke.points);
    }
  } catch (const std::length_error&) {
    throw RequestError("hatch-spacing", "the strokes are too dense");
  }
  return layers.take();
}

}  // namespace ligne
