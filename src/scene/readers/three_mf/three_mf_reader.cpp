#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "base/no_index.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/precision.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/readers/zip_archive.hpp"

namespace ligne {
namespace {

/// Access to the parts of a 3MF archive.

/// A group of materials of one resource: base materials, or colours.
using ThreeMfMaterials = std::vector<Material>;

/// A model part, with its elements by their ids.
struct ThreeMfPart {
  std::string path;  ///< path in the archive
  pugi::xml_document xml;
  pugi::xml_node model;
  std::map<std::string, pugi::xml_node> objects;
  std::map<std::string, ThreeMfMaterials> materials;
};

class ThreeMfDocument {
 public:
  ThreeMfDocument(const ZipArchive& archive, const std::string& name, Warnings& warnings)
      : archive_(archive), name_(name), warnings_(warnings) {}

  /// The part that the archive's relations declare as its model.
  ThreeMfPart& root();
  /// A part by its path, read on first use. Throws InputError.
  ThreeMfPart& part(const std::string& path);

 private:
  void parse(ThreeMfPart& part);
  void read_resources(ThreeMfPart& part);

  const ZipArchive& archive_;
  const std::string& name_;
  Warnings& warnings_;
  std::map<std::string, std::unique_ptr<ThreeMfPart>> parts_;
};

/// The name of an element or attribute without its prefix.
std::string_view local_name(const char* name) {
  const std::string_view whole(name);
  const std::size_t colon = whole.find(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

/// An attribute by its local name, with any prefix; empty if there is none.
std::string_view attribute_of(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    if (local_name(attribute.name()) == name) return attribute.value();
  }
  return {};
}

/// Elements that no drawing needs, or that are read elsewhere.
constexpr std::array<std::string_view, 9> kKnownElements{"metadata", "metadatagroup", "resources", "build",        "object",
                                                         "mesh",     "components",    "base",      "basematerials"};

int hex_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// Reads "#rrggbb" or "#rrggbbaa".
bool read_color(std::string_view text, Material& material) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return false;
  std::array<double, 4> parts{0, 0, 0, 1};
  for (std::size_t k = 0; 2 * k + 2 < text.size(); ++k) {
    const int high = hex_of(text[2 * k + 1]), low = hex_of(text[2 * k + 2]);
    if (high < 0 || low < 0) return false;
    parts[k] = (16 * high + low) / 255.0;
  }
  material.color = {parts[0], parts[1], parts[2]};
  material.opacity = parts[3];
  return true;
}

/// Materials of a basematerials or colorgroup element.
ThreeMfMaterials materials_of(const pugi::xml_node& group) {
  ThreeMfMaterials materials;
  for (const pugi::xml_node& entry : group.children()) {
    const bool is_base = local_name(entry.name()) == "base";
    const std::string_view color = attribute_of(entry, is_base ? "displaycolor" : "color");
    Material& material = materials.emplace_back();
    material.name = is_base ? attribute_of(entry, "name") : color;
    read_color(color, material);
  }
  return materials;
}

/// Twelve numbers, row by row, as a matrix for column vectors; nothing if the text is not that.
std::optional<glm::dmat4> transform_of(std::string_view text) {
  glm::dmat4 m(1);
  if (text.empty()) return m;
  // The file multiplies row vectors by its matrix, so its rows are columns here.
  for (int i = 0; i < 12; ++i) {
    const std::optional<double> value = number_in(take_word(text));
    if (!value) return std::nullopt;
    m[i / 3][i % 3] = *value;
  }
  return trimmed(text).empty() ? std::optional(m) : std::nullopt;
}

/// Path of the model that the archive declares; empty if it is no 3MF.
std::string model_path(const ZipArchive& archive) {
  if (const ZipEntry* const relations = archive.find("_rels/.rels")) {
    const std::vector<std::byte> bytes = archive.read(*relations);
    pugi::xml_document xml;
    if (xml.load_buffer(bytes.data(), bytes.size())) {
      for (const pugi::xml_node& relation : xml.document_element().children()) {
        if (!attribute_of(relation, "Type").ends_with("/3dmodel")) continue;
        std::string path(attribute_of(relation, "Target"));
        path.erase(0, path.find_first_not_of('/'));
        if (archive.find(path)) return path;
      }
    }
  }
  return archive.find("3D/3dmodel.model") ? "3D/3dmodel.model" : "";
}

ThreeMfPart& ThreeMfDocument::root() { return part(model_path(archive_)); }

ThreeMfPart& ThreeMfDocument::part(const std::string& path) {
  std::unique_ptr<ThreeMfPart>& known = parts_[path];
  if (known) return *known;
  const ZipEntry* const entry = archive_.find(path);
  if (!entry) throw InputError(name_, "there is no part " + shown(path));
  const std::vector<std::byte> bytes = archive_.read(*entry);
  known = std::make_unique<ThreeMfPart>();
  known->path = path;
  const pugi::xml_parse_result result = known->xml.load_buffer(bytes.data(), bytes.size());
  if (!result) {
    throw InputError(name_, "part " + shown(path) + ": broken XML at byte " + std::to_string(result.offset) + ": " +
                                result.description());
  }
  parse(*known);
  return *known;
}

void ThreeMfDocument::parse(ThreeMfPart& part) {
  part.model = part.xml.document_element();
  if (local_name(part.model.name()) != "model") throw InputError(name_, "part " + shown(part.path) + " is not a model");
  for (const pugi::xml_node& child : part.model.children()) {
    const std::string_view kind = local_name(child.name());
    if (std::ranges::find(kKnownElements, kind) == kKnownElements.end())
      warnings_.leave_out("elements " + std::string(child.name()));
  }
  read_resources(part);
}

void ThreeMfDocument::read_resources(ThreeMfPart& part) {
  for (const pugi::xml_node& resources : part.model.children()) {
    if (local_name(resources.name()) != "resources") continue;
    for (const pugi::xml_node& child : resources.children()) {
      const std::string_view kind = local_name(child.name());
      const std::string id(attribute_of(child, "id"));
      if (kind == "object") {
        if (!part.objects.emplace(id, child).second) throw InputError(name_, "object " + shown(id) + " is given twice");
      } else if (kind == "basematerials" || kind == "colorgroup") {
        part.materials[id] = materials_of(child);
      } else if (kind == "texture2d") {
        warnings_.leave_out("textures");
      } else if (child.type() == pugi::node_element) {
        warnings_.leave_out("elements " + std::string(child.name()));
      }
    }
  }
}

/// Largest nesting depth of objects; files have two or three levels.
constexpr int kMostLevels = 64;
/// Largest number of nested objects, and of triangles, that a small file may make by repeating its meshes.
constexpr std::size_t kMostReferences = std::size_t{1} << 18, kMostTriangles = std::size_t{1} << 25;
/// Number of roundings of a coordinate in a transform.
constexpr double kRoundings = 4;

constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{
    {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1000}}};

/// A mesh as stored in the file.
struct ThreeMfMesh {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> materials;  ///< per triangle, index in the scene; kNone: none
  double precision = 0;
};

class ThreeMfReader {
 public:
  ThreeMfReader(const ZipArchive& archive, const ModelReading& in)
      : document_(archive, in.file.name, in.warnings), in_(in), builder_(in.file.name, in.report) {}

  Scene read() {
    ThreeMfPart& root = document_.root();
    builder_.scene().unit_mm = unit_of(root);
    bool has_build = false;
    for (const pugi::xml_node& build : root.model.children()) {
      if (local_name(build.name()) != "build") continue;
      has_build = true;
      for (const pugi::xml_node& item : build.children()) {
        if (local_name(item.name()) == "item") add_reference(root, item, glm::dmat4(1), 0);
      }
    }
    if (!has_build) throw InputError(in_.file.name, "its model has no build element");
    return builder_.finish(Axis::z, in_.warnings.left_out());
  }

 private:
  double unit_of(const ThreeMfPart& part) const {
    const std::string_view unit = attribute_of(part.model, "unit");
    if (unit.empty()) return 1;
    const auto known = std::ranges::find(kUnits, unit, &std::pair<std::string_view, double>::first);
    if (known == kUnits.end()) throw InputError(in_.file.name, "unit " + shown(unit) + " is not known");
    return known->second;
  }

  /// Adds an item of the build, or a component of an object: a transformed object of this part or of another one.
  void add_reference(ThreeMfPart& part, const pugi::xml_node& reference, const glm::dmat4& to_build, int level) {
    const std::string id(attribute_of(reference, "objectid"));
    std::string path(attribute_of(reference, "path"));
    path.erase(0, std::min(path.find_first_not_of('/'), path.size()));
    ThreeMfPart& of_object = path.empty() ? part : document_.part(path);
    const std::optional<glm::dmat4> transform = transform_of(attribute_of(reference, "transform"));
    if (!transform) throw InputError(in_.file.name, "the transform of object " + shown(id) + " is not twelve numbers");
    const auto object = of_object.objects.find(id);
    if (object == of_object.objects.end()) throw InputError(in_.file.name, "there is no object " + shown(id));
    if (level > kMostLevels)
      throw InputError(in_.file.name, "object " + shown(id) + " contains itself, or is nested too deeply");
    if (++used_ > kMostReferences) throw InputError(in_.file.name, "there are too many repeated objects");
    add_object(of_object, id, object->second, to_build * *transform, level);
  }

  void add_object(ThreeMfPart& part, const std::string& id, const pugi::xml_node& object, const glm::dmat4& to_build,
                  int level) {
    const std::string_view type = attribute_of(object, "type");
    if (type == "support" || type == "solidsupport") return in_.warnings.leave_out("supports");
    for (const pugi::xml_node& child : object.children()) {
      const std::string_view kind = local_name(child.name());
      if (kind == "mesh") {
        add_mesh(mesh_of(part, id, object, child), std::string(attribute_of(object, "name")), to_build);
      } else if (kind == "components") {
        for (const pugi::xml_node& component : child.children()) add_reference(part, component, to_build, level + 1);
      } else if (kind != "metadatagroup" && child.type() == pugi::node_element) {
        in_.warnings.leave_out("elements " + std::string(child.name()));
      }
    }
  }

  const ThreeMfMesh& mesh_of(ThreeMfPart& part, const std::string& id, const pugi::xml_node& object,
                             const pugi::xml_node& mesh) {
    const auto [entry, is_new] = meshes_.try_emplace({part.path, id});
    if (!is_new) return entry->second;
    ThreeMfMesh& out = entry->second;
    const std::string place = "object " + shown(id);
    for (const pugi::xml_node& child : mesh.children()) {
      const std::string_view kind = local_name(child.name());
      if (kind == "vertices")
        read_vertices(child, place, out);
      else if (kind == "triangles")
        read_triangles(part, object, child, place, out);
      else if (child.type() == pugi::node_element)
        in_.warnings.leave_out("elements " + std::string(child.name()));
    }
    return out;
  }

  void read_vertices(const pugi::xml_node& list, const std::string& place, ThreeMfMesh& mesh) {
    DecimalPrecision precision;
    constexpr std::array kAxes{"x", "y", "z"};
    for (const pugi::xml_node& vertex : list.children()) {
      Point3 p;
      for (int k = 0; k < 3; ++k) {
        const std::string_view word = vertex.attribute(kAxes[static_cast<std::size_t>(k)]).value();
        const std::optional<double> value = number_in(word);
        if (!value) {
          throw InputError(in_.file.name, place + ": " + shown(word) + " is not a coordinate of vertex " +
                                              std::to_string(mesh.vertices.size()));
        }
        precision.add(word, *value);
        p[k] = *value;
      }
      mesh.vertices.push_back(p);
    }
    mesh.precision = precision.value();
  }

  void read_triangles(const ThreeMfPart& part, const pugi::xml_node& object, const pugi::xml_node& list,
                      const std::string& place, ThreeMfMesh& mesh) {
    const std::string object_group(attribute_of(object, "pid"));
    const std::string_view object_index = attribute_of(object, "pindex");
    constexpr std::array kCorners{"v1", "v2", "v3"};
    for (const pugi::xml_node& triangle : list.children()) {
      for (const char* corner : kCorners) {
        const std::string_view word = triangle.attribute(corner).value();
        const std::optional<std::int64_t> index = parse_integer(word);
        if (!index || *index < 0 || *index >= static_cast<std::int64_t>(mesh.vertices.size())) {
          throw InputError(in_.file.name, place + ": triangle " + std::to_string(mesh.corners.size() / 3) +
                                              " names vertex " + printable(word) + " of " +
                                              std::to_string(mesh.vertices.size()));
        }
        mesh.corners.push_back(static_cast<std::uint32_t>(*index));
      }
      const pugi::xml_attribute group = triangle.attribute("pid"), index = triangle.attribute("p1");
      mesh.materials.push_back(
          material_of(part, group ? group.value() : object_group, index ? index.value() : object_index));
    }
  }

  /// The scene's index of a material of the file. A triangle whose corners differ gets the material of the first.
  std::uint32_t material_of(const ThreeMfPart& part, const std::string& group, std::string_view index) {
    const auto materials = part.materials.find(group);
    const std::optional<std::int64_t> number = parse_integer(index);
    if (materials == part.materials.end() || !number || *number < 0 ||
        *number >= static_cast<std::int64_t>(materials->second.size())) {
      return kNone;
    }
    const auto [entry, is_new] = materials_.try_emplace({&materials->second, *number}, builder_.scene().materials.size());
    if (is_new) builder_.scene().materials.push_back(materials->second[static_cast<std::size_t>(*number)]);
    return static_cast<std::uint32_t>(entry->second);
  }

  void add_mesh(const ThreeMfMesh& mesh, const std::string& name, const glm::dmat4& to_build) {
    triangles_ += mesh.corners.size() / 3;
    if (triangles_ > kMostTriangles) throw InputError(in_.file.name, "repeated meshes have too many triangles");
    builder_.begin_object(name);
    const bool moved = to_build != glm::dmat4(1), mirrored = glm::determinant(glm::dmat3(to_build)) < 0;
    double largest = 0;
    for (const Point3& vertex : mesh.vertices) {
      const Point3 p = moved ? Point3(to_build * glm::dvec4(vertex, 1)) : vertex;
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      builder_.add_vertex(p);
    }
    const std::uint32_t first = builder_.object_vertex_begin();
    for (std::size_t t = 0; t < mesh.corners.size() / 3; ++t) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = first + mesh.corners[3 * t + k];
      if (mirrored) std::swap(corners[1], corners[2]);
      builder_.use_material(mesh.materials[t]);
      builder_.add_face(corners);
    }
    const double rounded = moved ? kRoundings * std::numeric_limits<double>::epsilon() * largest : 0;
    const double precision = mesh.precision * (moved ? largest_stretch(to_build) : 1) + rounded;
    builder_.end_object(std::isfinite(precision) ? precision : 0);
    in_.report.vertices += mesh.vertices.size();
  }

  ThreeMfDocument document_;
  const ModelReading& in_;
  SceneBuilder builder_;
  std::map<std::pair<std::string, std::string>, ThreeMfMesh> meshes_;  ///< by path and id
  std::map<std::pair<const ThreeMfMaterials*, std::int64_t>, std::size_t> materials_;
  std::size_t used_ = 0, triangles_ = 0;
};

}  // namespace

bool is_three_mf(const ZipArchive& archive) { return !model_path(archive).empty(); }

Scene read_three_mf(const ModelReading& in) {
  const ZipArchive archive(in.file.bytes, in.file.name);
  if (!is_three_mf(archive)) throw InputError(in.file.name, "is a ZIP archive without a 3MF model");
  return ThreeMfReader(archive, in).read();
}

}  // namespace ligne
