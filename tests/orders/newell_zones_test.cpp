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

struct ZoneGrid {
  int columns = 0, boxes = 0, of_first = 0;  ///< boxes of a zone, and of the first one
  int only = -1;                             ///< the one zone that has boxes, or -1: all have
};

/// Zones in a square, seen from the front. Two far specks keep the scale and the depths.
Scene zones_apart(const ZoneGrid& grid) {
  Scene scene;
  const double end = kApart * grid.columns;
  studies::add_plate(scene, {-kApart, -kApart + 0.1}, {-kApart, -kApart + 0.1}, {-6, 6});
  studies::add_plate(scene, {end, end + 0.1}, {end, end + 0.1}, {-6, 6});
  for (int i = 0; i < grid.columns * grid.columns; ++i) {
    if (grid.only >= 0 && i != grid.only) continue;
    const Point3 middle{kApart * (i % grid.columns), 0, kApart * (i / grid.columns)};
    add_zone(scene, i == 0 ? grid.of_first : grid.boxes, middle, static_cast<unsigned>(i));
  }
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

bool is_same(const PaintPiece& a, const PaintPiece& b) {
  return a.face == b.face && a.contours == b.contours && a.plane == b.plane;
}

void expect_same_order(const VisibilityResult& a, const VisibilityResult& b) {
  ASSERT_EQ(a.order->pieces.size(), b.order->pieces.size());
  EXPECT_TRUE(std::ranges::equal(a.order->pieces, b.order->pieces, is_same));
  EXPECT_EQ(a.statistics.counts, b.statistics.counts);
}

// 441 boxes in 144 lists, sorted in groups of about a thousand faces, of which one has more than the others. All lists have
// have cuts.
TEST(NewellZones, TheOrderIsThatOfOneAfterTheOther) {
  const Scene scene = zones_apart({12, 3, 12});
  for (const bool bodies : {false, true}) {
    const VisibilityResult sequence = painted_zones(scene, true, bodies);
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
      SCOPED_TRACE(threads);
      run_with_threads(threads, [&] { expect_same_order(painted_zones(scene, false, bodies), sequence); });
    }
  }
}

// A cut changes nothing in another zone: with the other zones and without them, whether threads copy the list of a zone or
// sort it in place, its pieces are the same, bit for bit, in the same order.
TEST(NewellZones, AZoneIsSortedAsItIsAlone) {
  const ZoneGrid grid{12, 3, 12};
  const VisibilityResult all = painted_zones(zones_apart(grid), false, false);
  std::size_t first_face = 2;  // behind the specks
  for (int zone = 0; zone < grid.columns * grid.columns; ++zone) {
    const int boxes = zone == 0 ? grid.of_first : grid.boxes;
    const std::size_t count = 6 * static_cast<std::size_t>(boxes);
    if (zone % 13 == 0) {
      SCOPED_TRACE(zone);
      ZoneGrid alone = grid;
      alone.only = zone;
      std::vector<PaintPiece> expected, found;
      const VisibilityResult result = painted_zones(zones_apart(alone), false, false);
      for (PaintPiece piece : result.order->pieces) {
        if (piece.face < 2) continue;
        piece.face += static_cast<std::uint32_t>(first_face - 2);
        expected.push_back(piece);
      }
      for (const PaintPiece& piece : all.order->pieces)
        if (piece.face >= first_face && piece.face < first_face + count) found.push_back(piece);
      EXPECT_GT(found.size(), count / 2);
      ASSERT_EQ(found.size(), expected.size());
      EXPECT_TRUE(std::ranges::equal(found, expected, is_same));
    }
    first_face += count;
  }
}

// Lists do not concern each other: no pair of elements of two zones is compared, and each list has the counts that it has
// alone.
TEST(NewellZones, ListsAddUp) {
  const Scene scene = zones_apart({12, 3, 12});
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

// The pieces of cut faces serve as the first list of the next view, whichever thread made them.
TEST(NewellZones, TheNextViewTakesOverPiecesOfAllZones) {
  const Scene scene = zones_apart({12, 3, 12});
  const auto study = [&](double lean, const KeptVisibility* earlier) {
    const Picture picture = draw(scene, {along({lean, 1, 0}), "all", false, 0, "appel"});
    VisibilityOptions options;
    options.wanted |= kOrder;
    options.keep = Keep::for_next_view;
    options.earlier = earlier;
    return find_method("newell")->compute_visibility(picture.projected, options);
  };
  const auto count = [](const VisibilityResult& result, const char* name) { return count_of(result.statistics, name); };
  const VisibilityResult first = study(0, nullptr);
  ASSERT_GT(count(first, "final elements"), count(first, "faces in the list") + 100);
  const VisibilityResult again = study(0, first.kept.get());
  EXPECT_EQ(count(again, "elements of the previous view"), count(first, "final elements"));
  EXPECT_EQ(count(again, "cuts by a plane") + count(again, "cuts on the page"), 0u);
  const VisibilityResult next = study(0.02, first.kept.get()), alone = study(0.02, nullptr);
  EXPECT_EQ(next.strokes->strokes.size(), alone.strokes->strokes.size());
}

}  // namespace
}  // namespace ligne::test
