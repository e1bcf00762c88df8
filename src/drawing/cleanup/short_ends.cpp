#include "drawing/cleanup/short_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/graphs/stroke_net.hpp"
#include "drawing/near_part.hpp"
#include "drawing/overlaps/stroke_index.hpp"
#include "drawing/stroke_piece.hpp"

namespace ligne {
namespace {

/// Adjustable: a line is so many times as long as the way that it goes on.
constexpr double kLongInWays = 3;
/// Adjustable: its direction is that of its last part, so long as the reach at the most.
constexpr double kDirectionInReaches = 0.5;
/// Adjustable: sine and cosine of the most that a line turns where it does not run into another one straight: 20 degrees.
constexpr double kTurnSine = 0.342, kTurnCosine = 0.94;

bool takes_part(const Stroke& s) { return is_edge(s) && s.line_class != LineClass::mesh; }

struct Vector {
  double x = 0, y = 0;
};

class ShortEnds {
 public:
  ShortEnds(const std::vector<Stroke>& strokes, double reach, double touching)
      : net_(strokes, touching),
        reach_(reach),
        grid_(walked_cell(strokes, reach), touching),
        wide_grid_(walked_cell(strokes, reach), touching + kTurnSine * reach) {
    const std::vector<StrokeNet::Piece>& pieces = net_.pieces();
    arc_of_.assign(pieces.size(), 0);
    const std::vector<StrokeNet::Arc> arcs = net_.arcs();
    for (std::uint32_t a = 0; a < arcs.size(); ++a) {
      for (const std::uint32_t i : arcs[a].pieces) arc_of_[i] = a;
      lengths_.push_back(arcs[a].length);
    }
  }

  /// Calls add(stroke that goes on, its end, where it meets a line).
  template <class Add>
  void find(const Add& add) {
    const std::vector<StrokeNet::Piece>& pieces = net_.pieces();
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (!pieces[i].alive || !takes_part(pieces[i].stroke)) continue;
      for (const bool at_from : {true, false}) {
        if (net_.arms(at_from ? pieces[i].from : pieces[i].to) != 1) continue;
        ends_.push_back({i, at_from, direction(i, at_from)});
        Vector& d = ends_.back().direction;
        const LatticePoint p = end_point(ends_.back());
        const double way = std::min(reach_, lengths_[arc_of_[i]] / kLongInWays);
        d = {d.x * way, d.y * way};
        const LatticePoint far{p.x + static_cast<std::int32_t>(d.x), p.y + static_cast<std::int32_t>(d.y)};
        wide_grid_.walk(p, far, [&](std::uint64_t cell) {
          std::uint32_t& first = cells_[cell];
          links_.emplace_back(static_cast<std::uint32_t>(ends_.size() - 1), first);
          first = static_cast<std::uint32_t>(links_.size() - 1);
          return false;
        });
      }
    }
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (!pieces[i].alive || !takes_part(pieces[i].stroke)) continue;
      const Stroke& s = pieces[i].stroke;
      grid_.walk(s.from, s.to, [&](std::uint64_t cell) {
        for (std::uint32_t l = cells_.find(cell); l != kNone; l = links_[l].second) meet(ends_[links_[l].first], i);
        return false;
      });
    }
    for (const End& end : ends_) {
      if (end.way > 1 && end.turned_way > 1) continue;
      const LatticePoint p = end_point(end);
      const Vector way = end.way > 1 ? end.turned : Vector{end.way * end.direction.x, end.way * end.direction.y};
      const LatticePoint to{p.x + static_cast<std::int32_t>(std::lround(way.x)),
                            p.y + static_cast<std::int32_t>(std::lround(way.y))};
      if (to != p) add(pieces[end.piece].stroke, end.at_from, to);
    }
  }

 private:
  struct End {
    std::uint32_t piece;
    bool at_from;
    Vector direction;  ///< as long as the way that it may go
    double way = 2;    ///< to the first line, as a part of that; more than 1 where there is none
    Vector turned{};   ///< the way to the nearest place on a line beside which it ends
    double turned_way = 2;
  };

  LatticePoint end_point(const End& end) const {
    const Stroke& s = net_.pieces()[end.piece].stroke;
    return end.at_from ? s.from : s.to;
  }

  /// The direction outwards, of unit length; none for a line that comes back to its end.
  Vector direction(std::uint32_t i, bool at_from) const {
    const Stroke& last = net_.pieces()[i].stroke;
    const LatticePoint end = at_from ? last.from : last.to;
    LatticePoint back = end;
    std::uint32_t node = at_from ? net_.pieces()[i].from : net_.pieces()[i].to;
    for (double left = kDirectionInReaches * reach_;;) {
      const StrokeNet::Piece& piece = net_.pieces()[i];
      const bool forwards = piece.from == node;
      node = forwards ? piece.to : piece.from;
      back = forwards ? piece.stroke.to : piece.stroke.from;
      left -= page_length(piece.stroke);
      if (left <= 0 || net_.arms(node) != 2) break;
      const auto arm = net_.pieces_at(node);
      i = arm[0] == i ? arm[1] : arm[0];
    }
    const Vector d{double(end.x) - back.x, double(end.y) - back.y};
    const double length = std::hypot(d.x, d.y);
    return length > 0 ? Vector{d.x / length, d.y / length} : Vector{};
  }

  void meet(End& end, std::uint32_t piece) const {
    if (arc_of_[piece] == arc_of_[end.piece]) return;
    const Stroke& s = net_.pieces()[piece].stroke;
    const LatticePoint p = end_point(end);
    const double ux = double(s.to.x) - s.from.x, uy = double(s.to.y) - s.from.y;
    const double px = double(s.from.x) - p.x, py = double(s.from.y) - p.y;
    const double area = end.direction.x * uy - end.direction.y * ux;
    if (area != 0) {
      const double way = (px * uy - py * ux) / area, along = (px * end.direction.y - py * end.direction.x) / area;
      if (way > 0 && way <= 1 && along >= 0 && along <= 1) end.way = std::min(end.way, way);
    }
    turn_to(end, {px, py}, {ux, uy});
  }

  /// The nearest place on start + [0, 1] u, from the end, to which the line may turn.
  static void turn_to(End& end, const Vector& start, const Vector& u) {
    const Vector& d = end.direction;
    double from = 0, to = 1;
    for (const double side : {-1.0, 1.0}) {
      // The inner normal of a side of the wedge.
      const Vector n{kTurnSine * d.x - side * kTurnCosine * d.y, kTurnSine * d.y + side * kTurnCosine * d.x};
      const double at_start = n.x * start.x + n.y * start.y, slope = n.x * u.x + n.y * u.y;
      if (slope == 0 && at_start < 0) return;
      if (slope > 0) from = std::max(from, -at_start / slope);
      if (slope < 0) to = std::min(to, -at_start / slope);
    }
    if (from > to || (d.x == 0 && d.y == 0)) return;
    const double square = u.x * u.x + u.y * u.y;
    const double at = square > 0 ? std::clamp(-(start.x * u.x + start.y * u.y) / square, from, to) : from;
    const Vector turned{start.x + at * u.x, start.y + at * u.y};
    const double way = std::hypot(turned.x, turned.y) / std::hypot(d.x, d.y);
    if (way >= end.turned_way) return;
    end.turned = turned;
    end.turned_way = way;
  }

  StrokeNet net_;
  double reach_;
  SegmentGrid grid_, wide_grid_;       // of the same cells
  std::vector<std::uint32_t> arc_of_;  // by piece
  std::vector<double> lengths_;        // by arc
  std::vector<End> ends_;
  KeyTable cells_;                                              // of each cell the first link
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links_;  // end, next link
};

/// One of two new strokes that lead to each other between equal ends stays.
void drop_ways_back(std::vector<Stroke>& added) {
  const auto is_before = [](const Stroke& a, const Stroke& b) { return a.from == b.from ? a.to < b.to : a.from < b.from; };
  std::vector<Stroke> sorted = added;
  std::sort(sorted.begin(), sorted.end(), is_before);
  std::erase_if(added, [&](const Stroke& s) {
    Stroke back = s;
    std::swap(back.from, back.to);
    return s.to < s.from && std::binary_search(sorted.begin(), sorted.end(), back, is_before);
  });
}

/// Cuts what lies along the new strokes off hidden ones.
void cut_hidden(std::vector<Stroke>& strokes, const std::vector<Stroke>& added, double reach, double touching) {
  if (!any_hidden(strokes)) return;
  const SegmentGrid grid(walked_cell(strokes, 2 * reach), touching);
  KeyTable cells;                                              // of each cell the first link
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links;  // new stroke, next link
  for (std::uint32_t a = 0; a < added.size(); ++a) {
    grid.walk(added[a].from, added[a].to, [&](std::uint64_t cell) {
      std::uint32_t& first = cells[cell];
      links.emplace_back(a, first);
      first = static_cast<std::uint32_t>(links.size() - 1);
      return false;
    });
  }
  std::erase_if(strokes, [&](Stroke& s) {
    if (s.visible || s.from == s.to) return false;
    return grid.walk(s.from, s.to, [&](std::uint64_t cell) {
      for (std::uint32_t l = cells.find(cell); l != kNone; l = links[l].second) {
        const StrokePart part = part_near(s, added[links[l].first], touching);
        if (part.empty() || (part.from > 0 && part.to < 1)) continue;
        if (part.from == 0 && part.to == 1) return true;
        const double at = part.from == 0 ? part.to : part.from;
        const StrokeCut cut{at,
                            {static_cast<std::int32_t>(std::lround(s.from.x + at * (double(s.to.x) - s.from.x))),
                             static_cast<std::int32_t>(std::lround(s.from.y + at * (double(s.to.y) - s.from.y)))}};
        s = part.from == 0 ? stroke_piece(s, cut, {1, s.to}) : stroke_piece(s, {0, s.from}, cut);
        if (s.from == s.to) return true;
      }
      return false;
    });
  });
}

}  // namespace

std::size_t extend_short_ends(StrokeModel& model, const ShortEndLimits& limits, const MakeSource& make_source) {
  const double reach = limits.reach_mm / model.lattice.step_mm, touching = limits.touching_mm / model.lattice.step_mm;
  std::vector<Stroke> added;
  ShortEnds(model.strokes, reach, touching).find([&](const Stroke& last, bool at_from, LatticePoint to) {
    Stroke s = last;
    s.t_from = 0;
    s.t_to = 1;
    s.from = at_from ? last.from : last.to;
    s.to = to;
    s.z_from = s.z_to = at_from ? last.z_from : last.z_to;
    s.w_from = s.w_to = at_from ? last.w_from : last.w_to;
    added.push_back(s);
  });
  drop_ways_back(added);
  for (Stroke& s : added) {
    model.intersections.push_back(make_source(s));
    s.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size()) - 1;
  }
  cut_hidden(model.strokes, added, reach, touching);
  model.strokes.insert(model.strokes.end(), added.begin(), added.end());
  return added.size();
}

}  // namespace ligne
