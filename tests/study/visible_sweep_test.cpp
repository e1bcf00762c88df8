// The sweep for the visible pieces of coplanar segments and arcs, against known answers and against two other ways.

#include "studies/operations/visible_sweep.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

using Curves = std::vector<PlaneCurve>;
using Kind = PlaneCurve::Kind;

std::vector<VisiblePiece> swept(const Curves& curves) {
  VisibleWork work;
  return visible_by_sweep(curves, work);
}

PlaneCurve opaque(LatticePoint a, LatticePoint b) { return PlaneCurve::segment(a, b); }
PlaneCurve glass(LatticePoint a, LatticePoint b) { return PlaneCurve::segment(a, b, true); }

/// By curve and level.
VisiblePiece piece(std::uint32_t curve, std::uint32_t level, OneRoot from, OneRoot to) { return {curve, level, from, to}; }

using Pieces = std::vector<VisiblePiece>;

// Behind two panes stands a wall; a bar between the panes hides all behind it.
TEST(VisibleSweep, PanesAreCounted) {
  const Curves curves{glass({0, 1}, {8, 1}), glass({4, 3}, {12, 3}), opaque({0, 9}, {12, 9}), opaque({6, 2}, {7, 2})};
  EXPECT_EQ(swept(curves),
            (Pieces{piece(0, 0, 0, 8), piece(1, 1, 4, 6), piece(1, 1, 7, 8), piece(1, 0, 8, 12), piece(2, 1, 0, 4),
                    piece(2, 2, 4, 6), piece(2, 2, 7, 8), piece(2, 1, 8, 12), piece(3, 1, 6, 7)}));
}

// Two circles of radius 5 whose centres are 6 apart meet 3 from either, and then the other is nearer; an irrational crossing
// with a slanted line.
TEST(VisibleSweep, ArcsMeetArcs) {
  Curves curves = circle({5, 5}, 5);
  for (const PlaneCurve& half : circle({11, 5}, 5)) curves.push_back(half);
  EXPECT_EQ(swept(curves), (Pieces{piece(0, 0, 0, 8), piece(2, 0, 8, 16)}));
  // x^2 + x^2 = 50 has the root 5; with the radius 6 it is sqrt(18).
  const Curves line{PlaneCurve::arc(Kind::far_arc, {0, 0}, 6, {0, 6}), opaque({0, 0}, {6, 6})};
  const OneRoot root(Int128(0), 1, 18, 1);
  EXPECT_EQ(swept(line), (Pieces{piece(0, 0, root, 6), piece(1, 0, 0, root)}));
}

TEST(VisibleSweep, SegmentsAlongTheViewHideNothing) {
  EXPECT_EQ(swept({opaque({5, 0}, {5, 9}), opaque({0, 4}, {9, 4}), opaque({0, 0}, {0, 8})}), (Pieces{piece(1, 0, 0, 9)}));
}

/// Depths in floating point, independent of the exact meetings.
long double depth_at(const PlaneCurve& c, long double x) {
  if (!c.is_arc()) return c.z_left + (x - c.left) * (static_cast<long double>(c.z_right) - c.z_left) / (c.right - c.left);
  const long double chord = std::sqrt(std::max(0.0L, c.radius_square - (x - c.x_middle) * (x - c.x_middle)));
  return c.z_middle + (c.kind == Kind::far_arc ? chord : -chord);
}

/// Checks the pieces at an abscissa where no two curves are close unless they coincide. Returns false if some are close.
bool check_at(const Curves& curves, const Pieces& pieces, long double x) {
  constexpr long double kClose = 1e-7L, kEqual = 1e-12L;
  std::vector<std::uint32_t> over;
  for (std::uint32_t i = 0; i < curves.size(); ++i)
    if (curves[i].left < x && x < curves[i].right) over.push_back(i);
  std::ranges::sort(over, [&](std::uint32_t a, std::uint32_t b) {
    const long double p = depth_at(curves[a], x), q = depth_at(curves[b], x);
    return std::abs(p - q) < kEqual ? a < b : p < q;
  });
  for (std::size_t i = 1; i < over.size(); ++i) {
    const long double gap = depth_at(curves[over[i]], x) - depth_at(curves[over[i - 1]], x);
    if (gap < kClose && gap >= kEqual) return false;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, found;
  for (std::uint32_t level = 0; level < over.size(); ++level) {
    expected.emplace_back(over[level], level);
    if (!curves[over[level]].is_transparent) break;
  }
  for (const VisiblePiece& p : pieces)
    if (p.from.value() < x && x < p.to.value()) found.emplace_back(p.curve, p.level);
  std::ranges::sort(expected);
  std::ranges::sort(found);
  EXPECT_EQ(found, expected) << static_cast<double>(x);
  return true;
}

/// Curves with ends and middles on a grid of `size` steps: the smaller it is, the more coincide, touch and meet in one
/// point.
Curves random_curves(std::mt19937& random, int count, int size, bool with_arcs) {
  const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  Curves curves;
  while (static_cast<int>(curves.size()) < count) {
    const bool is_glass = whole(0, 2) == 0;
    if (!with_arcs || whole(0, 1)) {
      const LatticePoint a{whole(0, size), whole(0, size)}, b{whole(0, size), whole(0, size)};
      if (!(a == b)) curves.push_back(PlaneCurve::segment(a, b, is_glass));
      continue;
    }
    const LatticePoint middle{whole(0, size), whole(0, size)};
    const int radius = whole(1, size), begin = middle.x - whole(-radius, radius), end = middle.x + radius;
    curves.push_back(PlaneCurve::arc(whole(0, 1) ? Kind::near_arc : Kind::far_arc, middle, radius,
                                     {begin, whole(std::min(begin, end), end)}, is_glass));
  }
  return curves;
}

TEST(VisibleSweep, IsWhatAllPairsGive) {
  std::mt19937 random(17);
  int checked = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    const int size = std::array{3, 6, 20, 300, 4096}[static_cast<std::size_t>(round) % 5];
    const Curves curves = random_curves(random, 2 + round % 23, size, round % 2 == 1);
    const Pieces pieces = swept(curves);
    ASSERT_TRUE(pieces == visible_by_pairs(curves));
    for (const VisiblePiece& p : pieces) EXPECT_TRUE(p.from < p.to);
    for (int i = 0; i < 40; ++i)
      checked += check_at(curves, pieces, std::uniform_real_distribution<double>(-size, 2.0 * size)(random));
  }
  EXPECT_GT(checked, 15000);
}

// The tree is asked in proportion to (n + k) log n: here about 16 segments lie over each abscissa, whatever n.
TEST(VisibleSweep, TakesNLogN) {
  const auto work_of = [](int n) {
    Curves curves;
    for (int i = 0; i < n; ++i) {
      const int x = (i * 37) % 3900, z = (i * 101) % 3900;
      curves.push_back(PlaneCurve::segment({x, z}, {x + 64'000 / n, z + 1}, i % 2 == 0));
    }
    VisibleWork work;
    visible_by_sweep(curves, work);
    return work;
  };
  const VisibleWork small = work_of(500), large = work_of(4000);
  EXPECT_LT(large.comparisons, 8 * 1.6 * double(small.comparisons));
  EXPECT_LT(large.pairs, 12 * small.pairs);
}

// Many curves of one carrier, each with its own ends, are one run: a stop asks about it once.
TEST(VisibleSweep, ACrowdOfCoincidentCurvesTakesNLogN) {
  const auto work_of = [](int n) {
    Curves curves;
    for (int i = 0; i < n; ++i)
      curves.push_back(PlaneCurve::segment({i % 1000, i % 1000}, {3000 + i % 997, 3000 + i % 997}, i % 3 == 0));
    for (int i = 0; i < n; ++i)
      curves.push_back(PlaneCurve::arc(Kind::far_arc, {2000, 0}, 2000, {i % 1000, 3999 - i % 991}, i % 2 == 0));
    VisibleWork work;
    const Pieces pieces = visible_by_sweep(curves, work);
    if (n <= 100) {
      EXPECT_TRUE(pieces == visible_by_pairs(curves));
    }
    return work;
  };
  const VisibleWork small = work_of(100), large = work_of(4000);
  EXPECT_LE(large.pairs, small.pairs);
  EXPECT_LT(large.comparisons, 4u * 2 * 4000);
}

TEST(OneRoot, OrderIsExact) {
  // sqrt(2) + 1 against 1 / (sqrt(2) - 1), which is the same number, and against neighbours.
  const OneRoot a(Int128(1), 1, 2, 1);
  EXPECT_EQ(OneRoot::compare(a, OneRoot(Int128(-1), -1, 2, -1)), 0);
  EXPECT_EQ(OneRoot::compare(OneRoot(Int128(3), 1, 18, 3), a), 0);
  // Continued fraction of sqrt(2): 665857 / 470832 is 1.6e-12 above it.
  EXPECT_LT(OneRoot(Int128(0), 1, 2, 1), OneRoot(Int128(665857), 0, 0, 470832));
  EXPECT_LT(OneRoot(Int128(275807), 0, 0, 195025), OneRoot(Int128(0), 1, 2, 1));
  EXPECT_TRUE(OneRoot(Int128(6), -1, 16, 2) == OneRoot(std::int64_t{1}));
  const Int128 big = Int128(1) << 41;
  EXPECT_LT(OneRoot(big, 1, big * big - 1, 1), OneRoot(2 * big, 0, 0, 1));
}

}  // namespace
}  // namespace ligne::studies
