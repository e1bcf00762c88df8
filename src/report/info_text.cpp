#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "files/message_text.hpp"
#include "report/scene_info.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Largest number of objects listed in the text; the JSON lists all.
constexpr std::size_t kMostObjectLines = 20;
/// Longest name in the text, in bytes; the JSON has the whole name.
constexpr std::size_t kLongestName = 120;

std::string point_text(const Point3& p) { return rounded(p.x) + ", " + rounded(p.y) + ", " + rounded(p.z); }

/// A line whose label has its own column.
std::string line(const std::string& label, const std::string& value) {
  constexpr std::size_t width = 15;
  return "  " + label + std::string(label.size() < width ? width - label.size() : 1, ' ') + value + "\n";
}

/// The last line of a list of `size` items of which `most` are named.
std::string rest_line(std::size_t size, std::size_t most, const char* noun = "more") {
  return size > most ? line("", "and " + std::to_string(size - most) + " " + noun) : "";
}

std::string closedness(const ObjectFacts& object) {
  if (object.solid()) return "closed, consistently wound";
  if (object.closed()) return "closed, inconsistently wound at " + std::to_string(object.unlike_wound_edges) + " edges";
  if (object.faces == 0) return "no faces";
  return "open: " + std::to_string(object.border_edges) + " border edges, " + std::to_string(object.many_face_edges) +
         " edges of more than two faces";
}

/// Largest number of objects with sewn borders that are listed.
constexpr std::size_t kMostSewnLines = 5;

/// Lists the healed faults.
std::string healed_text(const ModelFile& file) {
  const HealReport& healed = file.healed;
  std::string text;
  const auto add = [&](const std::string& what) { text += line("healed", what); };
  if (healed.vertices_collapsed > 0)
    add(std::to_string(healed.vertices_collapsed) + " vertices merged with others within rounding");
  if (healed.vertices_at_steps > 0)
    add(std::to_string(healed.vertices_at_steps) + " vertices merged with others at steps too low to be seen");
  if (healed.objects_twice > 0) add(std::to_string(healed.objects_twice) + " objects coincide with another one: omitted");
  if (healed.faces_twice > 0)
    add(std::to_string(healed.faces_twice) + " faces have the vertices of another face: drawn once, from both sides");
  if (healed.faces_turned > 0) add(std::to_string(healed.faces_turned) + " faces reversed to agree with their neighbours");
  if (healed.sewn.empty()) return text;
  add(std::to_string(healed.edges_sewn()) + " of " + std::to_string(healed.border_edges) + " border edges sewn: " +
      std::to_string(healed.vertices_moved) + " vertices merged, edges split at " + std::to_string(healed.edges_split));
  for (std::size_t i = 0; i < std::min(healed.sewn.size(), kMostSewnLines); ++i) {
    const SewnBorders& sewn = healed.sewn[i];
    text += line("", "object " + std::to_string(sewn.object) + ": " + std::to_string(sewn.vertices_near) +
                         " vertices lie within " + rounded(sewn.distance, 3) + " of another border, the others " +
                         (sewn.next_gap > 0 ? "from " + rounded(sewn.next_gap, 3) + " on" : "much farther"));
  }
  return text + rest_line(healed.sewn.size(), kMostSewnLines, "more objects");
}

/// Lists the groups of an OBJ. Options that select objects make them objects.
std::string groups_text(const std::vector<std::string>& groups) {
  std::string text;
  for (std::size_t i = 0; i < std::min(groups.size(), kMostObjectLines); ++i) {
    text += (i > 0 ? ", " : "") + printable(groups[i], kLongestName);
  }
  if (groups.size() > kMostObjectLines) text += " and " + std::to_string(groups.size() - kMostObjectLines) + " more";
  return text + " (objects for --only, --hide, --move, --group, --color)";
}

std::string file_text(const ModelFile& file) {
  std::string text = printable(file.name, kLongestPath) + "\n";
  text += line("format", std::string(to_string(file.report.format)));
  text += line("as stored", std::to_string(file.report.faces) + " faces, " + std::to_string(file.report.triangles) +
                                " triangles, " + std::to_string(file.report.vertices) + " vertices");
  if (!file.report.groups.empty()) text += line("groups", groups_text(file.report.groups));
  for (const auto& [kind, count] : file.warnings.counts()) text += line("repaired", ligne::counted(count, kind));
  if (!file.warnings.left_out().empty()) text += line("left out", file.warnings.left_out().list());
  text += healed_text(file);
  return text;
}

std::string material_text(const MaterialFacts& material, std::size_t number) {
  return (material.name.empty() ? "material " + std::to_string(number) : printable(material.name, kLongestName)) + " " +
         color_code_of(material.color);
}

/// Lists the colours of an object, by its materials.
std::string colors_of(const SceneFacts& scene, const ObjectFacts& object) {
  constexpr std::size_t kMostNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(object.materials.size(), kMostNamed); ++i)
    text += ", " + material_text(scene.materials[object.materials[i]], object.materials[i]);
  if (object.materials.size() > kMostNamed)
    text += " and " + std::to_string(object.materials.size() - kMostNamed) + " more materials";
  return text;
}

/// Lists the materials with their names for --pen material:NAME.
std::string materials_text(const SceneFacts& scene) {
  std::string text;
  for (std::size_t i = 0; i < std::min(scene.materials.size(), kMostObjectLines); ++i) {
    const MaterialFacts& material = scene.materials[i];
    std::string value = material_text(material, i) + ": " + std::to_string(material.faces) + " faces";
    if (material.opacity < 1) value += ", opacity " + rounded(material.opacity, 3);
    text += line(i == 0 ? "materials" : "", value);
  }
  return text + rest_line(scene.materials.size(), kMostObjectLines);
}

/// Largest number of groups of surfaces in the text; the JSON has all.
constexpr std::size_t kMostSurfaceLines = 10;

std::string surfaces_text(const SurfaceFacts& surfaces) {
  if (!surfaces.any()) return "";
  std::string text = line("surfaces", counts_text(surfaces));
  for (std::size_t i = 0; i < std::min(surfaces.groups.size(), kMostSurfaceLines); ++i) {
    text += line("", group_text(surfaces.groups[i]));
  }
  return text + rest_line(surfaces.groups.size(), kMostSurfaceLines);
}

std::string objects_text(const SceneFacts& scene) {
  std::size_t closed = 0, solid = 0;
  for (const ObjectFacts& object : scene.objects) {
    closed += object.closed();
    solid += object.solid();
  }
  std::string text = line("objects", std::to_string(scene.objects.size()) + ", " + std::to_string(closed) + " closed, " +
                                         std::to_string(solid) + " of them consistently wound");
  // Copies of a part, such as the screws of an assembly, share a line.
  std::vector<std::pair<std::string, std::size_t>> kinds;
  std::unordered_map<std::string, std::size_t> kind_of;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectFacts& object = scene.objects[i];
    const std::string value = (object.name.empty() ? "object " + std::to_string(i) : printable(object.name, kLongestName)) +
                              ": " + std::to_string(object.faces) + " faces, " + closedness(object) +
                              colors_of(scene, object);
    const auto [kind, is_new] = kind_of.try_emplace(value, kinds.size());
    if (is_new) kinds.emplace_back(value, 0);
    ++kinds[kind->second].second;
  }
  for (std::size_t i = 0; i < std::min(kinds.size(), kMostObjectLines); ++i) {
    text += line("", kinds[i].first + (kinds[i].second > 1 ? " (" + std::to_string(kinds[i].second) + " times)" : ""));
  }
  return text + rest_line(kinds.size(), kMostObjectLines);
}

/// The up axis. Formats that do not tell it have a usual one, which many of their files do not keep to.
std::string up_axis_text(const LoadedModels& models, const SceneInfo& info) {
  std::string axis(1, "xyz"[static_cast<unsigned>(info.up_axis)]);
  if (info.up_axis_is_given || models.files.empty()) return axis;
  const ModelFormat format = models.files.front().report.format;
  constexpr ModelFormat kSilent[] = {ModelFormat::obj, ModelFormat::stl_ascii, ModelFormat::stl_binary, ModelFormat::ply,
                                     ModelFormat::off};
  if (std::ranges::find(kSilent, format) == std::end(kSilent)) return axis;
  const std::string other = info.up_axis == Axis::z ? "y" : "z";
  return axis + " (" + std::string(to_string(format)) + " does not tell; if the model lies: --up-axis " + other + ")";
}

}  // namespace

std::string info_text(const LoadedModels& models, const SceneInfo& info) {
  std::string text;
  for (const ModelFile& file : models.files) text += file_text(file);
  const SceneFacts& scene = info.scene;
  text += "scene\n" + objects_text(scene);
  text += materials_text(scene);
  text += line("vertices", std::to_string(scene.vertices));
  text += line("faces", std::to_string(scene.faces) + ", " + std::to_string(scene.faces_with_holes) + " with holes");
  text += line("triangles", std::to_string(scene.triangles));
  text +=
      line("edges", std::to_string(scene.edges) + ", " + std::to_string(scene.sum(&ObjectFacts::border_edges)) +
                        " border, " + std::to_string(scene.sum(&ObjectFacts::many_face_edges)) + " of more than two faces");
  text += surfaces_text(info.surfaces);
  text += line("bounding box", point_text(scene.bounds[0]) + " to " + point_text(scene.bounds[1]));
  text += line("up axis", up_axis_text(models, info));
  std::string cameras;
  for (const SceneCamera& c : models.scene.cameras) cameras += (cameras.empty() ? "" : ", ") + printable(c.name);
  if (!cameras.empty()) text += line("cameras", cameras);
  text += line("unit", shortest(models.scene.unit_mm) + " mm");
  text += line("precision", rounded(scene.precision, 3) + " model units");

  text += "view\n";
  for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
    // Intersections are not edges of the scene; a method finds them.
    if (static_cast<LineClass>(c) == LineClass::intersection) continue;
    text += line(std::string(kLineClassNames[c]), std::to_string(info.view.edges[c]) + " edges");
  }
  if (info.culled) {
    text += line("back faces", std::to_string(info.culled->faces) + " left out, of " +
                                   std::to_string(info.culled->objects - info.culled->kept_objects) + " of " +
                                   std::to_string(info.culled->objects) + " objects");
  }
  text += line("depth", rounded(info.view.nearest) + " to " + rounded(info.view.farthest) + " along the view direction");
  const Page& page = info.placement.page;
  text += line("page", rounded(page.width_mm) + " x " + rounded(page.height_mm) + " mm");
  text += line("picture", info.placement.picture.empty()
                              ? "nothing is in view"
                              : rounded(info.placement.picture.width(), 4) + " x " +
                                    rounded(info.placement.picture.height(), 4) + " mm, " +
                                    rounded(info.placement.view.scale, 4) + " mm per model unit" +
                                    (info.placement.larger_than_page() ? ", larger than the page" : ""));
  text += "visibility\n";
  for (const auto& [name, value] : lines_of(info.traits)) text += line(name, value);
  text += "facts\n";
  for (const auto& [name, value] : lines_of(info.known)) text += line(name, value);
  text += "methods\n";
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    text += line(std::string(traits.name), meaning_for(traits) + (method == info.method ? " (chosen)" : ""));
  }
  return text;
}

}  // namespace ligne
