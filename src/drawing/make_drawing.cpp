/// Joins strokes into polylines, layer by layer.
///
/// 1. A stable counting sort divides the strokes among their layers.
/// 2. Ends are grouped by lattice point (stroke_nodes.hpp). All arrays are flat: 36 bytes per stroke besides the
///    drawing.
/// 3. At each node the ends are paired (node_pairs.hpp): `partner` then links strokes into chains and rings.
/// 4. Chains are walked from their loose ends, in the order of these ends; then the remaining rings are walked. Points
///    exactly on the segment between their neighbours are dropped.
///
/// Layers, and the buckets of one layer, are processed in parallel. Each writes only memory of its own, so the result
/// does not depend on the number of threads.

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "linework/node_pairs.hpp"
#include "linework/stroke_nodes.hpp"

namespace ligne {
namespace {

constexpr std::size_t kLayerCount = kStrokeLayerCount;
constexpr std::size_t kHiddenLayer = 0, kTransparentLayer = 1, kProfileLayer = kStrokeLayerCount - 1;

std::size_t layer_of(const Stroke& stroke) { return stroke_layer(stroke.line_class, stroke.visible, stroke.level); }

/// The strokes of one layer and their continuations.
class StrokeGraph {
 public:
  StrokeGraph(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members)
      : strokes_(strokes), members_(members), partner_(2 * members.size(), kNone) {
    link();
  }

  Polylines polylines(const Lattice& lattice) const;

 private:
  LatticePoint point(std::uint32_t end) const {
    const Stroke& s = strokes_[members_[end / 2]];
    return end % 2 == 0 ? s.from : s.to;
  }
  void link();

  const std::vector<Stroke>& strokes_;
  std::span<const std::uint32_t> members_;
  std::vector<std::uint32_t> partner_;
};

void StrokeGraph::link() {
  for_each_node(strokes_, members_, [&](std::span<const StrokeEnd> ends) {
    if (ends.size() < 2) return;
    pair_arms(NodeArms(strokes_, members_, ends).all(), partner_);
  });
}

/// Whether b lies on the segment a c, between its ends.
bool between(LatticePoint a, LatticePoint b, LatticePoint c) {
  if (orientation(a, b, c) != 0) return false;
  return (double(b.x) - a.x) * (double(c.x) - b.x) + (double(b.y) - a.y) * (double(c.y) - b.y) > 0;
}

/// Drops the first point of a closed line if the line runs straight through it.
void straighten_seam(std::vector<LatticePoint>& line) {
  const std::size_t n = line.size();
  if (n < 4 || line.front() != line.back() || !between(line[n - 2], line[0], line[1])) return;
  line.erase(line.begin());
  line.back() = line.front();
}

Polylines StrokeGraph::polylines(const Lattice& lattice) const {
  Polylines out;
  const auto loose = static_cast<std::size_t>(std::count(partner_.begin(), partner_.end(), kNone));
  out.points.reserve(members_.size() + loose / 2);
  out.begin.reserve(loose / 2 + 1);

  std::vector<bool> walked(members_.size());
  std::vector<LatticePoint> line;
  const auto walk = [&](std::uint32_t start) {
    line.assign(1, point(start));
    for (std::uint32_t end = start; end != kNone && !walked[end / 2]; end = partner_[end ^ 1]) {
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
    if (partner_[end] == kNone && !walked[end / 2]) walk(end);
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
