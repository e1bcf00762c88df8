#include "visibility/raster/convex_filler.hpp"

namespace ligne {
namespace {

__extension__ using Int128 = __int128;

}  // namespace

void ConvexFiller::walk(FixedCorner a, FixedCorner b, std::int64_t first, std::int64_t end) {
  // Every side is walked downwards, so that it gives equal places for both polygons that share it.
  if (b.v < a.v) std::swap(a, b);
  const std::int64_t from = std::max(first, ceiling(a.v, FixedCorner::kPlaces)),
                     to = std::min(end, ceiling(b.v, FixedCorner::kPlaces));
  if (from >= to) return;
  const std::int64_t du = b.u - a.u, dv = b.v - a.v;
  const std::int64_t step = static_cast<std::int64_t>((Int128{du} << 32) / dv);
  const std::int64_t down = (from << FixedCorner::kPlaces) - a.v;
  std::int64_t u = (a.u << (32 - FixedCorner::kPlaces)) +
                   static_cast<std::int64_t>((Int128{du} * down << (32 - FixedCorner::kPlaces)) / dv);
  for (std::int64_t line = from; line < to; ++line, u += step) {
    Places& p = lines_[static_cast<std::size_t>(line - first)];
    (p.first == kNone ? p.first : p.second) = u;
  }
}

}  // namespace ligne
