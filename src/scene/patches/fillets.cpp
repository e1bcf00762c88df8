#include "scene/patches/fillets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;  ///< two vertices in ascending order

/// A piece of the zero set: across a triangle, from one of its sides to another.
struct Piece {
  std::array<Side, 2> sides;
  std::array<Point3, 2> ends;
  std::uint32_t face;
};

struct PieceEnd {
  Side side;
  std::uint32_t piece;
  int end;
  friend bool operator<(const PieceEnd& l, const PieceEnd& r) {
    return std::tie(l.side, l.piece, l.end) < std::tie(r.side, r.piece, r.end);
  }
};

std::vector<Piece> pieces_of(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> triangles,
                             const std::function<double(const Point3&)>& value) {
  std::vector<Piece> pieces;
  for (const std::uint32_t t : triangles) {
    const Triangle& triangle = topology.triangles[t];
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) at[k] = value(scene.vertices[triangle.v[k]]);
    Piece piece{{}, {}, triangle.face};
    int found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
      const std::size_t next = (k + 1) % 3;
      if ((at[k] >= 0) == (at[next] >= 0)) continue;
      // From the lower vertex to the higher one, so that both triangles of a side find the same point.
      std::size_t from = k, to = next;
      if (triangle.v[from] > triangle.v[to]) std::swap(from, to);
      const double s = at[from] / (at[from] - at[to]);
      piece.sides[static_cast<std::size_t>(found)] = {triangle.v[from], triangle.v[to]};
      piece.ends[static_cast<std::size_t>(found)] =
          (1 - s) * scene.vertices[triangle.v[from]] + s * scene.vertices[triangle.v[to]];
      ++found;
    }
    if (found == 2) pieces.push_back(piece);
  }
  return pieces;
}

/// Adds the parts of a line where the function is not negative.
void add_kept(const FaceLine& line, const std::function<double(const Point3&)>& keeps, std::vector<FaceLine>& lines) {
  FaceLine part;
  const auto finish = [&] {
    if (!part.faces.empty()) lines.push_back(part);
    part = {};
  };
  for (std::size_t i = 0; i < line.faces.size(); ++i) {
    Point3 a = line.points[i], b = line.points[i + 1];
    const double at_a = keeps(a), at_b = keeps(b);
    if (at_a < 0 && at_b < 0) {
      finish();
      continue;
    }
    const Point3 cut = a + (b - a) * (at_a / (at_a - at_b));
    if (at_a < 0) a = cut;
    if (at_b < 0) b = cut;
    if (part.points.empty()) part.points.push_back(a);
    part.points.push_back(b);
    part.faces.push_back(line.faces[i]);
    if (at_b < 0) finish();
  }
  finish();
}

class Chainer {
 public:
  explicit Chainer(std::vector<Piece> pieces) : pieces_(std::move(pieces)), used_(pieces_.size(), 0) {
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      for (int end = 0; end < 2; ++end) ends_.push_back({pieces_[i].sides[static_cast<std::size_t>(end)], i, end});
    }
    std::sort(ends_.begin(), ends_.end());
  }

  std::vector<FaceLine> run() {
    std::vector<FaceLine> lines;
    // Open lines come first, from their ends; the remaining lines are closed.
    for (const bool open : {true, false}) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        for (int end = 0; end < 2; ++end) {
          if (used_[i] || (open && partner(i, end) != nullptr)) continue;
          lines.push_back(walk(i, end));
          lines.back().closed = !open;
        }
      }
    }
    return lines;
  }

 private:
  const Piece& piece(std::uint32_t i) const { return pieces_[i]; }

  /// The other piece at the side where a piece ends; null at the border of the triangles.
  const PieceEnd* partner(std::uint32_t i, int end) const {
    const Side& side = pieces_[i].sides[static_cast<std::size_t>(end)];
    auto at = std::lower_bound(ends_.begin(), ends_.end(), PieceEnd{side, 0, 0});
    for (; at != ends_.end() && at->side == side; ++at) {
      if (at->piece != i) return &*at;
    }
    return nullptr;
  }

  FaceLine walk(std::uint32_t i, int end) {
    FaceLine line;
    line.points.push_back(piece(i).ends[static_cast<std::size_t>(end)]);
    while (true) {
      used_[i] = 1;
      line.points.push_back(piece(i).ends[static_cast<std::size_t>(1 - end)]);
      line.faces.push_back(piece(i).face);
      const PieceEnd* next = partner(i, 1 - end);
      if (!next || used_[next->piece]) return line;
      i = next->piece;
      end = next->end;
    }
  }

  std::vector<Piece> pieces_;
  std::vector<std::uint8_t> used_;
  std::vector<PieceEnd> ends_;
};

/// Adds the polylines along which a function is zero. `value` gives the function at the corners of the triangles, and
/// it is linear in between. Zero at a corner counts as positive, so lines never branch. If `keeps` is not empty, the
/// parts of the lines where keeps(point) is negative are cut off. `triangles` are indices into the topology. O(n log n)
/// for n triangles.
void add_zero_lines(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> triangles,
                    const std::function<double(const Point3&)>& value, const std::function<double(const Point3&)>& keeps,
                    std::vector<FaceLine>& lines) {
  for (const FaceLine& line : Chainer(pieces_of(scene, topology, triangles, value)).run()) {
    if (keeps) {
      add_kept(line, keeps, lines);
    } else {
      lines.push_back(line);
    }
  }
}

constexpr double kTurn = 2 * std::numbers::pi;
/// Adjustable. Largest turn of a fillet, in radians. A strip that turns farther is a rod or a bead.
constexpr double kMostTurn = 200.0 / 360 * kTurn;
/// Adjustable. Least ratio between the lengths of the tangent borders on both sides of a fillet, the shorter to the
/// longer.
constexpr double kBothSides = 0.5;

/// Per patch: its triangles.
IndexLists triangles_of_patches(const Topology& topology, const Patches& patches) {
  return IndexLists(patches.list.size(), [&](const auto& add) {
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
      if (const std::uint32_t p = patches.patch_of[topology.triangles[t].face]; p != kNone) add(p, t);
    }
  });
}

/// Reduces a difference of two angles to [-pi, pi].
double turned(double angle) { return std::remainder(angle, kTurn); }

/// Measures the angle across a strip: about the axis of a cylinder, about the middle circle of a torus.
class AngleAcross {
 public:
  explicit AngleAcross(const PatchSurface& surface) : surface_(surface), frame_(frame_of(surface.axis)) {}

  double operator()(const Point3& p) const {
    const AxisPlace place = axis_place(surface_, p);
    if (surface_.kind == SurfaceKind::torus) return std::atan2(place.along, place.radius - surface_.radius);
    return std::atan2(glm::dot(place.out, frame_[1]), glm::dot(place.out, frame_[0]));
  }

 private:
  const PatchSurface& surface_;
  std::array<Point3, 2> frame_;
};

/// The arc across a patch that its corners span.
struct Arc {
  double middle = 0, turn = kTurn;  ///< radians
};

class FilletFinder {
 public:
  FilletFinder(const Scene& scene, const Topology& topology, const Patches& patches, std::span<const PatchEdge> edges,
               double widest)
      : scene_(scene),
        topology_(topology),
        patches_(patches),
        edges_(edges),
        widest_(widest),
        triangles_(triangles_of_patches(topology, patches)),
        arcs_(patches.list.size()),
        strips_(patches.list.size(), 0) {}

  FilletMiddles run() {
    find_strips();
    FilletMiddles found{strips_, {}};
    for (std::uint32_t p = 0; p < strips_.size(); ++p) {
      if (!strips_[p]) continue;
      const AngleAcross angle(patches_.list[p].surface);
      add_zero_lines(
          scene_, topology_, triangles_[p], [&](const Point3& q) { return turned(angle(q) - arcs_[p].middle); }, {},
          found.lines);
    }
    add_corners(found);
    return found;
  }

 private:
  const Point3& point(std::uint32_t t, std::size_t corner) const {
    return scene_.vertices[topology_.triangles[t].v[corner]];
  }

  /// `last_patch`: per vertex, the last patch for which it was measured.
  Arc arc_of(std::uint32_t p, std::vector<std::uint32_t>& last_patch) const {
    const AngleAcross angle(patches_.list[p].surface);
    std::vector<double> angles;
    for (const std::uint32_t t : triangles_[p]) {
      for (const std::uint32_t v : topology_.triangles[t].v) {
        if (std::exchange(last_patch[v], p) != p) angles.push_back(angle(scene_.vertices[v]));
      }
    }
    if (angles.empty()) return {};
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + kTurn - angles.back();
    std::size_t after = 0;
    for (std::size_t i = 1; i < angles.size(); ++i) {
      if (angles[i] - angles[i - 1] <= gap) continue;
      gap = angles[i] - angles[i - 1];
      after = i;
    }
    return {angles[after] + (kTurn - gap) / 2, kTurn - gap};
  }

  /// Calls visit(patch, edge) for the tangent borders of all patches.
  template <class Visit>
  void for_tangent_borders(Visit visit) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e] != PatchEdge::tangent) continue;
      const Edge& edge = topology_.edges[e];
      for (const std::uint32_t face : {edge.face0, edge.face1}) {
        if (const std::uint32_t p = patches_.patch_of[face]; p != kNone) visit(p, edge);
      }
    }
  }

  /// Finds the narrow patches that have tangent borders on both sides.
  void find_strips() {
    std::vector<std::uint8_t> is_narrow(strips_.size(), 0), has_tangent(strips_.size(), 0);
    std::vector<std::uint32_t> last_patch(scene_.vertices.size(), kNone);
    for_tangent_borders([&](std::uint32_t p, const Edge&) { has_tangent[p] = 1; });
    for (std::uint32_t p = 0; p < strips_.size(); ++p) {
      const PatchSurface& s = patches_.list[p].surface;
      if (!has_tangent[p] || (s.kind != SurfaceKind::cylinder && s.kind != SurfaceKind::torus)) continue;
      const double radius = s.kind == SurfaceKind::torus ? s.tube : s.radius;
      arcs_[p] = arc_of(p, last_patch);
      is_narrow[p] = arcs_[p].turn <= kMostTurn && arcs_[p].turn * radius <= widest_;
    }
    std::vector<std::array<double, 2>> sides(strips_.size(), {0, 0});  // lengths of tangent borders
    for_tangent_borders([&](std::uint32_t p, const Edge& edge) {
      if (!is_narrow[p]) return;
      const Point3 &a = scene_.vertices[edge.v0], &b = scene_.vertices[edge.v1];
      const double place = turned(AngleAcross(patches_.list[p].surface)((a + b) * 0.5) - arcs_[p].middle);
      // Borders near the middle are the ends of the strip.
      if (std::abs(place) < arcs_[p].turn / 4) return;
      sides[p][place > 0] += glm::distance(a, b);
    });
    for (std::uint32_t p = 0; p < strips_.size(); ++p) {
      const auto [least, most] = std::minmax(sides[p][0], sides[p][1]);
      strips_[p] = is_narrow[p] && least > 0 && least >= kBothSides * most;
    }
  }

  /// Adds the small spheres at the ends of strips.
  void add_corners(FilletMiddles& found) const {
    // The borders at which strips of cylinders end at spheres, by sphere and strip.
    struct End {
      Point3 sum{0, 0, 0};
      double length = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, End> ends;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e] != PatchEdge::tangent) continue;
      const Edge& edge = topology_.edges[e];
      std::uint32_t p = patches_.patch_of[edge.face0], q = patches_.patch_of[edge.face1];
      if (p == kNone || q == kNone) continue;
      if (patches_.list[p].surface.kind != SurfaceKind::sphere) std::swap(p, q);
      if (patches_.list[p].surface.kind != SurfaceKind::sphere || !strips_[q]) continue;
      if (patches_.list[q].surface.kind != SurfaceKind::cylinder) continue;
      const double length = edge_length(scene_, edge);
      End& end = ends[{p, q}];
      end.sum += length / 2 * (scene_.vertices[edge.v0] + scene_.vertices[edge.v1]);
      end.length += length;
    }
    for (const auto& [key, end] : ends) {
      const auto& [sphere, strip] = key;
      const PatchSurface& ball = patches_.list[sphere].surface;
      if (ball.radius * std::numbers::pi / 2 > widest_) continue;
      found.is_fillet[sphere] = 1;
      // The line lies in the plane through the axis and the middle of the strip. It runs from the end of the strip to
      // the middle of the corner.
      const PatchSurface& s = patches_.list[strip].surface;
      const auto [u, v] = frame_of(s.axis);
      const double angle = arcs_[strip].middle;
      const Point3 across = -std::sin(angle) * u + std::cos(angle) * v;
      const Point3 middle = middle_direction(sphere);
      Point3 towards = end.sum / end.length - ball.at;
      towards -= glm::dot(towards, middle) * middle;
      add_zero_lines(
          scene_, topology_, triangles_[sphere], [&](const Point3& p) { return glm::dot(p - s.at, across); },
          [&](const Point3& p) { return glm::dot(p - ball.at, towards); }, found.lines);
    }
  }

  /// Unit vector from the centre of a sphere to the middle of its patch.
  Point3 middle_direction(std::uint32_t sphere) const {
    Point3 sum(0, 0, 0);
    for (const std::uint32_t t : triangles_[sphere]) {
      sum += glm::cross(point(t, 1) - point(t, 0), point(t, 2) - point(t, 0));
    }
    const double length = glm::length(sum);
    if (!(length > 0)) return {0, 0, 1};
    return patches_.list[sphere].outward ? sum / length : -sum / length;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  std::span<const PatchEdge> edges_;
  double widest_;
  IndexLists triangles_;              ///< per patch
  std::vector<Arc> arcs_;             ///< per patch
  std::vector<std::uint8_t> strips_;  ///< per patch
};

}  // namespace

FilletMiddles fillet_middles(const Scene& scene, const Topology& topology, const Patches& patches,
                             std::span<const PatchEdge> edges, double widest) {
  if (patches.list.empty()) return {};
  return FilletFinder(scene, topology, patches, edges, widest).run();
}

}  // namespace ligne
