// The format was never published; this reader follows the descriptions that circulate of the files of 3D Studio R3 and R4.
// Our own reader: lib3ds has had no release since 2010 and trusts the counts in a file; assimp gives no places of
// errors, and adds 2.6 ms to the start of every run.
//
//   4d4d file
//     3d3d editor
//       afff material           a000 name, a020 colour, a050 transparency, a200 texture
//       4000 object: name       then one of:
//         4100 mesh             4110 vertices, 4120 faces (4130 material, 4150 smoothing groups), 4160 axes and origin
//         4600 light            position
//         4700 camera           position, target, bank, lens
//     b000 keyframes
//       b002 node of an object  b010 name and parent, b013 pivot, b020 to b022 positions, rotations and scales, b030 number

#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "base/no_index.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/load_bytes.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/studio/chunks.hpp"
#include "scene/readers/studio/studio_camera.hpp"

namespace ligne {
namespace {

constexpr std::uint16_t kFile = 0x4d4d;
constexpr std::size_t kChunkHeader = 6;
/// Longest chain of parents of a node. Longer ones, and circles, are an error.
constexpr int kDeepest = 1000;

using Matrix = glm::dmat4;

struct StudioMesh {
  struct Face {
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint8_t, 3> flags{};
    std::uint32_t smoothing = 0;  ///< one bit per group
    std::optional<std::string> material{};
  };
  std::string name;
  std::vector<Point3> vertices;
  std::vector<Face> faces;
  Matrix axes{1.0};  ///< from the mesh's own coordinates to the stored ones
  int instances = 0;
};

/// A node of the keyframes: where an object stands in the first frame.
struct KeyframeNode {
  std::string name;
  std::uint32_t parent = kNone;  ///< number of another node
  Point3 pivot{0, 0, 0};
  Matrix place{1.0};  ///< within the parent
};

class ThreeDsReader {
 public:
  explicit ThreeDsReader(const ModelReading& in)
      : file_(in.file.bytes, in.file.name), in_(in), builder_(in.file.name, in.report) {}

  Scene read() {
    file_.for_chunks([&](std::uint16_t number, ChunkReader chunk) {
      if (number == kFile) read_file(chunk);
    });
    add_meshes();
    Scene scene = builder_.finish(Axis::z, in_.warnings.left_out());
    for (Material& material : scene.materials) {
      const auto found = materials_.find(material.name);
      if (found != materials_.end()) material = found->second;
    }
    return scene;
  }

 private:
  void read_file(ChunkReader& file) {
    file.for_chunks([&](std::uint16_t number, ChunkReader chunk) {
      if (number == 0x3d3d) {
        chunk.for_chunks([&](std::uint16_t inner, ChunkReader part) {
          if (inner == 0xafff) read_material(part);
          if (inner == 0x4000) read_object(part);
        });
      } else if (number == 0xb000) {
        chunk.for_chunks([&](std::uint16_t inner, ChunkReader part) {
          if (inner == 0xb002) read_node(part);
        });
      }
    });
  }

  void read_material(ChunkReader& chunk) {
    Material material;
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0xa000) material.name = part.take_text();
      if (number == 0xa020) read_color(part, material.color);
      if (number == 0xa050) material.opacity = 1 - percentage(part);
      if (number == 0xa200) in_.warnings.leave_out("textures");
    });
    materials_[material.name] = material;
  }

  static void read_color(ChunkReader& chunk, Point3& color) {
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0x0010) color = glm::clamp(part.take_point(), 0.0, 1.0);
      if (number == 0x0011) {
        for (int k = 0; k < 3; ++k) color[k] = part.take<std::uint8_t>() / 255.0;
      }
    });
  }

  /// A share of 0 to 1.
  static double percentage(ChunkReader& chunk) {
    double percent = 0;
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0x0030) percent = part.take<std::uint16_t>();
      if (number == 0x0031) percent = part.take_float();
    });
    return std::clamp(percent / 100, 0.0, 1.0);
  }

  void read_object(ChunkReader& chunk) {
    const std::string name = chunk.take_text();
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0x4100) read_mesh(part, name);
      if (number == 0x4600) builder_.scene().lights.push_back({Light::Kind::point, part.take_point()});
      if (number == 0x4700) read_camera(part, name);
    });
  }

  void read_camera(ChunkReader& chunk, const std::string& name) {
    SceneCamera camera{.name = name, .eye = chunk.take_point()};
    camera.forward = chunk.take_point() - camera.eye;
    const double bank = chunk.take_float();
    set_lens(camera, chunk.take_float());
    if (glm::length(camera.forward) == 0 || camera.fov_degrees >= 180) return;
    bank_camera(camera, bank);
    builder_.scene().cameras.push_back(camera);
  }

  void read_mesh(ChunkReader& chunk, const std::string& name) {
    StudioMesh mesh;
    mesh.name = name;
    std::optional<ChunkReader> faces;  // they may precede the vertices
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0x4110) {
        const auto count = part.take<std::uint16_t>();
        for (std::size_t v = 0; v < count; ++v) mesh.vertices.push_back(part.take_point());
      } else if (number == 0x4120) {
        faces.emplace(part);
      } else if (number == 0x4160) {
        for (int column = 0; column < 4; ++column) mesh.axes[column] = {part.take_point(), column == 3 ? 1.0 : 0.0};
      }
    });
    if (faces) read_faces(*faces, mesh);
    meshes_.push_back(std::move(mesh));
  }

  void read_faces(ChunkReader& chunk, StudioMesh& mesh) {
    constexpr std::array<unsigned, 3> kVisible{4, 2, 1};  // sides AB, BC and CA
    mesh.faces.resize(chunk.take<std::uint16_t>());
    unsigned visible = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      StudioMesh::Face& face = mesh.faces[f];
      for (std::uint32_t& corner : face.corners) {
        corner = chunk.take<std::uint16_t>();
        if (corner < mesh.vertices.size()) continue;
        throw chunk.error("face " + std::to_string(f) + " names vertex " + std::to_string(corner) + " of " +
                          std::to_string(mesh.vertices.size()));
      }
      const unsigned flags = chunk.take<std::uint16_t>();
      visible |= flags & 7;
      for (std::size_t k = 0; k < 3; ++k) face.flags[k] = (flags & kVisible[k]) == 0 ? kCornerFileHidden : 0;
    }
    // Writers that know nothing of visible sides store none.
    if (visible == 0) std::ranges::for_each(mesh.faces, [](StudioMesh::Face& face) { face.flags = {}; });
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0x4150) {
        for (StudioMesh::Face& face : mesh.faces) face.smoothing = part.take<std::uint32_t>();
      } else if (number == 0x4130) {
        const std::string material = part.take_text();
        const auto count = part.take<std::uint16_t>();
        for (std::size_t i = 0; i < count; ++i) {
          const auto f = part.take<std::uint16_t>();
          if (f >= mesh.faces.size()) throw part.error("a material names a face that is not there");
          mesh.faces[f].material = material;
        }
      }
    });
  }

  void read_node(ChunkReader& chunk) {
    KeyframeNode node;
    std::uint32_t own_number = static_cast<std::uint32_t>(nodes_.size());
    Point3 position{0, 0, 0}, scale{1, 1, 1};
    Matrix rotation(1.0);
    chunk.for_chunks([&](std::uint16_t number, ChunkReader part) {
      if (number == 0xb030) own_number = part.take<std::uint16_t>();
      if (number == 0xb010) {
        node.name = part.take_text();
        part.skip(4);  // flags
        const auto parent = part.take<std::uint16_t>();
        if (parent != 0xffff) node.parent = parent;
      }
      if (number == 0xb013) node.pivot = part.take_point();
      if (number == 0xb020 && begin_first_key(part)) position = part.take_point();
      if (number == 0xb022 && begin_first_key(part)) scale = part.take_point();
      if (number == 0xb021 && begin_first_key(part)) {
        const double angle = part.take_float();
        const Point3 axis = part.take_point();
        // Turns are clockwise, seen from the tip of the axis.
        if (glm::length(axis) > 0) rotation = glm::rotate(Matrix(1.0), -angle, axis);
      }
    });
    node.place = glm::scale(glm::translate(Matrix(1.0), position) * rotation, scale);
    nodes_[own_number] = node;
  }

  /// Goes to the value of the first key of a track; false if it has none.
  static bool begin_first_key(ChunkReader& track) {
    track.skip(10);  // flags
    if (track.take<std::uint32_t>() == 0) return false;
    track.skip(4);  // frame
    // Each of the five lowest flags announces a number: tension, continuity, bias, and how the key is left and reached.
    const int numbers = std::popcount(track.take<std::uint16_t>() & 0x1fu);
    track.skip(sizeof(float) * static_cast<std::size_t>(numbers));
    return true;
  }

  /// From a node's own coordinates to those of the scene.
  Matrix place_of(const KeyframeNode& node) const {
    Matrix place = node.place;
    int depth = 0;
    for (std::uint32_t parent = node.parent; parent != kNone;) {
      const auto found = nodes_.find(parent);
      if (found == nodes_.end()) break;
      if (++depth > kDeepest)
        throw InputError(in_.file.name, "keyframes: node " + shown(node.name) + " is its own ancestor");
      place = found->second.place * place;
      parent = found->second.parent;
    }
    return place;
  }

  void add_meshes() {
    std::map<std::string, StudioMesh*> by_name;
    for (StudioMesh& mesh : meshes_) by_name.try_emplace(mesh.name, &mesh);
    for (const auto& [number, node] : nodes_) {
      if (const auto found = by_name.find(node.name); found != by_name.end()) ++found->second->instances;
    }
    for (const StudioMesh& mesh : meshes_) {
      if (mesh.instances < 2) add_mesh(mesh, Matrix(1.0));
    }
    for (const auto& [number, node] : nodes_) {
      const auto found = by_name.find(node.name);
      if (found == by_name.end() || found->second->instances < 2) continue;
      const StudioMesh& mesh = *found->second;
      const bool is_flat = glm::determinant(mesh.axes) == 0;
      const Matrix own = is_flat ? Matrix(1.0) : glm::inverse(mesh.axes);
      add_mesh(mesh, place_of(node) * glm::translate(Matrix(1.0), -node.pivot) * own);
    }
  }

  void add_mesh(const StudioMesh& mesh, const Matrix& place) {
    builder_.begin_object(mesh.name);
    const std::uint32_t first = builder_.object_vertex_begin();
    double largest = 0;
    for (const Point3& v : mesh.vertices) {
      const Point3 p{place * glm::dvec4(v, 1.0)};
      for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
      builder_.add_vertex(p);
    }
    for (const StudioMesh::Face& face : mesh.faces) {
      if (face.material)
        builder_.use_material(*face.material);
      else
        builder_.use_material(kNone);
      std::array<std::uint32_t, 3> corners = face.corners;
      for (std::uint32_t& corner : corners) corner += first;
      builder_.add_face(corners);
      builder_.set_corner_flags(face.flags);
      if (in_.shading) in_.shading->face_groups.push_back(face.smoothing);
    }
    builder_.end_object(half_ulp_float32(largest));
    if (!mesh.faces.empty()) in_.report.vertices += mesh.vertices.size();
  }

  ChunkReader file_;
  const ModelReading& in_;
  SceneBuilder builder_;
  std::map<std::string, Material> materials_;
  std::vector<StudioMesh> meshes_;
  std::map<std::uint32_t, KeyframeNode> nodes_;  ///< by number
};

}  // namespace

bool is_3ds(std::span<const std::byte> bytes) {
  if (bytes.size() <= kChunkHeader || load_bytes<std::uint16_t>(bytes.data(), std::endian::little) != kFile) return false;
  // Some writers append a few bytes to the file.
  constexpr std::size_t kMostBehind = 64;
  const std::size_t length = load_bytes<std::uint32_t>(bytes.data() + 2, std::endian::little);
  return length > kChunkHeader && length <= bytes.size() && bytes.size() - length <= kMostBehind;
}

Scene read_3ds(const ModelReading& in) {
  if (in.shading) in.shading->groups_are_bits = true;
  return ThreeDsReader(in).read();
}

}  // namespace ligne
