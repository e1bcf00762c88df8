#include "report/scene_info.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/no_index.hpp"
#include "picture/choice/method_choice.hpp"
#include "picture/clear/clear_creases.hpp"
#include "picture/parse/parse.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/products.hpp"
#include "report/listing.hpp"
#include "scene/clean/check_facts.hpp"
#include "scene/model/bounds.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

std::string text_of(const BoundedCount& count) { return (count.complete ? "" : "at least ") + std::to_string(count.n); }

nlohmann::ordered_json json_of(const BoundedCount& count) {
  if (count.complete) return count.n;
  return {{"at_least", count.n}};
}

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

std::string percent(double part) { return rounded(100 * part, 3) + " %"; }

/// The shares of pairs that the axes tell apart, and the privileged axis.
std::string text_of(const FaceSpread& spread) {
  std::string text = "pairs of faces apart ";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    text += std::string(axis > 0 ? ", " : "") + "by " + kAxes[axis] + " " + percent(spread.apart[axis]);
  }
  return text + (spread.privileged ? "; privileged: " + std::string(kAxes[static_cast<std::size_t>(*spread.privileged)])
                                   : "; none is privileged");
}

std::string plural(std::size_t n, const char* one) { return std::to_string(n) + " " + one + (n == 1 ? "" : "s"); }

/// Index of the object that owns the vertex: objects own ascending ranges of vertices.
std::size_t owner(const std::vector<Object>& objects, std::uint32_t vertex) {
  const auto after = std::upper_bound(objects.begin(), objects.end(), vertex,
                                      [](std::uint32_t v, const Object& object) { return v < object.vertex_end; });
  return static_cast<std::size_t>(after - objects.begin());
}

std::string_view name_of(StatedFact fact) { return kStatedFactNames[static_cast<std::size_t>(fact)]; }

KnownFact no_penetration(const Scene& scene, const Topology& topology, const SceneTraits& traits) {
  KnownFact known;
  known.fact = StatedFact::no_penetration;
  known.why_not = why_false(scene, topology, known.fact);
  if (known.why_not.empty() && traits.penetrations.n > 0) {
    known.why_not = std::to_string(traits.penetrations.n) + " pairs of faces pass through each other";
  }
  known.certain = !known.why_not.empty() || tests_all_pairs(topology);
  return known;
}

/// Planes across the axes of the model that have no object on both sides. O(n log n).
std::vector<SeparatingPlane> planes_between(const Scene& scene) {
  std::vector<Bounds> boxes;
  for (const Object& object : scene.objects) {
    if (object.vertex_begin < object.vertex_end) boxes.push_back(bounds_of(scene, object.vertex_begin, object.vertex_end));
  }
  std::vector<SeparatingPlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    std::sort(boxes.begin(), boxes.end(), [&](const Bounds& a, const Bounds& b) { return a.low[axis] < b.low[axis]; });
    for (std::size_t i = 0; i + 1 < boxes.size() && planes.size() < kMostSeparatingPlanes; ++i) {
      // From here on, the upper bound of this box is that of all boxes so far.
      if (boxes[i + 1].low[axis] >= boxes[i].high[axis]) {
        SeparatingPlane plane{{0, 0, 0}, {0, 0, 0}};
        plane.point[axis] = boxes[i].high[axis] + (boxes[i + 1].low[axis] - boxes[i].high[axis]) / 2;
        plane.normal[axis] = 1;
        planes.push_back(plane);
      }
      boxes[i + 1].high[axis] = std::max(boxes[i + 1].high[axis], boxes[i].high[axis]);
    }
  }
  return planes;
}

std::string text_of(const SeparatingPlane& plane) {
  for (int axis = 0; axis < 3; ++axis) {
    if (plane.normal[axis] == 1) return std::string(1, "xyz"[axis]) + " = " + rounded(plane.point[axis]);
  }
  return "through " + rounded(plane.point.x) + ", " + rounded(plane.point.y) + ", " + rounded(plane.point.z);
}

}  // namespace

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
    info.placement = place(picture_of(view, page, scene), page);
    Creases creases;
    const LineClasses classes = parse_edges("all");
    const EdgeSelection all = select_edges(search_creases(scene, topology, lines, classes), lines, classes, creases, run);
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

SceneFacts scene_facts(const Scene& scene, const Topology& topology) {
  SceneFacts facts{.vertices = scene.vertices.size(),
                   .faces = scene.faces.size(),
                   .triangles = topology.triangles.size(),
                   .edges = topology.edges.size()};
  if (!scene.faces.all_triangles()) {
    for (std::size_t f = 0; f < scene.faces.size(); ++f) facts.faces_with_holes += scene.faces.contour_count(f) > 1;
  }
  if (!scene.vertices.empty()) facts.bounds = {scene.vertices[0], scene.vertices[0]};
  for (const Point3& vertex : scene.vertices) {
    facts.bounds = {glm::min(facts.bounds[0], vertex), glm::max(facts.bounds[1], vertex)};
  }
  for (const Object& object : scene.objects) {
    facts.precision = std::max(facts.precision, object.precision);
    ObjectFacts& entry = facts.objects.emplace_back();
    entry.name = object.name;
    entry.vertices = object.vertex_end - object.vertex_begin;
    entry.faces = object.face_end - object.face_begin;
  }
  for (const Material& material : scene.materials)
    facts.materials.push_back({material.name, material.color, material.opacity, 0});
  for (std::size_t i = 0; i < scene.objects.size() && !scene.materials.empty(); ++i) {
    std::set<std::size_t> used;
    for (std::uint32_t face = scene.objects[i].face_begin; face < scene.objects[i].face_end; ++face) {
      const std::size_t material = face < scene.face_material.size() ? scene.face_material[face] : 0;
      if (material >= facts.materials.size()) continue;
      ++facts.materials[material].faces;
      used.insert(material);
    }
    facts.objects[i].materials.assign(used.begin(), used.end());
  }
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    const std::uint16_t flags = topology.edge_flags[e];
    const std::size_t object = owner(scene.objects, edge.v0);
    if (object >= facts.objects.size()) continue;
    ObjectFacts& entry = facts.objects[object];
    entry.border_edges += edge.face1 == kNone;
    entry.many_face_edges += (flags & kEdgeManyFaces) != 0;
    entry.unlike_wound_edges += (flags & kEdgeUnlikeWound) != 0;
  }
  return facts;
}

ViewFacts view_facts(const Scene& scene, const ProjectedScene& projected) {
  ViewFacts facts;
  std::uint32_t last = kNone;
  for (const ProjectedEdge& edge : projected.edges) {
    if (edge.source != last) ++facts.edges[static_cast<std::size_t>(edge.line_class)];
    last = edge.source;
  }
  const Camera& camera = projected.view.camera;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const double depth = glm::dot(camera.forward, scene.vertices[v] - camera.eye);
    facts.nearest = v == 0 ? depth : std::min(facts.nearest, depth);
    facts.farthest = v == 0 ? depth : std::max(facts.farthest, depth);
  }
  return facts;
}

std::string KnownFacts::assumable() const {
  std::string names;
  for (const KnownFact& f : facts) {
    if (f.why_not.empty() && f.certain) names += (names.empty() ? "" : ",") + std::string(name_of(f.fact));
  }
  return names;
}

KnownFacts known_facts(const Scene& scene, const Topology& topology, const SceneTraits& traits) {
  KnownFacts known;
  known.facts.push_back(no_penetration(scene, topology, traits));
  for (const StatedFact fact : {StatedFact::convex, StatedFact::adjacency}) {
    known.facts.push_back({fact, false, why_false(scene, topology, fact), true});
  }
  for (KnownFact& f : known.facts) f.stated = scene.stated.has(f.fact);
  known.planes_stated = !scene.stated.planes.empty();
  known.planes = known.planes_stated ? scene.stated.planes : planes_between(scene);
  return known;
}

std::vector<std::pair<std::string, std::string>> lines_of(const KnownFacts& known) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const KnownFact& f : known.facts) {
    const std::string value = !f.why_not.empty() ? "no: " + f.why_not
                              : f.certain        ? "yes"
                                                 : "none found, not all pairs tested";
    lines.emplace_back(name_of(f.fact), value + (f.stated ? " (stated)" : ""));
  }
  constexpr std::size_t kMostListed = 6;
  std::string planes = std::to_string(known.planes.size()) + (known.planes_stated ? " stated" : " between objects");
  for (std::size_t i = 0; i < std::min(kMostListed, known.planes.size()); ++i) {
    planes += (i == 0 ? ": " : ", ") + text_of(known.planes[i]);
  }
  lines.emplace_back("planes", planes + (known.planes.size() > kMostListed ? " and more" : ""));
  if (const std::string names = known.assumable(); !names.empty()) lines.emplace_back("to state", "--assume " + names);
  return lines;
}

nlohmann::ordered_json json_of(const KnownFacts& known) {
  nlohmann::ordered_json json;
  for (const KnownFact& f : known.facts) {
    nlohmann::ordered_json& entry = json[std::string(name_of(f.fact))];
    entry["holds"] = !f.why_not.empty() ? nlohmann::ordered_json(false)
                     : f.certain        ? nlohmann::ordered_json(true)
                                        : nlohmann::ordered_json(nullptr);
    entry["stated"] = f.stated;
    if (!f.why_not.empty()) entry["why_not"] = f.why_not;
  }
  json["assume"] = known.assumable();
  json["separating_planes"] = nlohmann::ordered_json::array();
  for (const SeparatingPlane& plane : known.planes) {
    const auto list = [](const Point3& p) { return nlohmann::ordered_json::array({p.x, p.y, p.z}); };
    json["separating_planes"].push_back({{"point", list(plane.point)}, {"normal", list(plane.normal)}});
  }
  return json;
}

std::vector<std::pair<std::string, std::string>> lines_of(const SceneTraits& traits) {
  return {
      {"faces", std::to_string(traits.faces) + " with area on the page, " + std::to_string(traits.front_faces) +
                    " facing the viewer, " + std::to_string(traits.transparent_faces) + " transparent"},
      {"visible", text_of(traits.visible_faces) + " faces in front somewhere, each of " + percent(traits.mean_visible_part) +
                      " of the picture on average"},
      {"area", percent(traits.covered_part) + " of the picture has a face"},
      {"corners", rounded(traits.mean_corners, 3) + " of a face on average, " + std::to_string(traits.most_corners) +
                      " at most; " + plural(traits.nonconvex_faces, "face") + " not convex"},
      {"directions", text_of(traits.spread)},
      {"objects", std::to_string(traits.convex_objects) + " convex"},
      {"zones", std::to_string(traits.zones) + ", the largest of " + plural(traits.largest_zone, "face")},
      {"overlap", rounded(traits.mean_overlap, 3) + " faces over a point of the page on average, " +
                      std::to_string(traits.most_overlap) + " at most"},
      {"conflicts", text_of(traits.conflicts) + " pairs of faces overlap on the page"},
      {"penetrations", text_of(traits.penetrations) + " pairs of faces pass through each other"},
      {"turns", std::to_string(traits.turning_vertices) + " vertices where a contour turns back (nbsom')"},
      {"height field", traits.height_field ? "yes" : "no"},
  };
}

nlohmann::ordered_json json_of(const SceneTraits& traits) {
  nlohmann::ordered_json json;
  json["faces"] = traits.faces;
  json["front_faces"] = traits.front_faces;
  json["transparent_faces"] = traits.transparent_faces;
  json["visible_faces"] = json_of(traits.visible_faces);
  json["mean_visible_part"] = traits.mean_visible_part;
  json["covered_part"] = traits.covered_part;
  json["mean_corners"] = traits.mean_corners;
  json["most_corners"] = traits.most_corners;
  json["nonconvex_faces"] = traits.nonconvex_faces;
  json["pairs_apart"] = traits.spread.apart;
  const auto& privileged = traits.spread.privileged;
  json["privileged_direction"] =
      privileged ? nlohmann::ordered_json(kAxes[static_cast<std::size_t>(*privileged)]) : nlohmann::ordered_json(nullptr);
  json["convex_objects"] = traits.convex_objects;
  json["zones"] = traits.zones;
  json["largest_zone"] = traits.largest_zone;
  json["mean_overlap"] = traits.mean_overlap;
  json["most_overlap"] = traits.most_overlap;
  json["conflicts"] = json_of(traits.conflicts);
  json["penetrations"] = json_of(traits.penetrations);
  json["turning_vertices"] = traits.turning_vertices;
  json["height_field"] = traits.height_field;
  return json;
}

}  // namespace ligne
