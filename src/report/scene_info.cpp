#include "report/scene_info.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "picture/choice/method_choice.hpp"
#include "picture/clear/clear_creases.hpp"
#include "picture/culling.hpp"
#include "picture/parse/parse.hpp"
#include "picture/products.hpp"
#include "report/listing.hpp"
#include "visibility/registry.hpp"

namespace ligne {

SceneInfo scene_info(const LoadedModels& models, const ViewRequest& view, const LineRequest& lines, const PageRequest& page,
                     RunReport& run) {
  SceneInfo info;
  PictureRequest request;
  request.lines = lines;
  info.method = &method_of(request);
  const Scene& scene = models.scene;
  info.up_axis = view.up_axis.value_or(scene.up_axis);
  info.up_axis_is_given = view.up_axis.has_value();
  std::optional<Topology> made;
  timed(run.stages, "topology", [&] {
    if (!models.topology) made = build_topology(scene);
  });
  const Topology& topology = made ? *made : *models.topology;
  info.scene = scene_facts(scene, topology);
  ProjectedScene projected;
  timed(run.stages, "project", [&] {
    info.placement = place(scene, camera_of(view, scene), page);
    Creases creases;
    const EdgeSelection all = select_edges(scene, topology, lines, parse_edges("all"), creases, run);
    info.surfaces = surface_facts(found_surfaces(scene, creases.patches));
    projected = project(scene, topology, info.placement.view, all);
    if (lines.cull) info.culled = cull_back_faces(scene, topology, projected, run);
    info.view = view_facts(scene, projected);
  });
  if (!lines.method) info.method = find_method(choice_rules()[choose_rule(facts_of(request, projected))].method);
  info.traits = timed(run.stages, "traits", [&] { return scene_traits(scene, topology, projected, info.up_axis); });
  info.known = timed(run.stages, "facts", [&] { return known_facts(scene, topology, info.traits); });
  return info;
}

std::string meaning_for(const MethodTraits& traits) {
  std::string text = precision_name(traits);
  text += traits.penetration ? "; penetrating faces are drawn correctly" : "; penetrating faces are not drawn correctly";
  if (!traits.only_for.empty()) text += "; only for " + std::string(traits.only_for);
  if (!(traits.products & kStrokes)) text += "; gives no lines";
  return text;
}

std::string color_code_of(const Point3& color) {
  char text[16];
  const auto level = [](double v) { return static_cast<unsigned>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", level(color.x), level(color.y), level(color.z));
  return text;
}

}  // namespace ligne
