#include "clear/mesh_sags.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"

namespace ligne::test {
namespace {

constexpr double kSagCellMm = 2;
constexpr double kDegree = 3.14159265358979323846 / 180;
/// Sags on the page are taken for no larger, mm.
constexpr double kLargestSagMm = 5;
/// A neighbour narrower by more than this factor decides alone.
constexpr double kWidthRatio = 4;

double width_across(const Scene& scene, std::uint32_t face, const Point3& from, const Point3& along) {
  double widest = 0;
  for (const std::uint32_t v : scene.faces.contour(face, 0)) {
    widest = std::max(widest, glm::length(glm::cross(along, scene.vertices[v] - from)));
  }
  return widest;
}

double distance(Point2 p, Point2 a, Point2 b) { return glm::length(a + nearest_on_segment(p, a, b) * (b - a) - p); }

double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }

double distance(Point2 p, Point2 a, Point2 b, Point2 c) {
  const double u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
  if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) return 0;
  return std::min({distance(p, a, b), distance(p, b, c), distance(p, c, a)});
}

}  // namespace

MeshSags::MeshSags(const Scene& scene, const Topology& topology, const View& view, double most_degrees) {
  std::vector<double> sags(scene.faces.size(), 0.0);
  for (const Edge& edge : topology.edges) {
    if (edge.face1 == kNone) continue;
    const Point3 n0 = face_normal(scene, edge.face0), n1 = face_normal(scene, edge.face1);
    const double turn = std::atan2(glm::length(glm::cross(n0, n1)), glm::dot(n0, n1));
    if (turn > most_degrees * kDegree) continue;
    const Point3 from = scene.vertices[edge.v0], to = scene.vertices[edge.v1];
    if (from == to) continue;
    const Point3 along = glm::normalize(to - from);
    const double w0 = width_across(scene, edge.face0, from, along), w1 = width_across(scene, edge.face1, from, along);
    const double rise = std::tan(turn / 4) / 2;
    sags[edge.face0] += (w0 > kWidthRatio * w1 ? w1 : w0) * rise;
    sags[edge.face1] += (w1 > kWidthRatio * w0 ? w0 : w1) * rise;
  }
  constexpr double kFar = std::numeric_limits<double>::max();
  bounds_ = {{kFar, kFar}, {-kFar, -kFar}};
  for (const Triangle& t : topology.triangles) {
    const auto at = [&](int k) { return page_point(view, scene.vertices[t.v[static_cast<std::size_t>(k)]]); };
    const PageTriangle on_page{at(0), at(1), at(2), std::min(sags[t.face] * view.scale, kLargestSagMm)};
    if (!std::isfinite(on_page.a.x + on_page.b.x + on_page.c.x + on_page.sag)) continue;
    triangles_.push_back(on_page);
    largest_sag_ = std::max(largest_sag_, on_page.sag);
    for (const Point2 p : {on_page.a, on_page.b, on_page.c}) {
      bounds_.min = glm::min(bounds_.min, p);
      bounds_.max = glm::max(bounds_.max, p);
    }
  }
  if (triangles_.empty()) bounds_ = {{0, 0}, {1, 1}};
  columns_ = std::clamp(static_cast<int>((bounds_.max.x - bounds_.min.x) / kSagCellMm) + 1, 1, 1000);
  rows_ = std::clamp(static_cast<int>((bounds_.max.y - bounds_.min.y) / kSagCellMm) + 1, 1, 1000);
  const auto each_cell = [&](const PageTriangle& t, const auto& visit) {
    const Point2 low = glm::min(glm::min(t.a, t.b), t.c), high = glm::max(glm::max(t.a, t.b), t.c);
    const auto column = [&](double x) {
      return std::clamp(static_cast<int>((x - bounds_.min.x) / kSagCellMm), 0, columns_ - 1);
    };
    const auto row = [&](double y) { return std::clamp(static_cast<int>((y - bounds_.min.y) / kSagCellMm), 0, rows_ - 1); };
    for (int y = row(low.y); y <= row(high.y); ++y) {
      for (int x = column(low.x); x <= column(high.x); ++x) visit(static_cast<std::size_t>(y * columns_ + x));
    }
  };
  cell_begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (const PageTriangle& t : triangles_) each_cell(t, [&](std::size_t cell) { ++cell_begin_[cell + 1]; });
  for (std::size_t i = 1; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
  cell_items_.resize(cell_begin_.back());
  std::vector<std::uint32_t> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    each_cell(triangles_[i], [&](std::size_t cell) { cell_items_[next[cell]++] = i; });
  }
}

std::optional<double> MeshSags::at(Point2 p, double within_mm) const {
  const auto cell = [](double offset, int count) { return std::clamp(static_cast<int>(offset / kSagCellMm), 0, count - 1); };
  const double reach = within_mm + largest_sag_;
  const Point2 low = p - Point2(reach) - bounds_.min, high = p + Point2(reach) - bounds_.min;
  std::optional<double> largest;
  for (int y = cell(low.y, rows_); y <= cell(high.y, rows_); ++y) {
    for (int x = cell(low.x, columns_); x <= cell(high.x, columns_); ++x) {
      const auto at = static_cast<std::size_t>(y * columns_ + x);
      for (std::uint32_t i = cell_begin_[at]; i < cell_begin_[at + 1]; ++i) {
        const PageTriangle& t = triangles_[cell_items_[i]];
        if (largest && t.sag <= *largest) continue;
        if (distance(p, t.a, t.b, t.c) <= within_mm + t.sag) largest = t.sag;
      }
    }
  }
  return largest;
}

}  // namespace ligne::test
