#include <nlohmann/json.hpp>

#include "report/scene_info.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

using Json = nlohmann::ordered_json;

Json healed_json(const HealReport& healed) {
  Json json{{"vertices_collapsed", healed.vertices_collapsed},
            {"vertices_at_steps", healed.vertices_at_steps},
            {"objects_twice", healed.objects_twice},
            {"faces_twice", healed.faces_twice},
            {"border_edges", healed.border_edges},
            {"border_edges_sewn", healed.edges_sewn()},
            {"vertices_moved", healed.vertices_moved},
            {"edges_split", healed.edges_split},
            {"faces_turned", healed.faces_turned}};
  json["sewn"] = Json::array();
  for (const SewnBorders& sewn : healed.sewn) {
    json["sewn"].push_back(Json{{"object", sewn.object},
                                {"distance", sewn.distance},
                                {"border_edges", sewn.edges},
                                {"border_edges_left", sewn.edges_left},
                                {"vertices_near", sewn.vertices_near},
                                {"next_gap", sewn.next_gap > 0 ? Json(sewn.next_gap) : Json(nullptr)}});
  }
  return json;
}

Json json_of(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

Json file_json(const ModelFile& file) {
  Json json;
  json["file"] = file.name;
  json["format"] = to_string(file.report.format);
  json["stored"] = {{"faces", file.report.faces}, {"triangles", file.report.triangles}, {"vertices", file.report.vertices}};
  if (!file.report.groups.empty()) json["groups"] = file.report.groups;
  json["warnings"] = Json::object();
  for (const auto& [kind, count] : file.warnings.counts()) json["warnings"][kind] = count;
  for (const auto& [kind, count] : file.warnings.left_out().counts()) json["left_out"][kind] = count;
  if (!file.healed.nothing()) json["healed"] = healed_json(file.healed);
  return json;
}

Json object_json(const SceneFacts& scene, const ObjectFacts& object) {
  Json json;
  json["name"] = object.name;
  json["vertices"] = object.vertices;
  json["faces"] = object.faces;
  json["materials"] = Json::array();
  for (const std::size_t material : object.materials) json["materials"].push_back(scene.materials[material].name);
  json["border_edges"] = object.border_edges;
  json["many_face_edges"] = object.many_face_edges;
  json["unlike_wound_edges"] = object.unlike_wound_edges;
  json["closed"] = object.closed();
  json["windings_agree"] = object.unlike_wound_edges == 0;
  return json;
}

Json scene_json(const LoadedModels& models, const SceneInfo& info) {
  const SceneFacts& facts = info.scene;
  Json scene;
  scene["vertices"] = facts.vertices;
  scene["faces"] = facts.faces;
  scene["faces_with_holes"] = facts.faces_with_holes;
  scene["triangles"] = facts.triangles;
  scene["edges"] = facts.edges;
  scene["border_edges"] = facts.sum(&ObjectFacts::border_edges);
  scene["many_face_edges"] = facts.sum(&ObjectFacts::many_face_edges);
  scene["bounds"] = Json::array({json_of(facts.bounds[0]), json_of(facts.bounds[1])});
  scene["up_axis"] = std::string(1, "xyz"[static_cast<unsigned>(info.up_axis)]);
  scene["cameras"] = Json::array();
  for (const SceneCamera& c : models.scene.cameras) scene["cameras"].push_back(c.name);
  scene["unit_mm"] = models.scene.unit_mm;
  scene["precision"] = facts.precision;
  if (info.surfaces.any()) scene["surfaces"] = json_of(info.surfaces);
  scene["objects"] = Json::array();
  for (const ObjectFacts& object : facts.objects) scene["objects"].push_back(object_json(facts, object));
  scene["materials"] = Json::array();
  for (const MaterialFacts& material : facts.materials) {
    scene["materials"].push_back(Json{{"name", material.name},
                                      {"color", color_code_of(material.color)},
                                      {"opacity", material.opacity},
                                      {"faces", material.faces}});
  }
  return scene;
}

Json view_json(const SceneInfo& info) {
  Json view;
  view["edges"] = Json::object();
  for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
    if (static_cast<LineClass>(c) != LineClass::intersection)
      view["edges"][std::string(kLineClassNames[c])] = info.view.edges[c];
  }
  if (info.culled) {
    view["culled"] = {{"faces", info.culled->faces},
                      {"objects", info.culled->objects - info.culled->kept_objects},
                      {"kept_objects", info.culled->kept_objects}};
  }
  view["depth"] = Json::array({info.view.nearest, info.view.farthest});
  view["perspective"] = info.placement.view.camera.perspective;
  view["page_mm"] = Json::array({info.placement.page.width_mm, info.placement.page.height_mm});
  view["picture_mm"] = info.placement.picture.empty()
                           ? Json(nullptr)
                           : Json::array({info.placement.picture.width(), info.placement.picture.height()});
  view["mm_per_unit"] = info.placement.view.scale;
  return view;
}

}  // namespace

std::string info_json(const LoadedModels& models, const SceneInfo& info) {
  Json json{{"format", "ligne-info"}, {"version", 1}};
  json["files"] = Json::array();
  for (const ModelFile& file : models.files) json["files"].push_back(file_json(file));
  json["scene"] = scene_json(models, info);
  json["view"] = view_json(info);
  json["traits"] = json_of(info.traits);
  json["facts"] = json_of(info.known);
  json["methods"] = Json::array();
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    json["methods"].push_back(
        Json{{"name", traits.name}, {"chosen", method == info.method}, {"meaning", meaning_for(traits)}});
  }
  // Names come from the file and may not be valid UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ligne
