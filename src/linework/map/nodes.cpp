#include "linework/map/nodes.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <utility>

#include "base/hash.hpp"
#include "base/parallel_counting_sort.hpp"

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
constexpr std::size_t kMaxBucketSize = 64 * kBucketEnds;

std::uint64_t hash_of(LatticePoint p) { return mix_bits(std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y)); }

/// All ends in buckets. A bucket is a square of the page, since strokes that are near each other on the page are mostly
/// near in memory. If a square has too many ends, buckets are chosen by the hash of the point.
class Buckets {
 public:
  Buckets(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members)
      : strokes_(strokes),
        members_(members),
        row_bits_(std::min<unsigned>(kMostBucketBits, std::bit_width(2 * members.size() / kBucketEnds)) / 2) {
    find_extent();
    scatter();
    for (std::size_t b = 0; b < count() && !by_hash_; ++b) by_hash_ = begin_[b + 1] - begin_[b] > kMaxBucketSize;
    if (by_hash_) scatter();
  }

  std::size_t count() const { return std::size_t{1} << (2 * row_bits_); }
  std::span<const StrokeEnd> operator[](std::size_t b) const {
    return {ends_.data() + begin_[b], ends_.data() + begin_[b + 1]};
  }

 private:
  std::size_t bucket(LatticePoint p) const {
    if (row_bits_ == 0) return 0;
    if (by_hash_) return hash_of(p) >> (64 - 2 * row_bits_);
    const auto x = static_cast<std::size_t>((p.x - low_.x) * per_step_.x);
    const auto y = static_cast<std::size_t>((p.y - low_.y) * per_step_.y);
    return y << row_bits_ | x;
  }

  void find_extent() {
    const Rect all = parallel_reduce(
        members_.size(), kScatteredBlock, Rect{},
        [&](std::size_t first, std::size_t last) {
          Rect part;
          for (std::size_t i = first; i < last; ++i) {
            const Stroke& s = strokes_[members_[i]];
            for (const LatticePoint p : {s.from, s.to}) part.extend({p.x, p.y});
          }
          return part;
        },
        [](Rect sum, const Rect& part) {
          sum.extend(part.min);
          sum.extend(part.max);
          return sum;
        });
    // One step is added to the extent, so that the highest coordinates lie in the last square.
    const double squares = double(std::size_t{1} << row_bits_);
    low_ = all.min;
    per_step_ = Point2(squares) / (Point2(all.width(), all.height()) + 1.0);
  }

  void scatter() {
    const auto list = [&](std::size_t first, std::size_t last, const auto& take) {
      for (std::size_t i = first; i < last; ++i) {
        const Stroke& s = strokes_[members_[i]];
        const auto end = static_cast<std::uint32_t>(2 * i);
        take(bucket(s.from), s.from, end);
        take(bucket(s.to), s.to, end + 1);
      }
    };
    begin_ = parallel_counting_sort(
        members_.size(), kScatteredBlock, count(), list, [&](std::size_t n) { ends_.resize(n); },
        [&](std::size_t place, LatticePoint p, std::uint32_t end) {
          ends_[place] = {p, end};
        });
  }

  const std::vector<Stroke>& strokes_;
  std::span<const std::uint32_t> members_;
  unsigned row_bits_;
  bool by_hash_ = false;
  Point2 low_{0, 0}, per_step_{0, 0};
  std::vector<std::size_t> begin_;
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
    : Nodes(strokes, [&] {
        std::vector<std::uint32_t> all(strokes.size());
        std::iota(all.begin(), all.end(), 0u);
        return all;
      }()) {}

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
