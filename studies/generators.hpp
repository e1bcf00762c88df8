#pragma once
/// Scenes of the experiments: those of the figures of [Boulle1980], as far as the text tells them, and families that grow.
///
/// Scenes are seen by the named view "front", along +y, unless the generator says otherwise: x to the right, z up, what has
/// the larger y is farther.

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

/// A rectangle on the page, over x and z, whose left side is at the depth y.low and whose right side at y.high.
void add_plate(Scene& scene, Limits x, Limits z, Limits y);

/// A comb in the plane y = depth: a back x 0..2 and teeth from there to x = 10, 2 wide and 2 apart. It has 4 teeth corners.
void add_comb(Scene& scene, int teeth, double depth);

/// Figures 2.20 to 2.23: a square of side 50 turned by 40 degrees, before a triangle that it hides, moved by the shift.
Scene square_before_triangle(double shift_x, double shift_z);

/// Figure 2.66: slab 1 of four faces, of which the nearest cuts the others, and before it the screen face of slab 2.
Scene screen_before_slab(bool with_screen);

/// Figure 2.67: n combs in a stair, each before the next: a comb's r - 1 teeth cut the back of the next one, of which r
/// parts are seen. r >= 2.
Scene nested(int n, int r);

/// Figures 2.81 e and 2.82: n bars round a centre, each over the next.
Scene ring(int n);

/// Figure 2.83: n plates whose depths are apart.
Scene apart_in_depth(int n);

/// Figure 2.84: a leaning plate, and n faces of c = 4 teeth corners that stand in it with their teeth.
Scene combs_through_plate(int n, int teeth);

/// Figure 2.88: zones of slabs of zones, each of one face in the end.
Scene zones_of_slabs();

/// [Huet1994] 3.1: the faces of a stair of n steps.
Scene stair(int n);

/// A ball of 2 n (n - 1) triangles.
Scene ball(int n);

/// n x n boxes on a square grid, of sizes and heights by chance, none of which touches another.
Scene city(int n);

/// Figure 2.52 in space: n square columns along a diagonal, turned about the vertical by the angle.
Scene columns(int n, double degrees);

/// n boxes by chance that pass through each other.
Scene penetrating_boxes(int n);

/// n faces by chance with 3 to 6 corners, all of which lean alike: none passes through another, and which of two is in front
/// their nearest points do not tell.
Scene leaning_faces(int n, std::uint32_t seed);

/// Fixed seed, the same on all machines.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  double uniform(double from, double to);
  int whole(int from, int to) { return from + static_cast<int>(next() % static_cast<std::uint64_t>(to - from + 1)); }

 private:
  std::uint64_t state_;
};

/// Figure 2.52: n squares of side 2 along a diagonal in the scan plane, turned, and moved along the line by `shift`. Sides
/// along the sight are no segments. `steps` of the line to a unit; whole numbers of them when X is whole.
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

/// Welds and checks, as a reader does.
void finish(Scene& scene);

/// The scene on a sheet of 297 x 210 mm with a margin of 10, or at the scale on one of 100 x 100, with these classes of
/// edges.
ProjectedScene on_sheet(const Scene& scene, std::string_view view = "front", bool all_edges = true);
ProjectedScene on_square_sheet(const Scene& scene);

}  // namespace ligne::studies
