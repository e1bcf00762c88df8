#include "scene/clean/far_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Number of vertices from which the median is taken: so many cost nothing beside reading.
constexpr std::size_t kSample = 10000;

double largest_coordinate(const Point3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

double usual_coordinate(std::span<const Point3> vertices) {
  std::vector<double> sizes;
  const std::size_t stride = std::max<std::size_t>(1, vertices.size() / kSample);
  for (std::size_t v = 0; v < vertices.size(); v += stride) {
    if (const double size = largest_coordinate(vertices[v]); size > 0) sizes.push_back(size);
  }
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return *middle;
}

}  // namespace

FarVertices find_far_vertices(std::span<const Point3> vertices) {
  struct Found {
    std::size_t count = 0, farthest = 0;
    double size = 0;
    Found operator+(const Found& o) const {
      const Found& larger = o.size > size ? o : *this;
      return {count + o.count, larger.farthest, larger.size};
    }
  };
  const double usual = usual_coordinate(vertices), limit = kFarRatio * usual;
  if (usual == 0) return {};
  const Found found = parallel_reduce(vertices.size(), kShortWorkBlock, Found{}, [&](std::size_t begin, std::size_t end) {
    Found of_block;
    for (std::size_t v = begin; v < end; ++v) {
      const double size = largest_coordinate(vertices[v]);
      if (size <= limit) continue;
      ++of_block.count;
      if (size > of_block.size) of_block = {of_block.count, v, size};
    }
    return of_block;
  });
  return {found.count, found.farthest, usual};
}

}  // namespace ligne
