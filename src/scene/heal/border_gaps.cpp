#include "scene/heal/border_gaps.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Smallest ratio of two gaps that separates cracks from openings, and largest crack relative to the median border edge
/// and to the model. Adjustable; see find_gap_break().
constexpr double kBreak = 2;
constexpr double kPartOfMedian = 1.0 / 8;
constexpr double kPartOfModel = 1.0 / 4096;

/// The gaps at the border's vertices up to a distance, in ascending order.
std::vector<double> gaps_up_to(const Border& border, double distance) {
  if (border.is_of_one_face()) return {};
  const std::vector<std::uint32_t>& vertices = border.vertices();
  std::vector<double> gaps(vertices.size(), -1);
  const std::vector<EdgeTree::Segment> segments = border.segments();
  const SegmentCells cells(segments, distance);
  std::vector<std::uint8_t> exceeds_limit(vertices.size(), 0);
  const auto keep = [&](std::size_t k, const NearestPoint& nearest) {
    if (nearest.segment != kNone) gaps[k] = nearest.distance;
  };
  const auto search_cell = [&](std::size_t k) {
    const Point3& p = border.point(vertices[k]);
    const std::span<const std::uint32_t> near = cells.near(p);
    exceeds_limit[k] = near.size() > EdgeTree::kMostVisits;
    if (exceeds_limit[k]) return;
    const auto is_apart = [&](std::uint32_t e, double at) { return border.is_apart(vertices[k], e, at); };
    keep(k, nearest_among(segments, near, p, distance, is_apart));
  };
  parallel_each(vertices.size(), search_cell, kSearchBlock);
  const std::vector<std::uint32_t> crowded =
      indices_where(vertices.size(), [&](std::size_t k) { return exceeds_limit[k] != 0; });
  if (!crowded.empty()) {
    const BorderSearch search(border);
    parallel_each(
        crowded.size(), [&](std::size_t i) { keep(crowded[i], search.nearest(vertices[crowded[i]], distance)); },
        kSearchBlock);
  }
  std::erase(gaps, -1.0);
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

GapBreak break_after(const std::vector<double>& gaps, std::size_t count, double distance) {
  return {distance, count, count < gaps.size() ? gaps[count] : 0};
}

std::size_t count_within(const std::vector<double>& gaps, double distance) {
  return static_cast<std::size_t>(std::upper_bound(gaps.begin(), gaps.end(), distance) - gaps.begin());
}

}  // namespace

Border::Border(const Scene& scene, std::vector<Edge> edges) : scene_(scene), edges_(std::move(edges)) {
  // The lower ends are sorted already.
  for (const Edge& edge : edges_) vertices_.push_back(edge.v0);
  for (const Edge& edge : edges_) vertices_.push_back(edge.v1);
  const auto higher = vertices_.begin() + static_cast<std::ptrdiff_t>(edges_.size());
  std::sort(higher, vertices_.end());
  std::inplace_merge(vertices_.begin(), higher, vertices_.end());
  const auto make_unique = [](auto& values) { values.erase(std::unique(values.begin(), values.end()), values.end()); };
  make_unique(vertices_);
  one_face_ = std::ranges::all_of(edges_, [&](const Edge& edge) { return edge.face0 == edges_[0].face0; });
  if (scene.faces.all_triangles()) return;
  std::vector<std::uint32_t> faces;
  for (const Edge& edge : edges_) faces.push_back(edge.face0);
  std::sort(faces.begin(), faces.end());
  make_unique(faces);
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : corners_of(scene.faces, f)) corners_.emplace_back(f, v);
  }
  std::sort(corners_.begin(), corners_.end());
  make_unique(corners_);
}

std::vector<EdgeTree::Segment> Border::segments() const {
  std::vector<EdgeTree::Segment> segments;
  segments.reserve(edges_.size());
  for (const Edge& edge : edges_) segments.push_back({point(edge.v0), point(edge.v1)});
  return segments;
}

double Border::median_length() const {
  if (edges_.empty()) return 0;
  std::vector<double> lengths;
  lengths.reserve(edges_.size());
  for (const Edge& edge : edges_) lengths.push_back(edge_length(scene_, edge));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

bool Border::has(std::uint32_t face, std::uint32_t v) const {
  if (scene_.faces.all_triangles()) {
    const std::uint32_t* const corner = &std::as_const(scene_.faces).corners()[3 * std::size_t{face}];
    return corner[0] == v || corner[1] == v || corner[2] == v;
  }
  return std::binary_search(corners_.begin(), corners_.end(), std::pair(face, v));
}

bool Border::adjacent(std::uint32_t u, std::uint32_t v) const {
  const auto [low, high] = std::minmax(u, v);
  const auto at = std::lower_bound(edges_.begin(), edges_.end(), std::pair(low, high),
                                   [](const Edge& e, const auto& ends) { return std::pair(e.v0, e.v1) < ends; });
  return at != edges_.end() && at->v0 == low && at->v1 == high;
}

bool Border::is_apart(std::uint32_t v, std::uint32_t e, double at) const {
  const Edge& edge = edges_[e];
  if (edge.v0 == v || edge.v1 == v) return false;
  if (at == 0 && adjacent(edge.v0, v)) return false;
  if (at == 1 && adjacent(edge.v1, v)) return false;
  return !has(edge.face0, v);
}

NearestPoint BorderSearch::nearest(std::uint32_t v, double distance, double inside) const {
  if (border_.is_of_one_face()) return {};  // the face has v, so no point is apart from it
  return tree_.nearest(border_.point(v), distance, [&](std::uint32_t e, double at) {
    if (inside > 0) {
      const Edge& edge = border_.edges()[e];
      const double length = glm::distance(border_.point(edge.v0), border_.point(edge.v1));
      if (!(std::min(at, 1 - at) * length > inside)) return false;
    }
    return border_.is_apart(v, e, at);
  });
}

GapBreak find_gap_break(const Border& border, double precision, double model_size) {
  const double median = border.median_length();
  const double roundings = straightness_tolerance(precision, median);
  const double limit = std::max(roundings, std::min(kPartOfMedian * median, kPartOfModel * model_size));
  const std::vector<double> gaps = gaps_up_to(border, kBreak * limit);
  for (std::size_t n = count_within(gaps, limit); n > 0 && gaps[n - 1] > roundings; --n) {
    const bool is_break = n == gaps.size() || gaps[n] >= kBreak * gaps[n - 1];
    if (is_break) return break_after(gaps, n, gaps[n - 1]);
  }
  const std::size_t rounded = count_within(gaps, roundings);
  return rounded > 0 ? break_after(gaps, rounded, roundings) : GapBreak{};
}

GapBreak gaps_within(const Border& border, double distance) {
  const std::vector<double> gaps = gaps_up_to(border, kBreak * distance);
  return break_after(gaps, count_within(gaps, distance), distance);
}

}  // namespace ligne
