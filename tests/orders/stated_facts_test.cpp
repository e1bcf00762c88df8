// Facts that a scene states: checked, and what they spare in the list of newell. Convex bodies as elements of it.

#include "newell_sorted.hpp"
#include "scene/clean/check_facts.hpp"
#include "support/scene_parts.hpp"

namespace ligne::test {
namespace {

Scene finished(Scene scene) {
  finish(scene);
  return scene;
}

std::string false_fact(const Scene& scene) { return find_false_fact(scene, build_topology(scene)); }

/// Two boxes on the sides of the plane x = 3, and one beyond y = 3.
Scene three_boxes() {
  Scene scene;
  add_box(scene, {0, 0, 0}, {2, 2, 2});
  add_box(scene, {4, 0, 0}, {2, 2, 2});
  add_box(scene, {0, 4, 0}, {6, 2, 2});
  return finished(scene);
}

TEST(StatedFacts, TrueOnesAreAccepted) {
  Scene scene = three_boxes();
  scene.stated.state(StatedFact::no_penetration);
  scene.stated.state(StatedFact::convex);
  scene.stated.state(StatedFact::adjacency);
  scene.stated.planes = {{{0, 3, 0}, {0, 1, 0}}, {{7, 0, 0}, {1, 0, 0}}};
  EXPECT_EQ(false_fact(scene), "");
}

TEST(StatedFacts, FalseOnesNameTheObject) {
  Scene scene = three_boxes();
  for (std::size_t i = 0; i < 3; ++i) scene.objects[i].name = std::string("box ") + "abc"[i];
  scene.stated.planes = {{{3, 0, 0}, {1, 0, 0}}};
  EXPECT_EQ(false_fact(scene), "separating_planes[0] cuts object \"box c\"");

  Scene open;
  add_face(open, {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}});
  open.stated.state(StatedFact::convex);
  EXPECT_EQ(false_fact(finished(open)),
            "the fact 'convex' is false: object \"object\" is not one closed convex body: it has a border edge");

  Scene through;
  add_box(through, {0, 0, 0}, {2, 2, 2});
  add_box(through, {-1, 0.5, 0.5}, {4, 1, 1});
  through = finished(through);
  through.stated.state(StatedFact::convex);
  EXPECT_EQ(false_fact(through), "");
  through.objects[0].name = "@";
  through.stated.state(StatedFact::no_penetration);
  EXPECT_EQ(false_fact(through), "the fact 'no-penetration' is false: objects \"@\" and \"box\" pass through each other");
}

TEST(StatedFacts, FalseAdjacencyNamesTheObject) {
  const auto why = [](const std::vector<std::vector<std::uint32_t>>& faces) {
    Scene scene = three_boxes();
    begin_object(scene, "added");
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    for (const Point3& p : {Point3{9, 0, 0}, {11, 0, 0}, {9, 2, 0}, {9, 0, 2}, {9, -1, -1}}) scene.vertices.push_back(p);
    for (std::vector<std::uint32_t> face : faces) {
      for (std::uint32_t& v : face) v += first;
      scene.faces.add_face(face);
    }
    end_object(scene);
    scene = finished(scene);
    scene.stated.state(StatedFact::adjacency);
    return false_fact(scene);
  };
  EXPECT_EQ(why({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), "");
  const std::string begin = "the fact 'adjacency' is false: object \"added\" has ";
  EXPECT_EQ(why({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}), begin + "a border edge");
  EXPECT_EQ(why({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 3, 0}}), begin + "an edge along which both faces run the same way");
  EXPECT_EQ(why({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}, {1, 0, 4}}),
            begin + "an edge of more than two faces");
}

// Bodies that touch along faces, edges and corners do not pass through each other.
TEST(StatedFacts, TouchingIsNoPenetration) {
  Scene scene;
  for (const Point3& corner : {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {1, 1, 0}, {0.5, 0.25, -1}})
    add_box(scene, corner, {1, 1, 1}, rotation(0.3, 0.4, 0.5));
  scene = finished(scene);
  scene.stated.state(StatedFact::no_penetration);
  EXPECT_EQ(false_fact(scene), "");
}

// A pyramid on a pentagram and one below it: every edge bends outwards, but the surface winds round the axis twice.
TEST(StatedFacts, ASurfaceThatWindsTwiceIsNotConvex) {
  Scene scene;
  begin_object(scene, "star");
  for (int i = 0; i < 5; ++i) {
    const double a = 4 * std::acos(-1.0) * i / 5;
    scene.vertices.push_back({std::cos(a), std::sin(a), 0});
  }
  scene.vertices.push_back({0, 0, 1});
  scene.vertices.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < 5; ++i) {
    scene.faces.add_triangle(i, (i + 1) % 5, 5);
    scene.faces.add_triangle((i + 1) % 5, i, 6);
  }
  end_object(scene);
  scene.stated.state(StatedFact::convex);
  EXPECT_NE(false_fact(scene), "");
}

// Each of the two boxes in front is compared with the one behind, unless a plane between them is known.
TEST(StatedFacts, SeparatingPlanesSpareComparisons) {
  // The depths of the boxes overlap as they are seen.
  const Point3 aslant{0.5, 1, -0.4};
  Scene scene = three_boxes();
  const Sorted without = sorted(scene, aslant);
  scene.stated.planes = {{{0, 3, 0}, {0, -1, 0}}, {{3, 0, 0}, {1, 0, 0}}};
  EXPECT_NE(false_fact(scene), "") << "the third box reaches through x = 3";
  scene.stated.planes.pop_back();
  EXPECT_EQ(false_fact(scene), "");
  const Sorted with = sorted(scene, aslant);
  EXPECT_LT(with.counts.compared + with.counts.one_body, without.counts.compared + without.counts.one_body);
  ASSERT_EQ(with.faces.size(), 18u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_GE(with.faces[i], 12u) << "the box behind is painted first";
}

// Figure 2.81 a with the fact: the pair is not compared the other way round, and the order is the same.
TEST(StatedFacts, ConvexFacesThatDoNotPenetrateHideOneWay) {
  Scene scene = plates({{0, 10, 0, 10, 9, 1}, {7, 9, 3, 6, 6, 6}});
  const Sorted without = sorted(scene);
  scene.stated.state(StatedFact::no_penetration);
  const Sorted with = sorted(scene);
  EXPECT_EQ(with.faces, without.faces);
  EXPECT_EQ(with.counts.one_way, 1u);
  EXPECT_EQ(with.counts.compared + 1, without.counts.compared);
}

// One height for each of the twelve triangles of a box, in place of eight for each.
TEST(StatedFacts, ConvexBodiesTakeOneHeightATriangle) {
  Scene scene = three_boxes();
  const auto heights = [](const Scene& s) {
    const Picture picture = listed(s, {0.5, 1, -0.4});
    const newell::PaintElements elements(picture.projected);
    EXPECT_EQ(elements.bodies().count(), 3u);
    return elements.bodies().heights();
  };
  EXPECT_EQ(heights(scene), 3u * 12 * 8);
  scene.stated.state(StatedFact::convex);
  EXPECT_EQ(heights(scene), 3u * 12);
}

VisibilityResult painted(const ProjectedScene& projected, bool bodies) {
  VisibilityOptions options;
  if (bodies) options.settings.set("newell-elements", ParameterWord{1});
  return find_method("newell")->compute_visibility(projected, options);
}

std::uint64_t count(const VisibilityResult& result, const char* name) { return count_of(result.statistics, name); }

// [Boulle1980] 1.2.2.3 c, 2.5.2.7: bodies as elements. The same is seen, and less is compared where most bodies are apart;
// where they pass through each other they are opened, which spares nothing. What is seen and painted: all methods, orders.
TEST(NewellBodies, SpareComparisonsWhereTheyAreApart) {
  for (const double apart : {20.0, 4.0}) {
    const Scene scene = finished(random_boxes(40, 7, apart / 2, {2, 2, 2}));
    const Picture picture = draw(scene, {along({0.3, 1, -0.4}), "all", false, 0, "appel"});
    const VisibilityResult faces = painted(picture.projected, false), bodies = painted(picture.projected, true);
    EXPECT_EQ(count(bodies, "elements in the list"), 40u);
    if (apart > 10) {
      EXPECT_LT(count(bodies, "bodies opened"), 10u);
      EXPECT_LT(count(bodies, "pairs compared"), count(faces, "pairs compared"));
    } else {
      EXPECT_GT(count(bodies, "bodies opened"), 0u);
    }
    EXPECT_EQ(bodies.strokes->strokes.size(), faces.strokes->strokes.size());
    EXPECT_EQ(bodies.regions->size(), faces.regions->size());
  }
}

// A body inside another has no place beside it as a whole.
TEST(NewellBodies, NestedBodiesAreOpened) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {6, 6, 6});
  add_box(scene, {2, 2, 2}, {2, 2, 2});
  scene = finished(scene);
  const Picture picture = listed(scene, {0.3, 1, -0.4});
  const VisibilityResult bodies = painted(picture.projected, true), faces = painted(picture.projected, false);
  EXPECT_EQ(count(bodies, "bodies kept as one element"), 2u);
  EXPECT_GE(count(bodies, "bodies opened"), 1u);
  EXPECT_EQ(bodies.regions->size(), faces.regions->size());
}

}  // namespace
}  // namespace ligne::test
