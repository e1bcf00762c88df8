// Zones of the method newell, sorted by several threads at the same time ([Boulle1980] 2.6).

#include "base/parallel.hpp"
#include "newell_sorted.hpp"

namespace ligne::test {
namespace {

constexpr double kApart = 9;  ///< between the middles of two zones

/// Boxes that penetrate each other, within less than kApart / 2 of a point. The seed tells which.
void add_zone(Scene& scene, int count, const Point3& middle, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < count; ++i) {
    const Point3 at = middle + Point3{u(random), u(random), u(random)} * 0.8;
    const Basis basis = rotation(u(random) * 3, u(random) * 3, u(random) * 3);
    // The basis turns a box about the origin.
    const Point3 turned{glm::dot(basis[0], at), glm::dot(basis[1], at), glm::dot(basis[2], at)};
    add_box(scene, turned - Point3(0.7), {1.4, 1.4, 1.4}, basis);
  }
}

/// 144 zones in a square, seen from the front: three boxes in each, twelve in the first one.
Scene zones_apart() {
  constexpr int kColumns = 12;
  Scene scene;
  for (int i = 0; i < kColumns * kColumns; ++i)
    add_zone(scene, i == 0 ? 12 : 3, {kApart * (i % kColumns), 0, kApart * (i / kColumns)}, static_cast<unsigned>(i));
  return scene;
}

VisibilityResult painted_zones(const Scene& scene, bool in_sequence, bool bodies) {
  const Picture picture = draw(scene, {along({0, 1, 0}), "all", false, 0, "appel"});
  VisibilityOptions options;
  options.wanted |= kOrder;
  if (in_sequence) options.settings.set("zones", ParameterWord{1});
  if (bodies) options.settings.set("newell-elements", ParameterWord{1});
  return find_method("newell")->compute_visibility(picture.projected, options);
}

void expect_same_order(const VisibilityResult& a, const VisibilityResult& b) {
  ASSERT_TRUE(a.order && b.order);
  EXPECT_TRUE(bytes_of(a) == bytes_of(b));
  EXPECT_EQ(a.statistics.counts, b.statistics.counts);
}

// 441 boxes in 144 lists, sorted in groups of about a thousand faces, of which one has more than the others. All lists have
// have cuts.
TEST(NewellZones, TheOrderIsThatOfOneAfterTheOther) {
  const Scene scene = zones_apart();
  for (const bool bodies : {false, true}) {
    const VisibilityResult sequence = painted_zones(scene, true, bodies);
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
      SCOPED_TRACE(threads);
      run_with_threads(threads, [&] { expect_same_order(painted_zones(scene, false, bodies), sequence); });
    }
  }
}

// Lists do not concern each other: no pair of elements of two zones is compared, and each list has the counts that it has
// alone.
TEST(NewellZones, ListsAddUp) {
  const Scene scene = zones_apart();
  const Picture picture = listed(scene);
  newell::PaintElements elements(picture.projected);
  newell::PriorityList list(elements);
  list.sort();
  ASSERT_GE(list.lists().size(), 144u);
  EXPECT_EQ(list.lists().size(), list.counts().lists);
  std::uint64_t compared = 0, cuts = 0;
  std::size_t longest = 0, with_cuts = 0;
  for (const auto& l : list.lists()) {
    compared += l.compared;
    cuts += l.cuts;
    longest = std::max(longest, l.elements);
    with_cuts += l.cuts > 0;
  }
  EXPECT_EQ(longest, 72u);
  EXPECT_GT(with_cuts, 100u);
  EXPECT_EQ(compared, list.counts().compared);
  EXPECT_EQ(cuts, list.counts().cuts());
}

}  // namespace
}  // namespace ligne::test
