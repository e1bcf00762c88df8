#include "linework/map/line_map.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/indices_where.hpp"
#include "base/parallel.hpp"

namespace ligne {

/// A point of a piece, inside it or at an end, where another line meets it.
struct LineMap::Meeting {
  std::uint32_t piece;
  double fraction, distance;
  std::uint32_t contact;  ///< the contact whose other node lies there
  LatticePoint place{};
};

LineMap::LineMap(StrokeModel& model, const std::function<bool(const Stroke&)>& takes_part, const Meetings& meetings,
                 double cell)
    : model_(model),
      meetings_(meetings),
      cell_(walked_cell(model.strokes, cell)),
      had_hidden_(std::ranges::any_of(model.strokes, [](const Stroke& s) { return !s.visible; })),
      given_(static_cast<std::uint32_t>(model.strokes.size())) {
  const std::vector<std::uint32_t> members = indices_where(given_, [&](std::size_t i) {
    const Stroke& s = model.strokes[i];
    return is_seen(s) && s.from != s.to && takes_part(s);
  });
  pieces_.reserve(members.size());
  for (const std::uint32_t i : members) pieces_.push_back({model.strokes[i], i, kNone});
  parallel_tasks(2, [&](std::size_t task) {
    if (task == 0) {
      nodes_ = Nodes(model.strokes, members);
    } else if (meetings.reach > 0) {
      file_pieces();
    }
  });
  if (meetings.reach > 0) find_contacts();
}

void LineMap::file_pieces() {
  cells_.emplace(cell_);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    if (pieces_[p].alive) cells_->insert(p, pieces_[p].stroke.from, pieces_[p].stroke.to);
  }
}

/// Adds a piece with two nodes of its own.
std::uint32_t LineMap::new_piece(const Stroke& stroke, std::uint32_t of) {
  const auto p = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({stroke, of, kNone});
  nodes_.add();
  nodes_.add();
  if (cells_) cells_->insert(p, stroke.from, stroke.to);
  return p;
}

void LineMap::move_end(std::uint32_t end, std::uint32_t node) {
  nodes_.unlink(end);
  nodes_.link(end, node);
}

std::vector<std::uint32_t> LineMap::line_back(std::uint32_t end, double length) const {
  std::vector<std::uint32_t> own;
  for (double passed = 0; end != kNone && passed <= length; end = next(end ^ 1)) {
    if (!own.empty() && own.front() == end / 2) break;
    own.push_back(end / 2);
    passed += page_length(pieces_[end / 2].stroke);
  }
  return own;
}

std::optional<LineMap::Meeting> LineMap::nearest_line(std::uint32_t end) {
  /// Least distance along a line from an end at which the line may meet itself, in reaches.
  constexpr double kOwnLineInReaches = 4;
  std::vector<std::uint32_t> own = line_back(end, kOwnLineInReaches * meetings_.reach);
  nodes_.for_each_end(nodes_.of(end), [&](std::uint32_t e) { own.push_back(e / 2); });
  const LatticePoint p = point(end);
  std::optional<Meeting> nearest;
  near(p, p, meetings_.reach, [&](std::uint32_t piece) {
    const FootPoint foot = foot_on(pieces_[piece].stroke, p);
    if (foot.distance > meetings_.reach) return false;
    if (nearest && std::tie(nearest->distance, nearest->piece) <= std::tie(foot.distance, piece)) return false;
    if (std::ranges::find(own, piece) == own.end()) nearest = {piece, foot.fraction, foot.distance, 0};
    return false;
  });
  if (nearest) nearest->place = point_at(pieces_[nearest->piece].stroke, nearest->fraction);
  return nearest;
}

void LineMap::find_contacts() {
  const std::vector<std::uint32_t> ends = indices_where(nodes_.end_count(), [&](std::size_t i) {
    const auto end = static_cast<std::uint32_t>(i);
    return meetings_.any_node ? nodes_.first(nodes_.of(end)) == end : is_free(end);
  });
  std::vector<std::optional<Meeting>> nearest(ends.size());
  parallel_blocks(ends.size(), kEndBlock, [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i) nearest[i] = nearest_line(ends[i]);
  });
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!nearest[i]) continue;
    nearest[i]->contact = static_cast<std::uint32_t>(contacts_.size());
    contacts_.push_back({nodes_.of(ends[i]), kNone, nearest[i]->distance});
    meetings.push_back(*nearest[i]);
  }
  std::ranges::sort(meetings, {}, [](const Meeting& m) { return std::tuple(m.piece, m.fraction, m.contact); });
  std::uint32_t piece = kNone, rest = kNone;  // the rest of the piece lies behind its last cut
  double cut = 0;                             // the fraction of the piece at which the rest begins
  for (const Meeting& m : meetings) {
    if (std::exchange(piece, m.piece) != m.piece) rest = piece, cut = 0;
    if (m.place != point(2 * rest) && m.place != point(2 * rest + 1)) {
      rest = cut_at(rest, {(m.fraction - cut) / (1 - cut), m.place});
      cut = m.fraction;
    }
    contacts_[m.contact].other = nodes_.of(m.place == point(2 * rest) ? 2 * rest : 2 * rest + 1);
  }
}

std::uint32_t LineMap::cut_at(std::uint32_t piece, const StrokeCut& place) {
  const Stroke whole = pieces_[piece].stroke;
  const std::uint32_t behind = new_piece(stroke_piece(whole, place, {1, whole.to}), pieces_[piece].of);
  pieces_[piece].stroke = stroke_piece(whole, {0, whole.from}, place);
  pieces_[behind].next = std::exchange(pieces_[piece].next, behind);
  move_end(2 * behind + 1, nodes_.of(2 * piece + 1));
  move_end(2 * piece + 1, nodes_.of(2 * behind));
  return behind;
}

void LineMap::remove(std::uint32_t piece) {
  pieces_[piece].alive = false;
  nodes_.unlink(2 * piece);
  nodes_.unlink(2 * piece + 1);
}

void LineMap::add(Stroke stroke, std::uint32_t from_end, std::uint32_t to_end, const MakeSource& make_source) {
  model_.intersections.push_back(make_source(stroke));
  stroke.source = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size()) - 1;
  stroke.t_from = 0;
  stroke.t_to = 1;
  stroke.is_joint = true;
  const std::uint32_t p = new_piece(stroke, static_cast<std::uint32_t>(model_.strokes.size()));
  model_.strokes.push_back(stroke);
  move_end(2 * p, nodes_.of(from_end));
  if (to_end != kNone) move_end(2 * p + 1, nodes_.of(to_end));
}

/// Writes adjacent removed parts of a stroke as one hidden stroke, and adjacent remaining parts as one visible stroke.
void LineMap::write_stroke(std::uint32_t first_piece, std::vector<Stroke>& out) const {
  for (std::uint32_t p = first_piece; p != kNone;) {
    Stroke part = pieces_[p].stroke;
    part.visible = pieces_[p].alive;
    std::uint32_t next = pieces_[p].next;
    for (; next != kNone && pieces_[next].alive == part.visible; next = pieces_[next].next) {
      const Stroke& s = pieces_[next].stroke;
      part.to = s.to, part.t_to = s.t_to, part.z_to = s.z_to, part.w_to = s.w_to;
    }
    if (part.visible || had_hidden_) out.push_back(part);
    p = next;
  }
}

void LineMap::commit() {
  std::vector<std::uint32_t> first_piece(model_.strokes.size(), kNone);
  for (std::uint32_t p = piece_count(); p-- > 0;) first_piece[pieces_[p].of] = p;
  std::vector<Stroke> out;
  out.reserve(model_.strokes.size());
  for (std::uint32_t i = 0; i < model_.strokes.size(); ++i) {
    if (first_piece[i] == kNone) out.push_back(model_.strokes[i]);  // it has no pieces to write
    write_stroke(first_piece[i], out);
  }
  model_.strokes = std::move(out);
}

void clear_hidden(std::vector<Stroke>& strokes, std::span<const Stroke> added, double ink) {
  if (added.empty()) return;
  LineCells cells(std::max(2 * ink, 1.0));
  for (std::uint32_t a = 0; a < added.size(); ++a) cells.insert(a, added[a].from, added[a].to);
  // How far ink covers a stroke from an end on, 0 or 1, as a fraction of its length.
  const auto end_of_ink = [&](const Stroke& s, double end) {
    constexpr double kRounding = 1;  // lattice steps
    double covered = end, before = -1;
    while (std::exchange(before, covered) != covered) {
      const LatticePoint p = point_at(s, covered);
      cells.near(p, p, ink, [&](std::uint32_t a) {
        if (foot_on(added[a], p).distance > ink + kRounding) return false;
        const StrokePart part = part_near(s, added[a], ink);
        if (part.from <= covered && covered <= part.to) covered = end == 0 ? part.to : part.from;
        return false;
      });
    }
    return covered;
  };
  const auto is_gone = [&](Stroke& s) {
    if (s.visible || s.from == s.to) return false;
    const double from = end_of_ink(s, 0), to = end_of_ink(s, 1);
    if (from == 0 && to == 1) return false;
    if (from >= to) return true;
    s = stroke_piece(s, {from, point_at(s, from)}, {to, point_at(s, to)});
    return s.from == s.to;
  };
  std::vector<std::uint8_t> stays(strokes.size(), 1);
  parallel_blocks(strokes.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) stays[i] = !is_gone(strokes[i]);
  });
  std::erase_if(strokes, [&](const Stroke& s) { return !stays[static_cast<std::size_t>(&s - strokes.data())]; });
}

}  // namespace ligne
