/// The guarantees at the head of linework/clean_lines.hpp, on random lines with gaps, dangles, short bits and hidden parts.

#include "base/parallel.hpp"
#include "linework/clean_lines.hpp"
#include "stroke_builder.hpp"

namespace ligne {
namespace {

constexpr double kStep = 0.001, kPen = 0.35;
/// Widths of the pen: the longest line that any rule may remove (a dangle beside another line), the longest stroke that one
/// may add, and the reach of extend_undershoots.
constexpr double kLongestRemoval = 48, kLongestBridge = 12, kReach = 3;

CleanOptions options_for(std::uint32_t given_sources) {
  CleanOptions options;
  options.pen_mm = kPen;
  options.least_mm = 1.5 * kPen;
  options.scan_of = [given_sources](const Stroke& s) { return s.source < given_sources && s.source % 2 == 0 ? 0u : kNone; };
  options.decimated_of = options.scan_of;
  options.form_of = [given_sources](const Stroke& s) { return s.source < given_sources && s.source % 2 == 1 ? 0u : kNone; };
  options.facet_parts = {0.02};
  options.object_of = [given_sources](const Stroke& s) { return s.source < given_sources ? s.source % 3 : kNone; };
  options.is_outline = [](Point2 a, Point2 b, bool) { return glm::length(b - a) < 2 * kPen; };
  options.make_source = no_source;
  return options;
}

/// Random polylines over a page of 100 mm, some nearly straight, with gaps; dangles that leave them; lines that end just
/// before them; spurs in the ink of lines; hidden strokes in some of the gaps.
class RandomLines {
 public:
  explicit RandomLines(unsigned seed) : random_(seed) {}

  StrokeModel make() {
    StrokeModel m;
    m.lattice.step_mm = kStep;
    for (std::uint32_t line = 0; line < 24; ++line) add_line(m, line);
    const std::vector<Stroke> lines = m.strokes;
    for (std::uint32_t k = 0; k < 40; ++k) add_beside(m, lines[k * lines.size() / 40], 24 + k);
    for (std::uint32_t k = 0; k < 8; ++k) add_spur(m, lines[k * lines.size() / 8], 64 + k);
    m.edge_count = 72;
    return m;
  }

 private:
  double number(double from, double to) { return std::uniform_real_distribution(from, to)(random_); }

  void add(StrokeModel& m, Point2 from, Point2 to, std::uint32_t source, bool visible = true) {
    Stroke s =
        stroke(m.lattice.snap(from), m.lattice.snap(to), source % 5 == 4 ? LineClass::crease : LineClass::outline, source);
    s.t_from = number(0, 0.4), s.t_to = number(0.6, 1);
    s.visible = visible;
    if (s.from != s.to) m.strokes.push_back(s);
  }

  void add_line(StrokeModel& m, std::uint32_t source) {
    Point2 p{number(0, 100), number(0, 100)};
    double angle = number(0, 6.28);
    for (int k = 0; k < 8; ++k) {
      const double length = std::exp(number(-2.5, 3.3));
      const Point2 q = p + length * Point2{std::cos(angle), std::sin(angle)};
      add(m, p, q, source);
      angle += number(-0.2, 0.2);
      const Point2 after = number(0, 1) < 0.4 ? q + number(0.02, 3) * Point2{std::cos(angle), std::sin(angle)} : q;
      if (after != q && number(0, 1) < 0.5) add(m, q, after, source, false);
      p = after;
    }
  }

  /// A line that leaves the stroke, or ends before it.
  void add_beside(StrokeModel& m, const Stroke& of, std::uint32_t source) {
    const Point2 from = m.lattice.to_mm(of.from), to = m.lattice.to_mm(of.to);
    const Point2 foot = from + number(0, 1) * (to - from);
    const Point2 along = (to - from) / std::max(glm::length(to - from), 1e-9), aside{-along.y, along.x};
    const Point2 start = foot + number(0, 0.8) * aside;
    add(m, start, start + number(0.1, 6) * (number(-1, 1) * along + number(0.05, 1) * aside), source);
  }

  /// A line from the end of the stroke that its ink hides.
  void add_spur(StrokeModel& m, const Stroke& of, std::uint32_t source) {
    const Point2 from = m.lattice.to_mm(of.from), to = m.lattice.to_mm(of.to);
    const Point2 along = (to - from) / std::max(glm::length(to - from), 1e-9), aside{-along.y, along.x};
    add(m, to, to + number(0.05, 0.15) * aside, source);
  }

  std::mt19937 random_;
};

std::vector<RuleReport> clean(StrokeModel& m) {
  const CleanReport report = clean_lines(m, options_for(m.edge_count));
  EXPECT_LT(report.passes, kMostCleanPasses);
  return report.rules;
}

std::size_t changes_of(const std::vector<RuleReport>& reports) {
  return std::accumulate(reports.begin(), reports.end(), std::size_t{0},
                         [](std::size_t sum, const RuleReport& report) { return sum + report.count; });
}

constexpr unsigned kScenes = 60;

/// Calls visit(lines, the same cleaned, what the rules did) for scenes of random lines, `one_in` of them.
template <class Visit>
void for_cleaned_scenes(const Visit& visit, unsigned one_in = 1) {
  for (unsigned seed = 0; seed < kScenes; seed += one_in) {
    SCOPED_TRACE("scene " + std::to_string(seed));
    const StrokeModel given = RandomLines(seed).make();
    StrokeModel m = given;
    const std::vector<RuleReport> reports = clean(m);
    visit(given, m, reports);
  }
}

/// The ends, class and visibility of a stroke, whatever its number is.
auto shown(const Stroke& s) { return std::tuple(std::min(s.from, s.to), std::max(s.from, s.to), s.line_class, s.visible); }
auto all_shown(const std::vector<Stroke>& strokes) {
  std::vector<decltype(shown(strokes[0]))> result;
  for (const Stroke& s : strokes) result.push_back(shown(s));
  std::ranges::sort(result);
  return result;
}

TEST(CleanLines, IsIdempotent) {
  for_cleaned_scenes([](const StrokeModel&, const StrokeModel& once, const auto&) {
    StrokeModel again = once;
    for (const RuleReport& report : clean(again)) EXPECT_EQ(report.count, 0u) << report.changes;
    EXPECT_TRUE(all_shown(again.strokes) == all_shown(once.strokes));
  });
}

TEST(CleanLines, LeadsAnEndToItsOwnLineOnce) {
  // The line returns to its first part at a small angle. A line that ends at its other side makes arcs of the two.
  for (int lean = 0; lean < 100; ++lean) {
    StrokeModel m =
        sketch("outline#6 0.1,3 0.1,0.405; outline#1 " + std::to_string(lean * kStep) + ",-1 0,0.4 0.15,0.4 0.03,0.05",
               LineClass::outline, kStep);
    m.edge_count = 7;
    const CleanReport report = clean_lines(m, options_for(m.edge_count));
    EXPECT_LE(report.passes, 3) << lean;
  }
}

TEST(CleanLines, LeavesNoRingThatInkFillsAndNoFoldOfADecimatedPart) {
  const std::string ring = "#0 10,0 11.4,0 10.7,", fold = "#6 9,20 9,24; #8 9,24 9,30; ";
  for (const auto& [lines, changes] : std::map<std::string, std::size_t>{
           {ring + "0.16 10,0", 1}, {ring + "0.2 10,0", 0}, {fold + "#8 9,30 12,33", 1}, {fold + "#4 9,30 12,33", 0}}) {
    StrokeModel m = sketch("#2 0,-9 200,-9; " + lines, LineClass::outline, kStep);
    m.edge_count = 9;
    EXPECT_EQ(changes_of(clean(m)), changes) << lines;
  }
}

TEST(CleanLines, EveryRuleCountsItsChanges) {
  std::map<std::string_view, std::size_t> counts;
  std::size_t changed = 0;
  for_cleaned_scenes([&](const StrokeModel& given, const StrokeModel& m, const std::vector<RuleReport>& reports) {
    for (const RuleReport& report : reports) counts[report.changes] += report.count;
    const bool is_same = all_shown(m.strokes) == all_shown(given.strokes);
    EXPECT_EQ(changes_of(reports) == 0, is_same);
    changed += !is_same;
  });
  EXPECT_GT(changed, kScenes / 2);
  EXPECT_EQ(counts.size(), 13u);
  for (const auto& [changes, count] : counts) EXPECT_GT(count, 0u) << changes;
}

TEST(CleanLines, MovesNoEndAndAddsShortStrokes) {
  for_cleaned_scenes([](const StrokeModel& given, const StrokeModel& m, const auto&) {
    for (const Stroke& s : m.strokes) {
      if (s.source >= given.edge_count) {
        EXPECT_LE(page_length(s) * kStep, kLongestBridge * kPen);
        continue;
      }
      // Every cut of a line is rounded to a point of the lattice.
      constexpr double kRounded = 2;
      const auto lies_on = [&](const Stroke& old) {
        return old.source == s.source && foot_on(old, s.from).distance <= kRounded &&
               foot_on(old, s.to).distance <= kRounded;
      };
      EXPECT_TRUE(std::ranges::any_of(given.strokes, lies_on));
    }
  });
}

/// The longest part of a stroke, in millimetres, that no visible stroke of its source covers.
double longest_missing(const Stroke& old, const std::vector<Stroke>& strokes) {
  std::vector<std::pair<double, double>> seen{{1, 1}};  // fractions
  for (const Stroke& s : strokes) {
    if (!s.visible || s.source != old.source) continue;
    const FootPoint from = foot_on(old, s.from), to = foot_on(old, s.to);
    if (from.distance <= 2 && to.distance <= 2) seen.push_back(std::minmax({from.fraction, to.fraction}));
  }
  std::ranges::sort(seen);
  double missing = 0, covered = 0;
  for (const auto& [from, to] : seen) {
    missing = std::max(missing, from - covered);
    covered = std::max(covered, to);
  }
  return missing * page_length(old) * kStep;
}

TEST(CleanLines, RemovesNothingThatIsLong) {
  std::size_t long_strokes = 0, cut = 0;
  for_cleaned_scenes([&](const StrokeModel& given, const StrokeModel& m, const auto&) {
    for (const Stroke& old : given.strokes) {
      if (!old.visible) continue;
      const double missing = longest_missing(old, m.strokes);
      EXPECT_LE(missing, kLongestRemoval * kPen);
      long_strokes += page_length(old) * kStep > kLongestRemoval * kPen;
      cut += missing > 0.01;
    }
  });
  EXPECT_GT(long_strokes, kScenes / 4);
  EXPECT_GT(cut, kScenes);
}

/// A plain search: free ends by comparing all ends, and the line straight on from each against all strokes.
TEST(CleanLines, LeavesNoEndThatPointsAtALineWithinReach) {
  std::size_t free_ends = 0;
  for_cleaned_scenes([&](const StrokeModel&, StrokeModel& m, const auto&) {
    std::erase_if(m.strokes, [](const Stroke& s) { return !s.visible; });
    const double reach = kReach * kPen / kStep, touching = kPen / 16 / kStep;
    for (const Stroke& s : m.strokes) {
      if (page_length(s) < 3 * reach) continue;  // long enough to be led on, and to have a direction
      for (const LatticePoint p : {s.from, s.to}) {
        const auto meets = [&](const Stroke& other) { return &other != &s && foot_on(other, p).distance <= touching + 1; };
        if (std::ranges::any_of(m.strokes, meets)) continue;
        ++free_ends;
        const LatticePoint q = p == s.from ? s.to : s.from;
        const double dx = (double(p.x) - q.x) / page_length(s), dy = (double(p.y) - q.y) / page_length(s);
        const LatticePoint ahead{p.x + std::int32_t(0.98 * reach * dx), p.y + std::int32_t(0.98 * reach * dy)};
        for (const Stroke& other : m.strokes) {
          if (&other == &s) continue;
          const bool crosses = orientation(p, ahead, other.from) * orientation(p, ahead, other.to) < 0 &&
                               orientation(other.from, other.to, p) * orientation(other.from, other.to, ahead) < 0;
          EXPECT_FALSE(crosses && other.source != s.source) << "at " << p.x << ',' << p.y;
        }
      }
    }
  });
  EXPECT_GT(free_ends, kScenes);
}

TEST(CleanLines, DoesNotDependOnOrderOrThreads) {
  unsigned seed = 0;
  for_cleaned_scenes([&](const StrokeModel& given, const StrokeModel& m, const auto&) {
    StrokeModel shuffled = given;
    std::ranges::shuffle(shuffled.strokes, std::mt19937(seed++));
    clean(shuffled);
    EXPECT_TRUE(all_shown(m.strokes) == all_shown(shuffled.strokes));
  });
  const auto with_threads = [](const StrokeModel& given, std::size_t n) {
    StrokeModel m = given;
    run_with_threads(n, [&] { clean(m); });
    return all_shown(m.strokes);
  };
  for_cleaned_scenes([&](const StrokeModel& given, const auto&,
                         const auto&) { EXPECT_TRUE(with_threads(given, 1) == with_threads(given, 4)); },
                     4);
}

TEST(CleanLines, TurnsAndMirrorsWithTheDrawing) {
  for (const std::array<int, 4>& turn : {std::array{0, -1, 1, 0}, std::array{-1, 0, 0, 1}}) {
    const auto move = [&](LatticePoint p) {
      return LatticePoint{turn[0] * p.x + turn[1] * p.y, turn[2] * p.x + turn[3] * p.y};
    };
    const auto moved = [&](StrokeModel m) {
      for (Stroke& s : m.strokes) s.from = move(s.from), s.to = move(s.to);
      return m;
    };
    for_cleaned_scenes([&](const StrokeModel& given, const StrokeModel& m, const auto&) {
      StrokeModel image = moved(given);
      clean(image);
      EXPECT_TRUE(all_shown(moved(m).strokes) == all_shown(image.strokes));
    });
  }
}

}  // namespace
}  // namespace ligne
