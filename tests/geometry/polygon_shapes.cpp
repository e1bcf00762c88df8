#include "polygon_shapes.hpp"

#include "support/standard.hpp"

namespace ligne::shapes {
namespace {

/// There along one side of a band and back along the other.
Polygon band(Contour there, const Contour& back) {
  there.insert(there.end(), back.rbegin(), back.rend());
  return {there};
}

Point2 polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

Polygon star(int n) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> radius(50, 1000);
  Contour c;
  for (int i = 0; i < n; ++i) c.push_back(polar(radius(random), 2 * std::numbers::pi * i / n));
  return {c};
}

Polygon comb(int n) {
  const int teeth = n / 2;
  Contour c{{0, -1}, {2.0 * teeth, -1}};
  for (int i = teeth; i-- > 0;) c.insert(c.end(), {{2.0 * i + 2, double(teeth)}, {2.0 * i + 1, 0}});
  c.emplace_back(0, teeth);
  return {c};
}

Polygon lying(Polygon polygon) {
  for (Point2& p : polygon[0]) p = {p.y, -p.x};
  return polygon;
}

Contour round_spiral(int n, double begin) {
  Contour c;
  for (int i = 0; i < n; ++i) c.push_back(polar(begin + 0.05 * i, 2 * std::numbers::pi * (i % 128) / 128));
  return c;
}

Contour right_angled_spiral(int n, double width) {
  Contour c;
  for (int i = 0; i < n; ++i) {
    const double t = i / 4 + 1 + width;
    const Point2 corner[] = {{t, 1 - t}, {t, t}, {-t, t}, {-t, -t}};
    c.push_back(corner[i % 4]);
  }
  return c;
}

/// Two rows of teeth; `gap` lies between their tips.
Polygon teeth(int n, double gap) {
  const int count = n / 4;
  Contour c;
  for (int i = 0; i < count; ++i) c.insert(c.end(), {{2.0 * i, -double(count)}, {2.0 * i + 1, -gap / 2}});
  c.insert(c.end(), {{2.0 * count, -double(count)}, {2.0 * count, double(count)}});
  for (int i = count; i-- > 0;) c.insert(c.end(), {{2.0 * i + 1, gap / 2}, {2.0 * i, double(count)}});
  return {c};
}

/// The closed space-filling curve of Moore.
Contour moore_curve(int n) {
  int order = 1;
  while (4 << (2 * order) <= n) ++order;
  Contour c;
  Point2 at{0, 0}, ahead{0, 1};
  // The L-system LFL+F+LFL, L -> -RF+LFL+FR-, R -> +LF-RFR-FL+.
  const auto turn = [&](int sign) { ahead = {-sign * ahead.y, sign * ahead.x}; };
  const auto forward = [&] {
    c.push_back(at);
    at = at + ahead;
  };
  const auto curve = [&](const auto& self, int sign, int depth) -> void {
    if (depth == 0) return;
    turn(sign);
    self(self, -sign, depth - 1);
    forward();
    turn(-sign);
    self(self, sign, depth - 1);
    forward();
    self(self, sign, depth - 1);
    turn(-sign);
    forward();
    self(self, -sign, depth - 1);
    turn(sign);
  };
  const int depth = order - 1;
  for (int half = 0; half < 2; ++half) {
    curve(curve, 1, depth);
    forward();
    curve(curve, 1, depth);
    turn(-1);
    forward();
    if (half == 0) turn(-1);
  }
  return c;
}

/// The corners of the space-filling curve up to `most` beside their places.
Polygon jittered_curve(int n, double most) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> jitter(-most, most);
  Polygon polygon{moore_curve(n)};
  for (Point2& p : polygon[0]) p += Point2{jitter(random), jitter(random)};
  return polygon;
}

Polygon grid_of_holes(int n, double hole_size) {
  const int side = static_cast<int>(std::sqrt(n / 4.0));
  Polygon polygon{rectangle(0, 0, 2 * side + 1, 2 * side + 1)};
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double x = 2 * i + 1, y = 2 * k + 1;
      polygon.push_back(rectangle(x, y, x + hole_size, y + hole_size));
    }
  return polygon;
}

/// A diagonal of holes, corner to corner.
Polygon chain_of_holes(int n) {
  const int count = n / 4;
  Polygon polygon{rectangle(0, 0, count + 2, count + 2)};
  for (int i = 1; i <= count; ++i) polygon.push_back(rectangle(i, i, i + 1, i + 1));
  return polygon;
}

/// A row of squares, corner to corner, that is one contour.
Polygon beads(int n) {
  const int count = n / 4;
  Contour there, back;
  for (int i = 0; i < count; ++i) {
    there.insert(there.end(), {{2.0 * i, 0}, {2.0 * i + 1, -1}});
    back.insert(back.end(), {{2.0 * i, 0}, {2.0 * i + 1, 1}});
  }
  there.emplace_back(2.0 * count, 0);
  return band(there, back);
}

/// All corners but two of each petal in one point.
Polygon petals(int n) {
  const int count = n / 3;
  Contour c;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count, width = 3.0 / count;
    c.insert(c.end(), {{0, 0}, polar(1000, angle), polar(1000, angle + width)});
  }
  return {c};
}

/// The lower side runs the whole way to and fro between all of its corners.
Polygon long_folds(int n) {
  const int count = n / 2;
  Contour c;
  for (int i = 0; i < count; ++i) c.insert(c.end(), {{double(i), 0}, {2.0 * count - i, 0}});
  c.insert(c.end(), {{double(count), 5}, {0, 10}});
  return {c};
}

Polygon random_points(int n) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> at(0, 1000);
  Contour c;
  for (int i = 0; i < n; ++i) c.emplace_back(at(random), at(random));
  return {c};
}

/// The outer contour taken twice.
Polygon twice_round(int n) {
  Contour c = star(n / 2)[0];
  const Contour once = c;
  c.insert(c.end(), once.begin(), once.end());
  return {c};
}

}  // namespace

const std::vector<Shape>& all_shapes() {
  static const std::vector<Shape> shapes{
      {"star", true, star},
      {"comb", true, comb},
      {"lying_comb", true, [](int n) { return lying(comb(n)); }},
      {"spiral", true, [](int n) { return band(round_spiral(n / 2, 10), round_spiral(n / 2, 8)); }},
      // All corners on common horizontal and vertical lines, all sides long.
      {"square_spiral", true, [](int n) { return band(right_angled_spiral(n / 2, 0), right_angled_spiral(n / 2, 0.25)); }},
      {"saw_teeth", true, [](int n) { return teeth(n, 1e-9); }},
      {"teeth_that_touch", true, [](int n) { return teeth(n, 0); }},
      {"space_filling", true, [](int n) { return Polygon{moore_curve(n)}; }},
      {"random_simple", true, [](int n) { return jittered_curve(n, 0.3); }},
      {"holes", true, [](int n) { return grid_of_holes(n, 1); }},
      {"chain_of_holes", true, chain_of_holes},
      {"beads", true, beads},
      {"petals", true, petals},
      {"long_folds", true, long_folds},
      {"teeth_that_cross", false, [](int n) { return teeth(n, -1); }},
      {"holes_that_cross", false, [](int n) { return grid_of_holes(n, 2.25); }},
      // Its corners leave their cells.
      {"tangled", false, [](int n) { return jittered_curve(n, 0.6); }},
      {"twice_round", false, twice_round},
      {"random_points", false, random_points}};
  return shapes;
}

}  // namespace ligne::shapes
