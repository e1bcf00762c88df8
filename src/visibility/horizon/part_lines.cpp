#include "visibility/horizon/part_lines.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::horizon {
namespace {

/// Extends the visible part of an upright line to an end that it misses only by rounding, so that it continues in the
/// next line.
void reach_ends(const Line& line, double least, std::vector<Span>& seen) {
  if (seen.empty()) return;
  if (seen.front().from - line.v0 <= least) seen.front().from = line.v0;
  if (line.v1 - seen.back().to <= least) seen.back().to = line.v1;
}

/// Merges the parts above and below.
void join(std::vector<Span>& above, const std::vector<Span>& below) {
  above.insert(above.end(), below.begin(), below.end());
  std::sort(above.begin(), above.end(), [](const Span& s, const Span& t) { return s.from < t.from; });
  std::size_t count = 0;
  for (const Span& s : above) {
    if (count > 0 && s.from <= above[count - 1].to) {
      above[count - 1].to = std::max(above[count - 1].to, s.to);
    } else {
      above[count++] = s;
    }
  }
  above.resize(count);
}

void add_to(Chains& chains, const HorizonEdge& edge, double t0, double t1) {
  chains.add(CurveTracker::at(edge.a->page, edge.b->page, t0), CurveTracker::at(edge.a->page, edge.b->page, t1));
}

}  // namespace

PartLines::PartLines(const Eye& eye, const Columns& columns, double least, LineStore& store)
    : eye_(eye),
      upright_(kUprightPart * columns.extent()),
      least_(least),
      store_(store),
      upright_lines_(columns, upright_) {}

/// The visible fractions of an edge in space that are to be drawn; for an upright edge only those not drawn before.
const std::vector<Span>& PartLines::seen(const EdgeList& list, std::uint32_t number) {
  const HorizonEdge& edge = list.edges[number];
  const PlaneSegment& segment = edge.line;
  seen_.clear();
  below_.clear();
  for (std::size_t b = edge.first_band; b <= edge.last_band; ++b) {
    const std::vector<SeenSpan>& spans = list.seen[b];
    for (std::size_t& k = taken_[b]; k < spans.size() && spans[k].edge == number; ++k) {
      if (segment.upright()) {
        seen_.push_back(spans[k].span);
      } else {
        append_span(spans[k].below ? below_ : seen_, spans[k].span, least_);
      }
    }
  }
  if (!below_.empty()) join(seen_, below_);
  if (seen_.empty()) return seen_;
  if (segment.upright()) {
    // Between two closed sides each visible part moves the horizons, so nothing is found twice.
    if (edge.open) upright_lines_.draw(segment.line().u0, seen_);
    reach_ends(segment.line(), upright_, seen_);
  }
  segment.to_space(seen_);
  return seen_;
}

void PartLines::emit(const HorizonEdge& edge, const std::vector<Span>& seen) {
  const auto each = [&](auto sink) { eye_.emit(*edge.a, *edge.b, edge.from, edge.to, seen, sink); };
  switch (edge.use) {
    case VisibleUse::curve:
    case VisibleUse::underside: {
      Polylines& lines = edge.use == VisibleUse::curve ? store_.lines.curves : store_.lines.underside;
      each([&](double t0, double t1) { edge.curve->add(edge.a->page, edge.b->page, t0, t1, lines); });
      edge.curve->next_segment();
      break;
    }
    case VisibleUse::outline:
      return each([&](double t0, double t1) { add_to(store_.outline, edge, t0, t1); });
    case VisibleUse::border:
      return each([&](double t0, double t1) { add_to(store_.border, edge, t0, t1); });
    case VisibleUse::contour:
      return each([&](double t0, double t1) { add_to(store_.contours[edge.number], edge, t0, t1); });
    case VisibleUse::base_contour:
      return each([&](double t0, double t1) { add_to(store_.base_contours[edge.number], edge, t0, t1); });
    case VisibleUse::back_line:
      return each([&](double t0, double t1) { store_.lines.back_lines[edge.number].push_back({t0, t1}); });
    case VisibleUse::interruption:
    case VisibleUse::nothing:
      break;
  }
}

void PartLines::add(EdgeList& list) {
  taken_.assign(list.seen.size(), 0);
  for (std::uint32_t k = 0; k < list.edges.size(); ++k) {
    const HorizonEdge& edge = list.edges[k];
    if (edge.use == VisibleUse::interruption) edge.curve->interrupt();
    if (edge.is_tested()) emit(edge, seen(list, k));
  }
  list.nearest_row.end();
  list.row.end();
}

std::vector<Span>& UprightLines::drawn_at(double u) {
  const std::size_t first = columns_.at(u - least_), last = columns_.at(u + least_);
  for (std::size_t c = first; c <= last; ++c) {
    for (Upright& line : cells_[c]) {
      if (std::abs(line.u - u) <= least_) return line.drawn;
    }
  }
  return cells_[columns_.at(u)].emplace_back(Upright{u, {}}).drawn;
}

void UprightLines::draw(double u, std::vector<Span>& spans) {
  if (spans.empty()) return;
  std::vector<Span>& drawn = drawn_at(u);
  open_.clear();
  for (const Span& span : spans) {
    double at = span.from;
    const auto leave_open = [&](double to) {
      if (to - at > least_) open_.push_back({at, to});
    };
    const auto first =
        std::lower_bound(drawn.begin(), drawn.end(), span.from, [](const Span& d, double v) { return d.to < v; });
    auto last = first;
    Span all = span;
    for (; last != drawn.end() && last->from <= span.to; ++last) {
      leave_open(last->from);
      at = std::max(at, last->to);
      all = {std::min(all.from, last->from), std::max(all.to, last->to)};
    }
    leave_open(span.to);
    if (first == last) {
      drawn.insert(first, all);
    } else {
      *first = all;
      drawn.erase(first + 1, last);
    }
  }
  spans.swap(open_);
}

}  // namespace ligne::horizon
