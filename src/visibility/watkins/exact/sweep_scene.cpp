#include "visibility/watkins/exact/sweep_scene.hpp"

#include <cassert>

namespace ligne::watkins {
namespace {

/// Lattice coordinates are signed 27-bit numbers. The offset makes them positive, so that keys sort as points do.
std::uint64_t key_of(LatticePoint p) {
  constexpr std::int64_t kOffset = std::int64_t{1} << 30;
  return static_cast<std::uint64_t>(p.y + kOffset) << 32 | static_cast<std::uint64_t>(p.x + kOffset);
}

LatticePoint point_of(std::uint64_t key) {
  constexpr std::int64_t kOffset = std::int64_t{1} << 30;
  return {static_cast<std::int32_t>(static_cast<std::int64_t>(key & 0xffffffffu) - kOffset),
          static_cast<std::int32_t>(static_cast<std::int64_t>(key >> 32) - kOffset)};
}

/// Adds one edge for all uses of a segment.
void add_edges(const ListsOf<SegmentUse>& by_point, SweepScene& scene) {
  scene.first_start.assign(by_point.size() + 1, 0);
  for (std::size_t p = 0; p < by_point.size(); ++p) {
    scene.first_start[p] = static_cast<std::uint32_t>(scene.edges.size());
    const std::span<const SegmentUse> uses = by_point[p];
    for (std::size_t i = 0; i < uses.size();) {
      SweepEdge edge{.top = scene.points[p],
                     .bottom = scene.points[uses[i].other],
                     .top_point = static_cast<std::uint32_t>(p),
                     .bottom_point = uses[i].other,
                     .facets_begin = static_cast<std::uint32_t>(scene.edge_facets.size()),
                     .lines_begin = static_cast<std::uint32_t>(scene.edge_lines.size())};
      const std::uint32_t bottom = uses[i].other;
      for (; i < uses.size() && uses[i].other == bottom; ++i) {
        (uses[i].line ? scene.edge_lines : scene.edge_facets).push_back(uses[i].index);
      }
      edge.facets_end = static_cast<std::uint32_t>(scene.edge_facets.size());
      edge.lines_end = static_cast<std::uint32_t>(scene.edge_lines.size());
      scene.edges.push_back(edge);
    }
  }
  scene.first_start[by_point.size()] = static_cast<std::uint32_t>(scene.edges.size());
}

}  // namespace

bool is_in_scan_order(const SweepScene& scene) {
  for (std::size_t p = 1; p < scene.points.size(); ++p) {
    if (!comes_before(scene.points[p - 1], scene.points[p])) return false;
  }
  for (std::size_t e = 0; e < scene.edges.size(); ++e) {
    const SweepEdge& edge = scene.edges[e];
    if (edge.top_point >= edge.bottom_point || edge.bottom_point >= scene.points.size()) return false;
    if (e > 0 && edge.top_point < scene.edges[e - 1].top_point) return false;
  }
  return true;
}

SweepScene make_sweep_scene(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                            std::span<const SweepLine> lines) {
  // Numbers all distinct places in scan order.
  struct Place {
    std::uint64_t key;
    std::uint32_t user;
    bool operator<(const Place& o) const { return key != o.key ? key < o.key : user < o.user; }
  };
  const std::size_t n = vertices.size();
  std::vector<std::uint8_t> used(n, 0);
  for (const Facet& f : facets) used[f.v[0]] = used[f.v[1]] = used[f.v[2]] = 1;
  std::vector<Place> places;
  places.reserve(n + 2 * lines.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (used[i]) places.push_back({key_of(vertices[i].p), i});
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].to_study()) continue;
    places.push_back({key_of(lines[i].from.p), static_cast<std::uint32_t>(n + 2 * i)});
    places.push_back({key_of(lines[i].to.p), static_cast<std::uint32_t>(n + 2 * i + 1)});
  }
  parallel_sort(places.begin(), places.end());
  SweepScene scene;
  std::vector<std::uint32_t> number(n + 2 * lines.size(), kNone);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0 || places[i].key != places[i - 1].key) scene.points.push_back(point_of(places[i].key));
    number[places[i].user] = static_cast<std::uint32_t>(scene.points.size() - 1);
  }

  const auto for_each_use = [&](const auto& add) {
    const auto use = [&](std::uint32_t a, std::uint32_t b, bool line, std::uint32_t index) {
      if (a != b) add(a, b, line, index);
    };
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      for (int k = 0; k < 3; ++k) use(number[facets[f].v[k]], number[facets[f].v[(k + 1) % 3]], false, f);
    }
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      if (lines[i].to_study()) use(number[n + 2 * i], number[n + 2 * i + 1], true, i);
    }
  };
  add_edges(uses_by_end(scene.points.size(), for_each_use), scene);
  scene.ends = numbers_by_key(scene.points.size(), scene.edges.size(),
                              [&](std::uint32_t edge) { return scene.edges[edge].bottom_point; });
  assert(is_in_scan_order(scene));
  return scene;
}

std::vector<SweepBand> make_bands(const SweepScene& scene) {
  assert(is_in_scan_order(scene));
  constexpr std::uint32_t kPointsPerBand = 4096, kMostBands = 32;
  const auto n = static_cast<std::uint32_t>(scene.points.size());
  if (n == 0) return {};
  const std::uint32_t wanted = std::clamp(n / kPointsPerBand, 1u, kMostBands), size = (n + wanted - 1) / wanted;
  std::vector<SweepBand> bands((n + size - 1) / size);
  for (std::uint32_t b = 0; b < bands.size(); ++b) {
    bands[b].first = b * size;
    bands[b].end = std::min(n, (b + 1) * size);
  }
  for (std::uint32_t e = 0; e < scene.edges.size(); ++e) {
    for (std::uint32_t b = scene.edges[e].top_point / size + 1; b <= scene.edges[e].bottom_point / size; ++b)
      bands[b].active.push_back(e);
  }
  return bands;
}

}  // namespace ligne::watkins
