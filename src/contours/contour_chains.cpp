#include "contours/contour_chains.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// A curve whose end normals are those of a mesh edge rises above the edge by an eighth of its length times the angle
/// between them, which below the crease angle of 30 degrees is less than this share. More comes of normals that have gone
/// astray.
constexpr double kHighestRise = 0.07;

class ContourTracer {
 public:
  ContourTracer(const Scene& scene, const SmoothPatch& patch)
      : scene_(scene), patch_(patch), done_(patch.triangles.size(), 0) {}

  std::vector<ContourChain> trace() {
    std::vector<ContourChain> chains;
    const auto n = static_cast<std::uint32_t>(patch_.triangles.size());
    for (std::uint32_t t = 0; t < n; ++t) {  // from their loose ends
      if (done_[t] || !is_crossed(t)) continue;
      for (const std::uint32_t side : crossed_sides(t)) {
        if (!done_[t] && beyond(side) == kNone) chains.push_back(walk(t, side, false));
      }
    }
    for (std::uint32_t t = 0; t < n; ++t) {
      if (!done_[t] && is_crossed(t)) chains.push_back(walk(t, crossed_sides(t)[0], true));
    }
    return chains;
  }

 private:
  bool crosses(std::uint32_t side) const {
    return patch_.looks_at_viewer(side) != patch_.looks_at_viewer(next_corner(side));
  }
  bool is_crossed(std::uint32_t t) const {
    if (!patch_.complete[3 * t] || !patch_.complete[3 * t + 1] || !patch_.complete[3 * t + 2]) return false;
    return crosses(3 * t) || crosses(3 * t + 1);
  }
  std::array<std::uint32_t, 2> crossed_sides(std::uint32_t t) const {
    if (!crosses(3 * t)) return {3 * t + 1, 3 * t + 2};
    return {3 * t, crosses(3 * t + 1) ? 3 * t + 1 : 3 * t + 2};
  }
  /// The triangle that continues the chain beyond a side, or kNone.
  std::uint32_t beyond(std::uint32_t side) const {
    const std::uint32_t other = patch_.across[side];
    return other == kNone || !is_crossed(other / 3) ? kNone : other / 3;
  }

  ContourChain walk(std::uint32_t t, std::uint32_t entry, bool closed) {
    ContourChain chain;
    chain.closed = closed;
    chain.nodes.push_back(node(entry));
    while (t != kNone && !done_[t]) {
      done_[t] = 1;
      const auto sides = crossed_sides(t);
      const std::uint32_t exit = sides[0] == entry ? sides[1] : sides[0];
      chain.triangles.push_back(t);
      chain.nodes.push_back(node(exit));
      t = beyond(exit);
      entry = patch_.across[exit];
    }
    if (closed) chain.nodes.back() = chain.nodes.front();
    return chain;
  }

  const Point3& vertex(std::uint32_t corner) const { return scene_.vertices[patch_.triangles[corner / 3].v[corner % 3]]; }

  ContourNode node(std::uint32_t side) const {
    ContourNode out;
    out.side = side;
    // The same end first from both triangles, so that both get the same point.
    std::uint32_t a = side, b = next_corner(side);
    if (patch_.triangles[a / 3].v[a % 3] > patch_.triangles[b / 3].v[b % 3]) std::swap(a, b);
    const Point3 &p = vertex(a), &q = vertex(b);
    const Point3 &np = patch_.normals[patch_.sector[a]], &nq = patch_.normals[patch_.sector[b]];
    const double ga = patch_.g[patch_.sector[a]], gb = patch_.g[patch_.sector[b]];
    const double t = ga == gb ? 0.5 : std::clamp(ga / (ga - gb), 0.0, 1.0);
    out.on_mesh = p + t * (q - p);
    const Point3 n = (1 - t) * np + t * nq;
    const double size = glm::length(n);
    out.normal = size > 0 ? n / size : np;
    // Cubic with tangents in the tangent planes of the ends [Vlachos2001].
    const Point3 d = q - p;
    const Point3 rise = (1 - t) * t * (t * glm::dot(d, nq) * nq - (1 - t) * glm::dot(d, np) * np);
    const double most = kHighestRise * glm::length(d), height = glm::length(rise);
    out.on_surface = out.on_mesh + (height > most ? rise * (most / height) : rise);
    if (patch_.across[side] == kNone) {
      const bool facing = patch_.facing[side / 3] >= 0;
      const std::uint32_t corner = patch_.looks_at_viewer(side) != facing ? side : next_corner(side);
      out.meets = patch_.triangles[corner / 3].v[corner % 3];
    }
    return out;
  }

  const Scene& scene_;
  const SmoothPatch& patch_;
  std::vector<std::uint8_t> done_;
};

}  // namespace

std::vector<ContourChain> trace_contours(const Scene& scene, const SmoothPatch& patch) {
  return ContourTracer(scene, patch).trace();
}

}  // namespace ligne
