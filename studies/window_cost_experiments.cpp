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

/// Counts over all windows, and the bounds of the source for these windows.
struct WindowCosts {
  std::uint64_t windows = 0;
  std::uint64_t side_tests = 0, side_least = 0, side_most = 0;  ///< POS
  std::uint64_t surrounders = 0, cover_depths = 0;              ///< PRO between surrounders
  std::uint64_t intersectors = 0, depths = 0;                   ///< PRO of intersectors and the cover, or two covers
  std::uint64_t depths_most = 0;
};

/// Warnock's method as the source describes it. It does not search for points where a face is in front of another's plane.
/// It divides a window unless the window is empty or everything lies behind a cover.
class ClassicalWindows {
 public:
  /// `apart`: no faces penetrate, so one depth of each decides.
  ClassicalWindows(const FaceTable& table, double limit, bool apart) : table_(table), limit_(limit), apart_(apart) {}

  WindowCosts study(const Window& window) {
    std::vector<std::uint32_t> all = table_.by_depth;
    study(window, {}, all);
    return costs_;
  }

 private:
  enum class Place : std::uint8_t { disjoint, intersector, surrounder };

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

  /// Depths at the four corners of a window, or at one corner if no faces penetrate.
  std::vector<double> depths_of(const Face& face, const Window& w, std::uint64_t& count) const {
    if (apart_) {
      ++count;
      return {face.z(w.u0, w.v0)};
    }
    count += 4;
    return {face.z(w.u0, w.v0), face.z(w.u1, w.v0), face.z(w.u0, w.v1), face.z(w.u1, w.v1)};
  }

  static bool nowhere_behind(const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b, std::less_equal{});
  }

  /// The surrounder in front of all others; none if two cross.
  std::optional<std::uint32_t> cover_of(const std::vector<std::uint32_t>& surrounders, const Window& window) {
    std::optional<std::uint32_t> cover;
    std::vector<double> nearest;
    for (const std::uint32_t f : surrounders) {
      std::vector<double> depths = depths_of(table_.faces[f], window, costs_.cover_depths);
      if (cover && nowhere_behind(nearest, depths)) continue;
      if (cover && !nowhere_behind(depths, nearest)) return std::nullopt;
      cover = f;
      nearest = std::move(depths);
    }
    return cover;
  }

  /// True if an intersector lies behind the cover over the common part of window and bounding box (figure 2.17).
  bool is_behind(const Face& face, const Face& cover, const Window& window) {
    const Window common = window.common(face.box);
    return nowhere_behind(depths_of(cover, common, costs_.depths), depths_of(face, common, costs_.depths));
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
    costs_.depths_most += (apart_ ? 2 : 8) * intersectors.size();
    if (intersectors.empty() && surrounders.empty()) return;
    const std::optional<std::uint32_t> cover = cover_of(surrounders, window);
    const bool understood = cover && std::ranges::all_of(intersectors, [&](std::uint32_t f) {
                              return is_behind(table_.faces[f], table_.faces[*cover], window);
                            });
    if (understood || (intersectors.empty() && cover) || window.longer_side() <= limit_) return;
    const double u = std::floor((window.u0 + window.u1) / 2), v = std::floor((window.v0 + window.v1) / 2);
    if (cover) surrounders = {*cover};
    for (const Window& child : {Window{window.u0, u, window.v0, v}, Window{u, window.u1, window.v0, v},
                                Window{window.u0, u, v, window.v1}, Window{u, window.u1, v, window.v1}})
      study(child, surrounders, intersectors);
  }

  const FaceTable& table_;
  double limit_;
  bool apart_;
  WindowCosts costs_;
};

WindowCosts classical_costs(const ProjectedScene& scene, unsigned resolution, bool apart) {
  const InitialWindow first = initial_window(scene, WindowChoice::bounding);
  const double step = scene.lattice.step_mm, longer = std::max(scene.view.window.width(), scene.view.window.height());
  const Facets facets = make_facets(scene, coincidence_mm(scene) / step);
  const FaceTable table = make_faces(scene, facets.facets, first.frame);
  return ClassicalWindows(table, std::ceil(longer / resolution / step * first.frame.unit()), apart).study(first.window);
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
      const WindowCosts c = classical_costs(projected, resolution, apart);
      holds = holds && c.side_least <= c.side_tests && c.side_tests <= c.side_most && c.depths <= c.depths_most &&
              c.cover_depths <= (apart ? 1 : 4) * c.surrounders;
      if (!apart)
        sides.rows.push_back({named.name, "(Ti+Tc) sum a + Ti I <= T <= (Ti+Tc) sum a - Tc I", c.windows, c.side_least,
                              c.side_tests, c.side_most});
      depths.rows.push_back({named.name, apart ? "nothing penetrates" : "nothing",
                             apart ? "E, and 2 an intersector" : "at most 4 E, and 8 an intersector", c.windows,
                             c.surrounders, c.cover_depths, c.intersectors, c.depths, c.depths_most});
    }
  }
  Result result;
  result.tables = {std::move(sides), std::move(depths)};
  result.finding = holds ? Finding::holds : Finding::no_longer;
  result.sentence =
      "Every window keeps the bounds, and most stay far below: the comparison of intersectors ends with the first that is in front. "
      "Where nothing penetrates one depth of each surrounder is enough, and two for an intersector.";
  return result;
}

}  // namespace ligne::studies
