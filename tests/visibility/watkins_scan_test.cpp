// The scan by lines: lines passed over give the spans that a study would; what is recognised as no change; groups of lines;
// the classical precision.

#include "main/tier.hpp"
#include "support/line_scans.hpp"
#include "visibility/methods.hpp"

namespace ligne::watkins {
namespace {

using namespace ligne::test;

double length(const std::vector<Span>& spans) {
  double sum = 0;
  for (const Span& s : spans) sum += s.x_to - s.x_from;
  return sum;
}

/// Length on all lines on which the two say different faces, in mm.
double difference(const std::vector<Span>& a, const std::vector<Span>& b) {
  double common = 0;
  std::size_t k = 0;
  for (const Span& s : a) {
    while (k < b.size() && (b[k].line < s.line || (b[k].line == s.line && b[k].x_to <= s.x_from))) ++k;
    for (std::size_t i = k; i < b.size() && b[i].line == s.line && b[i].x_from < s.x_to; ++i)
      if (b[i].face == s.face) common += std::min(s.x_to, b[i].x_to) - std::max(s.x_from, b[i].x_from);
  }
  return length(a) + length(b) - 2 * common;
}

/// [Boulle1980] proposes to pass over changes among hidden elements and never tested it. Here: the spans are those of a
/// study of every line.
/// Holds for all scenes that are not large, also along an axis, where vertices, edges and lines of intersection lie on
/// each other and are horizontal.
TEST(WatkinsScan, LinesPassedOverHaveTheSpansOfAStudyOnAllScenes) {
  constexpr std::uintmax_t kMostBytes = 20'000;
  constexpr double kSameShare =
      1e-6;  // of the length of all spans: ends that follow an edge are off by the roundings of its accumulator
  constexpr double kAccuracyMm = 1e-3;  // scenes seen edge on are no wider
  std::size_t scenes = 0;
  for (const std::filesystem::path& file : corpus_files(kMostBytes)) {
    const std::string name = file.stem().string();
    const Scene scene = corpus_scene(name);
    for (const Point3 direction : chosen(
             "scan lines, " + name, 4, {Point3{-0.31, 0.87, -0.39}, Point3{0, 1, 0}, Point3{-1, 1, -1}, Point3{0, 0, -1}})) {
      SCOPED_TRACE(name + " along " + std::to_string(direction.x) + ' ' + std::to_string(direction.y));
      const PreparedScan p(scene, along(direction));
      for (const std::uint32_t lines : {256u, 1000u}) {
        const LineStudyResult every = p.study(lines, kEveryLine), coherent = p.study(lines, kCoherent),
                              recognising = p.study(lines, kRecognising);
        EXPECT_EQ(every.scan.studied, every.scan.lines);
        EXPECT_LE(coherent.scan.studied, every.scan.studied);
        EXPECT_LE(recognising.scan.studied, coherent.scan.studied);
        EXPECT_LE(difference(every.spans, coherent.spans), kSameShare * length(every.spans) + kAccuracyMm) << lines;
        EXPECT_LE(difference(every.spans, recognising.spans), kSameShare * length(every.spans) + kAccuracyMm) << lines;
      }
    }
    ++scenes;
  }
  EXPECT_GT(scenes, 100u);
}

/// Figure 2.59: three faces where points and exchanges alter nothing, seen along the sight of the figure (the sheets face
/// the viewer).
TEST(WatkinsScan, HiddenChangesAreRecognised) {
  for (const auto& [name, at_most] :
       {std::pair("thesis_2_59a", 2), std::pair("thesis_2_59b", 5), std::pair("thesis_2_59c", 4)}) {
    const PreparedScan p(corpus_scene(name), along({0, 1, 0}));
    const LineStudyResult coherent = p.study(2000, kCoherent), recognising = p.study(2000, kRecognising);
    EXPECT_LT(recognising.scan.studied, coherent.scan.studied) << name;
    EXPECT_LE(recognising.scan.studied, static_cast<std::uint64_t>(at_most)) << name;
    EXPECT_GT(recognising.scan.passed_chains + recognising.scan.passed_points + recognising.scan.passed_exchanges, 0u)
        << name;
  }
}

/// Groups of any size put together give what one group gives: a seam leaves no trace.
TEST(WatkinsScan, GroupsLeaveNoSeam) {
  const PreparedScan p(corpus_scene("bricks"), kOdd);
  const LineStudyResult whole = p.study(600, kRecognising);
  // Where edges run along each other a carried span may end at the one or the other: they are the same place within 2^-20 of
  // a line.
  const double same = 2 * 0x1p-20 * (210.0 / 600) * static_cast<double>(whole.spans.size());
  OpenParts open;
  for (const std::uint32_t group : {1u, 7u, 100u, 599u}) {
    const LineStudyResult parts = p.study(600, kRecognising, group);
    EXPECT_LT(difference(whole.spans, parts.spans), same) << group;
    if (group == 1) continue;  // one line has no line before it to tell what lies between the two
    for (std::size_t i = 0; i < p.lines.size(); ++i) {
      const std::vector<LinePart> expected = whole.found.visible_parts(i, open);
      const std::vector<LinePart>& found = parts.found.visible_parts(i, open);
      ASSERT_EQ(found.size(), expected.size()) << group << " line " << i;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k].from, expected[k].from, 1e-9);
        EXPECT_NEAR(found[k].to, expected[k].to, 1e-9);
      }
    }
  }
}

/// Spans are the same whether or not the lines of intersection are to be drawn: the scan needs them to know where faces come
/// out of each other.
TEST(WatkinsScan, IntersectionsAreKnownAlsoWhenNobodyDrawsThem) {
  for (const char* name :
       {"cross_of_plates", "two_triangular_prisms_penetrating", "three_plates_penetrating", "thesis_2_81c"}) {
    const Scene scene = corpus_scene(name);
    for (const bool by_lines : {true, false}) {
      VisibilityOptions options;
      if (by_lines) {
        options.settings.set("lines", 700u);
      } else {
        options.span_lines = SpanLines{0.15, 0.3, 700};
      }
      const auto draw = [&](const char* edges) {
        return watkins_method().compute_visibility(project_on_a4(scene, kOdd, edges), options);
      };
      const VisibilityResult with = draw("feature"), without = draw("outline border crease");
      EXPECT_LT(difference(with.spans->spans, without.spans->spans), 1e-6 * length(with.spans->spans)) << name << by_lines;
      EXPECT_TRUE(without.strokes->intersections.empty()) << name;
      for (const Stroke& s : without.strokes->strokes) EXPECT_NE(s.line_class, LineClass::intersection) << name;
    }
  }
}

/// On whole coordinates the spans end on whole columns, and are the same picture but for a column.
TEST(WatkinsScan, WholeNumbers) {
  const PreparedScan p(corpus_scene("stair"), kOdd);
  const LineStudyResult real = p.study(400, kEveryLine), whole = p.study(400, kEveryLine, 0, true);
  const double column = 210.0 / 400;
  EXPECT_LT(difference(real.spans, whole.spans), 2 * column * static_cast<double>(real.spans.size()));
  for (const Span& s : whole.spans) {
    ASSERT_NEAR(s.x_from / column, std::round(s.x_from / column), 1e-3);
    ASSERT_NEAR(s.x_to / column, std::round(s.x_to / column), 1e-3);
  }
}

/// A plate whose upper rim is horizontal, and one that lies between two lines as a whole: neither loses a line.
TEST(WatkinsScan, HorizontalAndFlatEdgesAreDrawn) {
  Scene scene = scene_of_faces(
      {{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}}, {{12, 0, 5}, {20, 0, 5.001}, {20, 0, 5.002}, {12, 0, 5.003}}});
  finish(scene);
  const PreparedScan p(scene, along({0, 1, 0}));
  const LineStudyResult r = p.study(64, kRecognising);
  OpenParts open;
  for (std::size_t i = 0; i < p.lines.size(); ++i) EXPECT_EQ(r.found.visible_parts(i, open).size(), 1u) << i;
}

// How many lines a scan by lines studies: as many as there are changes that can be seen, however many lines there are. And
// who is in front where faces touch, which is what keeps it so.

std::uint64_t studied(const PreparedScan& p, std::uint32_t lines) { return p.study(lines, kRecognising).scan.studied; }

/// On every scene without penetration, faces that touch, coincide, lie on each other or not. Changes at one height but for a
/// step of the lattice fall on one line or on two.
TEST(WatkinsStudies, TwiceTheLinesAreNoMoreStudiesOnAllScenes) {
  constexpr std::uintmax_t kMostBytes = 20'000;
  constexpr std::uint32_t kLines = 1u << 16;
  std::size_t scenes = 0;
  for (const std::filesystem::path& file : chosen("studies of scan lines", 3, corpus_files(kMostBytes))) {
    const std::string name = file.stem().string();
    const PreparedScan p(corpus_scene(name), kOdd);
    if (p.lines.size() > p.projected.edges.size()) continue;
    const std::uint64_t once = studied(p, kLines), twice = studied(p, 2 * kLines);
    EXPECT_NEAR(double(once), double(twice), 2) << name;
    ++scenes;
  }
  EXPECT_GT(scenes, runs_all() ? 80u : 25u);
}

/// In a city with its digits rounded faces touch within the digits of the file, and their depths change places from
/// line to line.
TEST(WatkinsStudies, FacesThatTouchAreNoChanges) {
  const std::filesystem::path file = std::filesystem::path(LIGNE_MODELS_DIR) / "CITY.ASC";
  if (!std::filesystem::exists(LIGNE_MODELS_DIR)) GTEST_SKIP() << "shared models are absent";
  const PreparedScan p(scene_of_file(file), CameraRequest{});
  const std::uint64_t many = studied(p, 32000);
  EXPECT_LT(many, 600u);
  EXPECT_NEAR(double(studied(p, 16000)), double(many), 0.02 * double(many));
  EXPECT_NEAR(double(studied(p, 8000)), double(many), 0.05 * double(many));
}

/// Penetrations of which no edge of the scene tells: they are followed from study to study.
TEST(WatkinsStudies, PenetrationsWithoutAnEdgeAreCarriedOn) {
  for (const char* name : {"two_plates_penetrating", "cross_of_plates", "grazing_plates"}) {
    PreparedScan p(corpus_scene(name), kOdd);
    p.lines.resize(p.projected.edges.size());
    const LineStudyResult r = p.study(4096, kRecognising);
    EXPECT_LT(r.scan.studied, 60u) << name;
    EXPECT_EQ(p.study(8192, kRecognising).scan.studied, r.scan.studied) << name;
  }
}

}  // namespace
}  // namespace ligne::watkins
