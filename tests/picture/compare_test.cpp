/// Drawings of two methods, and strokes that differ.

#include "report/compare.hpp"
#include "linework/stroke_builder.hpp"
#include "report/stroke_difference.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

// Methods side by side: exact ones agree, what goes wrong with one is a row.

CompareRequest all() {
  CompareRequest request;
  for (const Method* method : all_methods()) request.methods.push_back({method});
  request.picture.lines.quality = Quality::exact;
  return request;
}

MethodComparison compared(const Scene& scene, const CompareRequest& request) {
  return compare_methods(scene, build_topology(scene), request);
}

TEST(Compare, ExactMethodsAgree) {
  for (const char* name : {"bricks", "cross_of_plates", "lattice_of_bars", "gear", "holes_behind_holes", "cyclic_4"}) {
    const MethodComparison c = compared(corpus_scene(name), all());
    ASSERT_EQ(c.methods.size(), all_methods().size());
    ASSERT_TRUE(c.reference);
    for (std::size_t i = 0; i < c.methods.size(); ++i) {
      const MethodOutcome& m = c.methods[i];
      EXPECT_TRUE(m.drawn()) << m.failure;
      EXPECT_GT(m.seconds(), 0);
      EXPECT_EQ(c.differences_mm[i][i], 0);
      if (m.exact() && m.unsupported_reason.empty()) {
        EXPECT_GT(m.visible_mm, 0) << name << ", " << m.method->traits().name;
        EXPECT_EQ(c.differences_mm[*c.reference][i], 0) << name << ", " << m.method->traits().name;
      }
    }
  }
}

TEST(Compare, OrdersLeaveFacesThatAreAllButEdgeOnToDepths) {
  CompareRequest request;
  for (const char* name : {"appel", "newell", "bsp", "convex-tree"}) request.methods.push_back({find_method(name)});
  request.picture.lines.quality = Quality::exact;
  const MethodComparison c = compared(corpus_scene("nearly_edge_on_iso"), request);
  for (std::size_t i = 0; i < c.methods.size(); ++i)
    EXPECT_EQ(c.differences_mm[0][i], 0) << c.methods[i].method->traits().name;
}

TEST(Compare, TellsWhatAMethodCanNot) {
  const MethodComparison c = compared(corpus_scene("cross_of_plates"), all());
  const auto of = [&](const char* name) -> const MethodOutcome& {
    return *std::find_if(c.methods.begin(), c.methods.end(),
                         [&](const MethodOutcome& m) { return m.method->traits().name == name; });
  };
  EXPECT_FALSE(of("culling").unsupported_reason.empty());
  EXPECT_GT(of("culling").from_reference.length_mm, 1);
  EXPECT_TRUE(of("zbuffer").resolution_mm);
  EXPECT_FALSE(of("appel").resolution_mm);
  EXPECT_TRUE(of("appel").operations[static_cast<std::size_t>(OperationKind::line_tests)]);
  EXPECT_FALSE(of("appel").operations[static_cast<std::size_t>(OperationKind::abscissas)]);
  // 2.6: 3 words to a vertex and 37 to a face.
  const Scene scene = corpus_scene("cross_of_plates");
  EXPECT_EQ(of("warnock").thesis_words, 3 * scene.vertices.size() + 37 * scene.faces.size());
  EXPECT_FALSE(of("appel").thesis_words);
}

TEST(Compare, OneThatTakesTooLongIsARow) {
  CompareRequest request = all();
  request.limit_seconds = 0;
  const MethodComparison c = compared(corpus_scene("lattice_of_bars"), request);
  ASSERT_EQ(c.methods.size(), all_methods().size());
  std::size_t ended = 0;
  for (const MethodOutcome& m : c.methods) ended += m.failure == "ended after 0 s";
  EXPECT_GT(ended, 0u);
}

TEST(Compare, OneThatFailsIsARow) {
  CompareRequest request;
  request.methods = {{find_method("appel")}, {find_method("zbuffer")}};
  request.methods[1].settings.set("lines", 512u);
  request.picture.regions = true;  // which the depth buffer does not have, nor does appel
  const MethodComparison c = compared(corpus_scene("cube"), request);
  ASSERT_EQ(c.methods.size(), 2u);
  for (const MethodOutcome& m : c.methods) expect_parts(m.failure, {"needs a method that gives regions"});
  EXPECT_FALSE(c.reference);
  EXPECT_FALSE(c.differences_mm[0][1]);
}

TEST(Compare, ProgressRises) {
  CompareRequest request = all();
  double last = 0;
  request.progress = [&](double fraction) {
    EXPECT_GE(fraction, last - 1e-12);
    last = fraction;
  };
  compared(corpus_scene("bricks"), request);
  EXPECT_EQ(last, 1);
}

// Parts of lines that one drawing shows and another lacks.

/// A tolerance of half a step of these lattices, which are a millimetre wide.
constexpr double kHalf = 0.5;

TEST(StrokeDifference, IsTheLengthThatOneOfThemLacks) {
  const struct {
    const char *name, *first, *second;
    double length;
  } cases[] = {{"one line in other pieces", "0,0 90,30", "30,10 0,0; 30,10 90,30", 0},
               {"hidden strokes are not drawn", "0,0 100,0", "hidden 0,0 100,0", 100},
               {"hidden strokes are not missing", "hidden 0,0 100,0", "hidden 0,0 100,0", 0},
               {"back to front", "0,0 100,30; 20,0 20,50", "20,50 20,0; 100,30 0,0", 0}};
  for (const auto& c : cases)
    EXPECT_NEAR(difference_of(sketch(c.first), sketch(c.second), kHalf).length_mm, c.length, 1e-9 * c.length) << c.name;
}

TEST(StrokeDifference, IsWhatOneOfThemLacks) {
  const StrokeDifference d =
      difference_of(sketch("0,0 100,0; 0,50 100,50"), sketch("0,0 40,0; 70,0 100,0; 0,50 120,50"), kHalf);
  ASSERT_EQ(d.only_first.size(), 1u);
  EXPECT_NEAR(d.only_first[0].from.x, 40, 1e-9);
  EXPECT_NEAR(d.only_first[0].to.x, 70, 1e-9);
  ASSERT_EQ(d.only_second.size(), 1u);
  EXPECT_NEAR(d.length_mm, 50, 1e-9);
  EXPECT_NEAR(d.longest_mm, 30, 1e-9);
}

TEST(StrokeDifference, LevelsCountWhereTheyAreAskedFor) {
  StrokeModel direct = sketch("0,0 100,0"), through = direct;
  through.strokes[0].level = 1;
  EXPECT_TRUE(parts_missing(direct, through, kHalf).empty());
  EXPECT_EQ(parts_missing(direct, through, kHalf, true).size(), 1u);
}

TEST(StrokeDifference, TheSamePointsOfAnotherLatticeAreElsewhere) {
  const StrokeModel here = sketch("0,0 100,0");
  StrokeModel elsewhere = here;
  elsewhere.lattice.origin_mm.y += 10;
  EXPECT_NEAR(difference_of(here, elsewhere, kHalf).length_mm, 200, 1e-9);
}

}  // namespace
}  // namespace ligne::test
