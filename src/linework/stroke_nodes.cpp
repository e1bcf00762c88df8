#include "linework/stroke_nodes.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "base/hash.hpp"

namespace ligne {
namespace {

// Adjustable: ends in a bucket (12 bytes each, so that the ends and their table fit into the first-level cache); binary
// logarithm of the most buckets, which limits the memory areas that a scattering pass writes to at once; buckets that
// one task sorts; strokes that one task scatters.
constexpr std::size_t kBucketEnds = 512;
constexpr unsigned kMostBucketBits = 14;
constexpr std::size_t kBucketsPerTask = 16;
constexpr std::size_t kScatteredBlock = 131'072;
/// Adjustable: above this many ends in a bucket, buckets are chosen by hash.
constexpr std::uint32_t kMaxBucketSize = 64 * kBucketEnds;

std::uint64_t hash_of(LatticePoint p) { return mix_bits(std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y)); }

/// All ends in buckets. A bucket is a square of the page, since strokes that are near each other on the page are mostly
/// near in memory. If a square has too many ends, buckets are chosen by the hash of the point.
class Buckets {
 public:
  Buckets(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members)
      : strokes_(strokes),
        members_(members),
        row_bits_(std::min<unsigned>(kMostBucketBits, std::bit_width(2 * members.size() / kBucketEnds)) / 2),
        begin_(count() + 1),
        ends_(2 * members.size()) {
    find_extent();
    std::vector<std::uint32_t> next = counts();
    if (exceeds_limit(next)) {
      by_hash_ = true;
      next = counts();
    }
    // Each block of strokes has its own place in each bucket, so the ends of a bucket keep their order.
    const std::size_t blocks = next.size() / count();
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < count(); ++b) {
      begin_[b] = sum;
      for (std::size_t block = 0; block < blocks; ++block) sum += std::exchange(next[block * count() + b], sum);
    }
    begin_.back() = sum;
    for_blocks(next, [&](std::uint32_t* own, LatticePoint p, std::uint32_t end) { ends_[own[bucket(p)]++] = {p, end}; });
  }

  std::size_t count() const { return std::size_t{1} << (2 * row_bits_); }
  std::span<const StrokeEnd> operator[](std::size_t b) const {
    return {ends_.data() + begin_[b], ends_.data() + begin_[b + 1]};
  }

 private:
  std::size_t bucket(LatticePoint p) const {
    if (row_bits_ == 0) return 0;
    if (by_hash_) return hash_of(p) >> (64 - 2 * row_bits_);
    const auto x = static_cast<std::size_t>((double(p.x) - low_x_) * per_step_x_);
    const auto y = static_cast<std::size_t>((double(p.y) - low_y_) * per_step_y_);
    return y << row_bits_ | x;
  }

  void find_extent() {
    struct Extent {
      std::int32_t low_x = kLatticeLimit, low_y = kLatticeLimit, high_x = -kLatticeLimit, high_y = -kLatticeLimit;
      void add(const Extent& o) {
        low_x = std::min(low_x, o.low_x), low_y = std::min(low_y, o.low_y);
        high_x = std::max(high_x, o.high_x), high_y = std::max(high_y, o.high_y);
      }
    };
    const Extent all = parallel_reduce(
        members_.size(), kScatteredBlock, Extent{},
        [&](std::size_t first, std::size_t last) {
          Extent extent;
          for (std::size_t i = first; i < last; ++i) {
            const Stroke& s = strokes_[members_[i]];
            extent.add({s.from.x, s.from.y, s.from.x, s.from.y});
            extent.add({s.to.x, s.to.y, s.to.x, s.to.y});
          }
          return extent;
        },
        [](Extent sum, const Extent& part) {
          sum.add(part);
          return sum;
        });
    // One step is added to the extent, so that the highest coordinates lie in the last square.
    const double squares = double(std::size_t{1} << row_bits_);
    low_x_ = all.low_x, low_y_ = all.low_y;
    per_step_x_ = squares / (double(all.high_x) - low_x_ + 1);
    per_step_y_ = squares / (double(all.high_y) - low_y_ + 1);
  }

  template <class Visit>
  void for_blocks(std::vector<std::uint32_t>& of_blocks, const Visit& visit) const {
    parallel_blocks(members_.size(), kScatteredBlock, [&](std::size_t first, std::size_t last) {
      std::uint32_t* const own = of_blocks.data() + first / kScatteredBlock * count();
      for (std::size_t i = first; i < last; ++i) {
        const auto end = static_cast<std::uint32_t>(2 * i);
        visit(own, strokes_[members_[i]].from, end);
        visit(own, strokes_[members_[i]].to, end + 1);
      }
    });
  }

  /// Counts ends by block of strokes and by bucket.
  std::vector<std::uint32_t> counts() const {
    std::vector<std::uint32_t> counts(block_count(members_.size(), kScatteredBlock) * count());
    for_blocks(counts, [&](std::uint32_t* own, LatticePoint p, std::uint32_t) { ++own[bucket(p)]; });
    return counts;
  }

  bool exceeds_limit(const std::vector<std::uint32_t>& counts) const {
    for (std::size_t b = 0; b < count(); ++b) {
      std::uint32_t ends = 0;
      for (std::size_t k = b; k < counts.size(); k += count()) ends += counts[k];
      if (ends > kMaxBucketSize) return true;
    }
    return false;
  }

  const std::vector<Stroke>& strokes_;
  std::span<const std::uint32_t> members_;
  unsigned row_bits_;
  bool by_hash_ = false;
  double low_x_ = 0, low_y_ = 0, per_step_x_ = 0, per_step_y_ = 0;
  std::vector<std::uint32_t> begin_;
  std::vector<StrokeEnd> ends_;
};

/// Groups the ends of a bucket by their point. One object serves many buckets, to reuse its memory.
class NodeSorter {
 public:
  void visit_nodes(std::span<const StrokeEnd> ends, FunctionRef<void(std::span<const StrokeEnd>)> visit) {
    constexpr std::uint32_t kFree = 0xffffffffu;
    const std::size_t n = ends.size();
    // Points are numbered in order of appearance. A hash table with at least twice as many slots finds them again.
    const std::size_t mask = std::bit_ceil(2 * n) - 1;
    table_.assign(mask + 1, kFree);
    node_of_.resize(n);
    first_end_.clear();
    next_.assign(1, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      std::size_t slot = hash_of(ends[i].p) & mask;
      while (table_[slot] != kFree && ends[first_end_[table_[slot]]].p != ends[i].p) slot = (slot + 1) & mask;
      if (table_[slot] == kFree) {
        table_[slot] = static_cast<std::uint32_t>(first_end_.size());
        first_end_.push_back(i);
        next_.push_back(0);
      }
      node_of_[i] = table_[slot];
      ++next_[node_of_[i] + 1];
    }
    for (std::size_t node = 0; node + 1 < next_.size(); ++node) next_[node + 1] += next_[node];
    sorted_.resize(n);
    for (std::size_t i = 0; i < n; ++i) sorted_[next_[node_of_[i]]++] = ends[i];
    // Each entry of next_ now is the place where the next node begins.
    std::uint32_t begin = 0;
    for (std::size_t node = 0; node + 1 < next_.size(); ++node) {
      visit({sorted_.data() + begin, sorted_.data() + next_[node]});
      begin = next_[node];
    }
  }

 private:
  std::vector<std::uint32_t> table_, node_of_, first_end_, next_;
  std::vector<StrokeEnd> sorted_;
};

}  // namespace

void for_each_node(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                   FunctionRef<void(std::span<const StrokeEnd>)> visit) {
  const Buckets buckets(strokes, members);
  parallel_blocks(buckets.count(), kBucketsPerTask, [&](std::size_t first, std::size_t last) {
    NodeSorter sorter;
    for (std::size_t b = first; b < last; ++b) sorter.visit_nodes(buckets[b], visit);
  });
}

}  // namespace ligne
