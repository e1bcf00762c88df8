#include "drawing/cleanup/spurs.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/graphs/stroke_net.hpp"
#include "drawing/near_part.hpp"
#include "drawing/overlaps/stroke_index.hpp"

namespace ligne {
namespace {

/// Adjustable: without a spur the line that it left may be part of another one.
constexpr int kSpurRounds = 8;
/// Adjustable: where a line is left out, another way from end to end is at most so many times as long.
constexpr double kDetour = 2;

class SpurFinder {
 public:
  SpurFinder(const std::vector<Stroke>& strokes, const std::function<std::uint32_t(const Stroke&)>& body_of,
             const SpurLimits& limits, double step)
      : net_(strokes, limits.touching_mm / step),
        limits_(limits),
        step_(step),
        grid_(walked_cell(strokes, 2 * limits.beside_mm / step), limits.beside_mm / step),
        node_grid_(walked_cell(strokes, 2 * limits.gap_mm / step), limits.gap_mm / step) {
    const std::vector<StrokeNet::Piece>& pieces = net_.pieces();
    body_.reserve(pieces.size());
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      const Stroke& s = pieces[i].stroke;
      body_.push_back(s.line_class == LineClass::outline ? body_of(s) : kNone);
      grid_.walk(s.from, s.to, [&](std::uint64_t cell) {
        std::uint32_t& first = cells_[cell];
        links_.push_back({i, first});
        first = static_cast<std::uint32_t>(links_.size() - 1);
        return false;
      });
      for (const bool at_from : {true, false}) {
        const std::uint32_t node = at_from ? pieces[i].from : pieces[i].to;
        if (!pieces[i].alive) continue;
        const LatticePoint p = at_from ? s.from : s.to;
        std::uint32_t& first = node_cells_[node_grid_.cell_of(p)];
        places_.push_back({node, first, p});
        first = static_cast<std::uint32_t>(places_.size() - 1);
      }
    }
    extents_ = body_extents(strokes, body_of);
  }

  std::size_t take_away() {
    std::size_t count = 0;
    for (int round = 0; round < kSpurRounds; ++round) {
      std::vector<StrokeNet::Arc> arcs = net_.arcs();
      std::stable_sort(arcs.begin(), arcs.end(),
                       [](const StrokeNet::Arc& a, const StrokeNet::Arc& b) { return a.length < b.length; });
      const std::size_t before = count;
      for (const StrokeNet::Arc& arc : arcs) {
        if (!is_spur(arc)) continue;
        net_.take_away(arc);
        ++count;
      }
      if (count == before) break;
    }
    return count;
  }

  const StrokeNet& net() const { return net_; }

 private:
  bool is_spur(const StrokeNet::Arc& arc) const {
    const std::uint32_t body = body_[arc.pieces.front()];
    if (body == kNone || arc.ends.size() != 2) return false;
    for (const std::uint32_t i : arc.pieces) {
      if (body_[i] != body) return false;
    }
    const double longest = std::min(limits_.longest_mm / step_, limits_.body_part * extents_[body]);
    if (arc.length > limits_.beside_times * longest) return false;
    const std::uint32_t a = net_.arms(arc.ends[0]), b = net_.arms(arc.ends[1]);
    // An end of two arms was one of more, of which a spur was taken away: this arc is part of a longer line now.
    if (a == 2 || b == 2 || bridges_a_gap(arc)) return false;
    if (arc.length <= longest && std::min(a, b) == 1 && std::max(a, b) > 2) return true;
    return std::ranges::all_of(arc.pieces, [&](std::uint32_t i) { return runs_beside(i, arc); }) &&
           (std::min(a, b) == 1 || stays_connected(arc));
  }

  /// Lines that end near a free end of the arc have no other way to where its other end leads: they are one line with a gap.
  bool bridges_a_gap(const StrokeNet::Arc& arc) const {
    const std::vector<std::uint32_t> at[2] = {nodes_near(arc, 0), nodes_near(arc, 1)};
    // Each by itself: among the nodes near an end may be some of lines with which the arc hangs together anyway.
    return !at[0].empty() && std::ranges::any_of(at[1], [&](std::uint32_t node) {
      return !leads_to_all(node, at[0], arc, limits_.gap_mm / step_);
    });
  }

  /// The nodes of other lines within a gap of a free end, in order; the end itself where it is not free.
  std::vector<std::uint32_t> nodes_near(const StrokeNet::Arc& arc, std::size_t end) const {
    std::vector<std::uint32_t> near;
    if (net_.arms(arc.ends[end]) > 1) return {arc.ends[end]};
    const auto at = net_.pieces_at(arc.ends[end]);
    const auto own = std::ranges::find_if(at, [&](std::uint32_t i) { return net_.pieces()[i].alive; });
    const StrokeNet::Piece& piece = net_.pieces()[*own];
    const LatticePoint p = piece.from == arc.ends[end] ? piece.stroke.from : piece.stroke.to;
    const double gap = limits_.gap_mm / step_;
    node_grid_.walk(p, p, [&](std::uint64_t cell) {
      for (std::uint32_t l = node_cells_.find(cell); l != kNone; l = places_[l].next) {
        const NodePlace& other = places_[l];
        const double dx = double(other.p.x) - p.x, dy = double(other.p.y) - p.y;
        if (dx * dx + dy * dy <= gap * gap && goes_on_without(other.node, arc)) near.push_back(other.node);
      }
      return false;
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  /// The node has a piece of another arc.
  bool goes_on_without(std::uint32_t node, const StrokeNet::Arc& arc) const {
    return std::ranges::any_of(net_.pieces_at(node), [&](std::uint32_t i) {
      return net_.pieces()[i].alive && !std::ranges::binary_search(arc.pieces, i);
    });
  }

  /// There is another way from end to end that is not much longer.
  bool stays_connected(const StrokeNet::Arc& arc) const {
    return leads_to_all(arc.ends[0], {arc.ends[1]}, arc, limits_.beside_mm / step_);
  }

  /// From a node to each of `to`, which are in order, there is a way that is not by the arc and not much longer than it and
  /// `more`. Of several ways to a node the one with the fewest pieces counts, so that a spur may stay.
  bool leads_to_all(std::uint32_t from, const std::vector<std::uint32_t>& to, const StrokeNet::Arc& arc, double more) const {
    const double longest = kDetour * (arc.length + more);
    std::vector<std::pair<std::uint32_t, double>> reached{{from, 0}};  // nodes
    KeyTable place_of;                                                 // by node
    place_of[from] = 0;
    std::size_t left = to.size();
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const auto [node, length] = reached[k];
      if (std::ranges::binary_search(to, node) && --left == 0) return true;
      for (const std::uint32_t i : net_.pieces_at(node)) {
        const StrokeNet::Piece& piece = net_.pieces()[i];
        const double further = length + page_length(piece.stroke);
        if (!piece.alive || further > longest || std::ranges::binary_search(arc.pieces, i)) continue;
        const std::uint32_t next = piece.from == node ? piece.to : piece.from;
        std::uint32_t& place = place_of[next];
        if (place != kNone) continue;
        place = static_cast<std::uint32_t>(reached.size());
        reached.emplace_back(next, further);
      }
    }
    return false;
  }

  /// Its ends and its middle lie beside another line.
  bool runs_beside(std::uint32_t i, const StrokeNet::Arc& arc) const {
    const Stroke& s = net_.pieces()[i].stroke;
    const LatticePoint middle{static_cast<std::int32_t>((std::int64_t{s.from.x} + s.to.x) / 2),
                              static_cast<std::int32_t>((std::int64_t{s.from.y} + s.to.y) / 2)};
    return lies_beside(s.from, arc) && lies_beside(middle, arc) && lies_beside(s.to, arc);
  }

  bool lies_beside(LatticePoint p, const StrokeNet::Arc& arc) const {
    Stroke point;
    point.from = point.to = p;
    return grid_.walk(p, p, [&](std::uint64_t cell) {
      for (std::uint32_t l = cells_.find(cell); l != kNone; l = links_[l].next) {
        const std::uint32_t other = links_[l].piece;
        if (!net_.pieces()[other].alive || std::ranges::binary_search(arc.pieces, other)) continue;
        if (!part_near(net_.pieces()[other].stroke, point, limits_.beside_mm / step_).empty()) return true;
      }
      return false;
    });
  }

  struct Link {
    std::uint32_t piece, next;
  };
  struct NodePlace {
    std::uint32_t node, next;
    LatticePoint p;
  };

  StrokeNet net_;
  SpurLimits limits_;
  double step_;
  SegmentGrid grid_;
  KeyTable cells_;  // of each cell the first link
  std::vector<Link> links_;
  SegmentGrid node_grid_;
  KeyTable node_cells_;  // of each cell the first place
  std::vector<NodePlace> places_;
  std::vector<std::uint32_t> body_;  // by piece: kNone but for outlines
  std::vector<double> extents_;
};

}  // namespace

std::size_t drop_spurs(StrokeModel& model, const std::function<std::uint32_t(const Stroke&)>& body_of,
                       const SpurLimits& limits) {
  SpurFinder finder(model.strokes, body_of, limits, model.lattice.step_mm);
  const std::size_t count = finder.take_away();
  if (count == 0) return 0;
  const bool hidden_too = any_hidden(model.strokes);
  // Strokes of which nothing was taken away stay as they are.
  std::vector<std::uint8_t> is_cut(model.strokes.size(), 0);
  for (const StrokeNet::Piece& piece : finder.net().pieces()) {
    if (!piece.alive && piece.from != piece.to) is_cut[piece.of] = 1;
  }
  std::vector<Stroke> kept;
  kept.reserve(model.strokes.size());
  auto piece = finder.net().pieces().begin();
  const auto end = finder.net().pieces().end();
  for (std::uint32_t i = 0; i < model.strokes.size(); ++i) {
    if (is_cut[i] == 0) kept.push_back(model.strokes[i]);
    for (; piece != end && piece->of == i; ++piece) {
      if (is_cut[i] == 0) continue;
      const bool stays = piece->alive || piece->from == piece->to;
      if (!stays && !hidden_too) continue;
      kept.push_back(piece->stroke);
      kept.back().visible = stays;
    }
  }
  model.strokes = std::move(kept);
  return count;
}

}  // namespace ligne
