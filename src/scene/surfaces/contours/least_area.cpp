#include "scene/surfaces/contours/least_area.hpp"

#include <glm/geometric.hpp>

#include <limits>

#include "geometry/predicates.hpp"

namespace ligne {

std::vector<std::array<std::uint32_t, 3>> least_area_triangles(std::span<const Point3> corners) {
  const std::size_t n = corners.size();
  if (n < 3) return {};
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto flat = [&](std::size_t i) { return Point2{corners[i].x, corners[i].y}; };
  // least[i * n + k]: smallest area of triangles between corners i and k; apex[i * n + k]: third corner of the one at i
  // k.
  std::vector<double> least(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t k = i + span;
      double best = kNone;
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
  if (!(least[n - 1] < kNone)) return {};
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

}  // namespace ligne
