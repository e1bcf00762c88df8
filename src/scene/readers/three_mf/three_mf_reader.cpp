#include "scene/readers/three_mf/three_mf_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/readers/three_mf/three_mf_document.hpp"

namespace ligne {
namespace {

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
  ThreeMfReader(const ZipArchive& archive, const std::string& name, ReadReport& report, Warnings& warnings)
      : document_(archive, name, warnings), name_(name), warnings_(warnings), builder_(name, report), report_(report) {}

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
    if (!has_build) throw InputError(name_, "its model has no build element");
    return builder_.finish(Axis::z, warnings_.left_out());
  }

 private:
  double unit_of(const ThreeMfPart& part) const {
    const std::string_view unit = attribute_of(part.model, "unit");
    if (unit.empty()) return 1;
    const auto known = std::ranges::find(kUnits, unit, &std::pair<std::string_view, double>::first);
    if (known == kUnits.end()) throw InputError(name_, "unit " + shown(unit) + " is not known");
    return known->second;
  }

  /// Adds an item of the build, or a component of an object: a transformed object of this part or of another one.
  void add_reference(ThreeMfPart& part, const pugi::xml_node& reference, const glm::dmat4& to_build, int level) {
    const std::string id(attribute_of(reference, "objectid"));
    std::string path(attribute_of(reference, "path"));
    path.erase(0, std::min(path.find_first_not_of('/'), path.size()));
    ThreeMfPart& of_object = path.empty() ? part : document_.part(path);
    const std::optional<glm::dmat4> transform = transform_of(attribute_of(reference, "transform"));
    if (!transform) throw InputError(name_, "the transform of object " + shown(id) + " is not twelve numbers");
    const auto object = of_object.objects.find(id);
    if (object == of_object.objects.end()) throw InputError(name_, "there is no object " + shown(id));
    if (level > kMostLevels) throw InputError(name_, "object " + shown(id) + " contains itself, or is nested too deeply");
    if (++used_ > kMostReferences) throw InputError(name_, "there are too many repeated objects");
    add_object(of_object, id, object->second, to_build * *transform, level);
  }

  void add_object(ThreeMfPart& part, const std::string& id, const pugi::xml_node& object, const glm::dmat4& to_build,
                  int level) {
    const std::string_view type = attribute_of(object, "type");
    if (type == "support" || type == "solidsupport") return warnings_.leave_out("supports");
    for (const pugi::xml_node& child : object.children()) {
      const std::string_view kind = local_name(child.name());
      if (kind == "mesh") {
        add_mesh(mesh_of(part, id, object, child), std::string(attribute_of(object, "name")), to_build);
      } else if (kind == "components") {
        for (const pugi::xml_node& component : child.children()) add_reference(part, component, to_build, level + 1);
      } else if (kind != "metadatagroup" && child.type() == pugi::node_element) {
        warnings_.leave_out("elements " + std::string(child.name()));
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
        warnings_.leave_out("elements " + std::string(child.name()));
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
          throw InputError(
              name_, place + ": " + shown(word) + " is not a coordinate of vertex " + std::to_string(mesh.vertices.size()));
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
          throw InputError(name_, place + ": triangle " + std::to_string(mesh.corners.size() / 3) + " names vertex " +
                                      printable(word) + " of " + std::to_string(mesh.vertices.size()));
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
    if (triangles_ > kMostTriangles) throw InputError(name_, "repeated meshes have too many triangles");
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
    report_.vertices += mesh.vertices.size();
  }

  ThreeMfDocument document_;
  const std::string& name_;
  Warnings& warnings_;
  SceneBuilder builder_;
  ReadReport& report_;
  std::map<std::pair<std::string, std::string>, ThreeMfMesh> meshes_;  ///< by path and id
  std::map<std::pair<const ThreeMfMaterials*, std::int64_t>, std::size_t> materials_;
  std::size_t used_ = 0, triangles_ = 0;
};

}  // namespace

bool is_three_mf(const ZipArchive& archive) { return !model_path(archive).empty(); }

Scene read_three_mf(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  const ZipArchive archive(bytes, name);
  if (!is_three_mf(archive)) throw InputError(name, "is a ZIP archive without a 3MF model");
  return ThreeMfReader(archive, name, report, warnings).read();
}

}  // namespace ligne
