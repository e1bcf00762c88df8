#include "scene/readers/scene_bytes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/model/faces_and_edges.hpp"
#include "scene/readers/reader.hpp"

namespace ligne {
namespace {

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

void write_point(ByteWriter& bytes, const Point3& p) {
  for (int k = 0; k < 3; ++k) bytes.number(p[k]);
}

Point3 read_point(ByteReader& bytes) {
  Point3 p;
  for (int k = 0; k < 3; ++k) p[k] = bytes.number<double>();
  bytes.need(is_finite(p), "a coordinate is not a number");
  return p;
}

void write_points(ByteWriter& bytes, const std::vector<Point3>& points) { bytes.list(std::span(points)); }

/// Reads points; refuses coordinates that readers of models refuse.
std::vector<Point3> read_points(ByteReader& bytes) {
  std::vector<Point3> points = bytes.list<Point3>();
  for (const Point3& p : points) {
    bytes.need(is_finite(p), "a coordinate is not a number");
    for (int k = 0; k < 3; ++k)
      bytes.need(std::abs(p[k]) <= kLargestCoordinate, "a coordinate is too large to compute with");
  }
  return points;
}

/// Writes all corners, then the sizes of the contours per face; no sizes if all faces are triangles.
void write_faces(ByteWriter& bytes, const PolygonFaces& faces) {
  bytes.list(faces.corners());
  std::vector<std::uint32_t> contours, sizes;
  if (!faces.all_triangles()) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      contours.push_back(static_cast<std::uint32_t>(faces.contour_count(f)));
      for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
        sizes.push_back(static_cast<std::uint32_t>(faces.contour(f, c).size()));
      }
    }
  }
  bytes.list(std::span<const std::uint32_t>(contours));
  bytes.list(std::span<const std::uint32_t>(sizes));
}

PolygonFaces read_faces(ByteReader& bytes, std::size_t vertices) {
  const std::vector<std::uint32_t> corners = bytes.list<std::uint32_t>(), contours = bytes.list<std::uint32_t>(),
                                   sizes = bytes.list<std::uint32_t>();
  for (const std::uint32_t v : corners) bytes.need(v < vertices, "a face has a vertex that is not there");
  PolygonFaces faces;
  if (contours.empty()) {
    bytes.need(corners.size() % 3 == 0 && sizes.empty(), "corners of triangles are not three each");
    std::ranges::copy(corners, faces.append_triangles(corners.size() / 3).begin());
    return faces;
  }
  std::size_t corner = 0, contour = 0;
  for (const std::uint32_t count : contours) {
    bytes.need(count >= 1 && count <= sizes.size() - contour, "a face has contours that are not there");
    for (std::uint32_t c = 0; c < count; ++c) {
      const std::uint32_t size = sizes[contour++];
      bytes.need(size >= 3 && size <= corners.size() - corner, "a contour has corners that are not there");
      const auto list = std::span(corners).subspan(corner, size);
      c == 0 ? faces.add_face(list) : faces.add_hole(list);
      corner += size;
    }
  }
  bytes.need(contour == sizes.size() && corner == corners.size(), "corners belong to no face");
  return faces;
}

void write_object(ByteWriter& bytes, const Object& object) {
  bytes.text(object.name);
  bytes.number(object.vertex_end);
  bytes.number(object.face_end);
  bytes.number(object.precision);
}

/// Reads objects. Checks that they own consecutive ranges, and that each face uses vertices of its own object.
void read_objects(ByteReader& bytes, Scene& scene) {
  const auto count = bytes.number<std::uint64_t>();
  std::uint32_t vertex = 0, face = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    Object& object = scene.objects.emplace_back();
    object.name = bytes.text();
    object.vertex_begin = vertex;
    object.face_begin = face;
    object.vertex_end = vertex = bytes.number<std::uint32_t>();
    object.face_end = face = bytes.number<std::uint32_t>();
    object.precision = bytes.number<double>();
    bytes.need(object.vertex_begin <= vertex && vertex <= scene.vertices.size() && object.face_begin <= face &&
                   face <= scene.faces.size(),
               "an object has faces or vertices that are not there");
    bytes.need(std::isfinite(object.precision) && object.precision >= 0, "the precision of an object is not a number");
    for (std::size_t f = object.face_begin; f < face; ++f) {
      for (const std::uint32_t v : corners_of(scene.faces, f))
        bytes.need(v >= object.vertex_begin && v < vertex, "a face has a vertex of another object");
    }
  }
  bytes.need(vertex == scene.vertices.size() && face == scene.faces.size(), "faces or vertices belong to no object");
}

void read_materials(ByteReader& bytes, Scene& scene) {
  const auto count = bytes.number<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    Material& material = scene.materials.emplace_back();
    material.name = bytes.text();
    material.color = read_point(bytes);
    material.opacity = bytes.number<double>();
    bytes.need(material.opacity >= 0 && material.opacity <= 1, "an opacity is not from 0 to 1");
  }
  scene.face_material = bytes.list<std::uint32_t>();
  bytes.need(scene.face_material.empty() || scene.face_material.size() == scene.faces.size(),
             "there is not one material for each face");
  for (const std::uint32_t m : scene.face_material) bytes.need(m < count, "a face has a missing material");
}

void read_lights(ByteReader& bytes, Scene& scene) {
  const auto count = bytes.number<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto kind = bytes.number<std::uint8_t>();
    bytes.need(kind <= static_cast<std::uint8_t>(Light::Kind::point), "a light is of no kind that there is");
    scene.lights.push_back({static_cast<Light::Kind>(kind), read_point(bytes)});
  }
}

void write_camera(ByteWriter& bytes, const SceneCamera& camera) {
  bytes.text(camera.name);
  write_point(bytes, camera.eye);
  write_point(bytes, camera.forward);
  bytes.number(static_cast<std::uint8_t>(camera.up.has_value()));
  write_point(bytes, camera.up.value_or(Point3{0, 0, 0}));
  bytes.number(static_cast<std::uint8_t>(camera.perspective));
  bytes.number(camera.fov_degrees);
  bytes.number(camera.aspect.value_or(0));
}

void read_cameras(ByteReader& bytes, Scene& scene) {
  const auto count = bytes.number<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    SceneCamera& camera = scene.cameras.emplace_back();
    camera.name = bytes.text();
    camera.eye = read_point(bytes);
    camera.forward = read_point(bytes);
    const bool has_up = bytes.number<std::uint8_t>() != 0;
    const Point3 up = read_point(bytes);
    if (has_up) camera.up = up;
    camera.perspective = bytes.number<std::uint8_t>() != 0;
    camera.fov_degrees = bytes.number<double>();
    const auto aspect = bytes.number<double>();
    bytes.need(std::isfinite(camera.fov_degrees) && std::isfinite(aspect) && aspect >= 0, "a camera has no field of view");
    if (aspect > 0) camera.aspect = aspect;
  }
}

void read_details(ByteReader& bytes, Scene& scene) {
  const auto count = bytes.number<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    Detail& detail = scene.details.emplace_back();
    detail.face = bytes.number<std::uint32_t>();
    detail.material = bytes.number<std::uint32_t>();
    detail.contour = read_points(bytes);
    bytes.need(detail.face < scene.faces.size() && detail.material < scene.materials.size() && detail.contour.size() >= 3,
               "a detail lies on no face, or has no material");
  }
}

}  // namespace

void write_scene(ByteWriter& bytes, const Scene& scene) {
  bytes.number(static_cast<std::uint8_t>(scene.up_axis));
  bytes.number(scene.unit_mm);
  write_points(bytes, scene.vertices);
  write_faces(bytes, scene.faces);
  bytes.list(std::span<const std::uint8_t>(scene.corner_flags));
  bytes.number(static_cast<std::uint64_t>(scene.objects.size()));
  for (const Object& object : scene.objects) write_object(bytes, object);
  bytes.number(static_cast<std::uint64_t>(scene.materials.size()));
  for (const Material& material : scene.materials) {
    bytes.text(material.name);
    write_point(bytes, material.color);
    bytes.number(material.opacity);
  }
  bytes.list(std::span<const std::uint32_t>(scene.face_material));
  bytes.number(static_cast<std::uint64_t>(scene.lights.size()));
  for (const Light& light : scene.lights) {
    bytes.number(static_cast<std::uint8_t>(light.kind));
    write_point(bytes, light.vector);
  }
  bytes.number(static_cast<std::uint64_t>(scene.cameras.size()));
  for (const SceneCamera& camera : scene.cameras) write_camera(bytes, camera);
  bytes.number(static_cast<std::uint64_t>(scene.details.size()));
  for (const Detail& detail : scene.details) {
    bytes.number(detail.face);
    bytes.number(detail.material);
    write_points(bytes, detail.contour);
  }
}

Scene read_scene(ByteReader& bytes) {
  Scene scene;
  const auto up_axis = bytes.number<std::uint8_t>();
  bytes.need(up_axis <= static_cast<std::uint8_t>(Axis::z), "the up axis is none that there is");
  scene.up_axis = static_cast<Axis>(up_axis);
  scene.unit_mm = bytes.number<double>();
  bytes.need(std::isfinite(scene.unit_mm) && scene.unit_mm > 0, "the unit is not a length");
  scene.vertices = read_points(bytes);
  scene.faces = read_faces(bytes, scene.vertices.size());
  scene.corner_flags = bytes.list<std::uint8_t>();
  bytes.need(scene.corner_flags.empty() || scene.corner_flags.size() == scene.faces.corners().size(),
             "there are not as many flags as corners");
  read_objects(bytes, scene);
  read_materials(bytes, scene);
  read_lights(bytes, scene);
  read_cameras(bytes, scene);
  read_details(bytes, scene);
  return scene;
}

}  // namespace ligne
