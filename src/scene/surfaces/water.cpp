#include "scene/surfaces/water.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

/// A part of the stroke with this number.
struct Run {
  std::int64_t number;
  double from, to;
};

}  // namespace

std::optional<double> fill_holes(SurfacePoints& surface) {
  std::optional<double> lowest, highest;
  for (const Point3& p : surface.points) {
    if (!std::isfinite(p.z)) continue;
    lowest = std::min(lowest.value_or(p.z), p.z);
    highest = std::max(highest.value_or(p.z), p.z);
  }
  if (!lowest) return std::nullopt;
  const double depth = *lowest < *highest ? *highest - *lowest : 1;
  for (Point3& p : surface.points) {
    if (!std::isfinite(p.z)) p.z = *lowest - depth;
  }
  return lowest;
}

WaterTriangles flood(SurfaceMesh& mesh, double level) {
  const std::array<double, 1> levels{level};
  cut_contours(mesh, levels);
  constexpr auto kLines = static_cast<std::uint8_t>(kCornerCurve | kCornerContour);
  // No triangle has heights below and above the level, except by rounding: cut_contours() has made a vertex wherever a
  // triangle crosses the level by more than that.
  WaterTriangles water(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double low = level, high = level;
    for (const std::uint32_t v : mesh.triangles[t]) {
      low = std::min(low, mesh.vertices[v].z);
      high = std::max(high, mesh.vertices[v].z);
    }
    water[t] = level - low > high - level;
  }
  std::vector<std::uint8_t> is_shore(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (water[t]) continue;
    for (const std::uint32_t v : mesh.triangles[t]) is_shore[v] = 1;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!water[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      const bool shore = (mesh.flags[t][k] & kCornerContour) && is_shore[a] && is_shore[b];
      mesh.flags[t][k] = static_cast<std::uint8_t>((mesh.flags[t][k] & ~kLines) | (shore ? kCornerContour : 0));
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!water[t]) continue;
    for (const std::uint32_t v : mesh.triangles[t]) mesh.vertices[v].z = level;
  }
  return water;
}

std::vector<std::array<Point3, 2>> hatch_water(const SurfaceMesh& mesh, const WaterTriangles& water, const Point3& factor,
                                               Point2 along, double spacing) {
  const Point2 across{-along.y, along.x};
  std::vector<Run> runs;
  double height = 0;
  for (std::size_t t = 0; t < water.size(); ++t) {
    if (!water[t]) continue;
    std::array<Point2, 3> p;  // x along the strokes, y across them in spacings
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 v = mesh.vertices[mesh.triangles[t][k]] * factor;
      height = v.z;
      p[k] = {v.x * along.x + v.y * along.y, (v.x * across.x + v.y * across.y) / spacing};
    }
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    for (double n = std::ceil(low); n < high; ++n) {
      double from = INFINITY, to = -INFINITY;
      for (std::size_t k = 0; k < 3; ++k) {
        // From the lower end upwards, so that both triangles of an edge find the same point.
        Point2 a = p[k], b = p[(k + 1) % 3];
        if (b.y < a.y) std::swap(a, b);
        if (!(a.y <= n && n < b.y)) continue;
        const double at = a.x + (b.x - a.x) * ((n - a.y) / (b.y - a.y));
        from = std::min(from, at);
        to = std::max(to, at);
      }
      if (from < to) runs.push_back({static_cast<std::int64_t>(n), from, to});
    }
  }
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.number != b.number ? a.number < b.number : a.from < b.from; });
  std::vector<std::array<Point3, 2>> lines;
  const auto point = [&](double at, double number) {
    const Point2 p = along * at + across * (number * spacing);
    return Point3{p.x, p.y, height};
  };
  for (std::size_t i = 0; i < runs.size();) {
    double to = runs[i].to;
    std::size_t next = i + 1;
    while (next < runs.size() && runs[next].number == runs[i].number && runs[next].from <= to)
      to = std::max(to, runs[next++].to);
    const auto number = static_cast<double>(runs[i].number);
    lines.push_back({point(runs[i].from, number), point(to, number)});
    i = next;
  }
  return lines;
}

}  // namespace ligne
