// Iso-curves against a plain search: every segment against every nearer one, with nothing remembered, in long double.

#include "visibility/horizon/horizon.hpp"
#include "height_functions.hpp"
#include "main/tier.hpp"

namespace ligne::test {
namespace {

FunctionHeights heights(const Function& f, std::size_t n, double half = 1) {
  return {f, positions(n, half), positions(n, half)};
}

struct Drawn {
  Polylines lines;
  View view;
  double length() const { return length_of(lines); }
};

Drawn drawn(const HeightSource& source, const CameraRequest& request, HorizonOptions options = {}) {
  const View view = view_of(source, request, options.z_scale);
  Statistics statistics;
  return {horizon_lines(source, view, options, statistics).curves, view};
}

HorizonOptions by_curves() {
  HorizonOptions options;
  options.hidden_by = HiddenBy::curves;
  return options;
}

CameraRequest from(const Point3& eye, const Point3& target = {0, 0, 0}) { return from_eye(eye, target, 100); }

using Real = long double;

struct Seen {
  Real u, v, w;
};

struct CurvePiece {
  Seen a, b;
  Point3 from, to;
  Real at(Real u) const { return a.v + (b.v - a.v) * (u - a.u) / (b.u - a.u); }
  Real left() const { return std::min(a.u, b.u); }
  Real right() const { return std::max(a.u, b.u); }
};

/// Visible length on the page, for a viewer towards whom x and y descend (parallel: direction with both positive;
/// perspective: an eye before the corner of the smallest x and y), with a drawing plane of the test's own: at right angles
/// to the x axis' and y axis' bisector.
double brute_force(const HeightSource& source, const Drawn& picture) {
  const std::size_t nx = source.x().size(), ny = source.y().size();
  const Camera& camera = picture.view.camera;
  std::vector<CurvePiece> nearer;
  double sum = 0;
  std::vector<double> before(nx), row(nx);
  const auto seen = [&](const Point3& p) -> Seen {
    if (!camera.perspective) {
      const Real fx = camera.forward.x, fy = camera.forward.y, fz = camera.forward.z, level = std::hypot(fx, fy);
      return {(p.x * fy - p.y * fx) / level, p.z * level - fz * (p.x * fx + p.y * fy) / level, 1};
    }
    const Real x = Real(p.x) - camera.eye.x, y = Real(p.y) - camera.eye.y, z = Real(p.z) - camera.eye.z;
    return {(x - y) / (x + y), z / (x + y), x + y};
  };
  const auto page = [&](const Point3& p) { return page_point(picture.view, p); };
  const auto take = [&](const Point3& p, const Point3& q) {
    CurvePiece piece{seen(p), seen(q), p, q};
    std::vector<Real> cuts{piece.left(), piece.right()};
    for (const CurvePiece& n : nearer) {
      const Real l = std::max(n.left(), piece.left()), r = std::min(n.right(), piece.right());
      if (l >= r) continue;
      const Real dl = piece.at(l) - n.at(l), dr = piece.at(r) - n.at(r);
      cuts.insert(cuts.end(), {l, r});
      if ((dl < 0) != (dr < 0)) cuts.push_back(l + (r - l) * dl / (dl - dr));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const Real u = (cuts[k - 1] + cuts[k]) / 2, v = piece.at(u);
      Real highest = -std::numeric_limits<Real>::infinity(), lowest = -highest;
      for (const CurvePiece& n : nearer) {
        if (!(n.left() < u && u < n.right())) continue;
        highest = std::max(highest, n.at(u));
        lowest = std::min(lowest, n.at(u));
      }
      if (v <= highest && v >= lowest) continue;
      const auto in_space = [&](Real cut) {
        const Real s = (cut - piece.a.u) / (piece.b.u - piece.a.u);
        const double t = static_cast<double>(s * piece.a.w / ((1 - s) * piece.b.w + s * piece.a.w));
        return page(p + (q - p) * t);
      };
      const Point2 c = in_space(cuts[k - 1]), d = in_space(cuts[k]);
      sum += std::hypot(d.x - c.x, d.y - c.y);
    }
    nearer.push_back(piece);
  };
  for (std::size_t j = 0; j < ny; ++j) {
    source.read_row(j, row);
    const auto point = [&](std::size_t i, std::size_t k, double z) { return Point3{source.x()[i], source.y()[k], z}; };
    if (j > 0)
      for (std::size_t i = 0; i < nx; ++i) take(point(i, j - 1, before[i]), point(i, j, row[i]));
    for (std::size_t i = 1; i < nx; ++i) take(point(i - 1, j, row[i - 1]), point(i, j, row[i]));
    before = row;
  }
  return sum;
}

double ridges(double x, double y) { return 0.4 * std::abs(std::fmod(7 * x + 3 * y + 20, 2) - 1); }

TEST(Horizon, IsWhatAllPairsSay) {
  for (const Function& f : {Function(waves), Function(sombrero), Function(ridges)}) {
    const FunctionHeights source = heights(f, 21);
    for (const Point3& direction :
         chosen("all pairs", 2, {Point3{1, 0.7, -0.5}, Point3{0.3, 1, -0.2}, Point3{1, 0.2, 0.4}, Point3{0.6, 0.8, -3}})) {
      const Drawn picture = drawn(source, along(direction), by_curves());
      EXPECT_NEAR(picture.length(), brute_force(source, picture), 0.01) << direction.x;
    }
    for (const Point3& eye : chosen("all pairs", 2, {Point3{-3, -2.5, 2}, Point3{-1.2, -1.4, 0.6}})) {
      const Drawn picture = drawn(source, from(eye), by_curves());
      EXPECT_NEAR(picture.length(), brute_force(source, picture), 0.01) << "eye " << eye.x;
    }
  }
}

TEST(Horizon, SidesAreAlike) {
  // One surface turned by quarters, seen from directions turned with it.
  const double full = drawn(heights(waves, 25), along({1, 0.7, -0.5})).length();
  const double full_by_curves = drawn(heights(waves, 25), along({1, 0.7, -0.5}), by_curves()).length();
  const auto turned = [](double x, double y) { return waves(y, -x); };  // a quarter: the cells' diagonals are others
  EXPECT_NEAR(drawn(heights(turned, 25), along({-0.7, 1, -0.5}), by_curves()).length(), full_by_curves, 1e-3);
  const auto half = [](double x, double y) { return waves(-x, -y); };
  EXPECT_NEAR(drawn(heights(half, 25), along({-1, -0.7, -0.5})).length(), full, 1e-3);
}

TEST(Horizon, TheEyeOverTheGroundSeesAllOfAFlatOne) {
  const FunctionHeights source = heights([](double, double) { return 0.0; }, 11);
  const auto whole = [&](const Point3& eye) {
    Drawn picture = drawn(source, from(eye, {eye.x, eye.y, 0}));
    double expected = 0;
    const auto page = [&](double x, double y) { return page_point(picture.view, {x, y, 0}); };
    for (const double at : source.x())
      for (const auto& [p, q] : {std::pair(page(at, -1), page(at, 1)), std::pair(page(-1, at), page(1, at))})
        expected += std::hypot(q.x - p.x, q.y - p.y);
    EXPECT_NEAR(picture.length(), expected, 1e-3) << eye.x << "," << eye.y;
  };
  whole({0.13, -0.27, 4});  // between curves
  whole({0.2, -0.4, 4});    // over a crossing of two curves
  whole({0.13, -1.5, 5});   // over no part of the ground, beside it in y alone
}

TEST(Horizon, PixelsTendToExact) {
  const FunctionHeights source = heights(sombrero, 41);
  const double exact = drawn(source, along({1, 0.7, -0.5})).length();
  double before = 1e300;
  for (const std::size_t resolution : {200, 2000, 20'000}) {
    HorizonOptions options;
    options.resolution = resolution;
    const double off = std::abs(drawn(source, along({1, 0.7, -0.5}), options).length() - exact);
    EXPECT_LT(off, before) << resolution;
    before = off;
  }
  EXPECT_LT(before, 0.005 * exact);
}

// Surface seen between distant curves, which hides nothing there, makes coarse grids a little longer: 0.6 % here.
TEST(Horizon, NoSurfaceIsLostWhereCurvesAreDense) {
  const auto wide = [](double x, double y) { return sombrero(x * 2 / 3, y * 2 / 3); };  // sin(r)/r up to 8
  const auto length_by_curve = [&](std::size_t n) {
    return drawn(heights(wide, n), along({1, 0.7, -0.5})).length() / (2 * n);
  };
  EXPECT_NEAR(length_by_curve(400) / length_by_curve(100), 1, 0.01);
}

TEST(Horizon, IsTheSameForAnyNumberOfThreads) {
  const Function hills = [](double x, double y) { return std::sin(3 * x) * std::cos(4 * y) + 0.2 * x; };
  const Function pierced = [&](double x, double y) { return std::hypot(x, y) < 0.8 ? kNaN : hills(x, y); };
  // Along an axis every column is an upright line, and the lines that two bands meet at are among them.
  for (const Point3& sight : {Point3{1, 2, -1}, Point3{0, 1, -0.5}, Point3{-1, 0.01, -0.2}})
    for (const Function& f : {hills, pierced}) {
      const FunctionHeights source = heights(f, 120, 2);
      std::vector<Polylines> lines;
      for (const unsigned threads : {1u, 2u, 7u})
        run_with_threads(threads, [&] { lines.push_back(drawn(source, along(sight)).lines); });
      ASSERT_GT(lines[0].points.size(), 1000u);
      for (const Polylines& other : lines) {
        EXPECT_EQ(other.begin, lines[0].begin);
        EXPECT_EQ(other.points, lines[0].points);
      }
    }
}

TEST(Horizon, FewLongRowsSpanFewColumns) {
  EXPECT_EQ(horizon::column_count(400, 0.5, 300, -1), 700u);
  EXPECT_EQ(horizon::column_count(2, 0, 65'000, 1), 65'002u);
  EXPECT_LT(horizon::column_count(2, 0.8, 65'000, -0.2), 200u);
}

TEST(Horizon, HolesEndCurves) {
  const auto with_hole = [](double x, double y) { return std::abs(x) < 0.25 && std::abs(y) < 0.25 ? kNaN : 0.0; };
  const FunctionHeights source = heights(with_hole, 9);  // in steps of a quarter; the hole is the sample in the middle
  const Drawn picture = drawn(source, along({0, 0, -1}));
  EXPECT_EQ(picture.lines.size(), 20u);
  EXPECT_NEAR(picture.length(), 18 * 190 - 4 * 190 / 8.0, 1e-6);
}

TEST(Horizon, NothingToSee) {
  EXPECT_EQ(drawn(heights([](double, double) { return kNaN; }, 5), along({1, 1, -1})).lines.size(), 0u);
}

}  // namespace
}  // namespace ligne::test
