#include "contours/shapes/zero_chains.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"

namespace ligne {
namespace {

class ZeroTracer {
 public:
  ZeroTracer(const FormMesh& mesh, const std::vector<double>& value, const std::vector<Point3>& way)
      : mesh_(mesh), value_(value), way_(way), done_(mesh.triangles.size(), 0) {}

  std::vector<ZeroChain> trace() {
    std::vector<ZeroChain> chains;
    const auto n = static_cast<std::uint32_t>(mesh_.triangles.size());
    for (std::uint32_t t = 0; t < n; ++t) {  // open chains, from their ends
      if (done_[t] || !is_crossed(t)) continue;
      for (const int side : crossed_sides(t)) {
        if (!done_[t] && beyond(t, side) == kNone) chains.push_back(walk(t, side, false));
      }
    }
    for (std::uint32_t t = 0; t < n; ++t) {
      if (!done_[t] && is_crossed(t)) chains.push_back(walk(t, crossed_sides(t)[0], true));
    }
    return chains;
  }

 private:
  using Ends = std::array<std::uint32_t, 2>;

  /// The nodes of a side, the lower first, so that both of its triangles get the same pair.
  Ends ends_of(std::uint32_t t, int side) const {
    const auto& node = mesh_.triangles[t].node;
    const std::uint32_t a = node[static_cast<std::size_t>(side)], b = node[static_cast<std::size_t>((side + 1) % 3)];
    return {std::min(a, b), std::max(a, b)};
  }
  double second_value(const Ends& ends) const {
    const bool turned = !way_.empty() && glm::dot(way_[ends[0]], way_[ends[1]]) < 0;
    return turned ? -value_[ends[1]] : value_[ends[1]];
  }
  bool crosses(std::uint32_t t, int side) const {
    const Ends ends = ends_of(t, side);
    return (value_[ends[0]] >= 0) != (second_value(ends) >= 0);
  }
  bool is_crossed(std::uint32_t t) const { return crosses(t, 0) + crosses(t, 1) + crosses(t, 2) == 2; }
  std::array<int, 2> crossed_sides(std::uint32_t t) const {
    if (!crosses(t, 0)) return {1, 2};
    return {0, crosses(t, 1) ? 1 : 2};
  }
  /// The triangle that continues the chain beyond a side, or kNone.
  std::uint32_t beyond(std::uint32_t t, int side) const {
    const std::uint32_t other = mesh_.triangles[t].across[static_cast<std::size_t>(side)];
    return other == kNone || !is_crossed(other) ? kNone : other;
  }
  int same_side(std::uint32_t t, const Ends& ends) const {
    for (int side = 0; side < 2; ++side) {
      if (ends_of(t, side) == ends) return side;
    }
    return 2;
  }

  Point3 point(const Ends& ends) const {
    const double a = value_[ends[0]], b = second_value(ends);
    return mesh_.points[ends[0]] + (a / (a - b)) * (mesh_.points[ends[1]] - mesh_.points[ends[0]]);
  }

  ZeroChain walk(std::uint32_t t, int entry, bool closed) {
    ZeroChain chain;
    chain.closed = closed;
    chain.points.push_back(point(ends_of(t, entry)));
    while (t != kNone && !done_[t]) {
      done_[t] = 1;
      const auto sides = crossed_sides(t);
      const int exit = sides[0] == entry ? sides[1] : sides[0];
      const Ends ends = ends_of(t, exit);
      chain.triangles.push_back(t);
      chain.points.push_back(point(ends));
      t = beyond(t, exit);
      if (t != kNone) entry = same_side(t, ends);
    }
    if (closed) chain.points.back() = chain.points.front();
    return chain;
  }

  const FormMesh& mesh_;
  const std::vector<double>& value_;
  const std::vector<Point3>& way_;
  std::vector<std::uint8_t> done_;
};

}  // namespace

std::vector<ZeroChain> trace_zero_set(const FormMesh& mesh, const std::vector<double>& value,
                                      const std::vector<Point3>& way) {
  return ZeroTracer(mesh, value, way).trace();
}

}  // namespace ligne
