/// Runs that do not show beside the ink of other lines, against a plain search for them.

#include "linework/map/line_groups.hpp"
#include "linework/near_part.hpp"
#include "rule_runner.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;

std::size_t remove_overdrawn(StrokeModel& m, const OverdrawLimits& limits) {
  return apply_rule(m, 0, [&](LineMap& map) { return remove_overdrawn_runs(map, limits); });
}

TEST(AddedRuns, AreNotOverdrawn) {
  for (const bool is_added : {false, true}) {
    StrokeModel m = sketch("0,0 600,0; crease 300,0 300,20", kOutline);
    m.strokes.back().is_joint = is_added;  // the rule that added it would add it again
    EXPECT_EQ(remove_overdrawn(m, {50, 17, 17}), is_added ? 0u : 1u);
  }
}

/// A plain search for the same: every bit against every line.
std::vector<Stroke> left_by_all_pairs(StrokeModel m, const OverdrawLimits& limits) {
  const LineMap map(m, is_no_mesh, {}, 100);  // a piece has the number of its stroke
  const Runs runs(map);
  const auto is_short = [&](std::uint32_t i) { return runs[runs.of(i)].length < limits.longest_mm; };
  std::vector<double> shown(m.strokes.size(), 0);
  std::vector<bool> touches(m.strokes.size(), false);
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    if (!is_short(i)) continue;
    constexpr int kPlaces = 4096;  // along the bit
    std::vector<bool> inked(kPlaces, false);
    for (std::uint32_t k = 0; k < m.strokes.size(); ++k) {
      if (is_short(k)) continue;
      const StrokePart part = part_near(m.strokes[i], m.strokes[k], limits.ink_mm);
      for (int place = 0; place < kPlaces; ++place) {
        const double at = (place + 0.5) / kPlaces;
        if (part.from <= at && at <= part.to) inked[place] = true;
      }
      if (!part.empty()) touches[runs.of(i)] = true;
    }
    shown[runs.of(i)] += page_length(m.strokes[i]) * double(std::count(inked.begin(), inked.end(), false)) / kPlaces;
  }
  std::vector<Stroke> left;
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    const std::uint32_t run = runs.of(i);
    if (!is_short(i) || !touches[run] || shown[run] >= limits.shown_mm) left.push_back(m.strokes[i]);
  }
  return left;
}

TEST(OverdrawnRunsRandom, AreThoseOfAllPairs) {
  std::mt19937 random(7);
  std::size_t dropped = 0, kept = 0;
  // A pen that is narrow, and wide, against the lines.
  for (const double ink : {5.0, 17.0, 60.0}) {
    for (int scene = 0; scene < 20; ++scene) {
      const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
      std::vector<Stroke> strokes;
      for (int i = 0; i < 60; ++i) {
        const LatticePoint p{number(0, 900), number(0, 900)};
        const int reach = i % 6 == 0 ? 500 : 30;
        const LatticePoint q{p.x + number(-reach, reach), p.y + number(-reach, reach)};
        if (p != q) strokes.push_back(stroke(p, q, i % 2 == 0 ? kOutline : kCrease));
      }
      StrokeModel m = model(strokes);
      const OverdrawLimits limits{50, ink, 17};
      const std::vector<Stroke> left = left_by_all_pairs(m, limits);
      remove_overdrawn(m, limits);
      ASSERT_EQ(m.strokes.size(), left.size()) << "ink " << ink << ", scene " << scene;
      for (std::size_t i = 0; i < left.size(); ++i) EXPECT_EQ(m.strokes[i].from, left[i].from);
      dropped += strokes.size() - left.size();
      kept += left.size();
    }
  }
  EXPECT_GT(dropped, 100u);
  EXPECT_GT(kept, 1000u);
}

}  // namespace
}  // namespace ligne
