#include "studies/scenes/generators.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/hash.hpp"
#include "scene/clean/clean.hpp"
#include "scene/model/scene_parts.hpp"
#include "scene/model/topology.hpp"

namespace ligne::studies {
namespace {

using std::numbers::pi;

EdgeSelection selection_of(bool all_edges) {
  EdgeSelection selection;
  for (const LineClass c : {LineClass::outline, LineClass::border, LineClass::crease}) selection.classes.add(c);
  if (all_edges) selection.classes.add(LineClass::mesh);
  return selection;
}

}  // namespace

void finish(Scene& scene) {
  Warnings warnings;
  finish_scene(scene, warnings);
}

void add_plate(Scene& scene, Limits x, Limits z, Limits y) {
  add_face(scene, {{{x.low, y.low, z.low}, {x.high, y.high, z.low}, {x.high, y.high, z.high}, {x.low, y.low, z.high}}});
}

void add_comb(Scene& scene, int teeth, double depth) {
  std::vector<Point3> corners{{0, depth, 0}};
  for (int t = 0; t < teeth; ++t) {
    const double z = 4 * t;
    corners.insert(corners.end(), {{10, depth, z}, {10, depth, z + 2}});
    if (t + 1 < teeth) corners.insert(corners.end(), {{2, depth, z + 2}, {2, depth, z + 4}});
  }
  corners.push_back({0, depth, 4.0 * teeth - 2});
  add_face(scene, {corners});
}

Scene leaning_bars(int n) {
  Scene scene;
  const double length = 3.0 * n;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 2; ++k) {
      const double x = 3.0 * i + 0.5 * k, y = k, z = 0.5 * k;
      add_face(scene, {{{x, y, z}, {x + 1, y, z}, {x + 1 + length, y, z + length}, {x + length, y, z + length}}});
    }
  }
  return scene;
}

Scene nested_angles(int n) {
  Scene scene;
  const double end = 3.0 * n;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 2; ++k) {
      const double a = 3.0 * i + 0.5 * k, b = a + 1, y = k;
      add_face(scene, {{{a, y, a}, {end, y, a}, {end, y, b}, {b, y, b}, {b, y, end}, {a, y, end}}});
    }
  }
  return scene;
}

Scene square_before_triangle(double shift_x, double shift_z) {
  const double angle = 40 * pi / 180, c = std::cos(angle), s = std::sin(angle);
  Scene scene;
  std::vector<Point3> square;
  for (const auto& [x, z] : {std::pair{-25, -25}, {25, -25}, {25, 25}, {-25, 25}})
    square.push_back({c * x - s * z, 0, s * x + c * z});
  add_face(scene, {square});
  std::vector<Point3> triangle;
  for (const auto& [x, z] : {std::pair{-6, -5}, {16, -3}, {4, 17}}) triangle.push_back({x + shift_x, 10.0, z + shift_z});
  add_face(scene, {triangle});
  return scene;
}

Scene screen_before_slab(bool with_screen) {
  Scene scene;
  add_plate(scene, {5, 8}, {1, 11}, {4, 4});
  add_face(scene, {{{2, 5, 8}, {7, 5, 9}, {3, 5, 11}}});
  add_plate(scene, {6, 12}, {5, 7}, {5, 5});
  add_face(scene, {{{1, 5, 1}, {6, 5, 2}, {2, 5, 4}}});
  if (with_screen) add_plate(scene, {0, 14}, {0, 12}, {0, 0});
  return scene;
}

Scene nested(int n, int r) {
  Scene scene;
  const double width = 4.0 * r + 2;
  for (int k = 0; k < n; ++k) {
    // Comb k has its back at z in [-4 k - 1, -4 k]; its teeth hang over the back of comb k + 1.
    const double y = k, top = -4.0 * k, bottom = top - 1, tip = top - 5.5;
    std::vector<Point3> corners{{0, y, top}, {width, y, top}, {width, y, bottom}};
    for (int t = r - 2; t >= 0; --t) {
      const double x = 4.0 * t + 2 + (k % 2) * 2;
      corners.insert(corners.end(), {{x + 1, y, bottom}, {x + 1, y, tip}, {x, y, tip}, {x, y, bottom}});
    }
    corners.push_back({0, y, bottom});
    std::reverse(corners.begin(), corners.end());
    add_face(scene, {corners});
  }
  return scene;
}

Scene ring(int n) {
  Scene scene;
  const auto corner = [&](double i, double radius) {
    const double a = 2 * pi * i / n;
    return Point2{radius * std::cos(a), radius * std::sin(a)};
  };
  // The radius grows with n so that adjacent bars still cross within their length.
  const double radius = n <= 6 ? 10 : 10.0 * n / 6;
  for (int i = 0; i < n; ++i) {
    const Point2 a = corner(i, radius), b = corner(i + 1, radius), d = glm::normalize(b - a), side = Point2{-d.y, d.x} * 0.5;
    const Point2 from = a - d * 3.0, to = b + d * 3.0;
    const auto at = [](Point2 p, double y) { return Point3{p.x, y, p.y}; };
    add_face(scene, {{at(from - side, 0), at(to - side, 4), at(to + side, 4), at(from + side, 0)}});
  }
  return scene;
}

Scene apart_in_depth(int n) {
  Scene scene;
  for (int i = 0; i < n; ++i) add_plate(scene, {0, 10}, {0, 10}, {3.0 * i + 2, 3.0 * i});
  return scene;
}

Scene combs_through_plate(int n, int teeth) {
  Scene scene;
  const double height = 4.0 * teeth;
  add_plate(scene, {-1, 11}, {-1, 1.0 * height * n + 1}, {0, 12});
  for (int i = 0; i < n; ++i) {
    // Each face has a plane of its own, so that one cut of the plate can not serve several faces.
    const double z0 = height * i, lean = 0.8 - 0.3 * i / n;
    const auto at = [&](double x, double z) { return Point3{x, 9 - lean * x, z0 + z}; };
    std::vector<Point3> corners{at(0, 0)};
    for (int t = 0; t < teeth; ++t) {
      const double z = 4 * t;
      corners.insert(corners.end(), {at(10, z), at(10, z + 2)});
      if (t + 1 < teeth) corners.insert(corners.end(), {at(2, z + 2), at(2, z + 4)});
    }
    corners.push_back(at(0, height - 2));
    add_face(scene, {corners});
  }
  return scene;
}

Scene stair(int n) {
  Scene scene;
  for (int i = 0; i < n; ++i) {
    const double x = i, z = i;
    add_face(scene, {{{x, 0, z}, {x, 4, z}, {x, 4, z + 1}, {x, 0, z + 1}}});
    add_face(scene, {{{x, 0, z + 1}, {x, 4, z + 1}, {x + 1, 4, z + 1}, {x + 1, 0, z + 1}}});
  }
  return scene;
}

Scene ball(int n) {
  Scene scene;
  begin_object(scene);
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double a = pi * row / n, b = 2 * pi * column / n;
      scene.vertices.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    }
  }
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const auto at = [&](int r, int c) { return static_cast<std::uint32_t>(r * n + c % n); };
      if (row > 0) scene.faces.add_triangle(at(row, column), at(row + 1, column), at(row, column + 1));
      if (row + 1 < n) scene.faces.add_triangle(at(row, column + 1), at(row + 1, column), at(row + 1, column + 1));
    }
  }
  end_object(scene);
  return scene;
}

Scene city(int n) {
  Scene scene;
  Chance chance(7);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double width = chance.uniform(3, 8), depth = chance.uniform(3, 8), height = chance.uniform(2, 20);
      add_box(scene, {10.0 * column, 10.0 * row, 0}, {width, depth, height});
    }
  }
  return scene;
}

Scene zones_of_slabs() {
  Scene scene;
  add_plate(scene, {0, 10}, {0, 10}, {9, 8});
  add_plate(scene, {0, 10}, {0, 4}, {3, 2});
  add_plate(scene, {0, 10}, {6, 10}, {3, 1});
  add_plate(scene, {20, 30}, {0, 10}, {9, 1.5});
  add_plate(scene, {20, 30}, {2, 8}, {0, 0.5});
  return scene;
}

Scene columns(int n, double degrees) {
  Scene scene;
  const Basis basis = rotation(0, 0, degrees * pi / 180);
  for (int i = 0; i < n; ++i) add_box(scene, {3.0 * i, 3.0 * i, 0}, {2, 2, 6}, basis);
  return scene;
}

Scene penetrating_boxes(int n) {
  Scene scene;
  Chance chance(11);
  const double room = std::cbrt(static_cast<double>(n));
  for (int i = 0; i < n; ++i) {
    const Basis basis = rotation(chance.uniform(-3, 3), chance.uniform(-3, 3), chance.uniform(-3, 3));
    const Point3 corner{chance.uniform(0, room), chance.uniform(0, room), chance.uniform(0, room)};
    add_box(scene, corner, {chance.uniform(0.5, 1.5), chance.uniform(0.5, 1.5), chance.uniform(0.5, 1.5)}, basis);
  }
  return scene;
}

Scene leaning_faces(int n, std::uint32_t seed) {
  Scene scene;
  Chance chance(seed);
  for (int i = 0; i < n; ++i) {
    const int corners = chance.whole(3, 6);
    const double x = chance.uniform(0, 30), z = chance.uniform(0, 30), size = chance.uniform(3, 9);
    const double begin = chance.uniform(0, 2 * pi), level = 0.01 * i;
    std::vector<Point3> contour;
    for (int k = 0; k < corners; ++k) {
      const double a = begin + 2 * pi * k / corners, px = x + size * std::cos(a), pz = z + size * std::sin(a);
      contour.push_back({px, level + 0.7 * px + 0.3 * pz, pz});
    }
    add_face(scene, {contour});
  }
  return scene;
}

std::uint64_t Chance::next() {
  // Generator SplitMix64 (Steele, Lea, Flood 2014).
  return mix_bits(state_ += kGoldenRatio);
}

double Chance::uniform(double from, double to) { return from + (to - from) * static_cast<double>(next() >> 11) * 0x1p-53; }

ProjectedScene on_sheet(const Scene& scene, std::string_view view, bool all_edges) {
  CameraRequest request{.named_view = view, .up_axis = scene.up_axis};
  const View placed = make_view(scene, make_camera(request, scene), Frame{{{10, 10}, {287, 200}}}, Rect{{0, 0}, {297, 210}});
  return project(scene, build_topology(scene), placed, selection_of(all_edges));
}

ProjectedScene on_square_sheet(const Scene& scene) {
  CameraRequest request;
  request.named_view = "front";
  const View placed =
      make_view(scene, make_camera(request, scene), Frame{{{10, 10}, {90, 90}}}, Rect{{0, 0}, {100, 100}}, 1);
  return project(scene, build_topology(scene), placed, selection_of(true));
}

}  // namespace ligne::studies
