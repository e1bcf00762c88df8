/// Areas that abut, coincide and overlap, held against an independent library: Clipper 6 subtracts from every area what is
/// painted over it, and the borders of the remainders are the lines to be plotted.
///
/// The sides of all rectangles lie on the lines of a grid, so that both results are sets of edges of its cells.

#include <polyclipping/clipper.hpp>

#include "main/tier.hpp"
#include "plotting/meant_areas.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using namespace test;

/// An edge of a cell: from a crossing of the grid's lines to the next one, in +x or in +y.
struct CellEdge {
  long x, y;
  bool along_x;
  friend auto operator<=>(const CellEdge&, const CellEdge&) = default;
};
using CellEdges = std::map<CellEdge, int>;  ///< how often each is there

/// Farthest that a plotted corner may lie from a crossing of the grid's lines, mm: several steps of the lattice of areas.
constexpr double kOffGrid = 1e-3;

/// The number of the grid's line at the position; -1: none is there.
long line_at(const std::vector<double>& lines, double at) {
  const auto near = std::ranges::find_if(lines, [at](double v) { return std::abs(v - at) <= kOffGrid; });
  return near == lines.end() ? -1 : near - lines.begin();
}

/// Adds the edges of the cells along a segment between crossings; false where it is not parallel to an axis.
bool add_edges(CellEdges& edges, ClipperLib::IntPoint a, ClipperLib::IntPoint b) {
  if (a.X != b.X && a.Y != b.Y) return false;
  for (long x = std::min(a.X, b.X); x < std::max(a.X, b.X); ++x) ++edges[{x, static_cast<long>(a.Y), true}];
  for (long y = std::min(a.Y, b.Y); y < std::max(a.Y, b.Y); ++y) ++edges[{static_cast<long>(a.X), y, false}];
  return true;
}

/// The contours, whose coordinates are numbers of the grid's lines.
ClipperLib::Paths numbered(const MeantScene& scene, const std::vector<Contour>& contours) {
  ClipperLib::Paths paths;
  for (const Contour& contour : contours) {
    ClipperLib::Path& path = paths.emplace_back();
    for (const Point2 p : contour) path.emplace_back(line_at(scene.xs, p.x), line_at(scene.ys, p.y));
  }
  return paths;
}

/// The edges of the cells along contours.
CellEdges edges_of(const MeantScene& scene, const std::vector<Contour>& contours) {
  CellEdges edges;
  for (const ClipperLib::Path& path : numbered(scene, contours))
    for (std::size_t k = 0; k < path.size(); ++k) add_edges(edges, path[k], path[(k + 1) % path.size()]);
  return edges;
}

ClipperLib::Paths combined(ClipperLib::ClipType type, const ClipperLib::Paths& subject, ClipperLib::PolyFillType rule,
                           const ClipperLib::Paths& clip) {
  if (subject.empty() && clip.empty()) return {};  // for Clipper this is an error
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  EXPECT_TRUE(clipper.Execute(type, result, rule, ClipperLib::pftNonZero));
  return result;
}

/// The borders of what is seen of each area.
std::vector<CellEdges> borders_by_clipper(const MeantScene& scene) {
  std::vector<CellEdges> borders(scene.areas.size());
  ClipperLib::Paths painted_over;
  for (std::size_t i = scene.areas.size(); i-- > 0;) {
    const MeantArea& area = scene.areas[i];
    const auto rule = area.even_odd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
    ClipperLib::Paths shown = combined(ClipperLib::ctUnion, numbered(scene, area.contours), rule, {});
    for (const Contour& clip : area.clips)
      shown = combined(ClipperLib::ctIntersection, shown, ClipperLib::pftNonZero, numbered(scene, {clip}));
    for (const ClipperLib::Path& path : combined(ClipperLib::ctDifference, shown, ClipperLib::pftNonZero, painted_over))
      for (std::size_t k = 0; k < path.size(); ++k) EXPECT_TRUE(add_edges(borders[i], path[k], path[(k + 1) % path.size()]));
    painted_over = combined(ClipperLib::ctUnion, painted_over, ClipperLib::pftNonZero, shown);
  }
  return borders;
}

/// How many edges of cells are plotted wrongly: a border is drawn once, by the pen of an area whose border it is.
int wrong_edges(const MeantScene& scene) {
  const std::vector<CellEdges> borders = borders_by_clipper(scene);
  std::set<CellEdge> missing;
  for (const CellEdges& of_area : borders)
    for (const auto& [edge, count] : of_area) missing.insert(edge);
  int wrong = 0;
  for (const Layer& layer : plotted_borders(scene).drawing.layers) {
    std::size_t area = 0;
    while (area < borders.size() && color_of_area(area) != layer.name) ++area;
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      const auto line = layer.lines[i];
      CellEdges plotted;
      for (std::size_t k = 1; k < line.size(); ++k) {
        const ClipperLib::IntPoint a(line_at(scene.xs, line[k - 1].x), line_at(scene.ys, line[k - 1].y)),
            b(line_at(scene.xs, line[k].x), line_at(scene.ys, line[k].y));
        if (std::min({a.X, a.Y, b.X, b.Y}) < 0 || !add_edges(plotted, a, b)) ++wrong;
      }
      for (const auto& [edge, count] : plotted) {
        const bool is_first = missing.erase(edge) > 0;
        if (count == 1 && is_first && area < borders.size() && borders[area].contains(edge)) continue;
        // A contour that runs back on itself is drawn where the area has nothing beside it, too.
        if (count != 1 || area == borders.size() || edges_of(scene, scene.areas[area].contours)[edge] < 2) ++wrong;
      }
    }
  }
  return wrong + static_cast<int>(missing.size());
}

TEST(SvgAreasAgainstClipper, AbuttingRectangles) {
  SeededDice dice(3);
  const int count = runs_all() ? 10'000 : 1'000;
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const MeantScene scene = abutting_rectangles(dice);
    if (wrong_edges(scene) == 0) continue;
    if (++wrong == 1) ADD_FAILURE() << "the first that is wrong: " << svg_of(scene);
  }
  EXPECT_EQ(wrong, 0) << "of " << count;
}

}  // namespace
}  // namespace ligne
