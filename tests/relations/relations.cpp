#include "relations/relations.hpp"

namespace ligne::test {
namespace {

constexpr unsigned kSeed = 20;

struct Box {
  Point3 low, high;
  Point3 centre() const { return (low + high) * 0.5; }
  double radius() const { return glm::length(high - low) / 2; }
};

Box box_of(const PlainObject& object) {
  Box box{object.faces[0].contours[0][0], object.faces[0].contours[0][0]};
  for (const PlainFace& face : object.faces)
    for (const Point3& p : face.contours[0]) {
      box.low = glm::min(box.low, p);
      box.high = glm::max(box.high, p);
    }
  return box;
}

Box box_of(const PlainScene& scene) {
  Box box = box_of(scene.objects[0]);
  for (const PlainObject& object : scene.objects) {
    const Box other = box_of(object);
    box = {glm::min(box.low, other.low), glm::max(box.high, other.high)};
  }
  return box;
}

/// Half a unit in the last place of the object's largest coordinate.
double rounding_of(const PlainObject& object) {
  const Box box = box_of(object);
  const Point3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
  return std::max({far.x, far.y, far.z}) * 0x1p-53;
}

template <class Function>
PlainScene with_points(PlainScene scene, const Function& function) {
  for (PlainObject& object : scene.objects)
    for (PlainFace& face : object.faces)
      for (Contour& contour : face.contours)
        for (Point3& p : contour) p = function(p);
  return scene;
}

/// Objects that were computed are no more exact than the roundings: three products and two sums for a coordinate.
PlainScene computed(PlainScene scene) {
  constexpr double kRoundings = 5;
  for (PlainObject& object : scene.objects) object.precision += kRoundings * rounding_of(object);
  return scene;
}

PlainScene with_faces(PlainScene scene, const std::function<std::vector<PlainFace>(const PlainFace&)>& function) {
  for (PlainObject& object : scene.objects) {
    std::vector<PlainFace> faces;
    for (const PlainFace& face : object.faces)
      for (PlainFace& f : function(face)) faces.push_back(std::move(f));
    object.faces = std::move(faces);
  }
  return scene;
}

PlainScene reversed(PlainScene scene) {
  for (PlainObject& object : scene.objects)
    for (PlainFace& face : object.faces)
      for (Contour& contour : face.contours) std::reverse(contour.begin(), contour.end());
  return scene;
}

/// The camera after a map of the points and one of the directions.
template <class OfPoint, class OfDirection>
CameraRequest mapped(CameraRequest camera, const OfPoint& of_point, const OfDirection& of_direction) {
  if (camera.eye) camera.eye = of_point(*camera.eye);
  if (camera.target) camera.target = of_point(*camera.target);
  if (camera.direction) camera.direction = of_direction(*camera.direction);
  if (camera.up) camera.up = of_direction(*camera.up);
  return camera;
}

Related shuffled(const Sight& sight, bool) {
  Sight changed = sight;
  std::mt19937 random(kSeed);
  // Not std::shuffle, which is another one in every library.
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
  };
  shuffle(changed.scene.objects);
  for (PlainObject& object : changed.scene.objects) shuffle(object.faces);
  return {changed};
}

Related rewound(const Sight& sight, bool) {
  Sight changed{reversed(sight.scene), sight.camera};
  std::size_t shift = 0;
  for (PlainObject& object : changed.scene.objects) {
    for (PlainFace& face : object.faces)
      for (Contour& c : face.contours)
        std::rotate(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(++shift % c.size()), c.end());
  }
  return {changed};
}

/// A power of two near the scene's size: sums with its small multiples are exact.
double dyadic_size(const PlainScene& scene) { return std::exp2(std::ceil(std::log2(box_of(scene).radius()))); }

Related moved(const Sight& sight, bool) {
  const Point3 by = Point3{3, -5, 2} * dyadic_size(sight.scene);
  const auto of_point = [&](const Point3& p) { return p + by; };
  return {{with_points(sight.scene, of_point), mapped(sight.camera, of_point, [](const Point3& d) { return d; })}};
}

Related scaled(const Sight& sight, double factor) {
  const auto of_point = [&](const Point3& p) { return p * factor; };
  Sight changed{with_points(sight.scene, of_point), mapped(sight.camera, of_point, [](const Point3& d) { return d; })};
  for (PlainObject& object : changed.scene.objects) object.precision *= factor;
  return {changed};
}

/// Round the line of sight, with what is up on the page: by the angle of 3, 4 and 5.
Related turned(const Sight& sight, bool) {
  const Camera camera = make_camera(sight.camera, to_scene(sight.scene));
  const Point3 axis = camera.forward, centre = box_of(sight.scene).centre();
  constexpr double kCos = 0.6, kSin = 0.8;
  const auto of_direction = [&](const Point3& d) {
    return d * kCos + glm::cross(axis, d) * kSin + axis * (glm::dot(axis, d) * (1 - kCos));
  };
  const auto of_point = [&](const Point3& p) { return centre + of_direction(p - centre); };
  CameraRequest upright = sight.camera;
  upright.up = -camera.down;
  return {{computed(with_points(sight.scene, of_point)), mapped(upright, of_point, of_direction)}};
}

/// Round the diagonal of the axes by a third of a turn, with the camera: exact, however large the coordinates.
Related axes_exchanged(const Sight& sight, bool) {
  const Camera camera = make_camera(sight.camera, to_scene(sight.scene));
  const auto exchanged = [](const Point3& p) { return Point3{p.z, p.x, p.y}; };
  CameraRequest upright = sight.camera;
  upright.up = -camera.down;
  return {{with_points(sight.scene, exchanged), mapped(upright, exchanged, exchanged)}};
}

/// In the plane of the line of sight and what is up.
Related mirrored(const Sight& sight, bool) {
  const Camera camera = make_camera(sight.camera, to_scene(sight.scene));
  const Point3 normal = camera.right;
  const Point3 through = camera.perspective ? camera.eye : box_of(sight.scene).centre();
  const auto of_point = [&](const Point3& p) { return p - normal * (2 * glm::dot(normal, p - through)); };
  return {{computed(reversed(with_points(sight.scene, of_point))), sight.camera}, true};
}

Related triangulated(const Sight& sight, bool) {
  const auto triangles_of = [](const PlainFace& face) {
    PlainScene one;
    one.objects.push_back({0, {face}});
    const Scene scene = to_scene(one);
    std::vector<PlainFace> triangles;
    for (const Triangle& t : build_topology(scene).triangles)
      triangles.push_back({{{scene.vertices[t.v[0]], scene.vertices[t.v[1]], scene.vertices[t.v[2]]}}});
    return triangles;
  };
  return {{with_faces(sight.scene, triangles_of), sight.camera}};
}

/// A point of the edge that is the same from either end, and exact for dyadic ends. No simple fraction: where things cross
/// exactly along such a cut, their common line is an edge of coplanar faces, mesh, and no intersection.
Point3 point_within(const Point3& a, const Point3& b) {
  constexpr double kPart = 11.0 / 32;
  const bool forward = std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  return forward ? a + (b - a) * kPart : b + (a - b) * kPart;
}

/// Every edge gets a corner more, and every convex quadrilateral becomes two that lie in its plane.
Related halved(const Sight& sight, bool) {
  const auto halves_of = [](const PlainFace& face) {
    PlainFace fine;
    for (const Contour& contour : face.contours) {
      Contour& c = fine.contours.emplace_back();
      for (std::size_t i = 0; i < contour.size(); ++i) {
        c.push_back(contour[i]);
        c.push_back(point_within(contour[i], contour[(i + 1) % contour.size()]));
      }
    }
    const Contour& outer = face.contours[0];
    bool convex = face.contours.size() == 1 && outer.size() == 4;
    for (std::size_t i = 0; convex && i < 4; ++i) {
      const auto turn = [&](std::size_t k) {
        return glm::cross(outer[(k + 1) % 4] - outer[k], outer[(k + 2) % 4] - outer[(k + 1) % 4]);
      };
      convex = glm::dot(turn(i), turn((i + 1) % 4)) > 0;
    }
    if (!convex) return std::vector<PlainFace>{fine};
    const Contour& c = fine.contours[0];
    return std::vector<PlainFace>{{{{c[0], c[1], c[5], c[6], c[7]}}}, {{{c[1], c[2], c[3], c[4], c[5]}}}};
  };
  return {{with_faces(sight.scene, halves_of), sight.camera}};
}

PlainObject tetrahedron(const Point3& centre, double size) {
  const std::array<Point3, 4> p{centre + Point3{1, 1, 1} * size, centre + Point3{1, -1, -1} * size,
                                centre + Point3{-1, 1, -1} * size, centre + Point3{-1, -1, 1} * size};
  PlainObject object{0, {{{{p[0], p[1], p[2]}}}, {{{p[0], p[3], p[1]}}}, {{{p[0], p[2], p[3]}}}, {{{p[1], p[3], p[2]}}}}};
  object.precision = rounding_of(object);
  return object;
}

/// A tetrahedron in the middle of the first object, when that is a closed convex solid; otherwise behind a plate that stands
/// behind the scene, which is there without the tetrahedron too.
Related with_hidden(const Sight& sight, bool closed_solid) {
  constexpr double kSmallPart = 1.0 / 16;
  Related result{sight};
  std::vector<PlainObject>& objects = result.changed.scene.objects;
  if (closed_solid) {
    const Box box = box_of(objects[0]);
    const Point3 size = box.high - box.low;
    objects.push_back(tetrahedron(box.centre(), kSmallPart * std::min({size.x, size.y, size.z})));
    return result;
  }
  const Camera camera = make_camera(sight.camera, to_scene(sight.scene));
  const Box box = box_of(sight.scene);
  const double r = box.radius();
  const Point3 centre = box.centre() + camera.forward * (1.5 * r);
  PlainObject plate{
      0, {{{{centre - camera.right * r, centre - camera.down * r, centre + camera.right * r, centre + camera.down * r}}}}};
  plate.precision = rounding_of(plate);
  objects.push_back(plate);
  result.base = result.changed.scene;
  objects.push_back(tetrahedron(centre + camera.forward * (0.5 * r), kSmallPart * r));
  return result;
}

}  // namespace

std::vector<Relation> all_relations() {
  return {{"shuffled", shuffled},
          {"rewound", rewound},
          {"moved", moved},
          {"doubled", [](const Sight& s, bool) { return scaled(s, 2); }},
          {"tripled", [](const Sight& s, bool) { return scaled(s, 3); }},
          {"turned", turned},
          {"mirrored", mirrored},
          {"triangulated", triangulated},
          {"halved", halved},
          {"with_hidden", with_hidden}};
}

std::vector<Relation> relations_of_near_surfaces() {
  return {
      {"shuffled", shuffled},
      {"rewound", rewound},
      {"scaled", [](const Sight& s, bool) { return scaled(s, 1024); }},
      {"turned", turned},
      {"axes_exchanged", axes_exchanged},
  };
}

}  // namespace ligne::test
