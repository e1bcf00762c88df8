#include "byte_scene.hpp"

#include "scene/surfaces/mesh_writer.hpp"
#include "support/judge.hpp"
#include "support/scene_parts.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

constexpr std::size_t kMostFaces = 12;  ///< no element is added to a scene that has so many
constexpr int kGrid = 5;                ///< whole coordinates 0 to 4

/// The bytes as a stream of small numbers.
class ByteStream {
 public:
  explicit ByteStream(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool more() const { return next_ < bytes_.size(); }
  int below(int n) { return more() ? bytes_[next_++] % n : 0; }
  int between(int low, int high) { return low + below(high - low + 1); }
  Point3 point() { return vector(0, kGrid - 1); }
  Point3 vector(int low, int high) {
    const int x = between(low, high), y = between(low, high), z = between(low, high);
    return {double(x), double(y), double(z)};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

bool is_flat(const Point3& a, const Point3& b) { return glm::cross(a, b) == Point3(0); }

using Contour = std::vector<Point3>;

void add_triangle(Scene& scene, ByteStream& bytes) {
  const Point3 a = bytes.point(), b = bytes.point(), c = bytes.point();
  if (!is_flat(b - a, c - a)) add_face(scene, {{a, b, c}});
}

/// A parallelogram, whole, with a hole at quarters of its sides, with two holes, or an L. Contours keep apart: turned, those
/// that touch would cross in the last digits, which polygons of this program do not.
void add_plate(Scene& scene, ByteStream& bytes) {
  const Point3 corner = bytes.point(), u = bytes.vector(-4, 4), v = bytes.vector(-4, 4);
  const int form = bytes.below(4);
  if (is_flat(u, v)) return;
  const auto at = [&](double i, double k) { return corner + u * (i / 4) + v * (k / 4); };
  const auto rectangle = [&](double i0, double k0, double i1, double k1) {
    return Contour{at(i0, k0), at(i1, k0), at(i1, k1), at(i0, k1)};
  };
  switch (form) {
    case 0:
      add_face(scene, {rectangle(0, 0, 4, 4)});
      break;
    case 1: {
      const int i = bytes.between(1, 2), k = bytes.between(1, 2);
      add_face(scene, {rectangle(0, 0, 4, 4), rectangle(i, k, bytes.between(i + 1, 3), bytes.between(k + 1, 3))});
      break;
    }
    case 2:
      add_face(scene, {rectangle(0, 0, 4, 4), rectangle(1, 1, 3, 2), {at(1, 3), at(2, 2.5), at(3, 3), at(2, 3.5)}});
      break;
    default: {
      const int i = bytes.between(1, 3), k = bytes.between(1, 3);
      add_face(scene, {{at(0, 0), at(4, 0), at(4, k), at(i, k), at(i, 4), at(0, 4)}});
    }
  }
}

/// An object of the points and of faces that name them.
void add_object(Scene& scene, const Contour& points, const std::vector<std::vector<std::uint32_t>>& faces) {
  begin_object(scene);
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), points.begin(), points.end());
  for (std::vector<std::uint32_t> face : faces) {
    for (std::uint32_t& v : face) v += base;
    scene.faces.add_face(face);
  }
  end_object(scene);
}

/// A triangle or an L, pushed along a vector; with or without its far end.
void add_prism(Scene& scene, ByteStream& bytes) {
  const Point3 corner = bytes.point(), u = bytes.vector(-2, 2), v = bytes.vector(-2, 2), push = bytes.vector(-3, 3);
  const bool bent = bytes.below(2) == 1, open = bytes.below(4) == 3;
  const double volume = glm::dot(glm::cross(u, v), push);
  if (volume == 0) return;
  Contour base =
      bent ? Contour{corner, corner + u * 2.0, corner + u * 2.0 + v, corner + u + v, corner + u + v * 2.0, corner + v * 2.0}
           : Contour{corner, corner + u, corner + v};
  const auto n = static_cast<std::uint32_t>(base.size());
  for (std::uint32_t i = 0; i < n; ++i) base.push_back(base[i] + push);
  std::vector<std::vector<std::uint32_t>> faces(open ? 1 : 2);
  for (std::uint32_t i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    if (!open) faces[1].push_back(n + i);
    const std::uint32_t k = (i + 1) % n;
    faces.push_back({i, k, n + k, n + i});
  }
  if (volume < 0)
    for (auto& face : faces) std::reverse(face.begin(), face.end());
  add_object(scene, base, faces);
}

void add_tetrahedron(Scene& scene, ByteStream& bytes) {
  Contour p;
  for (int i = 0; i < 4; ++i) p.push_back(bytes.point());
  const double volume = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
  if (volume == 0) return;
  if (volume < 0) std::swap(p[0], p[1]);
  add_object(scene, p, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

/// A few triangles over five vertices, as they come: books, sheets, several faces on one edge, faces on each other.
void add_mesh(Scene& scene, ByteStream& bytes) {
  Contour p;
  for (int i = 0; i < 5; ++i) p.push_back(bytes.point());
  std::vector<std::vector<std::uint32_t>> faces;
  const int n = bytes.between(2, 5);
  for (int i = 0; i < n; ++i) {
    const int a = bytes.below(5), b = (a + bytes.between(1, 3)) % 5, c = (a + 4) % 5;
    if (is_flat(p[b] - p[a], p[c] - p[a])) continue;
    faces.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  }
  if (!faces.empty()) add_object(scene, p, faces);
}

void add_element(Scene& scene, ByteStream& bytes) {
  switch (bytes.below(6)) {
    case 0: {
      const Point3 corner = bytes.point();
      return add_box(scene, corner, bytes.vector(1, 3));
    }
    case 1:
      return add_triangle(scene, bytes);
    case 2:
      return add_plate(scene, bytes);
    case 3:
      return add_prism(scene, bytes);
    case 4:
      return add_tetrahedron(scene, bytes);
    default:
      return add_mesh(scene, bytes);
  }
}

void turn(Scene& scene, const Basis& basis) {
  for (Point3& p : scene.vertices) p = basis[0] * p.x + basis[1] * p.y + basis[2] * p.z;
  for (Object& object : scene.objects) {
    double largest = 0;
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v)
      largest = std::max(largest, glm::length(scene.vertices[v]));
    constexpr double kRoundings = 4;  // of a coordinate: three products of rounded factors, and their sum
    object.precision = largest * kRoundings * 0x1p-53;
  }
}

StandardView along_vector(ByteStream& bytes) {
  Point3 d = bytes.vector(-3, 3);
  if (d == Point3(0)) d = {0, 1, 0};
  char options[96];
  std::snprintf(options, sizeof options, "--direction=%g,%g,%g --landscape", d.x, d.y, d.z);
  StandardView view{"along a vector", {}, options};
  view.camera.direction = d;
  return view;
}

StandardView from_point(ByteStream& bytes) {
  const Point3 eye = bytes.vector(-4, 8);
  Point3 target = bytes.point();
  if (target == eye) target.y += 1;
  constexpr std::array kAngles{35, 60, 90};
  const int fov = kAngles[static_cast<std::size_t>(bytes.below(3))];
  char options[160];
  std::snprintf(options, sizeof options, "--eye=%g,%g,%g --target=%g,%g,%g --fov=%d --landscape", eye.x, eye.y, eye.z,
                target.x, target.y, target.z, fov);
  StandardView view{"from a point", {}, options};
  view.camera.eye = eye;
  view.camera.target = target;
  view.camera.fov_degrees = fov;
  return view;
}

}  // namespace

ByteScene scene_of_bytes(std::span<const std::uint8_t> bytes) {
  ByteStream stream(bytes);
  ByteScene result;
  constexpr int kStandardViews = 7, kAlong = 4, kFrom = 3;
  const int view = stream.below(kStandardViews + kAlong + kFrom);
  const int turned = stream.below(16);
  if (view >= kStandardViews) result.view = view < kStandardViews + kAlong ? along_vector(stream) : from_point(stream);
  while (stream.more() && result.scene.faces.size() < kMostFaces) add_element(result.scene, stream);
  if (turned % 4 == 3) turn(result.scene, rotation(0.3 + turned, 0.7, 1.1 * turned));
  if (result.scene.faces.empty()) return result;
  finish(result.scene);
  if (view < kStandardViews) result.view = standard_views(result.scene)[static_cast<std::size_t>(view)];
  return result;
}

std::string faults_of(const ByteScene& scene) {
  if (scene.scene.faces.empty()) return {};
  const std::string name = "scene";
  const JudgedView judged(scene.scene, name, scene.view);
  std::string faults;
  for (const char* edges : {"all", "feature"}) faults += judged.judge(*find_method("auto"), edges).faults;
  if (faults.empty()) return {};
  // The judge speaks of a scene of the corpus; this one is to be saved first.
  const std::string folder = "tests/corpus/" + name;
  for (std::size_t at; (at = faults.find(folder)) != std::string::npos;) faults.replace(at, folder.size(), name);
  return faults + "scene.json:\n" + write_ligne_scene(scene.scene);
}

}  // namespace ligne::test
