/// Strokes joined into polylines, layer by layer.
///
/// 1. Strokes are dealt out to their layers by a counting sort, in their order.
/// 2. Ends are grouped by lattice point. The ends of a layer are first spread over buckets by a hash of their point, so that
/// a
///    bucket fits into the cache; in each bucket a small hash table numbers the nodes, and a counting sort brings the ends
///    of a node together. All arrays are flat: 36 bytes a stroke beside the drawing itself.
/// 3. At each node the arms are paired (node_pairs.hpp): `partner` then links the ends of strokes into chains and rings.
/// 4. The chains are walked from their loose ends, in the order of these, then the rings that are left. Points that lie
///    exactly on the segment between their neighbours are dropped on the way.
///
/// Layers, and the buckets of one layer, are worked on in parallel; each writes only what is its own, so that the result
/// does not depend on the number of threads.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "drawing/drawing.hpp"
#include "drawing/node_pairs.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

constexpr std::size_t kLayerCount = kStrokeLayerCount;
constexpr std::size_t kHiddenLayer = 0, kTransparentLayer = 1, kProfileLayer = kStrokeLayerCount - 1;

std::size_t layer_of(const Stroke& stroke) { return stroke_layer(stroke.line_class, stroke.visible, stroke.level); }

// Adjustable parameters: ends in a bucket (12 bytes each, to stay in the first-level cache with their table), and the
// number of buckets that a scattering pass can write to at once.
constexpr std::size_t kBucketEnds = 512;
constexpr unsigned kMostBucketBits = 14;
constexpr std::size_t kBucketsPerTask = 16;

/// An end of a stroke of the layer: end 2 i is the `from` of the layer's stroke i, end 2 i + 1 its `to`.
struct End {
  LatticePoint p;
  std::uint32_t end;
};

std::uint64_t hash(LatticePoint p) {
  std::uint64_t h = (std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y)) * 0x9e3779b97f4a7c15u;
  h ^= h >> 32;
  return h * 0xd6e8feb86659fd93u;
}

/// The strokes of one layer, and what continues what.
class StrokeGraph {
 public:
  StrokeGraph(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members)
      : strokes_(strokes), members_(members), partner_(2 * members.size(), kNoPartner) {
    link();
  }

  Polylines polylines(const Lattice& lattice) const;

 private:
  LatticePoint point(std::uint32_t end) const {
    const Stroke& s = strokes_[members_[end / 2]];
    return end % 2 == 0 ? s.from : s.to;
  }
  void link();
  void link_bucket(std::span<const End> ends);

  const std::vector<Stroke>& strokes_;
  std::span<const std::uint32_t> members_;
  std::vector<std::uint32_t> partner_;
};

void StrokeGraph::link() {
  const std::size_t n = partner_.size();
  const unsigned bits = std::min<unsigned>(kMostBucketBits, std::bit_width(n / kBucketEnds));
  const std::size_t buckets = std::size_t{1} << bits;
  const auto bucket = [bits](LatticePoint p) { return bits == 0 ? 0 : hash(p) >> (64 - bits); };

  std::vector<std::uint32_t> begin(buckets + 1);
  for (const std::uint32_t m : members_) {
    ++begin[bucket(strokes_[m].from) + 1];
    ++begin[bucket(strokes_[m].to) + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) begin[b + 1] += begin[b];
  std::vector<End> ends(n);
  std::vector<std::uint32_t> cursor(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    const Stroke& s = strokes_[members_[i]];
    ends[cursor[bucket(s.from)]++] = {s.from, 2 * i};
    ends[cursor[bucket(s.to)]++] = {s.to, 2 * i + 1};
  }
  parallel_blocks(buckets, kBucketsPerTask, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      link_bucket({ends.data() + begin[b], ends.data() + begin[b + 1]});
    }
  });
}

void StrokeGraph::link_bucket(std::span<const End> ends) {
  const std::size_t n = ends.size();
  if (n < 2) return;
  // Nodes are numbered in the order in which they are met; a table of at least twice as many slots finds them again.
  const std::size_t mask = std::bit_ceil(2 * n) - 1;
  std::vector<std::uint32_t> table(mask + 1, kNoPartner), node_of(n), first_end, begin{0};
  for (std::uint32_t i = 0; i < n; ++i) {
    std::size_t slot = hash(ends[i].p) & mask;
    while (table[slot] != kNoPartner && ends[first_end[table[slot]]].p != ends[i].p) slot = (slot + 1) & mask;
    if (table[slot] == kNoPartner) {
      table[slot] = static_cast<std::uint32_t>(first_end.size());
      first_end.push_back(i);
      begin.push_back(0);
    }
    node_of[i] = table[slot];
    ++begin[node_of[i] + 1];
  }
  for (std::size_t node = 0; node + 1 < begin.size(); ++node) begin[node + 1] += begin[node];
  std::vector<NodeArm> arms(n);
  std::vector<std::uint32_t> cursor(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const LatticePoint far = point(ends[i].end ^ 1);
    arms[cursor[node_of[i]]++] = {{far.x - ends[i].p.x, far.y - ends[i].p.y}, ends[i].end};
  }
  for (std::size_t node = 0; node + 1 < begin.size(); ++node) {
    pair_arms({arms.data() + begin[node], arms.data() + begin[node + 1]}, partner_);
  }
}

/// b lies on the segment a c, between its ends.
bool between(LatticePoint a, LatticePoint b, LatticePoint c) {
  if (orientation(a, b, c) != 0) return false;
  return (double(b.x) - a.x) * (double(c.x) - b.x) + (double(b.y) - a.y) * (double(c.y) - b.y) > 0;
}

/// Drops the seam of a closed line when the line runs straight on there.
void straighten_seam(std::vector<LatticePoint>& line) {
  const std::size_t n = line.size();
  if (n < 4 || line.front() != line.back() || !between(line[n - 2], line[0], line[1])) return;
  line.erase(line.begin());
  line.back() = line.front();
}

Polylines StrokeGraph::polylines(const Lattice& lattice) const {
  Polylines out;
  const auto loose = static_cast<std::size_t>(std::count(partner_.begin(), partner_.end(), kNoPartner));
  out.points.reserve(members_.size() + loose / 2);
  out.begin.reserve(loose / 2 + 1);

  std::vector<bool> walked(members_.size());
  std::vector<LatticePoint> line;
  const auto walk = [&](std::uint32_t start) {
    line.assign(1, point(start));
    for (std::uint32_t end = start; end != kNoPartner && !walked[end / 2]; end = partner_[end ^ 1]) {
      walked[end / 2] = true;
      const LatticePoint p = point(end ^ 1);
      if (line.size() > 1 && between(line[line.size() - 2], line.back(), p)) line.pop_back();
      line.push_back(p);
    }
    straighten_seam(line);
    for (const LatticePoint p : line) out.points.push_back(lattice.to_mm(p));
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  };
  for (std::uint32_t end = 0; end < partner_.size(); ++end) {
    if (partner_[end] == kNoPartner && !walked[end / 2]) walk(end);
  }
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (!walked[i]) walk(2 * i);
  }
  return out;
}

}  // namespace

std::size_t stroke_layer(LineClass line_class, bool visible, unsigned level) {
  if (!visible) return kHiddenLayer;
  if (level > 0) return kTransparentLayer;
  return line_class == LineClass::profile ? kProfileLayer : kProfileLayer - 1 - static_cast<std::size_t>(line_class);
}

std::string_view stroke_layer_name(std::size_t layer) {
  if (layer == kHiddenLayer) return "hidden";
  if (layer == kTransparentLayer) return "behind-glass";
  return kLineClassNames[layer == kProfileLayer ? static_cast<std::size_t>(LineClass::profile) : kProfileLayer - 1 - layer];
}

Drawing make_drawing(const StrokeModel& model) {
  std::array<std::size_t, kLayerCount + 1> begin{};
  for (const Stroke& s : model.strokes) {
    if (s.from != s.to) ++begin[layer_of(s) + 1];
  }
  for (std::size_t l = 0; l < kLayerCount; ++l) begin[l + 1] += begin[l];
  std::vector<std::uint32_t> members(begin[kLayerCount]);
  auto cursor = begin;
  for (std::uint32_t i = 0; i < model.strokes.size(); ++i) {
    const Stroke& s = model.strokes[i];
    if (s.from != s.to) members[cursor[layer_of(s)]++] = i;
  }

  std::array<Polylines, kLayerCount> lines;
  parallel_for(kLayerCount, [&](std::size_t l) {
    if (begin[l] == begin[l + 1]) return;
    lines[l] =
        StrokeGraph(model.strokes, {members.data() + begin[l], members.data() + begin[l + 1]}).polylines(model.lattice);
  });

  Drawing drawing;
  for (std::size_t l = 0; l < kLayerCount; ++l) {
    if (lines[l].size() > 0) drawing.layers.push_back({std::string(stroke_layer_name(l)), std::move(lines[l])});
  }
  return drawing;
}

}  // namespace ligne
