// The clip on faces at random. Faces made of quarter cells of a small grid have everything singular at once, and their
// common points can be counted; stars over the whole lattice try the arithmetic at its limits.

#include "clip_support.hpp"
#include "main/tier.hpp"

namespace ligne::test {
namespace {

constexpr int kSide = 4;  ///< cells by row

/// A set of quarter cells: each unit square is cut by both diagonals.
using Cells = std::array<bool, kSide * kSide * 4>;

/// An affine map of the grid, whose squares have side 2, to the lattice.
struct Placing {
  std::int32_t ax = 1, ay = 0, bx = 0, by = 1, x = 0, y = 0;
  LatticePoint operator()(int u, int v) const { return {x + ax * u + bx * v, y + ay * u + by * v}; }
  double determinant() const { return double(ax) * by - double(ay) * bx; }
};

std::array<LatticePoint, 3> quarter(const Placing& place, std::size_t i) {
  const int cell = static_cast<int>(i / 4), k = static_cast<int>(i % 4), u = 2 * (cell % kSide), v = 2 * (cell / kSide);
  constexpr int kU[] = {0, 2, 2, 0, 0}, kV[] = {0, 0, 2, 2, 0};
  return {place(u + kU[k], v + kV[k]), place(u + kU[k + 1], v + kV[k + 1]), place(u + 1, v + 1)};
}

/// The cells as faces; all corners on straight lines are kept, or none.
Faces faces_of(const Cells& cells, const Placing& place, bool straight) {
  std::vector<ContourEdge> edges;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i]) continue;
    const auto t = quarter(place, i);
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({{t[k], t[(k + 1) % 3]}, kSegmentBegin, kSegmentEnd, static_cast<std::uint32_t>(3 * i + k), false});
  }
  Faces faces = link_edges(std::move(edges));
  if (!straight) return faces;
  for (ContourFace& face : faces) {
    for (EdgeLoop& loop : face.contours) {
      EdgeLoop longer;
      for (const ContourEdge& e : loop) {
        if (!longer.empty() && cross(longer.back().segment, e.segment) == 0) {
          longer.back().segment.b = e.segment.b;
        } else {
          longer.push_back(e);
        }
      }
      if (longer.size() > 1 && cross(longer.back().segment, longer.front().segment) == 0) {
        longer.front().segment.a = longer.back().segment.a;
        longer.pop_back();
      }
      loop = std::move(longer);
    }
  }
  return faces;
}

Cells random_cells(std::mt19937& random) {
  Cells cells{};
  std::uniform_int_distribution<int> coin(0, 1), percent(0, 99), side(0, kSide - 1);
  const int mode = percent(random) % 4, dense = percent(random);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (mode == 0) cells[i] = percent(random) < dense;
    if (mode == 1 && i % 4 == 0) cells[i] = cells[i + 1] = cells[i + 2] = cells[i + 3] = percent(random) < dense;
    if (mode == 2 && i % 2 == 0) cells[i] = cells[i + 1] = percent(random) < dense;
  }
  if (mode == 3) {  // a frame
    const int x0 = side(random), x1 = side(random), y0 = side(random), y1 = side(random),
              hole = side(random) + kSide * side(random);
    for (int c = 0; c < kSide * kSide; ++c) {
      const int x = c % kSide, y = c / kSide;
      if (x < std::min(x0, x1) || x > std::max(x0, x1) || y < std::min(y0, y1) || y > std::max(y0, y1) || c == hole)
        continue;
      for (int k = 0; k < 4; ++k) cells[static_cast<std::size_t>(4 * c + k)] = c % 5 != 0 || coin(random) != 0;
    }
  }
  return cells;
}

Placing random_placing(std::mt19937& random, std::int32_t limit) {
  std::uniform_int_distribution<std::int32_t> u(-limit, limit);
  Placing place;
  do {
    place = {u(random), u(random), u(random), u(random), u(random), u(random)};
  } while (place.determinant() == 0);
  return place;
}

/// Twice the area of one quarter cell on the lattice.
double quarter_area(const Placing& place) { return 2 * std::abs(place.determinant()); }

void expect_cells(const Faces& faces, const Cells& cells, const Placing& place) {
  expect_well_formed(faces);
  const auto count = static_cast<double>(std::count(cells.begin(), cells.end(), true));
  EXPECT_EQ(twice_area(faces), count * quarter_area(place));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto t = quarter(place, i);
    const FinePoint a = fine(t[0]), b = fine(t[1]), c = fine(t[2]);
    EXPECT_EQ(inside(faces, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}), cells[i]);
  }
}

class ClipRandom : public testing::TestWithParam<unsigned> {};

/// In the first tier the first tenth of them.
const int kScenesByTest = runs_all() ? 10'000 : 1'000;

/// All corners of the results are corners of cells, so areas are compared exactly.
TEST_P(ClipRandom, CellsOfOneGrid) {
  std::mt19937 random(GetParam());
  std::uniform_int_distribution<int> coin(0, 1);
  for (int i = 0; i < kScenesByTest && !testing::Test::HasFailure(); ++i) {
    const Cells a = random_cells(random), b = random_cells(random);
    const Placing place = i % 3 == 0 ? Placing{} : random_placing(random, i % 3 == 1 ? 3 : 1 << 20);
    SCOPED_TRACE(i);
    if (place.determinant() < 0) continue;
    const Faces fa = faces_of(a, place, coin(random) != 0), fb = faces_of(b, place, coin(random) != 0);
    const ClipResult ab = clip_contour_by_contour(fa, fb), ba = clip_contour_by_contour(fb, fa);
    Cells both{}, only_a{}, only_b{};
    for (std::size_t k = 0; k < a.size(); ++k) {
      both[k] = a[k] && b[k];
      only_a[k] = a[k] && !b[k];
      only_b[k] = !a[k] && b[k];
    }
    expect_cells(ab.inside, both, place);
    expect_cells(ab.outside, only_a, place);
    expect_cells(ba.inside, both, place);
    expect_cells(ba.outside, only_b, place);
    if (i % 8 == 0) {  // by itself; and pieces again by the whole
      const ClipResult self = clip_contour_by_contour(fa, fa);
      expect_cells(self.inside, a, place);
      EXPECT_TRUE(self.outside.empty());
      expect_cells(clip_contour_by_contour(ab.outside, fa).inside, only_a, place);
      EXPECT_TRUE(clip_contour_by_contour(ab.inside, ab.outside).inside.empty());
    }
  }
}

/// Grids that lie askew over each other: corners on no lattice, areas add up.
TEST_P(ClipRandom, CellsOfTwoGrids) {
  std::mt19937 random(1000 + GetParam());
  std::uniform_int_distribution<std::int64_t> part(-(1 << 18), 1 << 18);
  for (int i = 0; i < kScenesByTest && !testing::Test::HasFailure(); ++i) {
    const std::int32_t limit = i % 2 == 0 ? 2 : 1 << 20;
    SCOPED_TRACE(i);
    const Placing pa = random_placing(random, limit), pb = random_placing(random, limit);
    if (pa.determinant() < 0 || pb.determinant() < 0) continue;
    const Faces a = faces_of(random_cells(random), pa, true), b = faces_of(random_cells(random), pb, true);
    const ClipResult ab = clip_contour_by_contour(a, b), ba = clip_contour_by_contour(b, a);
    for (const Faces* f : {&ab.inside, &ab.outside, &ba.inside, &ba.outside}) expect_well_formed(*f);
    const double tolerance = area_tolerance(a) + area_tolerance(b) + area_tolerance(ab.inside) + area_tolerance(ab.outside);
    EXPECT_NEAR(twice_area(ab.inside) + twice_area(ab.outside), twice_area(a), tolerance);
    EXPECT_NEAR(twice_area(ba.inside) + twice_area(ba.outside), twice_area(b), tolerance + area_tolerance(ba.outside));
    EXPECT_NEAR(twice_area(ab.inside), twice_area(ba.inside), tolerance);
    // Pieces have nothing in common with each other.
    EXPECT_NEAR(twice_area(clip_contour_by_contour(ab.outside, b).inside), 0, tolerance);
    // As point sets.
    for (int k = 0; k < 8; ++k) {
      const LatticePoint c = pa(kSide, kSide);
      const FinePoint p{fine(c).x + part(random) * limit, fine(c).y + part(random) * limit};
      if (on_contour(a, p) || on_contour(b, p)) continue;
      const bool in_a = inside(a, p), in_b = inside(b, p);
      EXPECT_EQ(inside(ab.inside, p), in_a && in_b);
      EXPECT_EQ(inside(ab.outside, p), in_a && !in_b);
      EXPECT_EQ(inside(ba.outside, p), !in_a && in_b);
    }
  }
}

/// However deep the clipping goes: a star cut by many others, in two orders.
TEST_P(ClipRandom, StarsAgainAndAgain) {
  std::mt19937 random(2000 + GetParam());
  std::uniform_int_distribution<std::int32_t> place(-kLatticeLimit / 4, kLatticeLimit / 4);
  for (int i = 0; i < kScenesByTest / 50 && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const ContourFace whole = random_star(random, {0, 0}, kLatticeLimit * 0.7, true);
    Faces clips;
    for (int k = 0; k < 6; ++k)
      clips.push_back(random_star(random, {place(random), place(random)}, kLatticeLimit * 0.4, k % 2 == 0));
    Faces forth{whole}, back{whole}, taken;
    for (int k = 0; k < 6; ++k) {
      ClipResult r = clip_contour_by_contour(forth, std::span(&clips[static_cast<std::size_t>(k)], 1));
      forth = std::move(r.outside);
      taken.insert(taken.end(), r.inside.begin(), r.inside.end());
      back = clip_contour_by_contour(back, std::span(&clips[static_cast<std::size_t>(5 - k)], 1)).outside;
    }
    expect_well_formed(forth);
    expect_well_formed(taken);
    const double tolerance = area_tolerance(forth) + area_tolerance(taken) + area_tolerance(back);
    EXPECT_NEAR(twice_area(forth) + twice_area(taken), twice_area(whole), tolerance);
    EXPECT_NEAR(twice_area(forth), twice_area(back), tolerance);
    const ClipResult at_once = clip_contour_by_contour(std::span(&whole, 1), clips);
    EXPECT_NEAR(twice_area(at_once.outside), twice_area(forth), tolerance);
    EXPECT_NEAR(twice_area(at_once.inside), twice_area(taken), tolerance + area_tolerance(at_once.inside));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ClipRandom, testing::Range(0u, 10u));

}  // namespace
}  // namespace ligne::test
