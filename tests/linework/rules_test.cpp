/// The rules of cleaning, on strokes in words (values/*.txt): gaps that are bridged, ends that are led on, bits, flecks,
/// spurs and overdrawn runs that go, runs that become those of their line, and strokes that lie on others.

#include "linework/rules/rules.hpp"
#include "base/no_index.hpp"
#include "drawing/drawing.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "main/script.hpp"
#include "stroke_builder.hpp"

namespace ligne {
namespace {

using Change = std::function<std::size_t(StrokeModel&)>;

/// Strokes of one body have sources below 100, those of edges sources below 1000.
constexpr std::uint32_t kSourcesOfBody = 100, kEdges = 1000;

struct RuleOfText {
  LineClass usual;
  double step_mm;
  Change change;
};

StrokeModel strokes_of(const RuleOfText& rule, const std::string& text) {
  StrokeModel m = sketch(text, rule.usual, rule.step_mm);
  m.edge_count = kEdges;
  return m;
}

/// "outline#1 0,0 300,0 320,5; hidden crease#0 0,9 9,9".
std::string as_words(const StrokeModel& m) {
  std::string text;
  const Stroke* before = nullptr;
  for (const Stroke& s : m.strokes) {
    const auto point = [&](LatticePoint p) {
      const Point2 mm = m.lattice.to_mm(p);
      return " " + test::as_text(std::round(mm.x * 1000) / 1000) + "," + test::as_text(std::round(mm.y * 1000) / 1000);
    };
    const bool goes_on = before && before->to == s.from && before->source == s.source &&
                         before->line_class == s.line_class && before->visible == s.visible;
    if (!goes_on)
      text += (before ? "; " : "") + std::string(s.visible ? "" : "hidden ") +
              std::string(kLineClassNames[static_cast<std::size_t>(s.line_class)]) + "#" + std::to_string(s.source) +
              point(s.from);
    text += point(s.to);
    before = &s;
  }
  return text;
}

/// The strokes behind the rule: "2: STROKES" after two changes, "0" where it changes nothing.
std::string changed(const RuleOfText& rule, const std::string& text) {
  StrokeModel m = strokes_of(rule, text);
  const std::string before = as_words(m);
  const std::size_t changes = rule.change(m);
  const auto made = [](const Stroke& s) { return s.source >= kEdges; };
  EXPECT_EQ(m.intersections.size(), std::size_t(std::ranges::count_if(m.strokes, made))) << "sources of their own";
  const std::string after = as_words(m);
  return changes == 0 && after == before ? "0" : std::to_string(changes) + ": " + after;
}

/// How many lines the layers of the drawing have then.
std::string lines_drawn(const RuleOfText& rule, const std::string& text) {
  StrokeModel m = strokes_of(rule, text);
  rule.change(m);
  std::string counts;
  for (const auto& layer : make_drawing(m).layers)
    counts += (counts.empty() ? "" : " ") + std::to_string(layer.lines.size());
  return counts;
}

template <class Rule>
Change applying(double reach_mm, const Rule& rule, double ink_mm = 0) {
  return [=](StrokeModel& m) { return apply_rule(m, reach_mm, rule, ink_mm); };
}

Change bridging(double reach_mm, double far_mm, double clear_mm) {
  const GapLimits limits{reach_mm, far_mm, clear_mm};
  return applying(
      0, [=](LineMap& map) { return bridge_gaps(map, limits, no_source); }, clear_mm);
}

/// Outlines along the x axis are known within 90 steps of it.
const Change close = applying(
    0,
    [](LineMap& map) {
      const auto is_outline = [](Point2 a, Point2 b, bool along) {
        return std::max(std::abs(a.y), std::abs(b.y)) <= (along ? 20 : 90);
      };
      return close_outlines(map, {0, 900, 50}, is_outline, no_source);
    },
    50);

const Change lead_on = applying(
    1, [](LineMap& map) { return extend_undershoots(map, {.longest_mm = 40, .touching_mm = 1}, no_source); }, 1);

/// Every source runs from x = 0 to x = 100, so that what is shorter was cut off by visibility.
Change dropping_bits(double least_mm) {
  return [=](StrokeModel& m) {
    for (Stroke& s : m.strokes) {
      s.t_from = m.lattice.to_mm(s.from).x / 100;
      s.t_to = m.lattice.to_mm(s.to).x / 100;
    }
    return apply_rule(m, 0, [&](LineMap& map) { return remove_short_bits(map, least_mm); });
  };
}

std::uint32_t body_of(const Stroke& s) { return s.source < kSourcesOfBody ? 0u : kNone; }

Change dropping_flecks(const IsolatedLimits& limits, double touching_mm) {
  return applying(touching_mm, [=](LineMap& map) { return remove_isolated_chains(map, body_of, limits); });
}

Change dropping_spurs(const DangleLimits& limits) {
  return applying(limits.touching_mm, [=](LineMap& map) { return prune_dangles(map, body_of, limits); });
}

Change dropping_spurs_and_flecks(const DangleLimits& spurs, const IsolatedLimits& flecks) {
  return [=](StrokeModel& m) { return dropping_spurs(spurs)(m) + dropping_flecks(flecks, spurs.touching_mm)(m); };
}

/// Facets are a hundredth of the body long.
constexpr std::array kParts{0.01};

const Change cut_ends = applying(
    0.35, [](LineMap& map) { return cut_overshoots(map, {.longest_mm = 4, .touching_mm = 0.02}); }, 0.35);

const Change merge_runs = applying(0, [](LineMap& map) { return merge_short_runs(map, 50); });

/// Lines along the edges of scans, which have source 1.
std::size_t smooth_scan(StrokeModel& m) {
  return smooth_lines(m, [](const Stroke& s) { return s.source == 1; });
}

/// A pen of 17 steps.
const Change drop_overdrawn = applying(0, [](LineMap& map) { return remove_overdrawn_runs(map, {50, 17, 17}); });

/// Within two steps; what is left by its sources.
std::size_t drop_coincident(StrokeModel& m) {
  const std::size_t before = m.strokes.size();
  remove_coincident_strokes(m, 2);
  std::ranges::sort(m.strokes, {}, [](const Stroke& s) { return std::pair(s.source, s.t_from); });
  return before - std::min(before, m.strokes.size());
}

const std::map<std::string, RuleOfText> kRules = {
    {"bridge", {LineClass::crease, 1, bridging(100, 250, 50)}},
    {"bridge-far", {LineClass::crease, 1, bridging(100, 900, 50)}},
    {"bridge-wide", {LineClass::crease, 1, bridging(1000, 2500, 500)}},
    {"close", {LineClass::outline, 1, close}},
    {"lead-on", {LineClass::outline, 1, lead_on}},
    {"bits-of-0.5", {LineClass::crease, 0.001, dropping_bits(0.5)}},
    {"bits-of-0.7", {LineClass::crease, 0.001, dropping_bits(0.7)}},
    {"bits-of-200", {LineClass::crease, 0.001, dropping_bits(200)}},
    {"flecks", {LineClass::outline, 0.001, dropping_flecks({.longest_mm = 2, .body_part = 1.0 / 48}, 0.1)}},
    {"flecks-and-rings", {LineClass::outline, 0.001, dropping_flecks({2, 1.0 / 48, 0.1, 2}, 0.1)}},
    {"spurs",
     {LineClass::outline, 0.001,
      dropping_spurs({.longest_mm = 4, .body_part = 1.0 / 32, .beside_mm = 1, .beside_times = 4, .touching_mm = 0.2})}},
    {"spurs-of-facets",
     {LineClass::outline, 0.001,
      dropping_spurs_and_flecks({.longest_mm = 12, .body_part = 2, .touching_mm = 0.2, .factors = kParts},
                                {.longest_mm = 12, .body_part = 1, .factors = kParts})}},
    {"spurs-of-folds",
     {LineClass::outline, 0.001,
      dropping_spurs_and_flecks({.longest_mm = 12, .body_part = 1, .touching_mm = 0.2, .most_sources = 2},
                                {.longest_mm = 12, .body_part = 1, .most_sources = 2})}},
    {"spurs-and-flecks",
     {LineClass::outline, 0.001,
      dropping_spurs_and_flecks(
          {.longest_mm = 4.2, .body_part = 1.0 / 32, .beside_mm = 0.875, .beside_times = 4, .touching_mm = 0.35},
          {.longest_mm = 2.8, .body_part = 1.0 / 48})}},
    {"overshoots", {LineClass::outline, 0.001, cut_ends}},
    {"merge", {LineClass::outline, 1, merge_runs}},
    {"smooth", {LineClass::crease, 1, smooth_scan}},
    {"overdrawn", {LineClass::outline, 1, drop_overdrawn}},
    {"coincident", {LineClass::mesh, 1, drop_coincident}}};

test::TextFunctions functions() {
  test::TextFunctions functions;
  for (const auto& entry : kRules) {
    const RuleOfText& rule = entry.second;
    functions[entry.first] = [&rule](const std::string& text) { return changed(rule, text); };
    functions[entry.first + "-lines"] = [&rule](const std::string& text) { return lines_drawn(rule, text); };
  }
  return functions;
}

[[maybe_unused]] const bool values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/linework/values", functions());

}  // namespace
}  // namespace ligne
