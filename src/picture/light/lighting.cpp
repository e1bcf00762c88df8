#include "picture/light/lighting.hpp"

#include <utility>

#include "picture/errors.hpp"
#include "picture/light/details.hpp"
#include "picture/light/shadows.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/products.hpp"

namespace ligne {

std::vector<Light> lights_of(const PictureRequest& request, const Scene& scene) {
  std::vector<Light> lights;
  for (const Point3& direction : request.fill.lights) lights.push_back({Light::Kind::parallel, direction});
  const bool shows_light = request.fill.kind == FillKind::shade || request.hatch.kind == HatchKind::shade ||
                           request.lines.classes.has(LineClass::shadow);
  if (lights.empty() && shows_light) lights = scene.lights;
  return lights;
}

void light_regions(const PreparedScene& prepared, VisibilityResult& result, RunReport& run) {
  const Scene& scene = prepared.scene;
  const PictureRequest& request = prepared.request;
  const bool draws_shadows = request.lines.classes.has(LineClass::shadow);
  if (draws_shadows && prepared.lights.empty()) {
    throw RequestError("edges", "there is no light that casts a shadow: give --light, or lights in the scene");
  }
  const bool wanted = wants_regions(request, prepared.method);
  if (!wanted && scene.details.empty()) return;
  timed(run.stages, "regions", [&] {
    if (!result.regions) return;
    if (!scene.details.empty()) *result.regions = cut_details(scene, prepared.view(), std::move(*result.regions));
    if (prepared.lights.empty()) return;
    CastShadows shadows = cast_shadows(scene, build_topology(scene), prepared.view(), prepared.lights, *result.regions);
    *result.regions = std::move(shadows.regions);
    if (draws_shadows) add_shadow_strokes(scene, prepared.view(), shadows.borders, *result.strokes);
  });
}

}  // namespace ligne
