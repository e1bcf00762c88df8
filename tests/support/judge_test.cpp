// The judge finds what is wrong with a drawing. Each fault is made by a method that spoils the drawing of the default one.

#include "support/judge.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

class SpoiltMethod : public Method {
 public:
  using Spoil = std::function<void(StrokeModel&)>;
  explicit SpoiltMethod(Spoil spoil) : spoil_(std::move(spoil)) {}
  const MethodTraits& traits() const override { return traits_; }
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override {
    VisibilityResult result = find_method("auto")->compute_visibility(scene, options);
    spoil_(*result.strokes);
    return result;
  }
  MethodTraits traits_ = find_method("auto")->traits();

 private:
  Spoil spoil_;
};

/// A box behind a plate that penetrates another plate.
Scene scene() {
  Scene s;
  add_box(s, {0, 0, 0}, {4, 4, 4});
  add_face(s, {{{-1, -2, 1}, {5, -2, 1}, {5, -2, 3}, {-1, -2, 3}}});
  add_face(s, {{{1, -4, -1}, {3, -4, 5}, {3, 2, 5}, {1, 2, -1}}});
  return s;
}

Verdict judged(const SpoiltMethod& method, const char* edges = "all") {
  const Scene s = scene();
  return JudgedView(s, "spoilt", standard_views(s)[1]).judge(method, edges);
}

bool is_long(const Stroke& s) { return std::hypot(double(s.to.x) - s.from.x, double(s.to.y) - s.from.y) > 1e5; }

TEST(Judge, PassesTheDefaultMethod) {
  const SpoiltMethod good([](StrokeModel&) {});
  for (const char* edges : {"all", "feature"}) {
    const Verdict verdict = judged(good, edges);
    EXPECT_TRUE(verdict.passes()) << verdict.faults;
    EXPECT_GT(verdict.line_mm, 500);
    EXPECT_LT(verdict.undecided_mm, 0.1 * verdict.line_mm);
  }
}

TEST(Judge, FindsAMissingStroke) {
  const Verdict verdict = judged(SpoiltMethod([](StrokeModel& m) {
    const auto lost =
        std::find_if(m.strokes.begin(), m.strokes.end(), [](const Stroke& s) { return s.visible && is_long(s); });
    m.strokes.erase(lost);
  }));
  EXPECT_GT(verdict.missing.worst_mm, 0.5);
  expect_parts(verdict.faults, {"missing", "ligne draw tests/corpus/spoilt.json --direction="});
}

TEST(Judge, FindsAStrokeThatIsTooShortByThreeMicrometres) {
  const Verdict verdict = judged(SpoiltMethod([](StrokeModel& m) {
    for (Stroke& s : m.strokes) {
      if (!s.visible || !is_long(s)) continue;
      const double length = std::hypot(double(s.to.x) - s.from.x, double(s.to.y) - s.from.y),
                   part = 0.003 / m.lattice.step_mm / length;
      s.to.x -= static_cast<std::int32_t>(std::lround((s.to.x - s.from.x) * part));
      s.to.y -= static_cast<std::int32_t>(std::lround((s.to.y - s.from.y) * part));
    }
  }));
  EXPECT_GT(verdict.missing.worst_mm, 0.001);
  EXPECT_LT(verdict.missing.worst_mm, 0.004);
}

TEST(Judge, FindsHiddenStrokesThatAreDrawn) {
  const Verdict verdict = judged(SpoiltMethod([](StrokeModel& m) {
    for (Stroke& s : m.strokes) s.visible = true;  // those of the study with hidden strokes
  }));
  EXPECT_GT(verdict.drawn_hidden.worst_mm, 0.5);
}

TEST(Judge, FindsDoubledStrokes) {
  const Verdict verdict = judged(SpoiltMethod([](StrokeModel& m) {
    for (Stroke& s : m.strokes) s.needs_overlap_check = false;  // so that nobody looks for them
    m.strokes.push_back(*std::find_if(m.strokes.begin(), m.strokes.end(), is_long));
  }));
  EXPECT_GT(verdict.twice.worst_mm, 0.5);
}

TEST(Judge, FindsLostHiddenStrokes) {
  const Verdict verdict =
      judged(SpoiltMethod([](StrokeModel& m) { std::erase_if(m.strokes, [](const Stroke& s) { return !s.visible; }); }));
  EXPECT_GT(verdict.uncovered.worst_mm, 0.5);
  EXPECT_EQ(verdict.missing.length_mm, 0);
}

TEST(Judge, FindsStrokesBesideTheirPlaces) {
  const Verdict verdict = judged(SpoiltMethod([](StrokeModel& m) {
    for (Stroke& s : m.strokes) s.t_to = (s.t_from + 999 * s.t_to) / 1000;  // the points stay
  }));
  EXPECT_GT(verdict.misplaced.worst_mm, 0.05);
  EXPECT_EQ(verdict.missing.length_mm, 0);
  expect_parts(verdict.faults, {"beside its place"});
}

TEST(Judge, FindsWrongClasses) {
  const SpoiltMethod method([](StrokeModel& m) {
    for (Stroke& s : m.strokes)
      if (s.line_class == LineClass::crease) s.line_class = LineClass::outline;
  });
  EXPECT_GT(judged(method, "all").wrong_class.worst_mm, 0.5);
  EXPECT_GT(judged(method, "feature").wrong_class.worst_mm, 0.5);
}

TEST(Judge, FindsIntersectionsThatAreNone) {
  const Verdict verdict = judged(SpoiltMethod([](StrokeModel& m) {
    for (SourceEdge& x : m.intersections) x.faces = {0, 1};
  }));
  EXPECT_GT(verdict.drawn_hidden.worst_mm, 0.5);
}

TEST(Judge, SkipsWhatAMethodDoesNotPromise) {
  SpoiltMethod method([](StrokeModel&) {});
  method.traits_.penetration = false;
  EXPECT_NE(judged(method).skipped, "");
  method.traits_.penetration = true;
  method.traits_.products = kPixels;
  EXPECT_NE(judged(method).skipped, "");
}

}  // namespace
}  // namespace ligne::test
