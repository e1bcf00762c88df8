#include "scene/surfaces/contours/cell_contours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "geometry/point.hpp"
#include "geometry/predicates.hpp"
#include "geometry/triangulate.hpp"

namespace ligne {

/// Cuts one cell of CellContours.
class CellCut {
 public:
  CellCut(const CellContours& grid, std::size_t i, std::size_t j, LineBreaks& breaks, CellContours::Found& found)
      : grid_(grid), i_(i), j_(j), breaks_(breaks), found_(found) {}

  /// Adds the triangles of the cell.
  void run();

 private:
  using Corner = CellContours::Corner;
  struct Arc {
    std::vector<Corner> corners;
    bool closed = false;
  };

  bool is_whole() const;
  void add_whole();
  std::vector<Arc> arcs() const;
  void add_polygons(const std::vector<Arc>& arcs);
  void add_polygon(const std::vector<Corner>& polygon);
  void add_torn(const std::vector<Corner>& polygon);
  void add(const Corner& a, const Corner& b, const Corner& c);

  void append_border(Corner from, Corner to, std::uint32_t inner, std::vector<Corner>& polygon);
  std::optional<Point3> border_between(const Point3& from, const Point3& to, const Point3& inner);
  bool connected(std::uint32_t a, std::uint32_t b);
  std::uint32_t inner_of(const Arc& arc) const;
  std::uint8_t rim_flag() const;

  Point3 point(std::uint32_t vertex) const;
  std::uint32_t sample(std::size_t di, std::size_t dj) const;
  /// Coordinates of a point in the cell, from 0 to 1 on both axes.
  Point2 in_cell(const Point3& p) const;
  Point2 in_plane(Point2 cell) const;

  const CellContours& grid_;
  std::size_t i_, j_;
  LineBreaks& breaks_;
  CellContours::Found& found_;
};

namespace {

/// Cuts a polygon, counter-clockwise in x and y, into counter-clockwise triangles with the smallest total area in
/// space. On a bent strip these connect corners at equal heights, so that it has no folds. Returns no triangles if
/// there is no such triangulation. O(n^3) for n corners (Klincsek 1980).
std::vector<std::array<std::uint32_t, 3>> least_area_triangles(std::span<const Point3> corners) {
  const std::size_t n = corners.size();
  if (n < 3) return {};
  constexpr double kImpossible = std::numeric_limits<double>::infinity();
  const auto flat = [&](std::size_t i) { return Point2{corners[i].x, corners[i].y}; };
  // least[i * n + k]: smallest area of triangles between corners i and k; apex[i * n + k]: third corner of the one at side
  // i k.
  std::vector<double> least(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t k = i + span;
      double best = kImpossible;
      for (std::size_t j = i + 1; j < k; ++j) {
        const double before = least[i * n + j] + least[j * n + k];
        if (!(before < best) || orientation_sign(flat(i), flat(j), flat(k)) <= 0) continue;
        const double area = before + glm::length(glm::cross(corners[j] - corners[i], corners[k] - corners[i]));
        if (!(area < best)) continue;
        best = area;
        apex[i * n + k] = static_cast<std::uint32_t>(j);
      }
      least[i * n + k] = best;
    }
  }
  if (!(least[n - 1] < kImpossible)) return {};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> open{{0, static_cast<std::uint32_t>(n - 1)}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k - i < 2) continue;
    const std::uint32_t j = apex[i * n + k];
    triangles.push_back({i, j, k});
    open.push_back({i, j});
    open.push_back({j, k});
  }
  return triangles;
}

/// Largest distance between a border and its chord where it counts as straight, in sides of a cell: a hundredth of a
/// millimetre for cells as wide as a finger.
constexpr double kStraight = 0x1p-10;
constexpr int kMostBorderHalvings = 4;
/// Largest distance of two ends of arcs that are the two sides of one point, in sides of a cell.
constexpr double kSamePlace = 0x1p-30;

/// Largest number of corners for least_area_triangles(), which takes cubic time; larger polygons use triangulate().
constexpr std::size_t kMostForLeastArea = 64;

double length(Point2 p) { return std::hypot(p.x, p.y); }

/// The point p + t d for the largest t, at most 1, that stays in the cell.
Point2 step_within(Point2 p, Point2 d) {
  double t = 1;
  for (int k = 0; k < 2; ++k) {
    if (p[k] + d[k] > 1) t = std::min(t, (1 - p[k]) / d[k]);
    if (p[k] + d[k] < 0) t = std::min(t, -p[k] / d[k]);
  }
  return p + std::max(t, 0.) * d;
}

}  // namespace

Point3 CellCut::point(std::uint32_t vertex) const {
  return vertex & CellContours::kOwn ? found_.points[vertex & ~CellContours::kOwn] : grid_.vertices_[vertex];
}

std::uint32_t CellCut::sample(std::size_t di, std::size_t dj) const {
  return static_cast<std::uint32_t>((j_ + dj) * grid_.surface_.columns + i_ + di);
}

Point2 CellCut::in_cell(const Point3& p) const {
  const Point3 low = point(sample(0, 0)), high = point(sample(1, 1));
  return {(p.x - low.x) / (high.x - low.x), (p.y - low.y) / (high.y - low.y)};
}

Point2 CellCut::in_plane(Point2 cell) const {
  const Point3 low = point(sample(0, 0)), high = point(sample(1, 1));
  return {low.x + cell.x * (high.x - low.x), low.y + cell.y * (high.y - low.y)};
}

bool CellCut::is_whole() const {
  for (const std::size_t dj : {0, 1}) {
    for (const std::size_t di : {0, 1}) {
      if (!grid_.counts(sample(di, dj))) return false;
    }
  }
  const GridEdge sides[] = {{sample(0, 0), false}, {sample(0, 1), false}, {sample(0, 0), true}, {sample(1, 0), true}};
  return std::none_of(std::begin(sides), std::end(sides), [&](const GridEdge& side) { return grid_.broken(side); });
}

void CellCut::run() {
  if (is_whole()) return add_whole();
  add_polygons(arcs());
}

void CellCut::add(const Corner& a, const Corner& b, const Corner& c) {
  found_.triangles.push_back({a.vertex, b.vertex, c.vertex});
  found_.flags.push_back({a.flags, b.flags, c.flags});
}

void CellCut::add_whole() {
  const std::array<std::uint8_t, 4> flags = grid_.side_flags(i_, j_);
  const std::uint32_t a = sample(0, 0), b = sample(1, 0), c = sample(0, 1), d = sample(1, 1);
  add({a, flags[0]}, {b, 0}, {c, flags[3]});
  add({b, flags[1]}, {d, flags[2]}, {c, 0});
}

std::vector<CellCut::Arc> CellCut::arcs() const {
  const std::array<std::uint8_t, 4> flags = grid_.side_flags(i_, j_);
  struct Side {
    GridEdge edge;
    bool reversed;
    std::uint32_t from, to;
  };
  const std::uint32_t a = sample(0, 0), b = sample(1, 0), c = sample(0, 1), d = sample(1, 1);
  const Side sides[] = {
      {{a, false}, false, a, b}, {{b, true}, false, b, d}, {{c, false}, true, d, c}, {{a, true}, true, c, a}};
  std::vector<Arc> arcs;
  bool goes_on = false;  // the last arc reached the corner before the next side
  const auto push = [&](std::uint32_t vertex, std::uint8_t side_flags) {
    Arc& arc = arcs.back();
    if (!arc.corners.empty()) arc.corners.back().flags = side_flags;
    arc.corners.push_back({vertex, 0});
  };
  const std::vector<CellContours::Piece> whole{{true, true, {}}}, none;
  for (std::size_t k = 0; k < 4; ++k) {
    const Side& side = sides[k];
    const std::vector<CellContours::Piece>* pieces = grid_.broken(side.edge);
    if (!pieces) pieces = grid_.counts(side.from) && grid_.counts(side.to) ? &whole : &none;
    bool reached = false;
    for (std::size_t n = 0; n < pieces->size(); ++n) {
      const CellContours::Piece& piece = (*pieces)[side.reversed ? pieces->size() - 1 - n : n];
      const bool from_start = side.reversed ? piece.to_end : piece.from_start;
      reached = side.reversed ? piece.from_start : piece.to_end;
      if (!from_start || !goes_on) {
        arcs.emplace_back();
        if (from_start) push(side.from, 0);
      }
      goes_on = false;
      for (std::size_t m = 0; m < piece.vertices.size(); ++m) {
        push(piece.vertices[side.reversed ? piece.vertices.size() - 1 - m : m], flags[k]);
      }
      if (reached) push(side.to, flags[k]);
    }
    goes_on = reached;
  }
  if (!goes_on || arcs.front().corners.front().vertex != a) return arcs;
  if (arcs.size() == 1) {
    arcs[0].closed = true;
    arcs[0].corners.pop_back();
    return arcs;
  }
  Arc& last = arcs.back();
  last.corners.pop_back();
  if (!last.corners.empty()) last.corners.back().flags = flags[3];
  last.corners.insert(last.corners.end(), arcs[0].corners.begin(), arcs[0].corners.end());
  arcs.erase(arcs.begin());
  return arcs;
}

/// A vertex of the arc that is not an end: a sample if there is one.
std::uint32_t CellCut::inner_of(const Arc& arc) const {
  for (const Corner& corner : arc.corners) {
    if (corner.vertex < grid_.surface_.points.size()) return corner.vertex;
  }
  return arc.corners[arc.corners.size() / 2].vertex;
}

bool CellCut::connected(std::uint32_t a, std::uint32_t b) {
  const Point3 p = point(a), q = point(b);
  for (const double t : {0.25, 0.5, 0.75}) {
    if (!breaks_.counts(breaks_.point({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}))) return false;
  }
  return !breaks_.last_before_break(p, {q.x, q.y});
}

void CellCut::add_polygons(const std::vector<Arc>& arcs) {
  if (arcs.empty()) return;
  if (arcs.size() == 1 && arcs[0].closed) return add_polygon(arcs[0].corners);
  // goes_on[k]: the surface connects arc k to the next one, so the border runs between them.
  const std::size_t n = arcs.size();
  std::vector<bool> goes_on(n);
  for (std::size_t k = 0; k < n; ++k) {
    const bool asked_already = n == 2 && k == 1;
    goes_on[k] = n > 1 && (asked_already ? goes_on[0] : connected(inner_of(arcs[k]), inner_of(arcs[(k + 1) % n])));
  }
  const auto first_break = std::find(goes_on.begin(), goes_on.end(), false);
  const std::size_t first = first_break == goes_on.end() ? 0 : static_cast<std::size_t>(first_break - goes_on.begin()) + 1;
  for (std::size_t k = 0; k < n;) {
    std::vector<Corner> polygon;
    const Arc& beginning = arcs[(first + k) % n];
    while (k < n) {
      const Arc& arc = arcs[(first + k) % n];
      polygon.insert(polygon.end(), arc.corners.begin(), arc.corners.end());
      const bool is_last = ++k == n || !goes_on[(first + k - 1) % n];
      const Corner next = is_last ? beginning.corners.front() : arcs[(first + k) % n].corners.front();
      append_border(polygon.back(), next, inner_of(arc), polygon);
      if (is_last) break;
    }
    const Point2 end = in_cell(point(beginning.corners.front().vertex)), start = in_cell(point(polygon.back().vertex));
    const auto is_sample = [&](const Corner& corner) { return corner.vertex < grid_.surface_.points.size(); };
    const bool is_torn = std::count_if(polygon.begin(), polygon.end(), is_sample) == 4 && length(end - start) < kSamePlace;
    is_torn ? add_torn(polygon) : add_polygon(polygon);
  }
}

/// Flag of a border that is part of the outer rim. A single wall surrounds all of it.
std::uint8_t CellCut::rim_flag() const { return grid_.outside_(i_ + 1, j_ + 1) ? SurfaceMesh::kRimTop : 0; }

/// Appends the border from the polygon's last corner to the corner `to`, without both. `inner` is a vertex to its left.
void CellCut::append_border(Corner from, Corner to, std::uint32_t inner, std::vector<Corner>& polygon) {
  std::vector<Point3> border{point(from.vertex), point(to.vertex)};
  for (int halving = 0; halving < kMostBorderHalvings; ++halving) {
    std::vector<Point3> finer{border.front()};
    for (std::size_t k = 1; k < border.size(); ++k) {
      if (const auto between = border_between(border[k - 1], border[k], point(inner))) finer.push_back(*between);
      finer.push_back(border[k]);
    }
    const bool is_fine = finer.size() == border.size();
    border = std::move(finer);
    if (is_fine) break;
  }
  polygon.back().flags = rim_flag();
  for (std::size_t k = 1; k + 1 < border.size(); ++k) {
    const auto vertex = CellContours::kOwn | static_cast<std::uint32_t>(found_.points.size());
    found_.points.push_back(border[k]);
    polygon.push_back({vertex, rim_flag()});
  }
}

/// The point of the border beside the middle of a chord; nothing if the border is straight there.
std::optional<Point3> CellCut::border_between(const Point3& from, const Point3& to, const Point3& inner) {
  const Point2 a = in_cell(from), b = in_cell(to), chord = b - a;
  if (length(chord) < kStraight) return std::nullopt;
  const Point2 middle = (a + b) * 0.5, left{-chord.y / 2, chord.x / 2};
  const Point3 begin = breaks_.point(in_plane(step_within(middle, left)));
  if (!breaks_.counts(begin)) return std::nullopt;
  // The start must be on the same piece of the surface.
  if (breaks_.last_before_break(inner, {begin.x, begin.y})) return std::nullopt;
  const auto border = breaks_.last_before_break(begin, in_plane(step_within(middle, -left)));
  if (!border) return std::nullopt;
  return length(in_cell(*border) - middle) > kStraight ? border : std::nullopt;
}

void CellCut::add_polygon(const std::vector<Corner>& polygon) {
  if (polygon.size() < 3) return;
  std::vector<Point2> plan;
  std::vector<Point3> corners;
  for (const Corner& corner : polygon) {
    const Point3 p = point(corner.vertex);
    plan.push_back(in_cell(p));
    corners.push_back({plan.back().x, plan.back().y, p.z * grid_.heights_to_cells_});
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (corners.size() <= kMostForLeastArea) triangles = least_area_triangles(corners);
  if (triangles.empty()) {
    const std::array<std::uint32_t, 1> end{static_cast<std::uint32_t>(corners.size())};
    triangles = triangulate(plan, end);
  }
  for (const std::array<std::uint32_t, 3>& triangle : triangles) {
    std::array<Corner, 3> cut;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t at = triangle[k], next = triangle[(k + 1) % 3];
      const bool is_side = (at + 1) % polygon.size() == next;
      cut[k] = {polygon[at].vertex, is_side ? polygon[at].flags : std::uint8_t{0}};
    }
    add(cut[0], cut[1], cut[2]);
  }
}

/// Adds the triangles of a cell in which a jump ends: the surface is torn from the rim to the middle of the cell.
void CellCut::add_torn(const std::vector<Corner>& polygon) {
  const Point3 middle = breaks_.point(in_plane({0.5, 0.5}));
  if (!breaks_.counts(middle)) return;
  const auto vertex = CellContours::kOwn | static_cast<std::uint32_t>(found_.points.size());
  found_.points.push_back(middle);
  for (std::size_t k = 0; k + 1 < polygon.size(); ++k) {
    add(polygon[k], {polygon[k + 1].vertex, 0}, {vertex, 0});
  }
}

CellContours::CellContours(const SurfacePoints& surface, const HeightWindow& window, double range,
                           const std::vector<BrokenEdge>& broken, std::vector<Point3>& vertices)
    : surface_(surface),
      window_(window),
      vertices_(vertices),
      outside_(surface.columns, surface.rows, [&](std::size_t k) { return counts(k); }) {
  heights_to_cells_ = range > 0 ? static_cast<double>(std::max(surface.columns, surface.rows)) / (2 * range) : 1;
  for (const BrokenEdge& edge : broken) {
    std::vector<Piece>& pieces = pieces_[edge.edge.key()];
    for (const LinePiece& piece : edge.pieces) {
      Piece& numbered = pieces.emplace_back(Piece{piece.from_start, piece.to_end, {}});
      for (const Point3& p : piece.points) {
        numbered.vertices.push_back(static_cast<std::uint32_t>(vertices.size()));
        vertices.push_back(p);
      }
    }
  }
}

/// Flags of the low row, the high column, the high row and the low column.
std::array<std::uint8_t, 4> CellContours::side_flags(std::size_t i, std::size_t j) const {
  const auto flags = [](bool is_curve, bool is_rim, std::uint8_t rim) {
    return static_cast<std::uint8_t>((is_curve ? kCornerCurve : 0) | (is_rim ? rim : 0));
  };
  const std::size_t last_column = surface_.columns - 1, last_row = surface_.rows - 1;
  const auto row = [&](std::size_t k) { return is_curve_at(k, surface_.rows, surface_.y_stride); };
  const auto column = [&](std::size_t k) { return is_curve_at(k, surface_.columns, surface_.x_stride); };
  return {flags(row(j), j == 0, SurfaceMesh::kRimBottom), flags(column(i + 1), i + 1 == last_column, SurfaceMesh::kRimRight),
          flags(row(j + 1), j + 1 == last_row, SurfaceMesh::kRimTop), flags(column(i), i == 0, SurfaceMesh::kRimLeft)};
}

void CellContours::cut_row(std::size_t j, Found& found) const {
  surface_.function->use([&](HeightFunction::At& at) {
    LineBreaks breaks(at, window_);
    for (std::size_t i = 0; i + 1 < surface_.columns; ++i) CellCut(*this, i, j, breaks, found).run();
  });
}

}  // namespace ligne
