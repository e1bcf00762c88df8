#include "visibility/common/facet.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Relative rounding error of an interpolated depth: a dozen double operations.
constexpr double kDepthRounding = 0x1p-48;

/// As nextafter() towards minus infinity, for any number but minus infinity: floats of one sign are ordered as their
/// bits are.
float next_below(float f) {
  const auto bits = std::bit_cast<std::uint32_t>(f);
  if (f == 0) return -std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}

/// One more than the largest face number of the triangles.
std::uint32_t count_faces(const std::vector<Triangle>& triangles) {
  const auto of_block = [&](std::size_t begin, std::size_t end) {
    std::uint32_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count = std::max(count, triangles[i].face + 1);
    return count;
  };
  const auto larger = [](std::uint32_t a, std::uint32_t b) { return std::max(a, b); };
  return parallel_reduce(triangles.size(), kShortWorkBlock, std::uint32_t{0}, of_block, larger);
}

}  // namespace

float round_down(double v) {
  const float f = static_cast<float>(v);
  return double(f) > v ? next_below(f) : f;
}

float round_up(double v) {
  const float f = static_cast<float>(v);
  return double(f) < v ? -next_below(-f) : f;
}

double depth_tolerance_mm(const ProjectedScene& scene, double gradient, double z_near) {
  const double magnification = scene.magnification(z_near);
  const double error_mm = scene.input_error_mm * magnification;
  const double steps = 1 + 2 * error_mm / scene.lattice.step_mm;
  return steps * gradient + 2 * error_mm * magnification + kDepthRounding * std::abs(z_near);
}

Facets make_facets(const ProjectedScene& scene, double thin_steps) {
  const std::size_t n = scene.triangles.size();
  constexpr std::size_t kBlock = 32'768;
  const std::size_t blocks = (n + kBlock - 1) / kBlock;
  Facets result;
  result.facets = large_vector<Facet>(n);
  std::vector<std::size_t> kept(blocks + 1, 0);
  std::vector<std::vector<std::uint32_t>> thin(blocks);
  const std::uint32_t face_count = count_faces(scene.triangles);

  parallel_for(blocks, [&](std::size_t block) {
    std::size_t out = block * kBlock;
    const std::size_t last = std::min(n, out + kBlock);
    for (std::size_t i = block * kBlock; i < last; ++i) {
      const Triangle& t = scene.triangles[i];
      const ProjectedVertex& a = scene.vertices[t.v[0]];
      const ProjectedVertex& b = scene.vertices[t.v[1]];
      const ProjectedVertex& c = scene.vertices[t.v[2]];
      const double area = scene.is_edge_on(t) ? 0 : orientation(a.p, b.p, c.p);
      const double abx = double(b.p.x) - a.p.x, aby = double(b.p.y) - a.p.y;
      const double acx = double(c.p.x) - a.p.x, acy = double(c.p.y) - a.p.y;
      const double length = std::max(
          {std::abs(abx) + std::abs(aby), std::abs(acx) + std::abs(acy), std::abs(acx - abx) + std::abs(acy - aby)});
      if (std::abs(area) <= thin_steps * length) thin[block].push_back(t.face);
      if (area == 0) continue;
      // Depth gradient by Cramer's rule.
      const double zb = b.z - a.z, zc = c.z - a.z;
      const double gradient = (std::abs(zb * acy - zc * aby) + std::abs(zc * abx - zb * acx)) / std::abs(area);
      Facet& f = result.facets[out++];
      f.v[0] = t.v[0];
      f.v[1] = area > 0 ? t.v[1] : t.v[2];
      f.v[2] = area > 0 ? t.v[2] : t.v[1];
      f.face = t.face;
      const double z_near = std::min({a.z, b.z, c.z});
      f.z_near = round_down(z_near);
      f.z_far = round_up(std::max({a.z, b.z, c.z}));
      f.depth_tolerance = round_up(depth_tolerance_mm(scene, gradient, z_near));
      f.size = round_up(length);
    }
    kept[block + 1] = out - block * kBlock;
  });
  // Close the gaps left by triangles without area.
  std::size_t end = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto first = result.facets.begin() + static_cast<std::ptrdiff_t>(block * kBlock);
    if (end != block * kBlock) std::copy_n(first, kept[block + 1], result.facets.begin() + static_cast<std::ptrdiff_t>(end));
    end += kept[block + 1];
  }
  result.facets.resize(end);
  result.face_is_thin.assign(face_count, 0);
  for (const auto& faces : thin) {
    for (const std::uint32_t f : faces) result.face_is_thin[f] = 1;
  }
  return result;
}

}  // namespace ligne
