// Costs of Warnock's functions, [Boulle1980] 2.2.3.2 and 2.2.3.4: the classical modules, with tests counted window by window
// and compared with the bounds of the source.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "studies/experiments.hpp"
#include "studies/scenes/generators.hpp"
#include "view/tolerances.hpp"
#include "visibility/warnock/faces.hpp"
#include "visibility/warnock/initial_window.hpp"

namespace ligne::studies {
namespace {

using namespace warnock;

/// Surrounders that a window may have in front of everything else.
enum class CoverRule : std::uint8_t {
  one,            ///< a single one; two that cross are divided
  two,            ///< two that cross; an intersector lies behind the farther of both at every corner, as in the source
  two_by_nearer,  ///< an intersector lies behind the nearer of both, also where their line of intersection leaves the corner
                  ///< box
};
constexpr std::array<std::uint64_t, 3> kDepthsWithTwo{0, 12, 16};

/// Knowledge about the scene, and cases that are recognised in windows.
struct WindowRules {
  bool apart = false;  ///< no faces penetrate, so one depth of each decides
  CoverRule covers = CoverRule::two;
};

/// Counts over all windows, and the bounds of the source for these windows.
struct WindowCosts {
  std::uint64_t windows = 0;
  std::uint64_t side_tests = 0, side_least = 0, side_most = 0;  ///< POS
  std::uint64_t surrounders = 0, cover_depths = 0;              ///< PRO between surrounders
  std::uint64_t comparisons = 0, comparisons_most = 0;          ///< of two depths of surrounders; 4 (E - 1)
  std::uint64_t intersectors = 0, depths = 0;                   ///< PRO of intersectors and the cover
  std::uint64_t depths_most = 0;
  std::uint64_t crossed_windows = 0;  ///< windows with two covers that penetrate; below: PRO of their intersectors
  std::uint64_t crossed_intersectors = 0, crossed_depths = 0, crossed_most = 0;

  bool keep_bounds(bool apart) const {
    return side_least <= side_tests && side_tests <= side_most && cover_depths <= (apart ? 1 : 4) * surrounders &&
           depths <= depths_most && crossed_depths <= crossed_most;
  }
};

/// Warnock's method as the source describes it. It does not search for points where a face is in front of another's plane.
/// It divides a window unless the window is empty or everything lies behind its covers.
class ClassicalWindows {
 public:
  ClassicalWindows(const FaceTable& table, double limit, WindowRules rules) : table_(table), limit_(limit), rules_(rules) {}

  WindowCosts study(const Window& window) {
    std::vector<std::uint32_t> all = table_.by_depth;
    study(window, {}, all);
    return costs_;
  }

 private:
  enum class Place : std::uint8_t { disjoint, intersector, surrounder };
  using Depths = std::array<double, 4>;  ///< at the corners of a window; all equal if only one was computed

  struct Cover {
    std::uint32_t face;
    Depths depths;
  };

  Place place_of(const Face& face, const Window& window) {
    const auto sides = table_.sides_of(face);
    costs_.side_most += 2 * sides.size();
    for (const Side& s : sides) {
      ++costs_.side_tests;
      if (!meets(table_.at(s.v0), table_.at(s.v1), window)) continue;
      costs_.side_most -= 1;
      costs_.side_least += 1;
      return Place::intersector;
    }
    costs_.side_least += 2 * sides.size();
    int turns = 0;
    for (const Side& s : sides) {
      ++costs_.side_tests;
      turns += winding(table_.at(s.v0), table_.at(s.v1), {window.u0, window.v0});
    }
    return turns != 0 ? Place::surrounder : Place::disjoint;
  }

  /// Corners of a window, in the order of its contour.
  static std::array<FramePoint, 4> corners_of(const Window& w) {
    return {FramePoint{w.u0, w.v0}, {w.u1, w.v0}, {w.u1, w.v1}, {w.u0, w.v1}};
  }

  /// Depths at the four corners of a window, or at one corner if no faces penetrate.
  Depths depths_of(const Face& face, const Window& w, std::uint64_t& count) const {
    Depths depths{};
    count += rules_.apart ? 1 : 4;
    const auto corners = corners_of(w);
    for (std::size_t k = 0; k < 4; ++k) {
      const FramePoint p = corners[rules_.apart ? 0 : k];
      depths[k] = face.z(p.u, p.v);
    }
    return depths;
  }

  /// Bit 1: a is nearer somewhere; bit 2: farther. Ends as soon as both are known.
  int order_of(const Depths& a, const Depths& b) {
    int order = 0;
    for (std::size_t k = 0; k < (rules_.apart ? 1 : 4) && order != 3; ++k) {
      ++costs_.comparisons;
      order |= a[k] < b[k] ? 1 : a[k] > b[k] ? 2 : 0;
    }
    return order;
  }

  /// The surrounders that no other one hides: one in front of all others, or several that cross. `surrounders` keeps these.
  std::vector<Cover> covers_of(std::vector<std::uint32_t>& surrounders, const Window& window) {
    std::vector<Cover> covers;
    if (!surrounders.empty()) costs_.comparisons_most += (rules_.apart ? 1 : 4) * (surrounders.size() - 1);
    for (std::size_t i = 0; i < surrounders.size(); ++i) {
      const Cover next{surrounders[i], depths_of(table_.faces[surrounders[i]], window, costs_.cover_depths)};
      bool hidden = false;
      std::erase_if(covers, [&](const Cover& cover) {
        if (hidden) return false;
        const int order = order_of(next.depths, cover.depths);
        hidden = (order & 1) == 0;
        return order == 1;
      });
      if (!hidden) covers.push_back(next);
      // The only failure of this step. Those that were not compared stay in the list.
      if (covers.size() > 2) return covers;
    }
    surrounders.clear();
    for (const Cover& cover : covers) surrounders.push_back(cover.face);
    return covers;
  }

  /// True if an intersector lies behind the cover over the common part of window and bounding box (figure 2.17).
  bool is_behind(const Face& face, const Face& cover, const Window& window) {
    const Window common = window.common(face.box);
    const Depths near = depths_of(cover, common, costs_.depths), far = depths_of(face, common, costs_.depths);
    return std::ranges::equal(near, far, std::less_equal{});
  }

  /// True if an intersector lies behind two covers that cross (figure 2.18). If it is behind the farther one at the corners
  /// it is behind both everywhere. It is behind the nearer one everywhere if it is so at the corners and at the ends of the
  /// line in which the covers cross: there alone the nearer depth bends, away from the viewer.
  bool is_behind_both(const Face& face, const Face& a, const Face& b, const Window& window) {
    const Window common = window.common(face.box);
    std::uint64_t& count = costs_.crossed_depths;
    const Depths za = depths_of(a, common, count), zb = depths_of(b, common, count), z = depths_of(face, common, count);
    bool by_farther = true, by_nearer = true;
    for (std::size_t k = 0; k < 4; ++k) {
      by_farther = by_farther && z[k] >= std::max(za[k], zb[k]);
      by_nearer = by_nearer && z[k] >= std::min(za[k], zb[k]);
    }
    if (by_farther || !by_nearer || rules_.covers == CoverRule::two) return by_farther;
    const auto corners = corners_of(common);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      const double from = za[k] - zb[k], to = za[next] - zb[next];
      if (from * to >= 0) continue;
      const double t = from / (from - to);
      const double u = corners[k].u + t * (corners[next].u - corners[k].u);
      const double v = corners[k].v + t * (corners[next].v - corners[k].v);
      count += 2;
      if (face.z(u, v) < a.z(u, v)) return false;
    }
    return true;
  }

  /// Whether everything lies behind the covers. Ends with the first intersector that does not.
  bool is_understood(const std::vector<Cover>& covers, const std::vector<std::uint32_t>& intersectors,
                     const Window& window) {
    if (covers.size() == 1) {
      return std::ranges::all_of(
          intersectors, [&](std::uint32_t f) { return is_behind(table_.faces[f], table_.faces[covers[0].face], window); });
    }
    if (covers.size() != 2) return false;
    ++costs_.crossed_windows;
    if (rules_.covers == CoverRule::one) return false;
    costs_.crossed_intersectors += intersectors.size();
    costs_.crossed_most += kDepthsWithTwo[static_cast<std::size_t>(rules_.covers)] * intersectors.size();
    return std::ranges::all_of(intersectors, [&](std::uint32_t f) {
      return is_behind_both(table_.faces[f], table_.faces[covers[0].face], table_.faces[covers[1].face], window);
    });
  }

  void study(const Window& window, std::vector<std::uint32_t> surrounders, const std::vector<std::uint32_t>& open) {
    ++costs_.windows;
    std::vector<std::uint32_t> intersectors;
    for (const std::uint32_t f : open) {
      const Place place = place_of(table_.faces[f], window);
      if (place == Place::surrounder) surrounders.push_back(f);
      if (place == Place::intersector) intersectors.push_back(f);
    }
    costs_.surrounders += surrounders.size();
    costs_.intersectors += intersectors.size();
    costs_.depths_most += (rules_.apart ? 2 : 8) * intersectors.size();
    if (intersectors.empty() && surrounders.empty()) return;
    const std::vector<Cover> covers = covers_of(surrounders, window);
    if (is_understood(covers, intersectors, window) || window.longer_side() <= limit_) return;
    const double u = std::floor((window.u0 + window.u1) / 2), v = std::floor((window.v0 + window.v1) / 2);
    for (const Window& child : {Window{window.u0, u, window.v0, v}, Window{u, window.u1, window.v0, v},
                                Window{window.u0, u, v, window.v1}, Window{u, window.u1, v, window.v1}})
      study(child, surrounders, intersectors);
  }

  const FaceTable& table_;
  double limit_;
  WindowRules rules_;
  WindowCosts costs_;
};

/// The costs of all windows below a part of the bounding square of the scene: all of it, or `part` round its middle.
WindowCosts classical_costs(const ProjectedScene& scene, unsigned resolution, WindowRules rules, double part = 1) {
  const InitialWindow first = initial_window(scene, WindowChoice::bounding);
  const double step = scene.lattice.step_mm, longer = std::max(scene.view.window.width(), scene.view.window.height());
  const Facets facets = make_facets(scene, coincidence_mm(scene) / step);
  const FaceTable table = make_faces(scene, facets.facets, first.frame);
  const double limit = std::ceil(longer / resolution / step * first.frame.unit());
  return ClassicalWindows(table, limit, rules)
      .study(first.window.grown(-std::floor((1 - part) / 2 * first.window.longer_side())));
}

/// Two plates that cross in the line x = 50 at depth 5, and a square behind that line at the given depth.
Scene crossing_plates(double depth) {
  Scene scene;
  add_plate(scene, {0, 100}, {0, 100}, {0, 10});
  add_plate(scene, {0, 100}, {0, 100}, {10, 0});
  add_plate(scene, {40, 60}, {40, 60}, {depth, depth});
  return scene;
}

/// Adds a row for each way to treat two covers, and tells whether all keep their bounds. The farther depth of two covers
/// understands no window that the nearer one does not, so its windows are at least as many.
bool add_crossing_rows(const std::string& name, const ProjectedScene& scene, unsigned resolution, double part,
                       Table& table) {
  bool holds = true;
  std::uint64_t before = ~std::uint64_t{0};
  for (const CoverRule covers : {CoverRule::one, CoverRule::two, CoverRule::two_by_nearer}) {
    const WindowCosts c = classical_costs(scene, resolution, {false, covers}, part);
    holds = holds && c.keep_bounds(false) && c.windows <= before;
    before = c.windows;
    constexpr const char* kWays[] = {"divided", "the farther depth", "the nearer depth"};
    const auto way = static_cast<std::size_t>(covers);
    table.rows.push_back({name, kWays[way], covers == CoverRule::two ? "12 an intersector" : std::string(kNoFigure),
                          c.windows, c.crossed_windows, c.surrounders, c.cover_depths, 4 * c.surrounders, c.comparisons,
                          c.comparisons_most, c.crossed_intersectors, c.crossed_depths, c.crossed_most});
  }
  return holds;
}

/// Windows with two covers that penetrate. The first two scenes are studied in the middle of the plates, which cover it.
bool add_crossing_scenes(const StudyRequest& request, unsigned resolution, Table& table) {
  const int boxes = request.pick(60, 120);
  struct Case {
    NamedScene named;
    double part;
  };
  std::vector<Case> cases;
  cases.push_back({{"a square behind two plates", crossing_plates(20), "front"}, 0.5});
  cases.push_back({{"a square in their notch", crossing_plates(5.5), "front"}, 0.5});
  cases.push_back({{"a plate and combs through it", combs_through_plate(2, 3), "front"}, 1});
  cases.push_back({{"boxes through each other, " + std::to_string(boxes), penetrating_boxes(boxes)}, 1});
  bool holds = true;
  for (Case& c : cases) {
    finish(c.named.scene);
    const bool keeps = add_crossing_rows(c.named.name, on_sheet(c.named.scene, c.named.view), resolution, c.part, table);
    holds = holds && keeps;
  }
  return holds;
}

/// Adds the rows of scenes in which nothing penetrates.
bool add_apart_scenes(const StudyRequest& request, unsigned resolution, Table& sides, Table& depths) {
  const int blocks = request.pick(3, 6), rows = request.pick(6, 12);
  std::vector<NamedScene> scenes;
  scenes.push_back({"a square before a triangle", square_before_triangle(0, 0), "front"});
  scenes.push_back({"a ring of 9 bars", ring(9), "front"});
  scenes.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", city(blocks)});
  scenes.push_back({"a ball, " + std::to_string(rows) + " rows", ball(rows)});
  bool holds = true;
  for (NamedScene& named : scenes) {
    finish(named.scene);
    const ProjectedScene projected = on_sheet(named.scene, named.view);
    for (const bool apart : {false, true}) {
      const WindowCosts c = classical_costs(projected, resolution, {apart, CoverRule::two});
      holds = holds && c.keep_bounds(apart);
      if (!apart)
        sides.rows.push_back({named.name, "(Ti+Tc) sum a + Ti I <= T <= (Ti+Tc) sum a - Tc I", c.windows, c.side_least,
                              c.side_tests, c.side_most});
      depths.rows.push_back({named.name, apart ? "nothing penetrates" : "nothing",
                             apart ? "E, and 2 an intersector" : "at most 4 E, and 8 an intersector", c.windows,
                             c.surrounders, c.cover_depths, c.intersectors, c.depths, c.depths_most});
    }
  }
  return holds;
}

}  // namespace

Result study_window_costs(const StudyRequest& request) {
  const unsigned resolution = request.pick(32u, 256u);
  Table sides{"POS: sides of faces against windows, down to a limit of " + std::to_string(resolution),
              {{"scene", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"windows", ColumnKind::count},
               {"at least", ColumnKind::count},
               {"tests", ColumnKind::count},
               {"at most", ColumnKind::count}}};
  Table depths{"PRO: depths of faces at the corners of windows, and where it is known that no faces penetrate",
               {{"scene", ColumnKind::label},
                {"known", ColumnKind::label},
                {"thesis", ColumnKind::source},
                {"windows", ColumnKind::count},
                {"surrounders", ColumnKind::count},
                {"their depths", ColumnKind::count},
                {"intersectors", ColumnKind::count},
                {"depths with the cover", ColumnKind::count},
                {"at most", ColumnKind::count}}};
  Table crossing{"PRO with two covers that penetrate: intersectors are compared with both, or the window is divided",
                 {{"scene", ColumnKind::label},
                  {"two covers", ColumnKind::label},
                  {"thesis", ColumnKind::source},
                  {"windows", ColumnKind::count},
                  {"of two covers", ColumnKind::count},
                  {"surrounders", ColumnKind::count},
                  {"their depths", ColumnKind::count},
                  {"4 E", ColumnKind::count},
                  {"comparisons", ColumnKind::count},
                  {"4 (E - 1)", ColumnKind::count},
                  {"intersectors", ColumnKind::count},
                  {"depths with both", ColumnKind::count},
                  {"at most", ColumnKind::count}}};
  const bool apart = add_apart_scenes(request, resolution, sides, depths);
  const bool crossed = add_crossing_scenes(request, resolution, crossing);
  Result result{.tables = {std::move(sides), std::move(depths), std::move(crossing)},
                .finding = apart && crossed ? Finding::holds : Finding::no_longer};
  result.sentence =
      "Every window keeps the bounds, and most stay far below: the comparison of intersectors ends with the first that is in front. "
      "Where nothing penetrates one depth of each surrounder is enough, and two for an intersector. With two covers that "
      "penetrate an intersector takes 12, and up to 16 where it is compared with the nearer of both.";
  return result;
}

}  // namespace ligne::studies
