// Experiments of the other sources: incremental depths (the lecture, 5.1) and complexity of display trees (Huet, 3.1).

#include <algorithm>
#include <cmath>

#include "studies/counting.hpp"
#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/scenes/generators.hpp"
#include "visibility/bsp/bsp.hpp"
#include "visibility/convex_tree/convex_tree.hpp"
#include "visibility/raster/scan_conversion.hpp"

namespace ligne::studies {
namespace {

using Real = Counted<double>;

/// A triangle over the pixels, and the plane of its depths, a x + b y + c z + d = 0.
struct Patch {
  double size;
  double a = 0.25, b = -0.5, c = 2, d = -7;
  double depth(double x, double y) const { return (-d - a * x - b * y) / c; }
};

struct Filling {
  Operations operations;
  std::uint64_t pixels = 0;
  double sum = 0, worst = 0;  ///< sum of the depths; largest error of one
};

/// Calls pixel(x, y) for the pixels of the triangle (0, 0), (size, 0), (0, size), and row(y) before each row.
template <class Row, class Pixel>
void scan(const Patch& patch, const Row& row, const Pixel& pixel) {
  for (int y = 0; y < int(patch.size); ++y) {
    row(y);
    for (int x = 0; x + y < int(patch.size); ++x) pixel(x, y);
  }
}

Filling by_equation(const Patch& patch) {
  Filling f;
  const Real a{patch.a, &f.operations}, b{patch.b, &f.operations}, c{patch.c, &f.operations},
      minus_d{-patch.d, &f.operations};
  Real z = minus_d;
  scan(
      patch, [](int) {},
      [&](int x, int y) {
        z = (minus_d - a * a.constant(x) - b * b.constant(y)) / c;
        ++f.pixels;
        f.sum += z.value();
        f.worst = std::max(f.worst, std::abs(z.value() - patch.depth(x, y)));
      });
  return f;
}

/// The lecture: dz = -(a / c) dx along a row, and -(b / c) dy from row to row.
Filling by_increments(const Patch& patch) {
  Filling f;
  const Real a{patch.a, &f.operations}, b{patch.b, &f.operations}, c{patch.c, &f.operations}, zero{0, &f.operations};
  const Real by_pixel = (zero - a) / c, by_row = (zero - b) / c;
  Real left = (zero - zero.constant(patch.d)) / c, z = left;
  scan(
      patch,
      [&](int y) {
        if (y > 0) left = left + by_row;
        z = left;
      },
      [&](int x, int y) {
        if (x > 0) z = z + by_pixel;
        ++f.pixels;
        f.sum += z.value();
        f.worst = std::max(f.worst, std::abs(z.value() - patch.depth(x, y)));
      });
  return f;
}

/// The lecture, for non-planar faces: interpolates along two sides, then along the row between them.
Filling by_interpolation(const Patch& patch) {
  Filling f;
  const double n = patch.size;
  const Real z1{patch.depth(0, 0), &f.operations}, z2{patch.depth(n, 0), &f.operations},
      z3{patch.depth(0, n), &f.operations};
  Real za = z1, zb = z1, z = z1, xb = z1;
  scan(
      patch,
      [&](int y) {
        const Real share = z1.constant(n - y) / z1.constant(n);
        za = z3 - (z3 - z1) * share;
        zb = z3 - (z3 - z2) * share;
        xb = z1.constant(n - y);
      },
      [&](int x, int y) {
        z = zb - (zb - za) * (xb - xb.constant(x)) / xb;
        ++f.pixels;
        f.sum += z.value();
        f.worst = std::max(f.worst, std::abs(z.value() - patch.depth(x, y)));
      });
  return f;
}

}  // namespace

Result study_depth_increments(const StudyRequest& request) {
  const Patch patch{request.pick(16.0, 512.0)};
  struct Way {
    const char *name, *source;
    Filling (*fill)(const Patch&);
  };
  constexpr Way kWays[] = {{"the plane's equation", "z = (-d - a x - b y) / c", by_equation},
                           {"increments", "dz = -(a/c) dx - (b/c) dy: one sum", by_increments},
                           {"interpolated", "three formulas of two sums, a product, a quotient", by_interpolation}};
  Table table{"Depth of the pixels of a triangle of " + std::to_string(int(patch.size)) + " rows, operations for each pixel",
              {{"way", ColumnKind::label},
               {"lecture", ColumnKind::source},
               {"pixels", ColumnKind::count},
               {"sums", ColumnKind::measure},
               {"products", ColumnKind::measure},
               {"quotients", ColumnKind::measure},
               {"farthest from the plane", ColumnKind::measure}}};
  double sums_of_increments = 0;
  for (const Way& way : kWays) {
    const Filling f = way.fill(patch);
    const double n = double(f.pixels);
    if (way.fill == by_increments) sums_of_increments = double(f.operations.sums() + f.operations.products) / n;
    table.rows.push_back({way.name, way.source, f.pixels, double(f.operations.sums()) / n, double(f.operations.products) / n,
                          double(f.operations.quotients) / n, f.worst});
  }
  Table bits{"The exercise: a buffer of 16 bits and an object at 500 m, distance of a second one",
             {{"depths", ColumnKind::label}, {"lecture", ColumnKind::source}, {"m", ColumnKind::measure}}};
  constexpr double kSteps = 65535, kFar = 500;
  bits.rows.push_back({"parallel, from the eye", "asked, not answered", kFar / kSteps});
  for (const double near : {0.5, 5.0}) {
    char name[64];
    std::snprintf(name, sizeof name, "perspective, near plane at %g m", near);
    bits.rows.push_back({name, "asked, not answered", kFar * (kFar - near) / (kSteps * near)});
  }
  Result result{.tables = {std::move(table), std::move(bits)},
                .finding = sums_of_increments < 1.5 ? Finding::holds : Finding::no_longer};
  result.sentence =
      "One sum a pixel instead of two products, two sums and a quotient, and the roundings of a whole row stay far below a step of "
      "any buffer; method zbuffer fills that way.";
  return result;
}

Result study_tree_complexity(const StudyRequest& request) {
  Table table{"Display trees",
              {{"scene", ColumnKind::label},
               {"Huet", ColumnKind::source},
               {"triangles", ColumnKind::count},
               {"convex sets", ColumnKind::count},
               {"complexity", ColumnKind::count},
               {"splits", ColumnKind::count},
               {"splits of a bsp tree", ColumnKind::count},
               {"nodes of a bsp tree", ColumnKind::count}}};
  struct Row {
    std::string name, source;
    Scene scene;
    bool zero = false;  ///< true if the source states zero
  };
  const int steps = request.pick(10, 100), rows = request.pick(8, 40), blocks = request.pick(2, 10),
            boxes = request.pick(3, 30);
  std::vector<Row> list;
  list.push_back({"a ball, " + std::to_string(rows) + " rows", "convex: 0", ball(rows), true});
  list.push_back({"a stair of " + std::to_string(steps) + " steps", "0, n nodes of type 1", stair(steps), true});
  list.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", "no figure", city(blocks)});
  list.push_back({std::to_string(boxes) + " boxes that penetrate", "no figure", penetrating_boxes(boxes)});
  bool zero = true;
  for (Row& row : list) {
    finish(row.scene);
    // Compiles as Huet does, with planes of faces only.
    const ConvexTree::Counts counts = ConvexTree(row.scene, {5, false}).counts();
    const BspTree bsp(row.scene, {});
    if (row.zero) zero = zero && counts.planes == 0;
    table.rows.push_back({row.name, row.source, counts.triangles, counts.convex_sets, counts.planes, counts.splits,
                          std::uint64_t{bsp.counts().splits}, std::uint64_t{bsp.counts().nodes}});
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = zero ? Finding::holds : Finding::no_longer;
  result.sentence =
      "Convex bodies and the stair have complexity 0, as proved; scenes of many bodies do not, but their trees have far fewer planes "
      "than a bsp tree has nodes.";
  return result;
}

}  // namespace ligne::studies
