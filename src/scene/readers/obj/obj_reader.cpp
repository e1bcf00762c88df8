#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/obj/obj_materials.hpp"
#include "scene/readers/obj/obj_statements.hpp"
#include "scene/readers/scene_builder.hpp"

namespace ligne {
namespace {

/// Makes objects of the statements. Objects own their vertices: a vertex used by several is stored in each.
class ObjScene {
 public:
  ObjScene(const ModelReading& in, ObjStatements& stream)
      : builder_(in.file.name, in.report), stream_(stream), shading_(in.shading), tags_(in.tags) {
    builder_.begin_object("");
  }

  void add_face(std::span<const ObjCorner> corners) {
    const std::vector<ObjVertex>& vertices = stream_.vertices();
    face_.clear();
    scene_index_.resize(vertices.size(), kNone);
    const auto count = static_cast<std::int64_t>(vertices.size());
    for (const auto& [written, normal] : corners) {
      const std::int64_t index = written < 0 ? count + written : written - 1;
      if (index < 0 || index >= count) {
        return stream_.fail("face names vertex " + std::to_string(written) + " of " + std::to_string(count));
      }
      face_.push_back(scene_vertex(static_cast<std::size_t>(index)));
    }
    builder_.add_face(face_);
    if (shading_) add_shading(corners);
  }

  void begin_object(const std::string& name) {
    end_object();
    builder_.begin_object(name);
  }

  /// Adds the triangles of a free-form patch, except those that a pole reduces to two corners.
  void add_patch(const ObjPatch& patch) {
    std::vector<ObjControlPoint> control;
    for (const std::size_t index : patch.control) {
      const ObjVertex& vertex = stream_.vertices()[index];
      control.push_back(vertex);
      for (int k = 0; k < 3; ++k) precision_.add(vertex.digits[k], vertex.position[k]);
    }
    const PatchGrid grid = sample_patch(patch, control);
    for (const Point3& p : grid.points) {
      if (!std::isfinite(p.x + p.y + p.z)) return stream_.fail("surf whose weights sum to zero");
    }
    std::vector<std::uint32_t> at;
    for (const Point3& point : grid.points) at.push_back(add_vertex(point, kNone));
    for (std::size_t j = 1; j < grid.rows; ++j) {
      for (std::size_t i = 1; i < grid.columns; ++i) {
        const std::size_t a = (j - 1) * grid.columns + i - 1, b = a + 1, c = b + grid.columns, d = c - 1;
        for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
          if (grid.points[p] == grid.points[q] || grid.points[q] == grid.points[r] || grid.points[r] == grid.points[p])
            continue;
          builder_.add_face(std::array{at[p], at[q], at[r]});
          if (!shading_) continue;
          shading_->corner_normals.insert(shading_->corner_normals.end(), 3, 0);
          shading_->face_groups.push_back(0);
        }
      }
    }
  }

  void use_material(const std::string& name) { builder_.use_material(name); }

  Scene finish(const Warnings& warnings) {
    end_object();
    if (shading_) {
      const auto is_zero = [](std::uint32_t value) { return value == 0; };
      for (auto* said : {&shading_->corner_normals, &shading_->face_groups}) {
        if (std::all_of(said->begin(), said->end(), is_zero)) said->clear();
      }
    }
    return builder_.finish(Axis::y, warnings.left_out());
  }

 private:
  void add_shading(std::span<const ObjCorner> corners) {
    const std::vector<std::uint32_t>& normals = stream_.normals();
    const auto count = static_cast<std::int64_t>(normals.size());
    for (const auto& [vertex, written] : corners) {
      const std::int64_t index = written < 0 ? count + written : written - 1;
      const bool known = index >= 0 && index < count;
      shading_->corner_normals.push_back(known ? normals[static_cast<std::size_t>(index)] : 0);
    }
    shading_->face_groups.push_back(stream_.smoothing_group());
  }

  std::uint32_t scene_vertex(std::size_t index) {
    std::uint32_t& known = scene_index_[index];
    if (known == kNone) {
      const ObjVertex& vertex = stream_.vertices()[index];
      for (int k = 0; k < 3; ++k) precision_.add(vertex.digits[k], vertex.position[k]);
      known = add_vertex(vertex.position, static_cast<std::uint32_t>(index));
      used_.push_back(index);
    }
    return known;
  }

  /// `file_vertex`: index of the vertex in the file, from 0, or kNone.
  std::uint32_t add_vertex(const Point3& position, std::uint32_t file_vertex) {
    const std::uint32_t vertex = builder_.add_vertex(position);
    if (tags_) {
      tags_->file_vertex.resize(vertex, kNone);  // an object without faces was dropped with its vertices
      tags_->file_vertex.push_back(file_vertex);
    }
    return vertex;
  }

  void end_object() {
    builder_.end_object(precision_.value());
    precision_ = {};
    for (const std::size_t index : used_) scene_index_[index] = kNone;
    used_.clear();
  }

  SceneBuilder builder_;
  ObjStatements& stream_;
  FileShading* shading_;  ///< may be null
  CreaseTags* tags_;      ///< may be null
  std::vector<std::uint32_t> face_;
  std::vector<std::uint32_t> scene_index_;  ///< per vertex of the file: its copy in the object, or kNone
  std::vector<std::size_t> used_;           ///< vertices of the file with a copy in the object
  DecimalPrecision precision_;
};

}  // namespace

Scene read_obj(const ModelReading& in) {
  const std::string& name = in.file.name;
  ObjStatements statements(as_text(in.file.bytes, name), name, in.shading != nullptr, in.groups_as_objects, in.warnings);
  ObjScene scene(in, statements);
  statements.tags = in.tags;
  statements.on_patch = [&](const ObjPatch& patch) { scene.add_patch(patch); };
  statements.on_face = [&](std::span<const ObjCorner> corners) { scene.add_face(corners); };
  statements.on_object = [&](const std::string& object) { scene.begin_object(object); };
  statements.on_material = [&](const std::string& material) { scene.use_material(material); };
  statements.run();

  if (statements.error()) throw *statements.error();
  if (statements.vertices().empty() && !statements.first_unknown().empty()) {
    throw InputError(
        name, "is not an OBJ file: no line is a vertex (v), and the first one is " + shown(statements.first_unknown()));
  }
  in.report.vertices += statements.vertices().size();
  in.report.groups = statements.groups();
  Scene read = scene.finish(in.warnings);
  apply_libraries(statements.libraries(), in.file.folder, read.materials, in.report.files, in.warnings);
  return read;
}

}  // namespace ligne
