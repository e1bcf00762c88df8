// Order of work: the document is opened and checked; the node tree gives the instances of meshes. A first pass over
// them opens their accessors and counts, so that the size of the scene is known, and can be refused, before memory is
// allocated. A second pass converts positions and indices straight into the scene.

#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "scene/readers/gltf/gltf_accessor.hpp"
#include "scene/readers/gltf/gltf_deform.hpp"
#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/gltf/gltf_draco.hpp"
#include "scene/readers/gltf/gltf_extensions.hpp"
#include "scene/readers/gltf/gltf_nodes.hpp"

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
/// Smallest opacity of materials with transmission: even if it transmits all light, its lines belong to an object.
constexpr double kTransmissionOpacity = 0.1;

/// A primitive whose data were checked to exist.
struct Primitive {
  std::size_t position_accessor = 0;
  GltfAccessor positions;               ///< unused with Draco
  std::optional<GltfAccessor> indices;  ///< without: the positions in order
  std::optional<GltfAccessor> normals;  ///< one per position, if requested
  const DracoMesh* draco = nullptr;
  GltfDeformation deformation;
  int mode = TINYGLTF_MODE_TRIANGLES;
  int material = -1;

  std::size_t vertex_count() const { return draco ? draco->positions.size() : positions.count(); }
  std::size_t corner_count() const { return draco ? draco->corners.size() : indices ? indices->count() : positions.count(); }
  std::size_t triangle_count() const {
    const std::size_t n = corner_count();
    if (draco || mode == TINYGLTF_MODE_TRIANGLES) return n / 3;
    return n < 3 ? 0 : n - 2;
  }
};

class Reader {
 public:
  Reader(GltfDocument& document, Warnings& warnings, FileShading* shading)
      : document_(document), model_(document.model), warnings_(warnings), shading_(shading) {}

  Scene run(ReadReport& report) {
    nodes_ = list_nodes(document_);
    std::vector<GltfInstance>& instances = nodes_.instances;
    add_gpu_instances(document_, kMaxInstanced, instances);
    meshes_.resize(model_.meshes.size());
    joints_.resize(model_.skins.size());
    count(instances);
    scene_.up_axis = Axis::y;
    scene_.unit_mm = kMetreMm;
    scene_.objects.reserve(instances.size());
    scene_.vertices.reserve(vertices_);
    scene_.faces.reserve_corners(3 * triangles_);
    for (const GltfInstance& instance : instances) add_object(instance);
    write_materials();
    for (const GltfCamera& camera : nodes_.cameras) add_camera(camera);
    for (const auto& [what, n] : document_.left_out.counts()) warnings_.leave_out(what, n);
    report.faces = report.triangles = triangles_;
    report.vertices = vertices_;
    return std::move(scene_);
  }

 private:
  /// Adds a camera, which looks along -z of its node with y up. A camera with meaningless numbers is left out; one
  /// without a name is named by its number, so that it can be selected.
  void add_camera(const GltfCamera& from) {
    const tinygltf::Camera& camera = model_.cameras[from.camera];
    const tinygltf::Node& node = model_.nodes[from.node];
    const auto axis = [&](int k) { return Point3(from.to_world[k][0], from.to_world[k][1], from.to_world[k][2]); };
    SceneCamera to;
    to.name = !node.name.empty() ? node.name : camera.name;
    if (to.name.empty()) to.name = std::to_string(scene_.cameras.size() + 1);
    to.eye = axis(3);
    to.forward = -axis(2);
    to.up = axis(1);
    to.perspective = camera.type != "orthographic";
    if (to.perspective) {
      to.fov_degrees = camera.perspective.yfov * 180 / std::numbers::pi;
      if (camera.perspective.aspectRatio > 0) to.aspect = camera.perspective.aspectRatio;
    }
    const double size = glm::length(to.eye) + glm::length(to.forward) + glm::length(*to.up);
    const bool looks = std::isfinite(size) && glm::length(glm::cross(to.forward, *to.up)) > 0;
    if (looks && to.fov_degrees > 0 && to.fov_degrees < 180) scene_.cameras.push_back(std::move(to));
  }

  // ---- first pass

  void count(const std::vector<GltfInstance>& instances) {
    for (const GltfInstance& instance : instances) {
      const auto& primitives = open_mesh(instance.mesh);
      std::size_t last_positions = kNone;
      for (const Primitive& p : primitives) {
        triangles_ += p.triangle_count();
        if (has_own_vertices(p, last_positions)) vertices_ += p.vertex_count();
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

  /// Whether a primitive has its own vertices. Consecutive primitives often share their positions: `last_positions` is
  /// the previous accessor, kNone at first.
  static bool has_own_vertices(const Primitive& p, std::size_t& last_positions) {
    const bool alone = p.draco || p.deformation.any();
    const bool own = alone || p.position_accessor != last_positions;
    last_positions = alone ? kNone : p.position_accessor;
    return own;
  }

  const std::vector<Primitive>& open_mesh(std::size_t mesh) {
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

  Primitive open_primitive(const tinygltf::Primitive& from) {
    Primitive p;
    p.mode = from.mode;
    p.material = from.material;
    p.position_accessor = static_cast<std::size_t>(from.attributes.at("POSITION"));
    const auto draco = from.extensions.find(kDracoExtension);
    if (draco != from.extensions.end()) {
      p.draco = &decode(draco->second);
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

  const DracoMesh& decode(const tinygltf::Value& extension) {
    const tinygltf::Value& attributes = extension.Get("attributes");
    const std::pair key{extension.Get("bufferView").Get<int>(), attributes.Get("POSITION").Get<int>()};
    const auto [entry, is_new] = draco_.try_emplace(key);
    if (is_new) {
      std::map<std::string, int> ids;
      for (const std::string& attribute : attributes.Keys()) ids[attribute] = attributes.Get(attribute).Get<int>();
      const auto bytes = document_.view_bytes(static_cast<std::size_t>(key.first));
      entry->second = decode_draco(bytes, ids, document_.name, "bufferView " + std::to_string(key.first));
    }
    return entry->second;
  }

  // ---- second pass

  void add_object(const GltfInstance& instance) {
    const glm::dmat4& m = instance.to_world;
    const std::vector<glm::dmat4>& joints = joints_of(instance);
    const bool mirrored = glm::determinant(glm::dmat3(joints.empty() ? m : joints[0])) < 0;
    Object object;
    object.name = model_.nodes[instance.node].name;
    if (object.name.empty()) object.name = model_.meshes[instance.mesh].name;
    object.vertex_begin = static_cast<std::uint32_t>(scene_.vertices.size());
    object.face_begin = static_cast<std::uint32_t>(scene_.faces.size());
    double largest_float = 0;
    std::size_t last_positions = kNone;
    std::uint32_t first_vertex = 0;
    for (const Primitive& p : *meshes_[instance.mesh]) {
      std::optional<GltfDeformer> deformer;
      if (p.deformation.any()) deformer.emplace(document_, p.deformation, weights_of(instance), joints, m);
      if (has_own_vertices(p, last_positions)) {
        first_vertex = static_cast<std::uint32_t>(scene_.vertices.size());
        const double largest = add_positions(p, m, deformer);
        if (p.draco || p.positions.is_float()) largest_float = std::max(largest_float, largest);
      }
      add_triangles(p, first_vertex, mirrored);
      if (shading_) add_normals(p, first_vertex, m, deformer);
      materials_.emplace_back(p.material, p.triangle_count());
    }
    object.vertex_end = static_cast<std::uint32_t>(scene_.vertices.size());
    object.face_end = static_cast<std::uint32_t>(scene_.faces.size());
    object.precision = precision(object, m, joints, largest_float);
    scene_.objects.push_back(std::move(object));
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

  double add_positions(const Primitive& p, const glm::dmat4& to_world, std::optional<GltfDeformer>& deformer) {
    const glm::dmat4 m = deformer ? glm::dmat4(1) : to_world;
    const std::size_t first = scene_.vertices.size();
    scene_.vertices.resize(first + p.vertex_count());
    const auto out = std::span(scene_.vertices).subspan(first);
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

  void add_triangles(const Primitive& p, std::uint32_t first_vertex, bool mirrored) {
    const std::size_t n = p.triangle_count();
    const std::span<std::uint32_t> corners = scene_.faces.append_triangles(n);
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

  /// Adds the normals of the triangles added last, transformed by the transposed inverse matrix. The list stays empty until
  /// the first triangles with normals.
  void add_normals(const Primitive& p, std::uint32_t first_vertex, const glm::dmat4& m,
                   std::optional<GltfDeformer>& deformer) {
    auto& out = shading_->corner_normals;
    const auto corners = std::as_const(scene_.faces).corners();
    const glm::dmat3 linear(m);
    if (!p.normals || (!deformer && glm::determinant(linear) == 0)) {
      if (!out.empty()) out.resize(corners.size(), 0);
      return;
    }
    out.resize(corners.size() - 3 * p.triangle_count(), 0);
    std::vector<Point3> normals(p.normals->count(), Point3(0));
    try {
      const glm::dmat4 turn = deformer ? glm::dmat4(1) : glm::dmat4(glm::transpose(glm::inverse(linear)));
      read_positions(document_, *p.normals, turn, normals);
      if (deformer) deformer->turn_normals(normals);
    } catch (const InputError&) {  // a normal is not finite: the ones before it stay
    }
    std::vector<std::uint32_t> packed(normals.size());
    std::transform(normals.begin(), normals.end(), packed.begin(), packed_direction);
    for (std::size_t k = out.size(); k < corners.size(); ++k) out.push_back(packed[corners[k] - first_vertex]);
  }

  void write_corners(const Primitive& p, std::uint32_t first_vertex, std::span<std::uint32_t> out) const {
    if (p.draco) {
      std::transform(p.draco->corners.begin(), p.draco->corners.end(), out.begin(),
                     [&](std::uint32_t v) { return first_vertex + v; });
    } else if (p.indices) {
      read_indices(document_, *p.indices, static_cast<std::uint32_t>(p.vertex_count()), first_vertex, out);
    } else {
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = first_vertex + static_cast<std::uint32_t>(i);
    }
  }

  /// Half a unit in the last place of the largest float32, carried through the transform, plus the rounding of the
  /// transform. Integers are exact before it.
  double precision(const Object& object, const glm::dmat4& m, std::span<const glm::dmat4> joints,
                   double largest_float) const {
    const double stored = largest_float > 0 ? std::ldexp(1.0, std::ilogb(largest_float) - kFloatDigits) : 0;
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
    for (const tinygltf::Material& from : model_.materials) {
      Material material;
      material.name = from.name;
      const std::vector<double>& c = from.pbrMetallicRoughness.baseColorFactor;
      material.color = glm::clamp(Point3(c[0], c[1], c[2]), 0.0, 1.0);
      // Only BLEND makes a face transparent: OPAQUE ignores the alpha value, MASK compares it (section 3.9.4).
      if (from.alphaMode == "BLEND") material.opacity = std::clamp(c[3], 0.0, 1.0);
      if (const auto transmission = from.extensions.find(kTransmissionExtension); transmission != from.extensions.end()) {
        const double through = transmission->second.Get("transmissionFactor").GetNumberAsDouble();
        material.opacity = std::min(material.opacity, std::max(1 - through, kTransmissionOpacity));
      }
      scene_.materials.push_back(std::move(material));
    }
    const auto number_of = [&](int material) {
      return static_cast<std::uint32_t>(material >= 0 ? static_cast<std::size_t>(material) : model_.materials.size());
    };
    bool some = false, unnamed = false;
    for (const auto& [material, faces] : materials_) {
      some = some || number_of(material) != 0;
      unnamed = unnamed || material < 0;
    }
    if (unnamed) scene_.materials.emplace_back();
    if (!some) return;
    scene_.face_material.reserve(triangles_);
    for (const auto& [material, faces] : materials_) {
      scene_.face_material.insert(scene_.face_material.end(), faces, number_of(material));
    }
  }

  GltfDocument& document_;
  const tinygltf::Model& model_;
  Warnings& warnings_;
  FileShading* shading_;  ///< may be null
  Scene scene_;
  GltfNodes nodes_;
  std::vector<std::vector<glm::dmat4>> joints_;  ///< by skin; empty until requested
  std::vector<std::optional<std::vector<Primitive>>> meshes_;
  std::map<std::pair<int, int>, DracoMesh> draco_;      ///< by bufferView and id of the positions
  std::vector<std::pair<int, std::size_t>> materials_;  ///< material (-1: none) and number of faces, in order
  std::size_t vertices_ = 0, triangles_ = 0, primitives_ = 0;
};

}  // namespace

Scene read_gltf(const ModelBytes& file, bool binary, ReadReport& report, Warnings& warnings, FileShading* shading,
                const std::optional<ScenePose>& pose) {
  GltfDocument document = open_gltf(file.bytes, binary, file.folder, file.name);
  if (pose) apply_pose(document, *pose);
  report.format = binary ? ModelFormat::glb : ModelFormat::gltf;
  report.files = document.buffers.files();
  return Reader(document, warnings, shading).run(report);
}

}  // namespace ligne
