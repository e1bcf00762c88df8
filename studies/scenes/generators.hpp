#pragma once
/// Scenes of the experiments: figures of [Boulle1980], as far as the text describes them, and families of growing size.
///
/// Scenes are viewed in the named view "front" unless the generator says otherwise: along +y, with x to the right and z up;
/// larger y is farther.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"
#include "view/projected_scene.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::studies {

struct Limits {
  double low, high;
};

/// A rectangle on the page, over x and z. Its left side has depth y.low, its right side y.high.
void add_plate(Scene& scene, Limits x, Limits z, Limits y);

/// A comb in the plane y = depth: a back in x 0..2 and teeth to x = 10, each 2 wide, 2 apart. It has 4 * teeth corners.
void add_comb(Scene& scene, int teeth, double depth);

/// Figures 2.20 to 2.23: a square of side 50, rotated by 40 degrees, hides a triangle. The shift moves the square.
Scene square_before_triangle(double shift_x, double shift_z);

/// Figure 2.66: slab 1 of four faces, of which the nearest cuts the others, and in front of it the screen face of slab 2.
Scene screen_before_slab(bool with_screen);

/// Figure 2.67: n combs in a stair, each in front of the next. The r - 1 teeth of a comb cut the back of the next into r
/// visible parts. Requires r >= 2.
Scene nested(int n, int r);

/// Figures 2.81 e and 2.82: n bars in a ring; each overlaps the next.
Scene ring(int n);

/// Figure 2.83: n plates with disjoint depth ranges.
Scene apart_in_depth(int n);

/// Figure 2.84: a leaning plate and n faces of 4 * teeth corners whose teeth penetrate it.
Scene combs_through_plate(int n, int teeth);

/// Figure 2.88: zones of slabs of zones, down to single faces.
Scene zones_of_slabs();

/// [Huet1994] 3.1: the faces of a stair of n steps.
Scene stair(int n);

/// A ball of 2 n (n - 1) triangles.
Scene ball(int n);

/// n x n boxes on a square grid, with random sizes and heights. No two touch.
Scene city(int n);

/// Figure 2.52 in space: n square columns along a diagonal, rotated about the vertical.
Scene columns(int n, double degrees);

/// n random boxes that penetrate each other.
Scene penetrating_boxes(int n);

/// n random faces with 3 to 6 corners and similar slopes. No two penetrate. The nearest points of two faces do not decide
/// which is in front.
Scene leaning_faces(int n, std::uint32_t seed);

/// n bars that lean by 45 degrees, side by side, each before a copy moved along it. The boxes of all overlap on the page,
/// the bars of different places do not.
Scene leaning_bars(int n);

/// n angles, each in the notch of the one before, and each before a copy moved into the notch. Their convex hulls overlap on
/// the page, the angles of different places do not.
Scene nested_angles(int n);

/// Random numbers from a fixed seed, equal on all machines.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  double uniform(double from, double to);
  int whole(int from, int to) { return from + static_cast<int>(next() % static_cast<std::uint64_t>(to - from + 1)); }

 private:
  std::uint64_t state_;
};

/// Figure 2.52: n rotated squares of side 2 along a diagonal in the scan plane, moved along the line by `shift`. Sides
/// parallel to the view direction make no segments. `steps`: scan line steps per unit. With integer X coordinates are
/// rounded.
template <class X>
std::vector<watkins::ScanSegment<X>> squares(int n, double degrees, double steps, double shift = 0) {
  constexpr double kPi = 3.14159265358979323846;
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  std::vector<watkins::ScanSegment<X>> segments;
  for (int i = 0; i < n; ++i) {
    const double corner[4][2] = {
        {3.0 * i, 3.0 * i}, {3.0 * i + 2, 3.0 * i}, {3.0 * i + 2, 3.0 * i + 2}, {3.0 * i, 3.0 * i + 2}};
    for (int k = 0; k < 4; ++k) {
      const auto x = [&](int v) { return std::round((corner[v % 4][0] * c - corner[v % 4][1] * s + shift) * steps); };
      const auto z = [&](int v) { return (corner[v % 4][0] * s + corner[v % 4][1] * c) * steps; };
      if (x(k) == x(k + 1)) continue;
      const int l = x(k) < x(k + 1) ? k : k + 1, r = l == k ? k + 1 : k;
      segments.push_back(
          {static_cast<X>(x(l)), static_cast<X>(x(r)), z(l), z(r), static_cast<std::uint32_t>(segments.size())});
    }
  }
  return segments;
}

/// Welds and checks the scene, as a reader does.
void finish(Scene& scene);

/// The projected scene: on a sheet of 297 x 210 mm with a margin of 10 mm, with all edges or the default classes; or at
/// scale on a sheet of 100 x 100 mm.
ProjectedScene on_sheet(const Scene& scene, std::string_view view = "front", bool all_edges = true);
ProjectedScene on_square_sheet(const Scene& scene);

}  // namespace ligne::studies
