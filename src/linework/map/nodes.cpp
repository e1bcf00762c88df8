#include "linework/map/nodes.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/hash.hpp"
#include "base/indices_where.hpp"
#include "base/parallel_counting_sort.hpp"

namespace ligne {
namespace {

// Adjustable: ends in a bucket, so that sorting stays in the first-level cache; binary logarithm of the most buckets, which
// limits the memory areas that a scattering pass writes to at once; buckets that one task sorts; strokes that one task
// scatters.
constexpr std::size_t kBucketEnds = 256;
constexpr unsigned kMostBucketBits = 14;
constexpr std::size_t kBucketsPerTask = 16;
constexpr std::size_t kScatteredBlock = 131'072;

}  // namespace

void for_each_node(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                   FunctionRef<void(std::span<const StrokeEnd>)> visit) {
  const unsigned bits = std::min<unsigned>(kMostBucketBits, std::bit_width(2 * members.size() / kBucketEnds));
  const auto bucket_of = [&](LatticePoint p) {
    const std::uint64_t key = std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y);
    return bits == 0 ? 0 : static_cast<std::size_t>(mix_bits(key) >> (64 - bits));
  };
  std::vector<StrokeEnd> ends(2 * members.size());
  const auto list = [&](std::size_t first, std::size_t last, const auto& take) {
    for (std::size_t i = first; i < last; ++i) {
      const Stroke& s = strokes[members[i]];
      const auto end = static_cast<std::uint32_t>(2 * i);
      take(bucket_of(s.from), s.from, end);
      take(bucket_of(s.to), s.to, end + 1);
    }
  };
  const auto put = [&](std::size_t place, LatticePoint p, std::uint32_t end) { ends[place] = {p, end}; };
  const std::size_t count = std::size_t{1} << bits;
  const auto begin = parallel_counting_sort(
      members.size(), kScatteredBlock, count, list, [](std::size_t) {}, put);
  parallel_blocks(count, kBucketsPerTask, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      const std::span<StrokeEnd> bucket(ends.data() + begin[b], ends.data() + begin[b + 1]);
      std::ranges::sort(bucket, {}, [](const StrokeEnd& e) { return std::tie(e.p.x, e.p.y, e.end); });
      for (std::size_t from = 0, to = 0; from < bucket.size(); from = to) {
        while (to < bucket.size() && bucket[to].p == bucket[from].p) ++to;
        visit(bucket.subspan(from, to - from));
      }
    }
  });
}

Nodes::Nodes(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members)
    : of_(2 * members.size()), next_(of_.size(), kNone), first_(of_.size(), kNone), degree_(of_.size(), 0) {
  for_each_node(strokes, members, [&](std::span<const StrokeEnd> ends) {
    const std::uint32_t node = ends[0].end;
    first_[node] = node;
    degree_[node] = static_cast<std::uint32_t>(ends.size());
    for (std::size_t k = 0; k < ends.size(); ++k) {
      of_[ends[k].end] = node;
      if (k + 1 < ends.size()) next_[ends[k].end] = ends[k + 1].end;
    }
  });
}

Nodes::Nodes(const std::vector<Stroke>& strokes)
    : Nodes(strokes, indices_where(strokes.size(), [](std::size_t) { return true; })) {}

void Nodes::add() {
  const std::uint32_t end = end_count();
  of_.push_back(end);
  next_.push_back(kNone);
  first_.push_back(end);
  degree_.push_back(1);
}

void Nodes::link(std::uint32_t end, std::uint32_t node) {
  std::uint32_t* place = &first_[node];
  while (*place != kNone && *place < end) place = &next_[*place];
  next_[end] = std::exchange(*place, end);
  of_[end] = node;
  ++degree_[node];
}

void Nodes::unlink(std::uint32_t end) {
  const std::uint32_t node = of_[end];
  std::uint32_t* place = &first_[node];
  while (*place != end) place = &next_[*place];
  *place = std::exchange(next_[end], kNone);
  --degree_[node];
}

}  // namespace ligne
