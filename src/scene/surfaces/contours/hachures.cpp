// Both kinds start from level lines at equal height steps. Along contours, these lines are the strokes; darker places
// get more of them. Down the slope, strokes start on them: darkness is summed along a level line, and where the sum
// reaches a whole number a stroke runs down to the next level, from triangle to triangle.

#include "scene/surfaces/contours/hachures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"

namespace ligne {
namespace {

// Adjustable.
constexpr double kSteepPart = 0.9;                         ///< quantile of the triangles' slopes that counts as steep
constexpr double kSteepAs = 1.0;                           ///< tangent to which that slope is scaled for lighting
constexpr double kLeastDark = 0.12;                        ///< lighter places stay white
constexpr double kThresholds[] = {0.12, 0.55, 0.3, 0.75};  ///< darkness from which every fourth level line is drawn
constexpr std::size_t kMostLevels = 20'000;
constexpr int kMostTrianglesOfStroke = 2000;  ///< longest stroke, in triangles

struct Slopes {
  std::vector<Point3> vertices;  ///< scaled
  std::vector<Point2> gradient;  ///< per triangle
  std::vector<double> dark;      ///< per vertex, from 0 (light) to 1
  double steep = 0;              ///< tangent of the steep slope
  double low = 0, high = 0;
};

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

Slopes slopes_of(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip, const Point3& factor, const Point3& sun) {
  Slopes slopes;
  for (const Point3& p : mesh.vertices) slopes.vertices.push_back(p * factor);
  slopes.gradient.resize(mesh.triangles.size());
  std::vector<Point2> sums(mesh.vertices.size(), {0, 0});
  std::vector<double> weights(mesh.vertices.size());
  std::vector<double> steepness;
  slopes.low = INFINITY;
  slopes.high = -INFINITY;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const Point3 a = slopes.vertices[v[0]], n = glm::cross(slopes.vertices[v[1]] - a, slopes.vertices[v[2]] - a);
    if (!(n.z > 0)) continue;
    const Point2 gradient{-n.x / n.z, -n.y / n.z};
    slopes.gradient[t] = gradient;
    for (const std::uint32_t k : v) {
      sums[k] += gradient * n.z;
      weights[k] += n.z;
    }
    if (!skip.empty() && skip[t]) continue;
    steepness.push_back(glm::length(gradient));
    for (const std::uint32_t k : v) {
      slopes.low = std::min(slopes.low, slopes.vertices[k].z);
      slopes.high = std::max(slopes.high, slopes.vertices[k].z);
    }
  }
  if (steepness.empty()) return slopes;
  const auto steep = steepness.begin() + static_cast<std::ptrdiff_t>(kSteepPart * static_cast<double>(steepness.size() - 1));
  std::nth_element(steepness.begin(), steep, steepness.end());
  slopes.steep = *steep;
  if (!(slopes.steep > 0)) return slopes;
  const Point3 light = glm::normalize(sun);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Point2 g = weights[i] > 0 ? sums[i] / weights[i] * (kSteepAs / slopes.steep) : Point2{0, 0};
    const double lit = glm::dot(glm::normalize(Point3{-g.x, -g.y, 1}), light);
    slopes.dark.push_back(std::clamp(1 - lit / light.z, 0.0, 1.0));
  }
  return slopes;
}

/// A point on an edge of the mesh at a level.
struct Crossing {
  std::uint64_t edge;
  Point3 p;
  double dark;
};

/// The point where an edge reaches a level; heights at the level count as above it.
std::optional<Crossing> crossing(const Slopes& slopes, std::uint32_t v0, std::uint32_t v1, double level) {
  if (v0 > v1) std::swap(v0, v1);  // both neighbours of the edge find the same place
  const Point3 &a = slopes.vertices[v0], &b = slopes.vertices[v1];
  if ((a.z >= level) == (b.z >= level)) return std::nullopt;
  const double s = (level - a.z) / (b.z - a.z);
  const Point3 p = a + (b - a) * s;
  return Crossing{edge_key(v0, v1), {p.x, p.y, level}, slopes.dark[v0] + (slopes.dark[v1] - slopes.dark[v0]) * s};
}

/// A piece of a level line inside one triangle.
struct LevelPiece {
  std::int64_t level;
  std::uint32_t triangle;
  Crossing from, to;
};

std::vector<LevelPiece> level_pieces(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip, const Slopes& slopes,
                                     double distance) {
  std::vector<LevelPiece> pieces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!skip.empty() && skip[t]) continue;
    const auto& v = mesh.triangles[t];
    const auto [low, high] = std::minmax({slopes.vertices[v[0]].z, slopes.vertices[v[1]].z, slopes.vertices[v[2]].z});
    for (double n = std::ceil(low / distance); n * distance <= high; ++n) {
      std::array<Crossing, 2> ends;
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3 && count < 2; ++k) {
        if (const auto found = crossing(slopes, v[k], v[(k + 1) % 3], n * distance)) ends[count++] = *found;
      }
      if (count == 2) pieces.push_back({static_cast<std::int64_t>(n), t, ends[0], ends[1]});
    }
  }
  return pieces;
}

/// Orders the pieces of one level so that each continues the one before, starting from a loose end if there is one.
class LevelWalk {
 public:
  explicit LevelWalk(std::span<const LevelPiece> pieces) : pieces_(pieces), walked_(pieces.size()) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      for (const std::uint64_t edge : {pieces[i].from.edge, pieces[i].to.edge}) {
        const auto [place, is_new] = at_edge_.try_emplace(edge, Ends{i, kNone});
        if (!is_new) place->second.second = i;
      }
    }
  }

  /// Calls visit(piece, runs backwards, begins a line) for each piece.
  template <class Visit>
  void run(Visit visit) {
    for (const bool rings : {false, true}) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        if (walked_[i]) continue;
        const bool from_loose = is_loose(pieces_[i].from.edge), to_loose = is_loose(pieces_[i].to.edge);
        if (rings || from_loose || to_loose) walk(i, !rings && !from_loose, visit);
      }
    }
  }

 private:
  struct Ends {
    std::uint32_t first, second;
  };
  bool is_loose(std::uint64_t edge) const { return at_edge_.at(edge).second == kNone; }

  template <class Visit>
  void walk(std::uint32_t i, bool backwards, Visit visit) {
    for (bool begins = true;; begins = false) {
      walked_[i] = true;
      visit(pieces_[i], backwards, begins);
      const std::uint64_t edge = backwards ? pieces_[i].from.edge : pieces_[i].to.edge;
      const Ends ends = at_edge_.at(edge);
      const std::uint32_t next = ends.first == i ? ends.second : ends.first;
      if (next == kNone || walked_[next]) return;
      backwards = pieces_[next].to.edge == edge;
      i = next;
    }
  }

  std::span<const LevelPiece> pieces_;
  std::vector<bool> walked_;
  std::unordered_map<std::uint64_t, Ends> at_edge_;
};

/// Follows the steepest descent from points on level lines.
class Descent {
 public:
  Descent(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip, const Slopes& slopes)
      : mesh_(mesh), skip_(skip), slopes_(slopes) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [place, is_new] =
            sides_.try_emplace(edge_key(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]), Sides{t, kNone});
        if (!is_new) place->second.second = t;
      }
    }
  }

  /// Appends the path from a point of the triangle down to the height `end`. The path also ends in a valley and at a
  /// rim.
  void run(std::uint32_t triangle, Point3 p, double end, std::vector<std::array<Point3, 2>>& lines) const {
    std::uint64_t entered = 0;
    for (int n = 0; n < kMostTrianglesOfStroke; ++n) {
      const Point2 g = slopes_.gradient[triangle], down = -g;
      const double steepness = glm::dot(g, g);
      if (!(steepness > 0) || (!skip_.empty() && skip_[triangle])) return;
      // The first side that the path reaches, or the end height before it.
      double s = (p.z - end) / steepness;
      std::uint64_t left = 0;
      const auto& v = mesh_.triangles[triangle];
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &a = slopes_.vertices[v[k]], &b = slopes_.vertices[v[(k + 1) % 3]];
        const std::uint64_t edge = edge_key(v[k], v[(k + 1) % 3]);
        const Point2 outwards{b.y - a.y, a.x - b.x};  // triangles are counter-clockwise
        const double speed = glm::dot(outwards, down);
        if (!(speed > 0)) continue;
        if (edge == entered) return;  // both triangles descend to this side: a valley
        const double reach = std::max(0.0, glm::dot(outwards, Point2{a.x - p.x, a.y - p.y}) / speed);
        if (reach < s) {
          s = reach;
          left = edge;
        }
      }
      const Point3 next{p.x + down.x * s, p.y + down.y * s, p.z - steepness * s};
      if (s > 0) lines.push_back({p, next});
      if (left == 0) return;
      const Sides sides = sides_.at(left);
      const std::uint32_t other = sides.first == triangle ? sides.second : sides.first;
      if (other == kNone) return;
      p = next;
      triangle = other;
      entered = left;
    }
  }

 private:
  struct Sides {
    std::uint32_t first, second;
  };
  const SurfaceMesh& mesh_;
  const std::vector<std::uint8_t>& skip_;
  const Slopes& slopes_;
  std::unordered_map<std::uint64_t, Sides> sides_;
};

/// Height step of levels at the distance `on_ground` on a steep slope, enlarged to give at most kMostLevels levels.
double level_distance(const Slopes& slopes, double on_ground) {
  return std::max(slopes.steep * on_ground, (slopes.high - slopes.low) / kMostLevels);
}

}  // namespace

std::vector<std::array<Point3, 2>> contour_hachures(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip,
                                                    const Point3& factor, const HachureOptions& options) {
  const Slopes slopes = slopes_of(mesh, skip, factor, options.sun);
  std::vector<std::array<Point3, 2>> lines;
  if (slopes.dark.empty()) return lines;
  for (const LevelPiece& piece : level_pieces(mesh, skip, slopes, level_distance(slopes, options.spacing))) {
    const double threshold = kThresholds[static_cast<std::size_t>(piece.level & 3)];
    const double from = piece.from.dark - threshold, to = piece.to.dark - threshold;
    if (from <= 0 && to <= 0) continue;
    Point3 a = piece.from.p, b = piece.to.p;
    const Point3 between = from == to ? a : a + (b - a) * (from / (from - to));
    if (from < 0) a = between;
    if (to < 0) b = between;
    lines.push_back({a, b});
  }
  return lines;
}

std::vector<std::array<Point3, 2>> slope_hachures(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& skip,
                                                  const Point3& factor, const HachureOptions& options) {
  const Slopes slopes = slopes_of(mesh, skip, factor, options.sun);
  std::vector<std::array<Point3, 2>> lines;
  if (slopes.dark.empty()) return lines;
  const double distance = level_distance(slopes, options.length * options.spacing);
  std::vector<LevelPiece> pieces = level_pieces(mesh, skip, slopes, distance);
  std::stable_sort(pieces.begin(), pieces.end(), [](const LevelPiece& a, const LevelPiece& b) { return a.level < b.level; });
  const Descent descent(mesh, skip, slopes);
  for (std::size_t first = 0; first < pieces.size();) {
    std::size_t end = first;
    while (end < pieces.size() && pieces[end].level == pieces[first].level) ++end;
    LevelWalk walk({pieces.data() + first, end - first});
    double sum = 0;
    walk.run([&](const LevelPiece& piece, bool backwards, bool begins) {
      // Offsets strokes of neighbouring levels by half their distance.
      if (begins) sum = piece.level & 1 ? 0.5 : 0;
      const Crossing &a = backwards ? piece.to : piece.from, &b = backwards ? piece.from : piece.to;
      const double dark = (a.dark + b.dark) / 2;
      if (dark < kLeastDark) return;
      const double strokes = dark * glm::distance(Point2{a.p.x, a.p.y}, Point2{b.p.x, b.p.y}) / options.spacing;
      for (double at = std::floor(sum) + 1; at <= sum + strokes; ++at) {
        const Point3 p = a.p + (b.p - a.p) * ((at - sum) / strokes);
        descent.run(piece.triangle, p, p.z - distance, lines);
      }
      sum += strokes;
    });
    first = end;
  }
  return lines;
}

}  // namespace ligne
