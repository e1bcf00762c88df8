#include "linework/overlaps/coincident_strokes.hpp"
#include "geometry/segment_overlap.hpp"
#include "main/tier.hpp"
#include "stroke_builder.hpp"
#include "support/page_lines.hpp"

namespace ligne {
namespace {

/// Tolerance in lattice steps, which are millimetres here.
constexpr double kCoincidence = 2;

std::vector<Stroke> removed(std::vector<Stroke> strokes) {
  StrokeModel m = model(std::move(strokes));
  remove_coincident_strokes(m, kCoincidence);
  std::ranges::sort(m.strokes, {}, [](const Stroke& s) { return std::pair(s.source, s.t_from); });
  return std::move(m.strokes);
}

struct Expected {
  std::uint32_t source;
  LatticePoint from, to;
};
void expect(const std::vector<Stroke>& got, const std::vector<Expected>& wanted) {
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].source, wanted[i].source) << i;
    EXPECT_TRUE(got[i].from == wanted[i].from && got[i].to == wanted[i].to)
        << i << ": " << got[i].from.x << "," << got[i].from.y << " " << got[i].to.x << "," << got[i].to.y;
  }
}

constexpr LatticePoint a{0, 0}, b{1000, 0};

TEST(CoincidentStrokes, TheLoserIsCut) {
  const auto got = removed({stroke(a, b, LineClass::mesh, 0), stroke({600, 1}, {300, -1}, LineClass::outline, 1)});
  expect(got, {{0, a, {300, -1}}, {0, {600, 1}, b}, {1, {600, 1}, {300, -1}}});
  EXPECT_NEAR(got[0].t_to, 0.3, 1e-4);
  EXPECT_NEAR(got[1].t_from, 0.6, 1e-4);
  EXPECT_EQ(got[0].t_from, 0);
  EXPECT_EQ(got[1].t_to, 1);
}

TEST(CoincidentStrokes, DepthIsInterpolated) {
  const auto got =
      removed({at_depth(stroke(a, b, LineClass::mesh, 0), 10, 110), stroke(a, {500, 0}, LineClass::outline, 1)});
  expect(got, {{0, {500, 0}, b}, {1, a, {500, 0}}});
  EXPECT_FLOAT_EQ(got[0].z_from, 60);
  EXPECT_FLOAT_EQ(got[0].z_to, 110);
}

TEST(CoincidentStrokes, ParametersFollowThePerspective) {
  // An edge from (0, 0) at distance 1 to (1000, 0) at distance 4, cut at 250 and 750 and then again.
  Stroke s = stroke(a, b, LineClass::mesh, 0);
  s.w_to = 4;
  const auto page = [](double t) { return 1000 * t * 4 / ((1 - t) * 1 + t * 4); };
  for (const double fraction : {0.1, 0.25, 0.5, 0.9})
    EXPECT_NEAR(page(source_parameter(s, fraction)), 1000 * fraction, 1e-9);
  const auto got =
      removed({s, stroke({250, 0}, {400, 0}, LineClass::outline, 1), stroke({600, 0}, {750, 0}, LineClass::border, 2)});
  ASSERT_EQ(got.size(), 5u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(page(got[i].t_from), got[i].from.x, 1e-4);
    EXPECT_NEAR(page(got[i].t_to), got[i].to.x, 1e-4);
    EXPECT_NEAR(got[i].w_from, 1 + 3 * got[i].t_from, 1e-6);
    EXPECT_NEAR(got[i].w_to, 1 + 3 * got[i].t_to, 1e-6);
  }
}

TEST(CoincidentStrokes, StrokesThatLieOnNoOtherKeepTheirOrder) {
  Stroke first = stroke(a, {400, 0}, LineClass::mesh, 5), second = stroke({400, 0}, b, LineClass::mesh, 5);
  first.t_to = second.t_from = 0.4;
  first.needs_overlap_check = second.needs_overlap_check = false;
  Stroke other = stroke({0, 9}, {9, 9}, LineClass::mesh, 2);
  other.needs_overlap_check = false;
  StrokeModel m = model({second, other, first});
  remove_coincident_strokes(m, kCoincidence);
  expect(m.strokes, {{5, {400, 0}, b}, {2, {0, 9}, {9, 9}}, {5, a, {400, 0}}});
}

// These hold for any strokes: nothing is lost, nothing is drawn twice.

constexpr double kApart = 2;

double distance(Point2 p, const Stroke& s) { return test::distance_to_segment(p, {s.from.x, s.from.y}, {s.to.x, s.to.y}); }

/// Largest distance of points along `strokes` from the nearest of `cover`; of visible strokes from visible ones only.
double farthest(const std::vector<Stroke>& strokes, const std::vector<Stroke>& cover) {
  double farthest = 0;
  for (const Stroke& s : strokes) {
    constexpr int samples = 64;
    for (int i = 0; i <= samples; ++i) {
      const double f = double(i) / samples;
      const Point2 p{s.from.x + f * (s.to.x - s.from.x), s.from.y + f * (s.to.y - s.from.y)};
      double nearest = 1e300;
      for (const Stroke& c : cover)
        if (c.visible || !s.visible) nearest = std::min(nearest, distance(p, c));
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

void expect_no_overlap(const std::vector<Stroke>& strokes) {
  for (std::size_t i = 0; i < strokes.size(); ++i)
    for (std::size_t j = i + 1; j < strokes.size(); ++j) {
      if (!strokes[i].needs_overlap_check && !strokes[j].needs_overlap_check) continue;
      EXPECT_FALSE(overlap(strokes[i].from, strokes[i].to, strokes[j].from, strokes[j].to, kApart)) << i << " " << j;
    }
}

/// Strokes on a few lines of whole slopes, `jitter` steps off them, of all classes, depths and both visibilities.
std::vector<Stroke> random_strokes(std::uint32_t seed, int count, int jitter) {
  std::mt19937 random(seed);
  constexpr LatticePoint directions[] = {{1, 0}, {0, 1}, {3, 2}, {1, -4}, {-5, 3}};
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    const LatticePoint d = directions[random() % std::size(directions)];
    const int offset = 500 * int(random() % 3), from = int(random() % 500) - 250, to = from + 4 + int(random() % 120);
    const auto point = [&](int k) {
      const auto off = [&] { return jitter == 0 ? 0 : int(random() % (2 * jitter + 1)) - jitter; };
      return LatticePoint{offset + k * d.x + off(), k * d.y + off()};
    };
    Stroke s = stroke(point(from), point(to), static_cast<LineClass>(random() % kLineClassCount), std::uint32_t(i));
    if (random() % 2) std::swap(s.from, s.to);
    s.visible = random() % 3 != 0;
    s.z_from = float(random() % 40);
    s.z_to = float(random() % 40);
    strokes.push_back(s);
  }
  return strokes;
}

TEST(CoincidentStrokesRandom, StrokesOnALineKeepTheirUnion) {
  for (const int jitter : {0, 1}) {
    // A loser that gives its place to a winner which later loses to a third moves by the tolerance each time.
    const double most = jitter == 0 ? kApart : 2 * kApart;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
      StrokeModel m = model(random_strokes(seed, 60, jitter));
      const std::vector<Stroke> before = m.strokes;
      remove_coincident_strokes(m, kApart);
      EXPECT_LE(farthest(before, m.strokes), most) << "lost, jitter " << jitter << ", seed " << seed;
      EXPECT_LE(farthest(m.strokes, before), most) << "invented, jitter " << jitter << ", seed " << seed;
      expect_no_overlap(m.strokes);
    }
  }
}

TEST(CoincidentStrokesRandom, TheOrderOfTheInputDoesNotMatter) {
  std::mt19937 random(9);
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    StrokeModel m = model(random_strokes(seed, 80, 1)), shuffled = m;
    std::shuffle(shuffled.strokes.begin(), shuffled.strokes.end(), random);
    remove_coincident_strokes(m, kApart);
    remove_coincident_strokes(shuffled, kApart);
    ASSERT_EQ(m.strokes.size(), shuffled.strokes.size());
    for (std::size_t i = 0; i < m.strokes.size(); ++i)
      EXPECT_TRUE(m.strokes[i].from == shuffled.strokes[i].from && m.strokes[i].to == shuffled.strokes[i].to &&
                  m.strokes[i].source == shuffled.strokes[i].source);
  }
}

TEST(CoincidentStrokesRandom, InACrowdBesideLongStrokesNothingIsLostOrDrawnTwice) {
  // The long strokes make the cells of the page larger than the square that has all the short ones, each of them twice.
  std::mt19937 random(17);
  StrokeModel m;
  const auto place = [&](int side) { return int(random() % static_cast<unsigned>(side)); };
  for (std::uint32_t i = 0; i < 300; ++i)
    m.strokes.push_back(stroke({-10'000'000, place(20'000'000) - 10'000'000}, {10'000'000, place(20'000'000) - 10'000'000},
                               LineClass::mesh, i));
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const LatticePoint from{place(5000), place(5000)}, to{from.x + place(400) - 200, from.y + 50 + place(200)};
    m.strokes.push_back(stroke(from, to, LineClass::crease, 1000 + 2 * i));
    m.strokes.push_back(stroke(to, from, LineClass::outline, 1001 + 2 * i));
  }
  const std::vector<Stroke> before = m.strokes;
  remove_coincident_strokes(m, kApart);
  expect_no_overlap(m.strokes);
  std::vector<Stroke> some;
  for (std::size_t i = 0; i < before.size(); i += 100) some.push_back(before[i]);
  EXPECT_LE(farthest(some, m.strokes), 2 * kApart);
}

TEST(CoincidentStrokesRandom, ThousandsOnOneLineAndFromOnePointStayFast) {
  // By pairs these would be 5e9 each; the time limit of the test run tells. The first tier looks at the result alone.
  const int count = test::runs_all() ? 100000 : 10000;
  StrokeModel line, fan;
  std::mt19937 random(13);
  for (int i = 0; i < count; ++i) {
    const int from = int(random() % 20000000), to = from + 1000 + int(random() % 10000000);
    line.strokes.push_back(stroke({from, 0}, {to, 0}, LineClass::mesh, std::uint32_t(i)));
    fan.strokes.push_back(stroke({0, 0}, {200 * (i + 1), 100 * (i + 1)}, LineClass::mesh, random()));
  }
  remove_coincident_strokes(line, kApart);
  EXPECT_LT(line.strokes.size(), 1000u);
  remove_coincident_strokes(fan, kApart);
  double sum = 0;
  for (const Stroke& s : fan.strokes) sum += length(s.from, s.to);
  EXPECT_NEAR(sum, std::hypot(200.0 * count, 100.0 * count), 1e-6 * sum);
}

/// So many strokes cross in one point that they are compared in batches. The last ones reach beyond the others.
TEST(CoincidentStrokesRandom, InAStarNothingIsLostOrDrawnTwice) {
  constexpr std::uint32_t count = 6000;
  std::mt19937 random(19);
  StrokeModel m;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool is_last = i < count / 20;
    const double angle = std::numbers::pi * random() / 0x1p32, length = (is_last ? 2000 : 50) + 150 * (random() / 0x1p32);
    const auto end = [&](double r) { return LatticePoint{int(r * std::cos(angle)), int(r * std::sin(angle))}; };
    m.strokes.push_back(stroke(end(-length), end(length), LineClass::crease, i));
    m.strokes.back().visible = !is_last;
    m.strokes.back().z_from = m.strokes.back().z_to = float(random() % 1000);
  }
  StrokeModel shuffled = m;
  std::shuffle(shuffled.strokes.begin(), shuffled.strokes.end(), random);
  const std::vector<Stroke> before = m.strokes;
  remove_coincident_strokes(m, kApart);
  expect_no_overlap(m.strokes);
  // Cuts are rounded to the lattice.
  EXPECT_LE(farthest({before.begin(), before.begin() + 200}, m.strokes), 2 * kApart + 1);
  remove_coincident_strokes(shuffled, kApart);
  ASSERT_EQ(m.strokes.size(), shuffled.strokes.size());
  for (std::size_t i = 0; i < m.strokes.size(); ++i) EXPECT_EQ(m.strokes[i].source, shuffled.strokes[i].source);
}

/// Strokes on one line, each all at a depth of its own: at every place the nearest stands, whatever lies on it.
TEST(CoincidentStrokesRandom, OfThousandsOnOneLineTheNearestStands) {
  for (const LatticePoint d : {LatticePoint{1, 0}, LatticePoint{-3, 7}}) {
    constexpr int count = 6000, places = 20000;
    std::mt19937 random(21);
    std::vector<float> depths(count), nearest(places, std::numeric_limits<float>::infinity());
    for (int i = 0; i < count; ++i) depths[static_cast<std::size_t>(i)] = static_cast<float>(10 * i);
    std::shuffle(depths.begin(), depths.end(), random);
    StrokeModel m;
    const auto point = [&](int place) { return LatticePoint{100 * place * d.x, 100 * place * d.y}; };
    for (std::uint32_t i = 0; i < count; ++i) {
      const int from = int(random() % (places - 1)), to = std::min(places, from + 1 + int(random() % 3000));
      m.strokes.push_back(at_depth(stroke(point(from), point(to), LineClass::mesh, i), depths[i], depths[i]));
      if (i % 2 == 0) std::swap(m.strokes.back().from, m.strokes.back().to);
      for (auto k = static_cast<std::size_t>(from); k < static_cast<std::size_t>(to); ++k)
        nearest[k] = std::min(nearest[k], depths[i]);
    }
    remove_coincident_strokes(m, kApart);
    std::vector<float> standing(places, std::numeric_limits<float>::infinity());
    const auto place_of = [&](LatticePoint p) { return static_cast<std::size_t>(p.x / (100 * d.x)); };
    for (const Stroke& s : m.strokes) {
      const auto [from, to] = std::minmax({place_of(s.from), place_of(s.to)});
      for (std::size_t k = from; k < to; ++k) {
        EXPECT_TRUE(std::isinf(standing[k])) << "twice at " << k;
        standing[k] = s.z_from;
      }
    }
    EXPECT_EQ(standing, nearest);
  }
}

/// Short strokes that follow each other on a line, and long ones whose depths change along them, so that they go before some
/// of the short ones. Among so many others that they are searched for runs, they are decided as they are by themselves.
TEST(CoincidentStrokesRandom, AmongThousandsOnOneLineAsAmongFew) {
  constexpr int shorts = 1500, longs = 200, more = 4000, place = 1000;
  constexpr std::uint32_t few = shorts + longs;
  std::mt19937 random(22);
  const auto z = [&] { return static_cast<float>(random() % 10'000); };
  const auto any_stroke = [&](int height, std::uint32_t source) {
    const int from = place * int(random() % (shorts - 1)), to = std::min(place * shorts, from + 1 + int(random() % 900'000));
    return at_depth(stroke({from, height}, {to, height}, LineClass::mesh, source), z(), z());
  };
  StrokeModel alone;
  for (std::uint32_t i = 0; i < shorts; ++i) {
    const int from = place * int(i);
    const float depth = z() / 4;
    alone.strokes.push_back(at_depth(stroke({from, 0}, {from + place, 0}, LineClass::mesh, i), depth, depth));
  }
  for (std::uint32_t i = shorts; i < few; ++i) alone.strokes.push_back(any_stroke(0, i));
  StrokeModel together = alone;
  for (std::uint32_t i = 0; i < more; ++i) together.strokes.push_back(any_stroke(10'000, few + i));
  remove_coincident_strokes(alone, kApart);
  remove_coincident_strokes(together, kApart);
  const auto pieces = [](const StrokeModel& m) {
    std::vector<std::tuple<int, int, std::uint32_t>> found;
    for (const Stroke& s : m.strokes)
      if (s.source < few) found.emplace_back(s.from.x, s.to.x, s.source);
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_GT(pieces(alone).size(), 100u);
  EXPECT_EQ(pieces(together), pieces(alone));
}

}  // namespace
}  // namespace ligne
