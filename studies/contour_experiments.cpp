// Experiments on contours: point in contour and clipping, [Boulle1980] 3.2.2 and 3.2.3; and sorts, 3.3.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/operations/contour_clipping.hpp"
#include "studies/operations/point_in_contour.hpp"
#include "studies/operations/sorts.hpp"
#include "studies/scenes/generators.hpp"

namespace ligne::studies {
namespace {

using std::numbers::pi;

/// A contour of n corners round the origin: on a circle if `convex`, else a star with random radii.
std::vector<LatticePoint> round_contour(int n, double radius, bool convex, double begin = 0.1) {
  Chance chance(31);
  std::vector<LatticePoint> contour;
  for (int i = 0; i < n; ++i) {
    const double a = begin + 2 * pi * i / n, r = radius * (convex ? 1 : chance.uniform(0.3, 1));
    const LatticePoint p{static_cast<std::int32_t>(std::lround(r * std::cos(a))),
                         static_cast<std::int32_t>(std::lround(r * std::sin(a)))};
    if (contour.empty() || !(contour.back() == p)) contour.push_back(p);
  }
  return contour;
}

struct Way {
  const char *name, *thesis;
  bool any_contour;
  std::function<Place(LatticePoint, ContourCounts&)> ask;
};

std::string fixed(double v) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", v);
  return buffer;
}

Contour as_points(const std::vector<LatticePoint>& contour) {
  Contour out;
  for (const LatticePoint p : contour) out.emplace_back(p.x, p.y);
  return out;
}

struct Sort {
  const char* name;
  void (*sort)(std::vector<int>&, SortCounts&);
  const char *random, *sorted, *reversed, *nearly;
};
constexpr Sort kSorts[] = {
    {"quick", quick_sort<int>, "mean n log n (3.3.2 says n^2)", "n^2", "n^2", "n^2"},
    {"bubble", bubble_sort<int>, "n^2", "n", "n^2", "near n"},
    {"tree", tree_sort<int>, "n log n", "n log n", "n log n", "n log n"},
    {"Shell", shell_sort<int>, "at most n^1.5", "n", "at most n^1.5", "no figure"},
};

std::vector<int> list_of(int n, int kind) {
  std::vector<int> list(static_cast<std::size_t>(n));
  std::iota(list.begin(), list.end(), 0);
  Chance chance(41);
  if (kind == 0) {
    for (std::size_t i = list.size(); i-- > 1;) std::swap(list[i], list[std::size_t(chance.whole(0, int(i)))]);
  } else if (kind == 2) {
    std::reverse(list.begin(), list.end());
  } else if (kind == 3) {
    // Adjacent transpositions, one per hundred elements: the change of order from one scan line to the next.
    for (std::size_t i = 50; i + 1 < list.size(); i += 100) std::swap(list[i], list[i + 1]);
  }
  return list;
}

/// The tests of a point against the contour. They keep both arguments by reference.
std::vector<Way> ways_to_ask(const std::vector<LatticePoint>& contour, const Sectors& sectors) {
  return {
      {"crossings", "O(n), special cases", true,
       [&](LatticePoint p, ContourCounts& c) { return by_crossings(contour, p, c); }},
      {"angles", "O(n), arc tangents", true, [&](LatticePoint p, ContourCounts& c) { return by_angles(contour, p, c); }},
      {"half planes (Dahan, Le Tuan)", "1 to n; n inside", false,
       [&](LatticePoint p, ContourCounts& c) { return by_half_planes(contour, p, c); }},
      {"triangles (Dahan, Le Tuan)", "3 to 2 n - 3 inside, 1 to 2 n - 3 outside", false,
       [&](LatticePoint p, ContourCounts& c) { return by_triangles(contour, p, c); }},
      {"sectors by angle (Shamos)", "O(log n)", false,
       [&](LatticePoint p, ContourCounts& c) { return sectors.by_angle(p, c); }},
      {"sectors by signs", "no figure", false, [&](LatticePoint p, ContourCounts& c) { return sectors.by_signs(p, c); }},
      {"codes", "O(n), coordinates alone", true,
       [&](LatticePoint p, ContourCounts& c) { return by_codes(contour, p, false, c); }},
      {"codes, mended", "no figure", true, [&](LatticePoint p, ContourCounts& c) { return by_codes(contour, p, true, c); }},
      {"crossings, convex", "ends at the second one", false,
       [&](LatticePoint p, ContourCounts& c) { return by_crossings(contour, p, c, ContourKind::convex); }},
      {"angles, convex", "ends where the sum turns", false,
       [&](LatticePoint p, ContourCounts& c) { return by_angles(contour, p, c, ContourKind::convex); }},
      {"half planes, no orientation", "1 to n; n inside", false,
       [&](LatticePoint p, ContourCounts& c) { return by_unoriented_half_planes(contour, p, c); }},
  };
}

std::vector<LatticePoint> points_to_ask(const std::vector<LatticePoint>& contour, int n, int reach) {
  Chance chance(53);
  std::vector<LatticePoint> points;
  for (int i = 0; i < n; ++i) {
    points.push_back({chance.whole(-reach, reach), chance.whole(-reach, reach)});
    // One point in four lies on the contour: a corner, or the midpoint of a side if that is a lattice point.
    const std::size_t k = std::size_t(chance.whole(0, int(contour.size()) - 1));
    const LatticePoint a = contour[k], b = contour[(k + 1) % contour.size()];
    if (i % 4 == 0)
      points.back() =
          (a.x + b.x) % 2 == 0 && (a.y + b.y) % 2 == 0 && i % 8 == 0 ? LatticePoint{(a.x + b.x) / 2, (a.y + b.y) / 2} : a;
  }
  return points;
}

struct Answers {
  ContourCounts counts;
  std::uint64_t wrong = 0, on_contour = 0;  ///< wrong answers for points beside the contour; for points on it
  double seconds = 0;                       ///< per point
};

Answers ask_all(const Way& way, const std::vector<LatticePoint>& contour, const std::vector<LatticePoint>& points) {
  Answers answers;
  ContourCounts unused;
  for (const LatticePoint p : points) {
    const Place truth = by_crossings(contour, p, unused), found = way.ask(p, answers.counts);
    const bool on = truth == Place::on_side || truth == Place::on_corner;
    answers.on_contour += on && found != truth;
    answers.wrong += !on && found != truth;
  }
  const double seconds = seconds_each([&] {
    int inside = 0;
    for (const LatticePoint p : points) inside += way.ask(p, unused) == Place::inside;
    return inside;
  });
  answers.seconds = seconds / double(points.size());
  return answers;
}

}  // namespace

Result study_point_in_contour(const StudyRequest& request) {
  Table table{
      "Points against a contour of n corners, what one of them takes on the mean; wrong answers against the exact ones",
      {{"contour", ColumnKind::label},
       {"n", ColumnKind::label},
       {"method", ColumnKind::label},
       {"thesis", ColumnKind::source},
       {"sides", ColumnKind::measure},
       {"signs", ColumnKind::measure},
       {"comparisons", ColumnKind::measure},
       {"arc tangents", ColumnKind::measure},
       {"wrong, in and out", ColumnKind::count},
       {"of points on the contour not told", ColumnKind::count},
       {"ns", ColumnKind::time}}};
  Chart chart{"A point against a convex contour", "corners", "ns"};
  chart.logarithmic = true;
  // This radius keeps a contour of a thousand corners convex after rounding to the lattice.
  constexpr int kRadius = 1 << 22, kReach = kRadius + kRadius / 10;
  const int points = request.pick(400, 4000);
  bool logarithmic = true, exact = true;
  for (const bool convex : {true, false}) {
    for (int n = 4; n <= request.pick(64, 1024); n *= 4) {
      const std::vector<LatticePoint> contour = round_contour(n, kRadius, convex);
      const Sectors sectors(contour);
      const std::vector<Way> ways = ways_to_ask(contour, sectors);
      const std::vector<LatticePoint> asked = points_to_ask(contour, points, kReach);
      for (std::size_t w = 0; w < ways.size(); ++w) {
        const Way& way = ways[w];
        if (!convex && !way.any_contour) continue;
        const auto [counts, wrong, on_contour, seconds] = ask_all(way, contour, asked);
        const double m = points;
        if (w == 5) {
          logarithmic = logarithmic && double(counts.signs) / m <= 3 + std::log2(n);
          exact = exact && wrong + on_contour == 0;
        }
        table.rows.push_back({convex ? "convex" : "star", std::to_string(n), way.name, way.thesis, double(counts.sides) / m,
                              double(counts.signs) / m, double(counts.comparisons) / m, double(counts.angles) / m, wrong,
                              on_contour, 1e9 * seconds});
        if (convex) {
          if (chart.curves.size() <= w) chart.curves.push_back({way.name, {}});
          chart.curves[w].points.emplace_back(n, 1e9 * seconds);
        }
      }
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.charts.push_back(std::move(chart));
  result.finding = logarithmic && exact ? Finding::holds : Finding::in_part;
  result.sentence =
      "Sectors gain most from what is known of a contour, log n signs for one point, and need no arc tangent: signs alone search "
      "them, exactly. Of the two for any contour the thesis prefers angles; crossings with the half-open rule have no special "
      "cases, are exact, and are many times as fast. Early ends on convex contours spare a quarter of the sides of crossings and "
      "a sixth of those of angles; doing without an orientation takes twice the signs. Codes as printed turn round every side "
      "that passes from a domain to the opposite one, and err.";
  return result;
}

Result study_contour_clipping(const StudyRequest& request) {
  Table table{"Contours of n corners clipped by contours of n corners, both round, moved by a third of their size",
              {{"contours", ColumnKind::label},
               {"n", ColumnKind::label},
               {"method", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"signs", ColumnKind::count},
               {"crossings", ColumnKind::count},
               {"parts", ColumnKind::count},
               {"area off by, of the exact one", ColumnKind::measure},
               {"microseconds", ColumnKind::time}}};
  Chart chart{"Two convex contours", "corners", "microseconds"};
  chart.logarithmic = true;
  chart.curves = {{"side by side", {}}, {"sectors", {}}, {"any against any", {}}};
  std::vector<double> corners, signs;
  for (const bool convex : {true, false}) {
    for (int n = 4; n <= request.pick(64, 1024); n *= 4) {
      std::vector<LatticePoint> subject = round_contour(n, 1 << 20, convex), clip = round_contour(n, 1 << 20, true, 0.37);
      for (LatticePoint& p : clip) p.x += (1 << 20) / 3;
      const Contour s = as_points(subject), c = as_points(clip);
      const ContourFace fs = make_contour_face(std::span(&subject, 1)), fc = make_contour_face(std::span(&clip, 1));
      const ClipResult truth = clip_contour_by_contour(fs, fc);
      const double area = twice_area(truth.inside);
      const auto row = [&](const char* name, const char* thesis, ContourClipCounts counts, std::size_t parts, double found,
                           double seconds, std::size_t curve) {
        table.rows.push_back({convex ? "convex" : "star by convex", std::to_string(n), name, thesis, counts.signs,
                              counts.crossings, std::uint64_t{parts}, std::abs(found - area) / area, 1e6 * seconds});
        if (convex) chart.curves[curve].points.emplace_back(n, 1e6 * seconds);
      };
      ContourClipCounts by_sides;
      const Contour sides = clip_side_by_side(s, c, by_sides);
      ContourClipCounts unused;
      row("side by side (Sutherland, Hodgman)", "O(n) for one side", by_sides, 1, twice_area_of(sides),
          seconds_each([&] { return clip_side_by_side(s, c, unused).size(); }), 0);
      if (convex) {
        ContourClipCounts by_sectors;
        const Contour sectors = clip_convex(s, c, by_sectors);
        corners.push_back(n);
        signs.push_back(double(by_sectors.signs));
        row("sectors (Shamos)", "the sum of the sides", by_sectors, 1, twice_area_of(sectors),
            seconds_each([&] { return clip_convex(s, c, unused).size(); }), 1);
      }
      // The program's clip tests each side of one contour against each side of the other.
      ContourClipCounts all{std::uint64_t(subject.size()) * clip.size(), 0};
      row("any against any (Weiler, Atherton), the program's", "the product of the sides, which is optimal", all,
          truth.inside.size(), area, seconds_each([&] { return clip_contour_by_contour(fs, fc).inside.size(); }), 2);
    }
  }
  Result result;
  const double e = growth(corners[corners.size() - 2], signs[signs.size() - 2], corners.back(), signs.back());
  result.tables.push_back(std::move(table));
  result.charts.push_back(std::move(chart));
  result.finding = e < 1.2 ? Finding::holds : Finding::no_longer;
  result.sentence =
      "For convex contours sectors take what the thesis promises, the sum of the sides (n to the " + fixed(e) +
      "), and the others the product; a star falls apart, which side by side does not tell, for its parts stay one "
      "contour. The program clips faces, which have few sides, by the general one, and convex ones by codes of their corners.";
  return result;
}

Result study_sorts(const StudyRequest& request) {
  constexpr const char* kLists[] = {"random", "sorted", "reversed", "nearly sorted"};
  Table table{"Sorts: comparisons and moves",
              {{"sort", ColumnKind::label},
               {"list", ColumnKind::label},
               {"n", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"comparisons", ColumnKind::count},
               {"moves", ColumnKind::count},
               {"deepest stack", ColumnKind::count},
               {"growth", ColumnKind::measure},
               {"microseconds", ColumnKind::time}}};
  Chart chart{"Comparisons on nearly sorted lists", "n", "comparisons"};
  chart.logarithmic = true;
  double quick_sorted = 0, bubble_nearly = 0;
  for (const Sort& sort : kSorts) {
    chart.curves.push_back({sort.name, {}});
    for (int kind = 0; kind < 4; ++kind) {
      const char* const thesis = kind == 0 ? sort.random : kind == 1 ? sort.sorted : kind == 2 ? sort.reversed : sort.nearly;
      double before = 0;
      for (int n = 100; n <= request.pick(400, 6400); n *= 4) {
        const std::vector<int> list = list_of(n, kind);
        std::vector<int> sorted = list;
        SortCounts counts;
        sort.sort(sorted, counts);
        SortCounts unused;
        const double seconds = seconds_each([&] {
          std::vector<int> again = list;
          sort.sort(again, unused);
          return again.front();
        });
        std::optional<double> grown;
        if (before > 0) grown = growth(n / 4.0, before, n, double(counts.comparisons));
        before = double(counts.comparisons);
        if (kind == 3) chart.curves.back().points.emplace_back(n, before);
        if (kind == 1 && sort.sort == kSorts[0].sort && grown) quick_sorted = *grown;
        if (kind == 3 && sort.sort == kSorts[1].sort && grown) bubble_nearly = *grown;
        table.rows.push_back({sort.name, kLists[kind], std::to_string(n), thesis, counts.comparisons, counts.moves,
                              counts.deepest, grown ? Cell(*grown) : Cell(), 1e6 * seconds});
      }
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.charts.push_back(std::move(chart));
  result.finding = quick_sorted < 1.5 && bubble_nearly < 1.2 ? Finding::in_part : Finding::no_longer;
  result.sentence =
      "Bubble is linear on lists that are nearly sorted, which is what scan lines have, and square elsewhere; but the quick sort "
      "printed in the thesis takes the middle for its pivot, and sorted lists, said to be its worst, are its best.";
  return result;
}

}  // namespace ligne::studies
