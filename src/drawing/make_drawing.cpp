/// Joins strokes into polylines, layer by layer.
///
/// 1. Strokes are divided among their layers, in their order.
/// 2. Ends are grouped by lattice point (map/nodes.hpp). All arrays are flat: 36 bytes per stroke besides the drawing.
/// 3. At each node the ends are paired (map/continuations.hpp).
/// 4. Lines are followed from their loose ends, in the order of these ends; then the rings. Points exactly on the
///    segment between their neighbours are dropped.
///
/// Layers, and the buckets of one layer, are processed in parallel. Each writes only memory of its own, so the result
/// does not depend on the number of threads.

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "linework/map/continuations.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

constexpr std::size_t kHiddenLayer = 0, kTransparentLayer = 1, kProfileLayer = kStrokeLayerCount - 1;

/// Whether b lies on the segment a c, between its ends.
bool between(LatticePoint a, LatticePoint b, LatticePoint c) {
  return orientation(a, b, c) == 0 && glm::dot(offset(a, b), offset(b, c)) > 0;
}

/// Drops the first point of a closed line if the line runs straight through it.
void straighten_seam(std::vector<LatticePoint>& line) {
  const std::size_t n = line.size();
  if (n < 4 || line.front() != line.back() || !between(line[n - 2], line[0], line[1])) return;
  line.erase(line.begin());
  line.back() = line.front();
}

/// The polylines of one layer.
Polylines polylines_of(const StrokeModel& model, std::span<const std::uint32_t> members) {
  const auto point = [&](std::uint32_t end) { return tip(model.strokes[members[end / 2]], end).p; };
  std::vector<std::uint32_t> partner(2 * members.size(), kNone);
  for_each_node(model.strokes, members, [&](std::span<const StrokeEnd> ends) {
    if (ends.size() < 2) return;
    std::vector<NodeArm> arms;
    for (const auto& [p, end] : ends) arms.push_back(arm_from(p, point(end ^ 1), end));
    pair_arms(arms, partner);
  });
  Polylines out;
  const auto loose = static_cast<std::size_t>(std::count(partner.begin(), partner.end(), kNone));
  out.points.reserve(members.size() + loose / 2);
  out.begin.reserve(loose / 2 + 1);
  std::vector<LatticePoint> line;
  for_each_line(partner, LineOrder::loose_ends, [&](std::span<const std::uint32_t> ends, bool) {
    line.assign(1, point(ends.front()));
    for (const std::uint32_t end : ends) {
      const LatticePoint p = point(end ^ 1);
      if (line.size() > 1 && between(line[line.size() - 2], line.back(), p)) line.pop_back();
      line.push_back(p);
    }
    straighten_seam(line);
    for (const LatticePoint p : line) out.points.push_back(model.lattice.to_mm(p));
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  });
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
  std::array<std::vector<std::uint32_t>, kStrokeLayerCount> members;
  for (std::uint32_t i = 0; i < model.strokes.size(); ++i) {
    const Stroke& s = model.strokes[i];
    if (s.from != s.to) members[stroke_layer(s.line_class, s.visible, s.level)].push_back(i);
  }

  std::array<Polylines, kStrokeLayerCount> lines;
  parallel_for(kStrokeLayerCount, [&](std::size_t l) {
    if (!members[l].empty()) lines[l] = polylines_of(model, members[l]);
  });

  Drawing drawing;
  for (std::size_t l = 0; l < kStrokeLayerCount; ++l) {
    if (lines[l].size() > 0) drawing.layers.push_back({std::string(stroke_layer_name(l)), std::move(lines[l])});
  }
  return drawing;
}

}  // namespace ligne
