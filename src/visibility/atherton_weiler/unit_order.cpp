#include "visibility/atherton_weiler/unit_order.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "visibility/polygons/clip_part.hpp"

namespace ligne::atherton_weiler {
namespace {

int common_corners(const Facet& a, const Facet& b) {
  int n = 0;
  for (const std::uint32_t v : a.v) n += v == b.v[0] || v == b.v[1] || v == b.v[2];
  return n;
}

DepthOrder turned(DepthOrder order) {
  return order == DepthOrder::first ? DepthOrder::second : order == DepthOrder::second ? DepthOrder::first : order;
}

}  // namespace

template <class Visit>
void UnitOrders::for_each_pair(std::uint32_t a, std::uint32_t b, const PageBox& within, Visit visit) const {
  struct Boxed {
    std::uint32_t facet;
    PageBox box;
  };
  const auto facets_within = [&](std::uint32_t unit) {
    std::vector<Boxed> list;
    for (const UnitFace& face : units_[unit].faces) {
      for (const std::uint32_t f : face.facets) {
        const PageBox box = box_of(facets_[f], scene_.vertices);
        if (box.meets(within)) list.push_back({f, box});
      }
    }
    return list;
  };
  const std::vector<Boxed> of_a = facets_within(a), of_b = facets_within(b);
  for (const Boxed& fa : of_a) {
    for (const Boxed& fb : of_b) {
      if (fa.box.meets(fb.box)) visit(fa.facet, fb.facet, order_of(facets_, scene_.vertices, fa.facet, fb.facet));
    }
  }
}

DepthOrder UnitOrders::order(std::uint32_t a, std::uint32_t b) {
  if (a > b) return turned(order(b, a));
  const auto [entry, is_new] = known_.try_emplace(std::uint64_t{a} << 32 | b, DepthOrder::first);
  if (!is_new) return entry->second;
  bool first = false, second = false;
  for_each_pair(a, b, common(units_[a].box, units_[b].box), [&](std::uint32_t fa, std::uint32_t fb, const FacetOrder& o) {
    if (o.order == DepthOrder::apart) return;
    first |= o.order != DepthOrder::second;
    second |= o.order != DepthOrder::first;
    if (o.tie || (o.touching && common_corners(facets_[fa], facets_[fb]) < 2)) touches_[fa] = touches_[fb] = 1;
  });
  entry->second = first && second ? DepthOrder::crossing : second ? DepthOrder::second : DepthOrder::first;
  return entry->second;
}

std::vector<ContourFace> UnitOrders::front_parts(std::uint32_t a, std::uint32_t b, const PageBox& within) {
  std::vector<ContourFace> parts;
  for_each_pair(a, b, within, [&](std::uint32_t fa, std::uint32_t fb, const FacetOrder& o) {
    if (o.order == DepthOrder::apart || o.order == DepthOrder::first) return;
    ClipPart front = whole_facet(facets_, scene_.vertices, fb);
    if (o.order == DepthOrder::crossing) front = left_of(front, {o.cut.b, o.cut.a});
    if (front.count == 0) return;
    const ContourFace subject = front.face(), clip = whole_facet(facets_, scene_.vertices, fa).face();
    clip_.divide(std::span(&subject, 1), std::span(&clip, 1));
    for (ContourFace& face : clip_.take_inside()) parts.push_back(std::move(face));
  });
  return parts;
}

}  // namespace ligne::atherton_weiler
