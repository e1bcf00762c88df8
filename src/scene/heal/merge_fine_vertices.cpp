#include "scene/heal/merge_fine_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/nearest_on_segment.hpp"
#include "scene/clean/clean.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Least part of the triangles of an object that are as fine as its coordinates.
constexpr double kLeastFine = 0.25;
/// Number of triangles of a sample.
constexpr std::size_t kSampled = 256;
/// Triangles of this many errors of a rounded point or more in height stay: they are tilted by 6 degrees at most.
constexpr double kStableErrors = 20;
/// Triangles thinner than this are no worse than others.
constexpr double kLeastErrors = 0.1;
/// Least gain of a change, in the thinness of a stable triangle.
constexpr double kLeastGain = 1;
/// Relative rounding of the thinness of a triangle a million times as long as high: 2^-53 of a double, 2^20 for the
/// cancellation in its area, and 2^3 for the operations. Gains that differ by less are equal, whatever the order of the
/// corners and faces.
constexpr double kThinnessRounding = 0x1p-30;
/// Triangles of this many errors in height or more tell a direction, if roughly: new faces have that of an old one, within
/// the angle of this cosine.
constexpr double kLeastSure = 3, kLeastCosine = 0.8;
/// Least cosine to the mean of the old faces, at an edge of two planes of which nearly all lie in one: 120 degrees.
constexpr double kLeastMeanCosine = -0.5;
/// Distance of a merged vertex from the faces that are left, in errors of a rounded point: its own, and that of a corner.
constexpr double kMostErrors = 2;
/// Distance of new faces from those in whose place they come, in the same unit. These may have that of a merged vertex
/// already, to the other side.
constexpr double kNearErrors = 2 * kMostErrors;
/// Vertices of more faces stay: those of fans.
constexpr std::size_t kMostFaces = 32;
/// Most looks at a face per face of the object.
constexpr std::size_t kMostLooks = 4096;

using Corners = std::array<std::uint32_t, 3>;

bool has(const Corners& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

/// The least height of a triangle.
double least_height(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a, ac = c - a, bc = c - b, area = glm::cross(ab, ac);
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return longest > 0 ? std::sqrt(glm::dot(area, area) / longest) : 0;
}

/// Square of the distance of a point from a triangle. Rounded.
double square_from_triangle(const Point3& p, const std::array<Point3, 3>& t) {
  const Point3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double square = glm::dot(normal, normal);
  double least = std::numeric_limits<double>::infinity();
  bool is_above = square > 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &from = t[k], &to = t[(k + 1) % 3];
    is_above = is_above && glm::dot(glm::cross(to - from, p - from), normal) >= 0;
    least = std::min(least, squared_distance(p, from, to));
  }
  const double height = glm::dot(p - t[0], normal);
  return is_above ? height * height / square : least;
}

/// The triangles of one object, which are changed one by one.
class FineMesh {
 public:
  FineMesh(Scene& scene, const Object& object);
  /// Makes thin triangles higher; returns the number of merged vertices.
  std::size_t run();

 private:
  /// A vertex, by the height of its thinnest face; those of one height by their place.
  struct Candidate {
    double height;
    Point3 at;
    std::uint32_t vertex, face;
    bool operator<(const Candidate& o) const {
      return std::tie(o.height, o.at.x, o.at.y, o.at.z) < std::tie(height, at.x, at.y, at.z);
    }
  };
  /// Faces that take the place of others: after a vertex was merged with a neighbour, or an edge was flipped.
  struct Change {
    std::vector<std::uint32_t> old{};
    std::vector<Corners> faces{};
    std::vector<std::uint32_t> like{};                            ///< per new face: the old one that it continues
    std::uint32_t vertex = kNone, to = kNone;                     ///< the merged vertex, and its neighbour
    std::vector<std::pair<std::uint32_t, std::size_t>> points{};  ///< merged vertices, each with its nearest new face
    double gain = 0;                                              ///< by how much the thinness() of the faces falls
  };

  std::vector<std::uint32_t>& faces_at(std::uint32_t v) { return faces_of_[v - object_.vertex_begin]; }
  const Point3& at(std::uint32_t v) const { return scene_.vertices[v]; }
  Point3 area(const Corners& t) const { return glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])); }
  double height(const Corners& t) const { return least_height(at(t[0]), at(t[1]), at(t[2])); }
  /// Inverse of the height of a triangle, up to a bound.
  double thinness(const Corners& t) const { return 1 / std::max(height(t), kLeastErrors * error_); }
  void add_candidate(std::uint32_t v);
  std::vector<std::uint32_t> ring(std::uint32_t v);
  bool are_joined(std::uint32_t v, std::uint32_t w);
  bool is_sure(const Corners& t) const { return height(t) >= kLeastSure * error_; }
  bool is_turned(const Corners& t, std::uint32_t like, std::span<const std::uint32_t> old) const;
  void offer(Change change, Change& best);
  void offer_mergers(std::uint32_t v, Change& best);
  void offer_flip(std::uint32_t f, Change& best);
  bool holds_points(Change& change);
  bool lies_near(const Change& change);
  void apply(const Change& change);

  Scene& scene_;
  const Object& object_;
  double error_;  ///< of a rounded point
  std::vector<Corners> triangles_{};
  std::vector<std::vector<std::uint32_t>> faces_of_;  ///< per vertex of the object
  std::vector<double> height_of_;                     ///< per vertex: as a candidate; -1 if it is none
  std::vector<std::vector<std::uint32_t>> merged_;    ///< per face: the merged vertices that lie on it
  std::size_t looks_;                                 ///< that are left
  std::priority_queue<Candidate> candidates_{};
};

FineMesh::FineMesh(Scene& scene, const Object& object)
    : scene_(scene),
      object_(object),
      error_(kSqrt3 * object.precision),
      faces_of_(object.vertex_end - object.vertex_begin),
      height_of_(faces_of_.size(), -1),
      merged_(object.face_end - object.face_begin),
      looks_(kMostLooks * merged_.size()) {
  for (std::uint32_t f = 0; f < merged_.size(); ++f) {
    const auto contour = scene.faces.contour(object.face_begin + f, 0);
    triangles_.push_back({contour[0], contour[1], contour[2]});
    for (const std::uint32_t v : contour) faces_at(v).push_back(f);
  }
}

/// Adds a vertex whose faces are new, if one of them is thin.
void FineMesh::add_candidate(std::uint32_t v) {
  double& own = height_of_[v - object_.vertex_begin];
  own = -1;
  if (faces_at(v).size() > kMostFaces) return;
  Candidate found{kStableErrors * error_, at(v), v, kNone};
  for (const std::uint32_t f : faces_at(v)) {
    const double least = height(triangles_[f]);
    if (least < found.height) found.height = least, found.face = f;
  }
  if (found.face == kNone) return;
  own = found.height;
  candidates_.push(found);
}

/// The neighbours of a vertex in their order around it; none if its faces are no disc around it, or too many.
std::vector<std::uint32_t> FineMesh::ring(std::uint32_t v) {
  if (faces_at(v).size() > kMostFaces) return {};
  std::vector<std::array<std::uint32_t, 2>> sides;  // opposite to v
  for (const std::uint32_t f : faces_at(v)) {
    const Corners& t = triangles_[f];
    const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    sides.push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  std::vector<std::uint32_t> ring{sides[0][0]};
  while (ring.size() <= sides.size()) {
    const auto next = std::ranges::find(sides, ring.back(), [](const auto& side) { return side[0]; });
    if (next == sides.end()) return {};
    if ((*next)[1] == ring.front()) return ring.size() == sides.size() ? ring : std::vector<std::uint32_t>{};
    ring.push_back((*next)[1]);
  }
  return {};
}

/// Whether two vertices have a face in common.
bool FineMesh::are_joined(std::uint32_t v, std::uint32_t w) {
  if (faces_at(v).size() > faces_at(w).size()) std::swap(v, w);
  looks_ -= std::min(looks_, faces_at(v).size());
  return std::ranges::any_of(faces_at(v), [&](std::uint32_t f) { return has(triangles_[f], w); });
}

/// Whether a new face is turned against the old one that it continues, or if that tells no direction, against all of them;
/// or against their mean, which is that of their border: many of those that rounding folds may have any direction.
bool FineMesh::is_turned(const Corners& t, std::uint32_t like, std::span<const std::uint32_t> old) const {
  if (!is_sure(t)) return false;
  const Point3 now = area(t);
  const auto is_like = [&](std::uint32_t f) {
    const Point3 before = area(triangles_[f]);
    return glm::dot(now, before) >= kLeastCosine * glm::length(now) * glm::length(before);
  };
  Point3 mean(0, 0, 0);
  for (const std::uint32_t f : old) mean += area(triangles_[f]);
  if (glm::dot(now, mean) < kLeastMeanCosine * glm::length(now) * glm::length(mean)) return true;
  if (is_sure(triangles_[like])) return !is_like(like);
  const auto may_tell = [&](std::uint32_t f) { return is_sure(triangles_[f]); };
  return std::ranges::any_of(old, may_tell) &&
         std::ranges::none_of(old, [&](std::uint32_t f) { return may_tell(f) && is_like(f); });
}

/// Takes a change for the best one if its faces are less thin, none is turned over, and all merged vertices lie on them.
void FineMesh::offer(Change change, Change& best) {
  double before = 0;
  for (const std::uint32_t f : change.old) before += thinness(triangles_[f]);
  change.gain = before;
  for (std::size_t i = 0; i < change.faces.size(); ++i) {
    if (is_turned(change.faces[i], change.like[i], change.old)) return;
    change.gain -= thinness(change.faces[i]);
  }
  // Among equal gains the place decides, so that the order of the faces has no say.
  const double margin = kThinnessRounding * before;
  const auto place = [&](const Change& c) { return c.to == kNone ? Point3(0, 0, 0) : at(c.to); };
  const auto is_before = [](const Point3& p, const Point3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
  const bool is_better =
      change.gain > kLeastGain / (kStableErrors * error_) &&
      (change.gain > best.gain + margin || (change.gain > best.gain - margin && is_before(place(change), place(best))));
  if (is_better && holds_points(change) && lies_near(change)) best = std::move(change);
}

/// Offers the mergers of a vertex with each of its neighbours.
void FineMesh::offer_mergers(std::uint32_t v, Change& best) {
  const std::vector<std::uint32_t> around = ring(v);
  const std::size_t n = around.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t w = around[k];
    // Beside v itself, only the two faces at the edge may join w to the ring.
    bool is_apart = true;
    for (std::size_t i = 2; i + 1 < n && is_apart; ++i) is_apart = !are_joined(w, around[(k + i) % n]);
    if (!is_apart) continue;
    Change change{faces_at(v), {}, {}, v, w};
    for (const std::uint32_t f : change.old) {
      if (has(triangles_[f], w)) continue;
      std::ranges::replace(change.faces.emplace_back(triangles_[f]), v, w);
      change.like.push_back(f);
    }
    offer(std::move(change), best);
  }
}

/// Offers the flip of the longest edge of a face.
void FineMesh::offer_flip(std::uint32_t f, Change& best) {
  const Corners& t = triangles_[f];
  std::size_t k = 0;  // of the corner opposite to the longest edge
  const auto length = [&](std::size_t i) { return glm::distance(at(t[(i + 1) % 3]), at(t[(i + 2) % 3])); };
  for (std::size_t i = 1; i < 3; ++i) k = length(i) > length(k) ? i : k;
  const std::uint32_t v = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
  std::vector<std::uint32_t> beyond;
  std::ranges::copy_if(faces_at(a), std::back_inserter(beyond),
                       [&](std::uint32_t g) { return g != f && has(triangles_[g], b); });
  looks_ -= std::min(looks_, faces_at(a).size());
  if (beyond.size() != 1) return;
  const Corners& other = triangles_[beyond[0]];
  const std::uint32_t c = other[0] + other[1] + other[2] - a - b;
  const Point3 normal = area(other);
  const bool is_flat = std::abs(glm::dot(at(v) - at(a), normal)) <= kMostErrors * error_ * glm::length(normal);
  if (c == v || !is_flat || are_joined(v, c)) return;
  offer({{f, beyond[0]}, {{v, a, c}, {v, c, b}}, {beyond[0], beyond[0]}}, best);
}

/// Gives the merged vertex, and those that were merged before on the old faces, to the new ones. Whether all of them lie
/// near enough.
bool FineMesh::holds_points(Change& change) {
  const auto holds = [&](std::uint32_t p) {
    double least = kMostErrors * kMostErrors * error_ * error_;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < change.faces.size(); ++i) {
      const auto [a, b, c] = change.faces[i];
      const double square = square_from_triangle(at(p), {at(a), at(b), at(c)});
      if (square > least) continue;
      least = square;
      nearest = i;
    }
    looks_ -= std::min(looks_, change.faces.size());
    if (nearest) change.points.push_back({p, *nearest});
    return nearest.has_value();
  };
  if (change.vertex != kNone && !holds(change.vertex)) return false;
  return std::ranges::all_of(change.old, [&](std::uint32_t f) { return std::ranges::all_of(merged_[f], holds); });
}

/// Whether points of the new faces lie near the old ones: a face across a sharp edge that a vertex lay on does not.
bool FineMesh::lies_near(const Change& change) {
  const auto is_near = [&](const Point3& p) {
    return std::ranges::any_of(change.old, [&](std::uint32_t f) {
      const auto [a, b, c] = triangles_[f];
      return square_from_triangle(p, {at(a), at(b), at(c)}) <= kNearErrors * kNearErrors * error_ * error_;
    });
  };
  looks_ -= std::min(looks_, change.faces.size() * change.old.size());
  return std::ranges::all_of(change.faces, [&](const Corners& t) {
    const auto [a, b, c] = std::array{at(t[0]), at(t[1]), at(t[2])};
    return is_near((a + b + c) / 3.0) && is_near((a + b) / 2.0) && is_near((b + c) / 2.0) && is_near((c + a) / 2.0);
  });
}

void FineMesh::apply(const Change& change) {
  for (const std::uint32_t f : change.old) {
    for (const std::uint32_t v : triangles_[f]) std::erase(faces_at(v), f);
    triangles_[f] = {kNone, kNone, kNone};
    merged_[f].clear();
  }
  for (std::size_t i = 0; i < change.faces.size(); ++i) {
    triangles_[change.old[i]] = change.faces[i];
    for (const std::uint32_t v : change.faces[i]) faces_at(v).push_back(change.old[i]);
  }
  for (const auto& [point, i] : change.points) merged_[change.old[i]].push_back(point);
}

std::size_t FineMesh::run() {
  std::size_t merged = 0;
  for (std::uint32_t v = object_.vertex_begin; v < object_.vertex_end; ++v) add_candidate(v);
  while (!candidates_.empty() && looks_ > 0) {
    const Candidate thinnest = candidates_.top();
    candidates_.pop();
    double& own = height_of_[thinnest.vertex - object_.vertex_begin];
    if (own != thinnest.height || !has(triangles_[thinnest.face], thinnest.vertex)) continue;
    own = -1;  // it is not asked again before its faces change
    Change best;
    offer_mergers(thinnest.vertex, best);
    offer_flip(thinnest.face, best);
    if (best.old.empty()) continue;
    std::vector<std::uint32_t> changed;
    for (const std::uint32_t f : best.old) changed.insert(changed.end(), triangles_[f].begin(), triangles_[f].end());
    apply(best);
    merged += best.vertex != kNone;
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t v : changed) add_candidate(v);
  }
  const std::span<std::uint32_t> corners = scene_.faces.corners().subspan(std::size_t{3} * object_.face_begin);
  for (std::size_t f = 0; f < triangles_.size(); ++f) {
    // Faces that are gone keep one of their corners, and go with the faces without area.
    for (std::size_t k = 0; k < 3; ++k)
      corners[3 * f + k] = triangles_[f][k] != kNone ? triangles_[f][k] : object_.vertex_begin;
  }
  return merged;
}

/// Whether the triangles of an object are as fine as its coordinates: many are higher than the roundings of their corners,
/// but not by much. Needles, which CSG leaves at the edges of planes, are lower.
bool is_fine(const Scene& scene, const Object& object) {
  const std::size_t count = object.face_end - object.face_begin;
  const double error = kSqrt3 * object.precision;
  const auto count_fine = [&](std::size_t begin, std::size_t end) {
    std::size_t found = 0;
    for (std::size_t f = object.face_begin + begin; f < object.face_begin + end; ++f) {
      const auto corners = scene.faces.contour(f, 0);
      const double height = least_height(scene.vertices[corners[0]], scene.vertices[corners[1]], scene.vertices[corners[2]]);
      found += height > 2 * error && height < kStableErrors * error;
    }
    return found;
  };
  // A sample shows for most objects that they are not.
  if (count > kSampled) {
    const std::size_t step = count / kSampled;
    std::size_t found = 0;
    for (std::size_t k = 0; k < kSampled; ++k) found += count_fine(k * step, k * step + 1);
    if (static_cast<double>(found) < kLeastFine / 2 * static_cast<double>(kSampled)) return false;
  }
  const std::size_t fine = parallel_reduce(count, kShortWorkBlock, std::size_t{0}, count_fine, std::plus<>());
  return static_cast<double>(fine) > kLeastFine * static_cast<double>(count);
}

}  // namespace

std::size_t merge_fine_vertices(Scene& scene) {
  if (!scene.faces.all_triangles() || !scene.corner_flags.empty()) return 0;
  std::vector<std::size_t> counts(scene.objects.size(), 0);
  parallel_tasks(scene.objects.size(), [&](std::size_t i) {
    if (is_fine(scene, scene.objects[i])) counts[i] = FineMesh(scene, scene.objects[i]).run();
  });
  std::size_t merged = 0;
  for (const std::size_t count : counts) merged += count;
  if (merged == 0) return 0;
  Warnings vanished;  // faces without thickness are no loss
  finish_scene(scene, vanished);
  return merged;
}

}  // namespace ligne
