#include "geometry/lattice.hpp"

#include <atomic>
#include <chrono>

#include "base/stop.hpp"
#include "geometry/connected_boxes.hpp"
#include "geometry/degrees.hpp"
#include "geometry/predicates.hpp"
#include "geometry/small_matrices.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

Rect rect(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

TEST(Lattice, StepIsAPowerOfTwoAndTheFinestThatFits) {
  for (const Rect& page : {rect(0, 0, 297, 210), rect(0, 0, 1189, 841), rect(0, 0, 1, 1e-3), rect(-5e3, 2, 7e4, 3)}) {
    const Lattice lattice = Lattice::covering(page);
    int exponent = 0;
    EXPECT_EQ(std::frexp(lattice.step_mm, &exponent), 0.5);
    const double half = std::max(page.width(), page.height()) / 2;
    EXPECT_LE(half / lattice.step_mm, kLatticeLimit);
    EXPECT_GT(half / (lattice.step_mm / 2), kLatticeLimit - 2);
  }
}

TEST(Lattice, IsFarBelowAMicrometreUpToA0) {
  EXPECT_LE(Lattice::covering(rect(0, 0, 297, 210)).step_mm, 8e-6);
  EXPECT_LE(Lattice::covering(rect(0, 0, 1189, 841)).step_mm, 4e-5);
}

TEST(Lattice, CornersStayInsideTheLimitAndComeBack) {
  const Rect page = rect(-3.7, 12.1, 1185.3, 853.1);
  const Lattice lattice = Lattice::covering(page);
  for (const Point2 p : {page.min, page.max, Point2(page.min.x, page.max.y), Point2(page.max.x, page.min.y)}) {
    const LatticePoint q = lattice.snap(p);
    EXPECT_LT(std::abs(q.x), kLatticeLimit);
    EXPECT_LT(std::abs(q.y), kLatticeLimit);
    EXPECT_LE(std::abs(lattice.to_mm(q).x - p.x), lattice.step_mm / 2);
    EXPECT_LE(std::abs(lattice.to_mm(q).y - p.y), lattice.step_mm / 2);
  }
}

TEST(Lattice, SnappingALatticePointChangesNothing) {
  const Lattice lattice = Lattice::covering(rect(0, 0, 297, 210));
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> coordinate(-kLatticeLimit, kLatticeLimit);
  for (int i = 0; i < 1000; ++i) {
    const LatticePoint p{coordinate(random), coordinate(random)};
    EXPECT_EQ(lattice.snap(lattice.to_mm(p)), p);
  }
}

TEST(Lattice, PagesWithoutAreaAndFarPoints) {
  const Lattice line = Lattice::covering(rect(10, 5, 90, 5));
  EXPECT_EQ(line.to_mm(line.snap({10, 5})), Point2(10, 5));
  const Lattice point = Lattice::covering(rect(7, 7, 7, 7));
  EXPECT_NEAR(point.to_mm(point.snap({7, 7})).x, 7, 1e-9);
  EXPECT_EQ(Lattice::covering(Rect{}).step_mm, 1);
  EXPECT_EQ(Lattice::covering(rect(0, 0, 297, 210)).snap({1e30, -1e30}), (LatticePoint{kLatticeLimit, -kLatticeLimit}));
}

TEST(LatticeOrientation, IdentitiesAndExactnessAtTheLimit) {
  std::mt19937 random(4);
  std::uniform_int_distribution<std::int32_t> coordinate(-kLatticeLimit, kLatticeLimit);
  for (int i = 0; i < 10000; ++i) {
    const auto draw = [&] { return LatticePoint{coordinate(random), coordinate(random)}; };
    const LatticePoint a = draw(), b = draw(), c = draw();
    const std::int64_t exact =
        (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    EXPECT_EQ(orientation(a, b, c), static_cast<double>(exact));
    EXPECT_EQ(orientation(a, b, c), orientation(b, c, a));
    EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c));
    EXPECT_EQ(orientation(a, a, c), 0);
  }
}

TEST(Degrees, WholeQuartersAreExact) {
  const double sines[] = {0, 1, 0, -1};
  for (int quarters = -9; quarters <= 9; ++quarters) {
    const SineCosine at = sine_cosine_degrees(90.0 * quarters);
    EXPECT_EQ(at.sine, sines[quarters & 3]) << quarters;
    EXPECT_EQ(at.cosine, sines[(quarters + 1) & 3]) << quarters;
  }
}

TEST(Degrees, OthersAreThoseOfRadians) {
  for (double degrees = -400; degrees <= 400; degrees += 7.3) {
    const SineCosine at = sine_cosine_degrees(degrees), opposite = sine_cosine_degrees(-degrees);
    EXPECT_NEAR(at.sine, std::sin(degrees * std::acos(-1.0) / 180), 1e-14) << degrees;
    EXPECT_NEAR(at.cosine, std::cos(degrees * std::acos(-1.0) / 180), 1e-14) << degrees;
    EXPECT_EQ(opposite.sine, -at.sine) << degrees;
    EXPECT_EQ(opposite.cosine, at.cosine) << degrees;
  }
  EXPECT_TRUE(std::isnan(sine_cosine_degrees(HUGE_VAL).sine) && std::isnan(sine_cosine_degrees(std::nan("")).cosine));
}

void expect_identities(Point2 a, Point2 b, Point2 c) {
  const int sign = orientation_sign(a, b, c);
  EXPECT_EQ(sign, orientation_sign(b, c, a));
  EXPECT_EQ(sign, orientation_sign(c, a, b));
  EXPECT_EQ(sign, -orientation_sign(b, a, c));
  EXPECT_EQ(sign, -orientation_sign(a, c, b));
  EXPECT_EQ(sign, -orientation_sign(c, b, a));
}

TEST(OrientationSign, IdentitiesOnNearlyCollinearPoints) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> step(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const auto near = [&](double v) { return v + step(random) * std::ldexp(1.0, -52); };
    expect_identities({near(0.5), near(0.5)}, {near(12), near(12)}, {near(24), near(24)});
  }
}

// Points (k + x u, k + y u) on a fine grid: the determinant is a whole number of steps and known without rounding.
TEST(OrientationSign, AgreesWithWholeNumberArithmetic) {
  std::mt19937_64 random(2);
  constexpr std::int64_t kSize = std::int64_t{1} << 52;
  std::uniform_int_distribution<std::int64_t> base(-kSize / 2, kSize / 2), nudge(-2, 2), factor(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t ax = base(random), ay = base(random), dx = base(random) / 2, dy = base(random) / 2;
    const std::int64_t bx = ax + dx, by = ay + dy;
    const std::int64_t f = factor(random);
    const std::int64_t cx = ax + f * dx + nudge(random), cy = ay + f * dy + nudge(random);
    const __int128 det = static_cast<__int128>(bx - ax) * (cy - ay) - static_cast<__int128>(by - ay) * (cx - ax);
    const auto point = [](std::int64_t x, std::int64_t y) { return Point2(double(x), double(y)); };
    const int sign = orientation_sign(point(ax, ay), point(bx, by), point(cx, cy));
    EXPECT_EQ(sign, det > 0 ? 1 : det < 0 ? -1 : 0);
  }
}

// Boxes that hang together, against the comparison of every pair.

DisjointSets by_pairs(const std::vector<AxisBox>& boxes) {
  DisjointSets sets(boxes.size());
  const auto has_inside = [](const AxisBox& b) { return b.x0 < b.x1 && b.y0 < b.y1; };
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t k = 0; k < i; ++k) {
      const AxisBox &a = boxes[i], &b = boxes[k];
      if (has_inside(a) && has_inside(b) && a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1) sets.join(i, k);
    }
  return sets;
}

TEST(ConnectedBoxes, AreThoseOfEveryPair) {
  std::mt19937 random(7);
  std::size_t sets_in_all = 0;
  for (int round = 0; round < 3000; ++round) {
    // Whole numbers, so that many borders coincide; from boxes that stand alone to one heap.
    const int n = static_cast<int>(random() % 41), side = 4 + static_cast<int>(random() % 60);
    std::vector<AxisBox> boxes;
    for (int i = 0; i < n; ++i) {
      const double x = random() % side, y = random() % side;
      boxes.push_back({x, y, x + random() % 7, y + random() % 7});
    }
    DisjointSets found = connect_boxes(boxes), expected = by_pairs(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      ASSERT_EQ(found.find(i), expected.find(i)) << "round " << round << ", box " << i;
      sets_in_all += found.find(i) == i;
    }
  }
  EXPECT_GT(sets_in_all, 3000u);
}

TEST(ConnectedBoxes, ACrowdCostsNoMoreThanOthers) {
  std::vector<AxisBox> boxes;
  constexpr int kBoxes = 200'000;
  for (int i = 0; i < kBoxes; ++i) boxes.push_back({1e-6 * i, 1e-6 * i, 1 + 1e-6 * i, 1 + 1e-6 * i});
  const auto start = std::chrono::steady_clock::now();
  DisjointSets sets = connect_boxes(boxes);
  // Two by two these are 2 10^10 pairs, which take minutes.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  for (std::uint32_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(sets.find(i), 0u);
}

// Work that is told to end does so in its loops, in all threads, and other work goes on.

constexpr std::size_t kMany = 1'000'000;

TEST(Stop, LoopsEndSoonAfterTheyAreTold) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> done = 0;
  const auto work = [&] {
    parallel_tasks(kMany, [&](std::size_t) {
      if (++done == 1000) stop = true;
    });
  };
  EXPECT_THROW(run_until(stop, work), Stopped);
  EXPECT_GE(done, 1000u);
  EXPECT_LT(done, kMany / 2);
}

TEST(Stop, LoopsInsideLoopsKnowIt) {
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> inner = 0;
  const auto work = [&] {
    parallel_tasks(1, [&](std::size_t) {
      stop = true;
      parallel_for(8, [&](std::size_t) { ++inner; });
    });
  };
  EXPECT_THROW(run_until(stop, work), Stopped);
  EXPECT_EQ(inner, 0u);
}

/// The exception of a task ends the loops of the tasks beside it, none of which may go on with half of its results.
TEST(Stop, LoopsBesideAnExceptionEndWithOneToo) {
  std::atomic<int> begun = 0, cut_short = 0;
  const auto work = [&](std::size_t task) {
    ++begun;
    // One thread does one task after the other.
    for (int tries = 0; begun < 2 && tries < 1000; ++tries) std::this_thread::sleep_for(std::chrono::microseconds(100));
    if (task == 0) throw std::runtime_error("first");
    for (int k = 0; k < 1000; ++k) {
      std::atomic<int> done = 0;
      parallel_for(64, [&](std::size_t) { ++done; });
      cut_short += done < 64;
    }
  };
  for (int run = 0; run < 20; ++run, begun = 0) EXPECT_THROW(parallel_tasks(2, work), std::runtime_error);
  EXPECT_EQ(cut_short, 0);
}

TEST(Stop, WorkThatIsToldBeforeDoesNotBeginAndSerialLoopsAsk) {
  std::atomic<bool> stop = true;
  EXPECT_THROW(run_until(stop, [] { FAIL(); }), Stopped);
  stop = false;
  EXPECT_THROW(run_until(stop, [&] { check_stop(), stop = true, check_stop(); }), Stopped);
  EXPECT_TRUE(stop);
}

TEST(Stop, OtherWorkGoesOn) {
  std::atomic<bool> stop = false, other_stop = true;
  std::atomic<std::size_t> done = 0;
  run_until(stop, [&] {
    EXPECT_THROW(run_until(other_stop, [] {}), Stopped);
    parallel_for(1000, [&](std::size_t) { ++done; });
    check_stop();
  });
  EXPECT_EQ(done, 1000u);
  // Outside nobody tells it to end.
  stop = true;
  check_stop();
  parallel_for(1000, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 2000u);
}

// Eigenvalues of 3 by 3 matrices, and systems of equations.

/// A symmetric matrix with these eigenvalues.
Matrix3 matrix_of(const std::array<double, 3>& values, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-1, 1);
  const Point3 x = glm::normalize(Point3(place(random), place(random), place(random)));
  const Point3 y = glm::normalize(glm::cross(x, Point3(place(random), place(random), place(random))));
  const std::array<Point3, 3> frame{x, y, glm::cross(x, y)};
  Matrix3 m{};
  for (std::size_t i = 0; i < 3; ++i) add_product(m, values[i] * frame[i], frame[i]);
  return m;
}

Point3 product(const Matrix3& m, const Point3& p) {
  Point3 sum(0.0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum[i] += m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] * p[j];
  return sum;
}

TEST(SmallMatrices, HaveTheirEigenvaluesAndVectors) {
  std::mt19937 random(1);
  for (const std::array<double, 3>& values :
       {std::array<double, 3>{1, 2, 3}, {0, 1e-6, 1}, {0, 0, 1}, {-2, -2, 5}, {1e-12, 1e-9, 1e-9}, {0, 0, 0}, {4, 4, 4}}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Matrix3 m = matrix_of(values, random);
      const Eigen3 e = symmetric_eigen(m);
      const double size = std::max(std::abs(values[0]), std::abs(values[2]));
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(e.values[i], values[i], 1e-14 * size);
        EXPECT_LE(glm::distance(product(m, e.vectors[i]), e.values[i] * e.vectors[i]), 1e-14 * size);
        for (std::size_t k = 0; k <= i; ++k) EXPECT_NEAR(glm::dot(e.vectors[i], e.vectors[k]), i == k, 1e-14);
      }
    }
  }
}

TEST(SmallMatrices, SolveSystemsOfFiveEquations) {
  constexpr std::size_t kSize = 5;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    std::array<std::array<double, kSize>, kSize> a{};
    std::array<double, kSize> solution{}, right{};
    for (std::size_t row = 0; row < 2 * kSize; ++row) {
      std::array<double, kSize> terms{};
      for (double& term : terms) term = place(random);
      for (std::size_t i = 0; i < kSize; ++i)
        for (std::size_t j = 0; j < kSize; ++j) a[i][j] += terms[i] * terms[j];
    }
    for (double& x : solution) x = place(random);
    for (std::size_t i = 0; i < kSize; ++i)
      for (std::size_t j = 0; j < kSize; ++j) right[i] += a[i][j] * solution[j];
    ASSERT_TRUE(solve_symmetric(a, right));
    for (std::size_t i = 0; i < kSize; ++i) EXPECT_NEAR(right[i], solution[i], 1e-12);
  }
}

TEST(SmallMatrices, ThatAreNotPositiveDefiniteAreNotSolved) {
  std::array<std::array<double, 2>, 2> singular{{{1, 0}, {2, 4}}}, negative{{{-1, 0}, {0, 1}}};
  std::array<double, 2> right{1, 2};
  EXPECT_FALSE(solve_symmetric(singular, right));
  EXPECT_FALSE(solve_symmetric(negative, right));
}

}  // namespace
}  // namespace ligne::test
