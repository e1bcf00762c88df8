#include "drawing/graphs/stroke_net.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/overlaps/stroke_index.hpp"
#include "drawing/stroke_piece.hpp"

namespace ligne {
namespace {

/// A free end does not meet the line that it ends, so many times as far back as lines meet.
constexpr double kOwnLineInReaches = 4;
/// Adjustable: the side of the cells in which ends are looked for.
constexpr double kCellInReaches = 16;

struct Foot {
  double fraction = 0, distance = 0;
};

Foot foot_on(const Stroke& s, LatticePoint p) {
  const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
  const double px = double(p.x) - s.from.x, py = double(p.y) - s.from.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
  return {t, std::hypot(px - t * dx, py - t * dy)};
}

LatticePoint point_at(const Stroke& s, double fraction) {
  const auto between = [&](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(std::lround(a + fraction * (double(b) - a)));
  };
  return {between(s.from.x, s.to.x), between(s.from.y, s.to.y)};
}

/// Where a free end lies on a line.
struct Meeting {
  LatticePoint end, place;
  std::uint32_t stroke;
  double fraction;
};

class MeetingFinder {
 public:
  MeetingFinder(const std::vector<Stroke>& strokes, double touching)
      : strokes_(strokes),
        chains_(strokes),
        touching_(touching),
        grid_(walked_cell(strokes, kCellInReaches * touching), touching) {
    const auto has_free_end = [&](std::uint32_t i) { return chains_.is_free(i, true) || chains_.is_free(i, false); };
    if (std::none_of(chains_.seen().begin(), chains_.seen().end(), has_free_end)) return;
    for (const std::uint32_t i : chains_.seen()) {
      for (const LatticePoint p : {strokes[i].from, strokes[i].to}) {
        std::uint32_t& first = places_[KeyTable::key(p)];
        arms_.emplace_back(i, first);
        first = static_cast<std::uint32_t>(arms_.size() - 1);
      }
    }
  }

  const std::vector<std::uint32_t>& seen() const { return chains_.seen(); }

  /// By stroke and fraction. A drawing in which all lines are closed has none.
  std::vector<Meeting> find() const {
    if (arms_.empty()) return {};
    struct FreeEnd {
      LatticePoint p;
      std::vector<std::uint32_t> own;  // strokes
      Meeting nearest{};
      double distance;
    };
    std::vector<FreeEnd> ends;
    KeyTable cells;                                              // of each cell the first link
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links;  // end, next link
    for (const std::uint32_t i : chains_.seen()) {
      for (const bool at_from : {true, false}) {
        if (!chains_.is_free(i, at_from)) continue;
        const LatticePoint p = at_from ? strokes_[i].from : strokes_[i].to;
        std::uint32_t& first = cells[grid_.cell_of(p)];
        links.emplace_back(static_cast<std::uint32_t>(ends.size()), first);
        first = static_cast<std::uint32_t>(links.size() - 1);
        ends.push_back({p, back_from(i, p), {}, 2 * touching_});
      }
    }
    for (const std::uint32_t i : chains_.seen()) {
      grid_.walk(strokes_[i].from, strokes_[i].to, [&](std::uint64_t cell) {
        for (std::uint32_t l = cells.find(cell); l != kNone; l = links[l].second) {
          FreeEnd& end = ends[links[l].first];
          const Foot foot = foot_on(strokes_[i], end.p);
          if (foot.distance > touching_ || foot.distance >= end.distance) continue;
          if (std::find(end.own.begin(), end.own.end(), i) != end.own.end()) continue;
          end.distance = foot.distance;
          end.nearest = {end.p, point_at(strokes_[i], foot.fraction), i, foot.fraction};
        }
        return false;
      });
    }
    std::vector<Meeting> found;
    for (const FreeEnd& end : ends) {
      if (end.distance <= touching_) found.push_back(end.nearest);
    }
    std::sort(found.begin(), found.end(), [](const Meeting& a, const Meeting& b) {
      return std::tie(a.stroke, a.fraction, a.end) < std::tie(b.stroke, b.fraction, b.end);
    });
    return found;
  }

 private:
  /// The strokes of the line that ends freely at p with stroke i, as far back as it can not meet itself.
  std::vector<std::uint32_t> back_from(std::uint32_t i, LatticePoint p) const {
    std::vector<std::uint32_t> own{i};
    double length = 0;
    for (;;) {
      const Stroke& s = strokes_[own.back()];
      length += page_length(s);
      p = s.from == p ? s.to : s.from;
      std::uint32_t next = kNone, arms = 0;
      for (std::uint32_t a = places_.find(KeyTable::key(p)); a != kNone; a = arms_[a].second, ++arms) {
        if (arms_[a].first != own.back()) next = arms_[a].first;
      }
      if (length > kOwnLineInReaches * touching_ || arms != 2 || next == kNone || next == i) return own;
      own.push_back(next);
    }
  }

  const std::vector<Stroke>& strokes_;
  StrokeChains chains_;
  double touching_;
  SegmentGrid grid_;
  KeyTable places_;                                            // of ends, where some end is free: of each the first arm
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arms_;  // stroke, next arm
};

}  // namespace

StrokeNet::StrokeNet(const std::vector<Stroke>& strokes, double touching) {
  const MeetingFinder finder(strokes, touching);
  const std::vector<Meeting> meetings = finder.find();
  KeyTable table;
  std::uint32_t count = 0;
  const auto node_at = [&](LatticePoint p) {
    std::uint32_t& number = table[KeyTable::key(p)];
    if (number == kNone) number = count++;
    return number;
  };
  auto meeting = meetings.begin();
  for (const std::uint32_t i : finder.seen()) {
    const Stroke& s = strokes[i];
    StrokeCut last{0, s.from};
    const auto cut_at = [&](const StrokeCut& cut) {
      if (cut.p == last.p) return;
      pieces_.push_back({stroke_piece(s, last, cut), i, node_at(last.p), node_at(cut.p)});
      last = cut;
    };
    for (; meeting != meetings.end() && meeting->stroke == i; ++meeting) {
      if (meeting->place != s.to) cut_at({meeting->fraction, meeting->place});
    }
    cut_at({1, s.to});
  }
  for (const Meeting& m : meetings) node_at(m.end), node_at(m.place);
  DisjointSets nodes(count);
  for (const Meeting& m : meetings) nodes.join(node_at(m.end), node_at(m.place));
  arms_.assign(count, 0);
  for (Piece& piece : pieces_) {
    piece.from = nodes.find(piece.from);
    piece.to = nodes.find(piece.to);
    piece.alive = piece.from != piece.to;
    if (!piece.alive) continue;
    ++arms_[piece.from];
    ++arms_[piece.to];
  }
  file_pieces();
}

void StrokeNet::file_pieces() {
  first_at_.assign(arms_.size() + 1, 0);
  std::partial_sum(arms_.begin(), arms_.end(), first_at_.begin() + 1);
  at_node_.resize(first_at_.back());
  std::vector<std::uint32_t> next(first_at_.begin(), first_at_.end() - 1);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].alive) continue;
    for (const std::uint32_t node : {pieces_[i].from, pieces_[i].to}) at_node_[next[node]++] = i;
  }
}

std::vector<StrokeNet::Arc> StrokeNet::arcs() const {
  DisjointSets sets(pieces_.size());
  std::vector<std::uint32_t> at_node(arms_.size(), kNone);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].alive) continue;
    for (const std::uint32_t node : {pieces_[i].from, pieces_[i].to}) {
      if (arms_[node] != 2) continue;
      if (at_node[node] != kNone) sets.join(i, at_node[node]);
      at_node[node] = i;
    }
  }
  std::vector<std::uint32_t> number(pieces_.size(), kNone);
  std::vector<Arc> found;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].alive) continue;
    std::uint32_t& n = number[sets.find(i)];
    if (n == kNone) {
      n = static_cast<std::uint32_t>(found.size());
      found.emplace_back();
    }
    Arc& arc = found[n];
    arc.pieces.push_back(i);
    arc.length += page_length(pieces_[i].stroke);
    for (const std::uint32_t node : {pieces_[i].from, pieces_[i].to}) {
      if (arms_[node] != 2) arc.ends.push_back(node);
    }
  }
  return found;
}

void StrokeNet::take_away(const Arc& arc) {
  for (const std::uint32_t i : arc.pieces) {
    pieces_[i].alive = false;
    --arms_[pieces_[i].from];
    --arms_[pieces_[i].to];
  }
}

}  // namespace ligne
