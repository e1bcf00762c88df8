#pragma once
/// Builds scenes from faces and boxes.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// Starts a new object. Faces and vertices that are added until end_object() belong to it.
inline void begin_object(Scene& scene, const std::string& name = "object") {
  Object object;
  object.name = name;
  object.vertex_begin = object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  object.face_begin = object.face_end = static_cast<std::uint32_t>(scene.faces.size());
  scene.objects.push_back(object);
}

/// Ends the object: sets the ends of its ranges, and its precision to that of doubles.
inline void end_object(Scene& scene) {
  Object& object = scene.objects.back();
  object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  object.face_end = static_cast<std::uint32_t>(scene.faces.size());
  double largest = 0;
  for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
    const Point3 p = scene.vertices[v];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  object.precision = largest * 0x1p-53;
}

/// Adds an object of one face. The first contour is the outer one, the others are holes.
inline void add_face(Scene& scene, const std::vector<std::vector<Point3>>& contours) {
  begin_object(scene);
  bool outer = true;
  for (const auto& contour : contours) {
    std::vector<std::uint32_t> corners;
    for (const Point3& p : contour) {
      corners.push_back(static_cast<std::uint32_t>(scene.vertices.size()));
      scene.vertices.push_back(p);
    }
    outer ? scene.faces.add_face(corners) : scene.faces.add_hole(corners);
    outer = false;
  }
  end_object(scene);
}

/// The images of the unit vectors of x, y and z.
using Basis = std::array<Point3, 3>;
inline constexpr Basis kUpright{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};

/// Adds an object that is a closed box of six quadrilaterals with outward normals. `corner` is its lowest corner and
/// `size` its extent before the basis is applied to both.
inline void add_box(Scene& scene, const Point3& corner, const Point3& size, const Basis& basis = kUpright) {
  begin_object(scene, "box");
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  for (int i = 0; i < 8; ++i) {
    const Point3 local = corner + size * Point3{double(i & 1), double((i >> 1) & 1), double(i >> 2)};
    scene.vertices.push_back(basis[0] * local.x + basis[1] * local.y + basis[2] * local.z);
  }
  for (const auto& q :
       {std::array<std::uint32_t, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    const std::array<std::uint32_t, 4> corners{base + q[0], base + q[1], base + q[2], base + q[3]};
    scene.faces.add_face(corners);
  }
  end_object(scene);
}

/// The basis of a rotation by Euler angles, in radians.
inline Basis rotation(double a, double b, double c) {
  const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b), cc = std::cos(c), sc = std::sin(c);
  return {Point3{cb * cc, cb * sc, -sb}, Point3{sa * sb * cc - ca * sc, sa * sb * sc + ca * cc, sa * cb},
          Point3{ca * sb * cc + sa * sc, ca * sb * sc - sa * cc, ca * cb}};
}

}  // namespace ligne
