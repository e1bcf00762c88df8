// The priority list of the method newell: its tests, what it never compares, and what it keeps.

#include "base/parallel.hpp"
#include "main/script.hpp"
#include "newell_sorted.hpp"
#include "support/mesh_text.hpp"

namespace ligne::test {
namespace {

using newell::PaintElements;
using studies::add_plate;
using studies::ring;

/// The order of the faces, the farthest first, and the counts of the list; seen along +y: x to the right, z up, what has the
/// larger y is farther.
std::string list_of(const std::string& mesh) {
  const Sorted s = sorted(mesh_of(mesh + "\nexact").scene());
  std::string text;
  for (const std::uint32_t face : s.faces) text += (text.empty() ? "" : " ") + std::to_string(face);
  const newell::ListCounts& c = s.counts;
  for (const auto& [name, count] :
       std::initializer_list<std::pair<const char*, std::uint64_t>>{{"zones", c.zones},
                                                                    {"slabs", c.slabs},
                                                                    {"lists", c.lists},
                                                                    {"compared", c.compared},
                                                                    {"moved", c.moved},
                                                                    {"projections", c.projections},
                                                                    {"depths", c.depths},
                                                                    {"cuts by a plane", c.plane_cuts},
                                                                    {"cuts on the page", c.page_cuts},
                                                                    {"behind the plane", c.behind_plane},
                                                                    {"before the plane", c.before_plane}})
    if (count > 0) text += ", " + std::to_string(count) + " " + name;
  return text;
}

[[maybe_unused]] const bool lists_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/orders/lists", {{"list", [](auto& t) { return list_of(unescaped(t)); }}});

// Plates that overlap in a strip narrower than a step of the lattice: a line on the strip is hidden with it, so they have an
// order. Pieces smaller than a step have none: nothing can be seen of them.
TEST(Newell, NarrowStripsHaveAnOrder) {
  const double step = listed(ring(3)).projected.lattice.step_mm;
  const auto disjoint = [](double overlap, double size) {
    const Scene scene = plates({{0, 10, 0, 10, 5, 5}, {10 - overlap, 10 - overlap + size, 2, 2 + size, 2, 2}});
    const Picture picture = listed(scene);
    return PaintElements(picture.projected).disjoint(0, 1);
  };
  EXPECT_FALSE(disjoint(10 * step, 5));
  EXPECT_FALSE(disjoint(0.3 * step, 5));
  EXPECT_TRUE(disjoint(0, 5));
  EXPECT_TRUE(disjoint(0.3 * step, 0.6 * step));
}

// The order is free of the aspect of faces (2.5.2.6), and siblings, pieces of one face, are never compared: a face with a
// hole is twelve triangles here, of which no two are in one comparison.
TEST(Newell, SiblingsAreNotCompared) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {9, 7, 0}, {9, 7, 9}, {0, 0, 9}},
                   {{3, 7.0 / 3, 3}, {3, 7.0 / 3, 6}, {6, 14.0 / 3, 6}, {6, 14.0 / 3, 3}}});
  EXPECT_EQ(sorted(scene).counts.compared, 0u);
  EXPECT_EQ(sorted(scene).faces.size(), 1u);
}

// 2.5.2.1: the model of visibility is the faces in another order. A face with a hole is one piece of two contours, and a
// face that was cut gives as many pieces as connected parts, with the area of the whole.
TEST(Newell, TheOrderHoldsWholeFaces) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {9, 0, 0}, {9, 0, 9}, {0, 0, 9}}, {{3, 0, 3}, {3, 0, 6}, {6, 0, 6}, {6, 0, 3}}});
  const auto order_of = [](const Scene& s, const Point3& direction) {
    const Picture picture = listed(s, direction);
    return *find_method("newell")->compute_visibility(picture.projected, {}).order;
  };
  const PaintOrder whole = order_of(scene, {0, 1, 0});
  ASSERT_EQ(whole.pieces.size(), 1u);
  ASSERT_EQ(whole.pieces[0].contours.size(), 2u);
  EXPECT_EQ(whole.pieces[0].contours[0].size(), 4u);
  EXPECT_NEAR(area_within(whole.pieces[0].contours), 72, 1e-9);

  Scene bar = scene;  // goes through the hole of the face and through its rim
  add_face(bar, {{{1, -4, 4}, {8, -4, 4}, {8, 4, 5}, {1, 4, 5}}});
  const PaintOrder cut = order_of(bar, {0, 1, 0});
  double of_plate = 0, of_bar = 0;
  for (const PaintPiece& piece : cut.pieces) (piece.face == 0 ? of_plate : of_bar) += area_within(piece.contours);
  EXPECT_GT(cut.pieces.size(), 2u);
  EXPECT_NEAR(of_plate, 72, 1e-6);
  EXPECT_NEAR(of_bar, 7, 1e-6);
}

/// Boxes that penetrate each other.
Scene crowd_of_boxes() { return random_boxes(40, 3, 4, {2, 2, 2}); }

// [Boulle1980], front and back partition: of a box three faces look at the viewer and three do not. Of the 15 pairs the six
// of one kind are never compared, nor is a face at the back with one at the front.
TEST(Newell, FacesOfAConvexBodyAreNotCompared) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {2, 2, 2}, rotation(0.4, 0.5, 0.6));
  const Picture picture = listed(scene);
  const PaintElements elements(picture.projected);
  EXPECT_EQ(elements.bodies().count(), 1u);
  EXPECT_EQ(elements.bodies().faces(), 6u);
  int never = 0;
  for (std::uint32_t a = 0; a < 6; ++a)
    for (std::uint32_t b = 0; b < 6; ++b) never += a != b && elements.never_hides(a, b);
  EXPECT_EQ(never, 2 * 6 + 9);
  const Sorted s = sorted(scene);
  EXPECT_LE(s.counts.compared, 9u);
  EXPECT_GT(s.counts.one_body, 0u);
}

// Three strips in a zigzag: the plane of the middle one has the others on both sides.
TEST(Newell, AZigzagIsNoConvexBody) {
  Scene scene;
  begin_object(scene);
  for (const double z : {0.0, 4.0})
    for (const Point3& p : {Point3{0, 0, z}, Point3{2, 2, z}, Point3{4, 0, z}, Point3{6, 2, z}}) scene.vertices.push_back(p);
  for (std::uint32_t i = 0; i < 3; ++i) scene.faces.add_face(std::vector<std::uint32_t>{i, i + 1, i + 5, i + 4});
  end_object(scene);
  const Picture picture = listed(scene, {0.3, 1, 0});
  EXPECT_EQ(PaintElements(picture.projected).bodies().count(), 0u);
}

// The list of a view, with its pieces, is a good beginning for that of a similar one: hardly anything is moved or cut. The
// strokes are the same either way.
TEST(Newell, TakesOverTheListOfASimilarView) {
  const Scene scene = crowd_of_boxes();
  const Method& newell = *find_method("newell");
  const auto study = [&](double degrees, const KeptVisibility* earlier) {
    const double turn = degrees * std::numbers::pi / 180;
    const Picture picture = listed(scene, {std::sin(turn), std::cos(turn), -0.3});
    VisibilityOptions options;
    options.keep = Keep::for_next_view;
    options.earlier = earlier;
    return newell.compute_visibility(picture.projected, options);
  };
  const auto count = [](const VisibilityResult& result, const char* name) { return count_of(result.statistics, name); };
  const auto length = [](const VisibilityResult& result) {
    double sum = 0;
    for (const Stroke& s : result.strokes->strokes) sum += std::hypot(double(s.to.x) - s.from.x, double(s.to.y) - s.from.y);
    return sum;
  };
  const VisibilityResult first = study(0, nullptr);
  EXPECT_EQ(count(first, "elements of the previous view"), 0u);
  for (const double degrees : {2.0, 5.0}) {
    const VisibilityResult alone = study(degrees, nullptr), next = study(degrees, first.kept.get());
    EXPECT_GT(count(next, "elements of the previous view"), 200u);
    EXPECT_LT(2 * count(next, "moved to the head"), count(alone, "moved to the head")) << degrees;
    EXPECT_LT(2 * count(next, "cuts by a plane"), count(alone, "cuts by a plane")) << degrees;
    EXPECT_EQ(next.strokes->strokes.size(), alone.strokes->strokes.size());
    EXPECT_EQ(length(next), length(alone));
  }
  EXPECT_EQ(count(study(90, first.kept.get()), "elements of the previous view"), 0u) << "it is another view";
}

// The priority list of the method newell, by hand: the figures of [Boulle1980] 2.5.

using studies::add_comb;

/// The ring, turned on the page: no two bars are equally wide and high.
Scene turned_ring(int n) {
  Scene scene = ring(n);
  const double c = std::cos(0.1), s = std::sin(0.1);
  for (Point3& p : scene.vertices) p = {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
  return scene;
}

// Figure 2.81 e, and larger rings. All bars are from depth 0 to 4, so the list begins with bar 0; the begin of bar i is
// before the end of bar i - 1, and no bar is penetrated.
//
// By hand: the head, 0, hides n - 1, which is moved to the head; this hides n - 2, and so on, until 1 hides 0, which is
// moved too. After these n moves 0 hides n - 1, which is marked, and one is cut.
// 3: the plane of 0 passes through 2, which is cut. Its end, behind 0, is moved to the head.
// 4: bars at right angles. The plane of a bar passes through the one before it where that lies before the next one, and
//    both halves hide that. So 3, 2, 1 and 0 are halved, one after the other; the farther half of each is moved to the head,
//    and that of 0 still hides that of 3. It is cut by its plane, and its end is moved. What is left are the nearer halves,
//    none of which hides another: they reach equally far, and their order is by chance.
// 5, 6: the planes pass between the neighbours. The larger of 0 and n - 1, 0, is halved, and its end is moved to the head.
TEST(Newell, Figure281eRings) {
  struct Expected {
    std::uint32_t n;
    Order in_order, in_any_order;
    std::uint64_t plane_cuts, page_cuts, moved, compared;
  };
  // 2.5.2.7 finds a ring by n studies of n - 1 comparisons. It leaves out that each move asks whether Q hides P too, and the
  // studies after a cut: so more may be needed, no more than are given here. Those of 3, 4 and 5 are counts and not worked
  // out; n(n - 1) is enough for all of the ring of 6.
  // It says that the c / 2 + 1 pieces of a face with c corners come from one cut, and two where the face is convex:
  // each cut adds one element. Bar 0 of four is the only one cut twice.
  for (const Expected& e :
       {Expected{3, {2, 0, 1, 2}, {}, 1, 0, 4, 15}, Expected{4, {0, 1, 2, 3, 0}, {0, 1, 2, 3}, 5, 0, 9, 46},
        Expected{5, {0, 1, 2, 3, 4, 0}, {}, 0, 1, 6, 23}, Expected{6, {0, 1, 2, 3, 4, 5, 0}, {}, 0, 1, 7, 6 * 5}}) {
    SCOPED_TRACE(e.n);
    const Sorted s = sorted(turned_ring(static_cast<int>(e.n)));
    ASSERT_EQ(s.faces.size(), e.in_order.size() + e.in_any_order.size());
    const auto end = s.faces.begin() + static_cast<std::ptrdiff_t>(e.in_order.size());
    EXPECT_EQ(Order(s.faces.begin(), end), e.in_order);
    EXPECT_TRUE(std::is_permutation(end, s.faces.end(), e.in_any_order.begin(), e.in_any_order.end()));
    EXPECT_EQ(s.faces.size(), e.n + e.plane_cuts + e.page_cuts) << "of a convex face a cut makes two";
    EXPECT_EQ(s.counts.plane_cuts, e.plane_cuts);
    EXPECT_EQ(s.counts.page_cuts, e.page_cuts);
    EXPECT_EQ(s.counts.moved, e.moved);
    EXPECT_LE(s.counts.compared, e.compared);
  }
}

// Figure 2.83: the depths of all faces are apart, and Q_p is empty for each: nothing is compared.
TEST(Newell, Figure283NothingIsCompared) {
  const Sorted s = sorted(studies::apart_in_depth(20));
  EXPECT_EQ(s.counts.compared, 0u);
  EXPECT_EQ(s.counts.slabs, 20u);
  Order farthest_first(20);
  for (std::uint32_t i = 0; i < 20; ++i) farthest_first[i] = 19 - i;
  EXPECT_EQ(s.faces, farthest_first);
}

/// A face of r corners which lie above and below z = 0 by turns, from x0 on, in the plane through y = 5 at z = 0 that leans
/// by `lean`: a straight line passes through all its sides.
void add_zigzag(Scene& scene, int r, double x0, double lean) {
  std::vector<Point3> corners;
  const auto add = [&](int i, double raise) {
    const double z = (i % 2 == 0 ? 3 : -3) + raise;
    corners.push_back({x0 + i, 5 + lean * z, z});
  };
  for (int i = 0; i < r / 2; ++i) add(i, 0);
  for (int i = r / 2; i >= 1; --i) add(i, 0.5);
  add_face(scene, {corners});
}

// Figure 2.85: a straight cut divides a face of r corners into r / 2 + 1 pieces at most: where it passes through all of its
// sides. A comb of t teeth has 4 t corners; a cut through the teeth leaves its back and t points.
TEST(Newell, Figure285PiecesOfACut) {
  const auto pieces = [](const Scene& scene, const ModelPlane& plane) {
    const Picture picture = listed(scene);
    PaintElements elements(picture.projected);
    return elements.cut(0, plane).size();
  };
  for (int r = 4; r <= 16; r += 2) {
    SCOPED_TRACE(r);
    Scene scene;
    add_zigzag(scene, r, 0, 1);
    EXPECT_EQ(pieces(scene, {{0, 0, 1}, {0, 5, 0}}), static_cast<std::size_t>(r) / 2 + 1);
  }
  for (int teeth = 1; teeth <= 6; ++teeth) {
    SCOPED_TRACE(teeth);
    Scene scene;
    add_comb(scene, teeth, 5);
    EXPECT_EQ(pieces(scene, {{1, 0, 0}, {6, 0, 0}}), static_cast<std::size_t>(teeth) + 1);
  }
}

// Figure 2.84: every face is in mutual overlap with P, and either order of each pair is wrong. P leans from depth 7 to 3 and
// has a slot along z = 0; n faces of r corners, which reach from behind P to before it, pass through the slot and touch
// nothing. They reach farther, so each is the head before P; each may hide P and P may hide it, so it is cut by P, into
// r / 2 + 1 pieces. Those behind P reach as far as the faces did, and those before it no farther than its slot: no element
// is moved, and the order is by depth.
TEST(Newell, Figure284EachFaceIsCutOnceByP) {
  for (const std::uint32_t n : {1u, 2u, 3u, 5u}) {
    for (const std::uint32_t r : {4u, 6u, 8u, 10u}) {
      SCOPED_TRACE(n);
      SCOPED_TRACE(r);
      Scene scene;
      const double width = r / 2 + 1.0, right = n * width;
      const auto at = [](double x, double z) { return Point3{x, 5 + 0.5 * z, z}; };
      add_face(scene, {{at(-2, -4), at(right + 1, -4), at(right + 1, 4), at(-2, 4)},
                       {at(-1, -0.5), at(-1, 0.5), at(right, 0.5), at(right, -0.5)}});
      for (std::uint32_t i = 0; i < n; ++i) add_zigzag(scene, static_cast<int>(r), i * width, 1 + 0.01 * i);
      const Sorted s = sorted(scene);
      const std::uint64_t pieces = r / 2 + 1, before = pieces / 2, behind = pieces - before;
      EXPECT_EQ(s.counts.plane_cuts, n);
      EXPECT_EQ(s.counts.page_cuts, 0u);
      EXPECT_EQ(s.counts.moved, 0u);
      // Face n leans the most, and reaches the farthest behind P. The first piece of each lacks the side that is raised.
      Order order;
      for (std::uint32_t f = n; f >= 1; --f) order.insert(order.end(), behind - 1, f);
      for (std::uint32_t f = n; f >= 1; --f) order.push_back(f);
      order.push_back(0);
      ASSERT_EQ(s.faces.size(), 1 + n * pieces);
      const auto end = s.faces.begin() + static_cast<std::ptrdiff_t>(order.size());
      EXPECT_EQ(Order(s.faces.begin(), end), order);
      for (std::uint32_t f = 1; f <= n; ++f) EXPECT_EQ(std::uint64_t(std::count(end, s.faces.end(), f)), before);
      // 2.5.2.7: the square of all pieces. Here each face is compared with P three times, ahead, as the head, and the other
      // way round; then each of its pieces is, once; and no piece with those of other faces, which lie beside it.
      EXPECT_EQ(s.counts.compared, n * (3 + pieces));
      EXPECT_EQ(s.counts.depths, n * 3);
      EXPECT_EQ(s.counts.behind_plane, n * behind);
      EXPECT_EQ(s.counts.before_plane, n * before);
    }
  }
}

// Zones of the method newell, sorted by several threads at the same time ([Boulle1980] 2.6).

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
