#include "visibility/watkins/exact/face_orders.hpp"

#include <algorithm>
#include <numeric>

#include "visibility/polygons/facet_order.hpp"

namespace ligne::watkins {

FacetsOfFaces::FacetsOfFaces(const std::vector<Facet>& facets, std::uint32_t face_count)
    : first(face_count + 1, 0), list(facets.size()) {
  for (const Facet& f : facets) ++first[f.face + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < facets.size(); ++i) list[next[facets[i].face]++] = i;
}

DepthOrder FaceOrders::of(std::uint32_t a, std::uint32_t b) {
  if (a == b || (skew_ && (skew_->has(a) || skew_->has(b)))) return DepthOrder::crossing;
  const std::uint32_t low = std::min(a, b), high = std::max(a, b);
  const auto [place, fresh] = known_.try_emplace((std::uint64_t{low} << 32) | high, DepthOrder::crossing);
  if (fresh) place->second = decide(low, high);
  const DepthOrder order = place->second;
  if (a == low || order == DepthOrder::crossing) return order;
  return order == DepthOrder::first ? DepthOrder::second : DepthOrder::first;
}

void FaceOrders::extents_of(std::uint32_t face, std::vector<Extent>& extents) const {
  extents.clear();
  for (const std::uint32_t f : of_faces_.of(face)) {
    const std::uint32_t* v = facets_[f].v;
    const LatticePoint a = vertices_[v[0]].p, b = vertices_[v[1]].p, c = vertices_[v[2]].p;
    extents.push_back(
        {std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), f});
  }
  std::sort(extents.begin(), extents.end(),
            [](const Extent& p, const Extent& q) { return p.x0 != q.x0 ? p.x0 < q.x0 : p.facet < q.facet; });
}

/// Compares all facets of one face with the overlapping facets of the other, from left to right. Requires a < b.
DepthOrder FaceOrders::decide(std::uint32_t a, std::uint32_t b) {
  extents_of(a, extents_a_);
  extents_of(b, extents_b_);
  open_.clear();
  bool a_in_front = false, b_in_front = false;
  std::size_t next = 0;
  for (const Extent& e : extents_a_) {
    while (next < extents_b_.size() && extents_b_[next].x0 < e.x1) open_.push_back(extents_b_[next++]);
    // Drops extents that end left of this one: later ones begin no farther left.
    std::erase_if(open_, [&](const Extent& o) { return o.x1 <= e.x0; });
    for (const Extent& o : open_) {
      if (o.x0 >= e.x1 || o.y1 <= e.y0 || o.y0 >= e.y1) continue;
      const FacetOrder order = order_of(facets_, vertices_, e.facet, o.facet);
      if (order.order == DepthOrder::crossing) return DepthOrder::crossing;
      if (order.order == DepthOrder::apart || order.tie) continue;
      (order.order == DepthOrder::first ? a_in_front : b_in_front) = true;
      if (a_in_front && b_in_front) return DepthOrder::crossing;
    }
  }
  return b_in_front ? DepthOrder::second : DepthOrder::first;
}

}  // namespace ligne::watkins
