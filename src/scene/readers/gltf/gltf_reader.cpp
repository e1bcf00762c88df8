// Order of work: the document is opened and checked; the node tree gives the instances of meshes. A first pass over
// them opens their accessors and counts, so that the size of the scene is known, and can be refused, before memory is
// allocated, and each instance gets its place in it. A second pass converts positions and indices straight into the scene,
// several instances at a time.

#include "base/parallel_each.hpp"
#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/gltf/gltf_extensions.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"
#include "scene/readers/gltf/gltf_primitive.hpp"
#include "scene/readers/gltf/gltf_textures.hpp"

namespace ligne {
namespace {

/// "The units for all linear distances are meters": glTF 2.0, 3.4.
constexpr double kMetreMm = 1000;

/// Largest number of triangles, and of vertices, that a small file may make by repeating its meshes; a larger file may
/// make as many as it has bytes.
constexpr std::size_t kMaxInstanced = std::size_t{1} << 25;
/// Number of bits of a float32 significand, including the hidden one.
constexpr int kFloatDigits = std::numeric_limits<float>::digits;
/// Number of roundings of a coordinate in a 4 x 4 transform: products and sums, once per level of a shallow node tree.
constexpr double kTransformRoundings = 4;

class Reader {
 public:
  Reader(GltfDocument& document, const ModelReading& in)
      : document_(document), model_(document.model), warnings_(in.warnings), shading_(in.shading) {}

  Scene run(ReadReport& report) {
    nodes_ = list_nodes(document_);
    std::vector<GltfInstance>& instances = nodes_.instances;
    add_gpu_instances(document_, kMaxInstanced, instances);
    palettes_ = read_palettes(document_, report.files);
    meshes_.resize(model_.meshes.size());
    joints_.resize(model_.skins.size());
    count(instances);
    scene_.up_axis = Axis::y;
    scene_.unit_mm = kMetreMm;
    place_objects(instances);
    read_objects(instances);
    write_materials();
    for (const GltfCamera& camera : nodes_.cameras) {
      if (auto found = scene_camera(model_, camera, scene_.cameras.size() + 1)) scene_.cameras.push_back(*std::move(found));
    }
    for (const auto& [what, n] : document_.left_out.counts()) warnings_.leave_out(what, n);
    warnings_.leave_out("textures", document_.color_textures.size());
    report.faces = report.triangles = triangles_;
    report.vertices = vertices_;
    return std::move(scene_);
  }

 private:
  // ---- first pass

  void count(const std::vector<GltfInstance>& instances) {
    for (const GltfInstance& instance : instances) {
      const auto& primitives = open_mesh(instance.mesh);
      std::size_t last_positions = kNone;
      for (const GltfPrimitive& p : primitives) {
        triangles_ += p.triangle_count();
        if (p.has_own_vertices(last_positions)) vertices_ += p.vertex_count();
      }
      primitives_ += primitives.size();
      const std::size_t limit = std::max(kMaxInstanced, document_.bytes_read());
      if (triangles_ > limit || vertices_ > limit || primitives_ > limit) {
        document_.fail("node " + std::to_string(instance.node),
                       "repeated meshes have more than " + std::to_string(limit) + " triangles or vertices");
      }
    }
    if (vertices_ >= kNone || triangles_ >= kNone / 3) document_.fail("scene", "too many vertices or triangles");
  }

  const std::vector<GltfPrimitive>& open_mesh(std::size_t mesh) {
    if (!meshes_[mesh]) {
      meshes_[mesh].emplace();
      for (const tinygltf::Primitive& from : model_.meshes[mesh].primitives) {
        if (from.mode < TINYGLTF_MODE_TRIANGLES) {
          warnings_.leave_out(from.mode == TINYGLTF_MODE_POINTS ? "primitives of points" : "primitives of lines");
        } else if (!from.attributes.contains("POSITION")) {
          warnings_.leave_out("primitives without positions");
        } else {
          meshes_[mesh]->push_back(open_primitive(from));
        }
      }
    }
    return *meshes_[mesh];
  }

  bool has_palette(int material) const { return material >= 0 && palettes_[static_cast<std::size_t>(material)]; }

  GltfPrimitive open_primitive(const tinygltf::Primitive& from) {
    GltfPrimitive p{.position_accessor = static_cast<std::size_t>(from.attributes.at("POSITION")),
                    .mode = from.mode,
                    .material = from.material};
    if (has_palette(p.material)) {
      const auto at = from.attributes.find(document_.textures[static_cast<std::size_t>(p.material)]->attribute());
      if (at != from.attributes.end()) p.coordinate_accessor = at->second;
    }
    const auto draco = from.extensions.find(kDracoExtension);
    if (draco != from.extensions.end()) {
      p.draco = &decode(draco->second, has_palette(p.material));
      p.deformation = read_deformation(document_, from, p.vertex_count(), p.draco);
      return p;
    }
    p.positions = position_accessor(document_, p.position_accessor);
    p.deformation = read_deformation(document_, from, p.positions.count(), nullptr);
    const auto indices = from.attributes.find(kGltfIndices);
    if (indices != from.attributes.end()) p.indices = index_accessor(document_, static_cast<std::size_t>(indices->second));
    const auto normals = from.attributes.find("NORMAL");
    if (shading_ && normals != from.attributes.end()) p.normals = open_normals(normals->second, p.positions.count());
    if (p.mode == TINYGLTF_MODE_TRIANGLES && p.corner_count() % 3 != 0) {
      document_.fail(p.indices ? p.indices->place : p.positions.place,
                     "its " + std::to_string(p.corner_count()) + " corners are not whole triangles");
    }
    return p;
  }

  /// Returns nothing for broken normals: shading is no reason to refuse a model.
  std::optional<GltfAccessor> open_normals(int accessor, std::size_t count) {
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size()) return std::nullopt;
    try {
      GltfAccessor normals = position_accessor(document_, static_cast<std::size_t>(accessor));
      if (normals.count() == count) return normals;
    } catch (const InputError&) {
      return std::nullopt;
    }
    return std::nullopt;
  }

  const DracoMesh& decode(const tinygltf::Value& extension, bool with_coordinates) {
    const tinygltf::Value& attributes = extension.Get("attributes");
    const std::pair key{extension.Get("bufferView").Get<int>(), attributes.Get("POSITION").Get<int>()};
    const auto [entry, is_new] = draco_.try_emplace(key);
    if (is_new) {
      std::map<std::string, int> ids;
      for (const std::string& attribute : attributes.Keys()) {
        if (with_coordinates || !attribute.starts_with("TEXCOORD_")) ids[attribute] = attributes.Get(attribute).Get<int>();
      }
      const auto bytes = document_.view_bytes(static_cast<std::size_t>(key.first));
      entry->second = decode_draco(bytes, ids, document_.name, "bufferView " + std::to_string(key.first));
    }
    return entry->second;
  }

  // ---- second pass

  /// Adds the objects with the places of their vertices and faces.
  void place_objects(const std::vector<GltfInstance>& instances) {
    scene_.objects.resize(instances.size());
    std::size_t vertices = 0, faces = 0;
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const auto& [node, mesh, to_world] = instances[i];
      Object& object = scene_.objects[i];
      object.name = model_.nodes[node].name.empty() ? model_.meshes[mesh].name : model_.nodes[node].name;
      object.vertex_begin = static_cast<std::uint32_t>(vertices);
      object.face_begin = static_cast<std::uint32_t>(faces);
      std::size_t last_positions = kNone, first_vertex = vertices;
      for (const GltfPrimitive& p : *meshes_[mesh]) {
        if (p.has_own_vertices(last_positions)) {
          first_vertex = vertices;
          vertices += p.vertex_count();
        }
        parts_.push_back({&p, static_cast<std::uint32_t>(faces), static_cast<std::uint32_t>(first_vertex)});
        faces += p.triangle_count();
        some_normals_ = some_normals_ || p.has_normals(to_world);
      }
      object.vertex_end = static_cast<std::uint32_t>(vertices);
      object.face_end = static_cast<std::uint32_t>(faces);
    }
  }

  /// Reads the vertices and faces of all objects in parallel, but objects with skins or morph targets one by one, since
  /// their data are decompressed on first use. Throws the error of the first object that has one.
  void read_objects(const std::vector<GltfInstance>& instances) {
    // Getting the memory takes as long as filling it.
    parallel_tasks(3, [&](std::size_t task) {
      if (task == 0) scene_.vertices = large_vector<Point3>(vertices_);
      if (task == 1) scene_.faces.append_triangles(large_vector<std::uint32_t>(3 * triangles_));
      if (task == 2 && some_normals_) shading_->corner_normals = large_vector<std::uint32_t>(3 * triangles_);
    });
    const auto is_plain = [&](const GltfInstance& instance) {
      return model_.nodes[instance.node].skin < 0 &&
             std::ranges::none_of(*meshes_[instance.mesh], [](const GltfPrimitive& p) { return p.deformation.any(); });
    };
    std::vector<std::exception_ptr> errors(instances.size());
    const auto read = [&](std::size_t i) {
      try {
        read_object(instances[i], scene_.objects[i]);
      } catch (const InputError&) {
        errors[i] = std::current_exception();
      }
    };
    parallel_tasks(instances.size(), [&](std::size_t i) {
      if (is_plain(instances[i])) read(i);
    });
    for (std::size_t i = 0; i < instances.size(); ++i) {
      if (!is_plain(instances[i])) read(i);
    }
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
  }

  void read_object(const GltfInstance& instance, Object& object) {
    const glm::dmat4& m = instance.to_world;
    const std::vector<glm::dmat4>& joints = joints_of(instance);
    const bool mirrored = glm::determinant(glm::dmat3(joints.empty() ? m : joints[0])) < 0;
    double largest_float = 0, step = 0;
    std::size_t last_positions = kNone, corner = 3 * std::size_t{object.face_begin};
    std::uint32_t first_vertex = object.vertex_begin, next_vertex = first_vertex;
    for (const GltfPrimitive& p : *meshes_[instance.mesh]) {
      std::optional<GltfDeformer> deformer;
      if (p.deformation.any()) deformer.emplace(document_, p.deformation, weights_of(instance), joints, m);
      if (p.has_own_vertices(last_positions)) {
        first_vertex = next_vertex;
        next_vertex += static_cast<std::uint32_t>(p.vertex_count());
        const double largest =
            read_vertices(p, m, deformer, std::span(scene_.vertices).subspan(first_vertex, p.vertex_count()));
        step = std::max(step, p.draco ? p.draco->step : p.positions.rounding_step(largest));
        if (p.draco || p.positions.is_float()) largest_float = std::max(largest_float, largest);
      }
      const std::size_t corners = 3 * p.triangle_count();
      read_triangles(p, first_vertex, mirrored, scene_.faces.corners().subspan(corner, corners));
      if (shading_ && p.has_normals(m)) read_normals(p, first_vertex, corner, m, deformer);
      corner += corners;
    }
    object.precision = precision(object, m, joints, largest_float, step);
  }

  /// Joint matrices of the node's skin; empty without one.
  const std::vector<glm::dmat4>& joints_of(const GltfInstance& instance) {
    static const std::vector<glm::dmat4> kNoJoints;
    const int skin = model_.nodes[instance.node].skin;
    if (skin < 0) return kNoJoints;
    auto& joints = joints_[static_cast<std::size_t>(skin)];
    if (joints.empty()) joints = joint_matrices(document_, nodes_, static_cast<std::size_t>(skin));
    return joints;
  }

  /// Weights of the morph targets: those of the node if it has any, else those of its mesh.
  std::span<const double> weights_of(const GltfInstance& instance) const {
    const std::vector<double>& own = model_.nodes[instance.node].weights;
    return own.empty() ? model_.meshes[instance.mesh].weights : own;
  }

  /// Writes the vertices. Returns the largest coordinate before the transform.
  double read_vertices(const GltfPrimitive& p, const glm::dmat4& to_world, std::optional<GltfDeformer>& deformer,
                       std::span<Point3> out) {
    const glm::dmat4 m = deformer ? glm::dmat4(1) : to_world;
    double largest = 0;
    if (p.draco) {
      std::transform(p.draco->positions.begin(), p.draco->positions.end(), out.begin(),
                     [&](const Point3& q) { return m == glm::dmat4(1) ? q : Point3(m * glm::dvec4(q, 1)); });
      largest = p.draco->largest;
    } else {
      largest = read_positions(document_, p.positions, m, out);
    }
    return deformer ? deformer->move_positions(out) : largest;
  }

  void read_triangles(const GltfPrimitive& p, std::uint32_t first_vertex, bool mirrored, std::span<std::uint32_t> corners) {
    const std::size_t n = p.triangle_count();
    if (p.draco || p.mode == TINYGLTF_MODE_TRIANGLES) {
      write_corners(p, first_vertex, corners);
    } else {
      std::vector<std::uint32_t> run(p.corner_count());
      write_corners(p, first_vertex, run);
      const bool strip = p.mode == TINYGLTF_MODE_TRIANGLE_STRIP;
      for (std::size_t i = 0; i < n; ++i) {
        // glTF 2.0, section 3.7.2.1: every second triangle of a strip is reversed; all triangles of a fan share its
        // first corner.
        corners[3 * i] = strip ? run[i] : run[i + 1];
        corners[3 * i + 1] = strip ? run[i + 1 + i % 2] : run[i + 2];
        corners[3 * i + 2] = strip ? run[i + 2 - i % 2] : run[0];
      }
    }
    if (!mirrored) return;
    for (std::size_t i = 0; i < n; ++i) std::swap(corners[3 * i + 1], corners[3 * i + 2]);
  }

  /// Reads the normals of the triangles from a corner on, transformed by the transposed inverse matrix.
  void read_normals(const GltfPrimitive& p, std::uint32_t first_vertex, std::size_t corner, const glm::dmat4& m,
                    std::optional<GltfDeformer>& deformer) {
    std::vector<Point3> normals(p.normals->count(), Point3(0));
    try {
      const glm::dmat4 turn = deformer ? glm::dmat4(1) : glm::dmat4(glm::transpose(glm::inverse(glm::dmat3(m))));
      read_positions(document_, *p.normals, turn, normals);
      if (deformer) deformer->turn_normals(normals);
    } catch (const InputError&) {  // a normal is not finite: the ones before it stay
    }
    std::vector<std::uint32_t> packed(normals.size());
    parallel_each(normals.size(), [&](std::size_t i) { packed[i] = packed_direction(normals[i]); });
    const auto corners = std::as_const(scene_.faces).corners();
    for (const std::size_t end = corner + 3 * p.triangle_count(); corner < end; ++corner) {
      shading_->corner_normals[corner] = packed[corners[corner] - first_vertex];
    }
  }

  void write_corners(const GltfPrimitive& p, std::uint32_t first_vertex, std::span<std::uint32_t> out) const {
    if (p.draco) {
      std::transform(p.draco->corners.begin(), p.draco->corners.end(), out.begin(),
                     [&](std::uint32_t v) { return first_vertex + v; });
    } else if (p.indices) {
      read_indices(document_, *p.indices, static_cast<std::uint32_t>(p.vertex_count()), first_vertex, out);
    } else {
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = first_vertex + static_cast<std::uint32_t>(i);
    }
  }

  /// Half a unit in the last place of the largest float32, plus a part of the step of quantized coordinates, carried through
  /// the transform, plus the rounding of the transform.
  double precision(const Object& object, const glm::dmat4& m, std::span<const glm::dmat4> joints, double largest_float,
                   double step) const {
    // Adjustable. Rounding to a step gives errors of up to 1/2 of it, and of 0.29 in the root mean square. Taking the
    // largest one for all corners, the search for surfaces would lose fillets whose facets are as small as a few steps; with
    // a quarter, strips that rounding has twisted would be no planes.
    constexpr double kErrorOfStep = 0.375;
    const double rounding = largest_float > 0 ? std::ldexp(1.0, std::ilogb(largest_float) - kFloatDigits) : 0;
    const double stored = rounding + kErrorOfStep * step;
    if (m == glm::dmat4(1) && joints.empty()) return stored;
    double stretch = joints.empty() ? largest_stretch(m) : 0;
    for (const glm::dmat4& joint : joints) stretch = std::max(stretch, largest_stretch(joint));
    double largest = 0;
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
      const Point3 p = glm::abs(scene_.vertices[v]);
      largest = std::max({largest, p.x, p.y, p.z});
    }
    const double sum = stored * stretch + kTransformRoundings * std::numeric_limits<double>::epsilon() * largest;
    return std::isfinite(sum) ? sum : 0;
  }

  void write_materials() {
    for (const tinygltf::Material& from : model_.materials) scene_.materials.push_back(scene_material(from));
    const auto number_of = [&](int material) {
      return static_cast<std::uint32_t>(material >= 0 ? static_cast<std::size_t>(material) : model_.materials.size());
    };
    bool some = false, unnamed = false;
    std::vector<std::vector<GltfPart>> textured(palettes_.size());  // by material
    for (const GltfPart& part : parts_) {
      if (has_palette(part.primitive->material)) textured[number_of(part.primitive->material)].push_back(part);
      some = some || number_of(part.primitive->material) != 0 || has_palette(part.primitive->material);
      unnamed = unnamed || part.primitive->material < 0;
    }
    if (unnamed) scene_.materials.emplace_back();
    if (!some) return;
    scene_.face_material.reserve(triangles_);
    for (const auto& [p, first_face, first_vertex] : parts_) {
      scene_.face_material.insert(scene_.face_material.end(), p->triangle_count(), number_of(p->material));
    }
    for (std::uint32_t m = 0; m < textured.size(); ++m) {
      if (!textured[m].empty()) color_faces(document_, *palettes_[m], m, textured[m], scene_);
    }
    if (std::ranges::all_of(scene_.face_material, [](std::uint32_t m) { return m == 0; })) scene_.face_material.clear();
  }

  GltfDocument& document_;
  const tinygltf::Model& model_;
  Warnings& warnings_;
  FileShading* shading_;  ///< may be null
  Scene scene_;
  GltfNodes nodes_;
  std::vector<std::vector<glm::dmat4>> joints_;  ///< by skin; empty until requested
  std::vector<std::optional<std::vector<GltfPrimitive>>> meshes_;
  std::map<std::pair<int, int>, DracoMesh> draco_;               ///< by bufferView and id of the positions
  std::vector<GltfPart> parts_;                                  ///< of all instances, in the order of their faces
  std::vector<std::shared_ptr<const PaletteTexture>> palettes_;  ///< by material
  std::size_t vertices_ = 0, triangles_ = 0, primitives_ = 0;
  bool some_normals_ = false;  ///< whether any triangle has normals
};

}  // namespace

Scene read_gltf(const ModelReading& in, bool binary) {
  GltfDocument document = open_gltf(in.file.bytes, binary, in.file.folder, in.file.name);
  if (in.pose) apply_pose(document, *in.pose);
  in.report.format = binary ? ModelFormat::glb : ModelFormat::gltf;
  in.report.files = document.buffers.files();
  return Reader(document, in).run(in.report);
}

}  // namespace ligne
