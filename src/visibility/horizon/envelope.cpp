#include "visibility/horizon/envelope.hpp"

#include <cassert>
#include <cmath>

namespace ligne::horizon {

ExactEnvelope::ExactEnvelope(const Columns& columns, ColumnRange own)
    : columns_(columns),
      own_(own),
      held_(with_neighbours(own, columns)),
      least_(kLeastPart * columns.extent()),
      cells_(held_.end - held_.begin) {}

/// Puts into found_ the parts of the line that are above the pieces of the cell, or over no piece.
void ExactEnvelope::find_in_cell(const std::vector<Piece>& cell, const Piece& line, double tolerance) {
  found_.clear();
  const auto level = [tolerance](double d) { return std::abs(d) <= tolerance ? 0.0 : d; };
  double at = line.u0;  // everything before this place is done
  for (const Piece& p : cell) {
    if (p.u1 <= at) continue;
    if (p.u0 >= line.u1) break;
    if (p.u0 - at > least_) append_span(found_, {at, p.u0}, least_);
    const double a = std::max(p.u0, at), b = std::min(p.u1, line.u1);
    at = b;
    const double da = level(line.height(a) - p.height(a)), db = level(line.height(b) - p.height(b));
    if (da <= 0 && db <= 0) continue;
    if (da >= 0 && db >= 0) {
      append_span(found_, {a, b}, least_);
      continue;
    }
    const double crossing = std::clamp(a + (b - a) * (da / (da - db)), a, b);
    append_span(found_, da > 0 ? Span{a, crossing} : Span{crossing, b}, least_);
  }
  if (line.u1 - at > least_) append_span(found_, {at, line.u1}, least_);
}

/// Replaces the pieces of the cell over the spans in found_ by the line.
void ExactEnvelope::rebuild(std::vector<Piece>& cell, const Piece& line) {
  rebuilt_.clear();
  const auto put = [this](Piece piece, double from, double to) {
    if (to - from <= least_) return;
    piece.u0 = from;
    piece.u1 = to;
    rebuilt_.push_back(piece);
  };
  for (const Piece& p : cell) {
    double from = p.u0;
    for (const Span& span : found_) {
      if (span.to <= from || span.from >= p.u1) continue;
      put(p, from, span.from);
      from = span.to;
    }
    put(p, from, p.u1);
  }
  for (const Span& span : found_) put(line, span.from, span.to);
  std::sort(rebuilt_.begin(), rebuilt_.end(), [](const Piece& a, const Piece& b) { return a.u0 < b.u0; });
  assert(std::adjacent_find(rebuilt_.begin(), rebuilt_.end(),
                            [this](const Piece& a, const Piece& b) { return a.u1 - b.u0 > least_; }) == rebuilt_.end());
  cell.assign(rebuilt_.begin(), rebuilt_.end());
}

template <bool kRaise>
void ExactEnvelope::search(const Line& line, std::vector<Span>& above) {
  const std::size_t first_span = above.size();
  const std::size_t first = columns_.at(line.u0), last = columns_.at(line.u1);
  const ColumnRange range = kRaise ? held_ : own_;
  Piece piece{line.u0, line.u1, line.u0, line.v0, (line.v1 - line.v0) / (line.u1 - line.u0)};
  const double tolerance = kLevelPart * (std::max({columns_.extent(), std::abs(line.v0), std::abs(line.v1)}) +
                                         std::abs(piece.slope) * columns_.extent());
  for (std::size_t c = std::max(first, range.begin); c <= last && c < range.end; ++c) {
    piece.u0 = c == first ? line.u0 : columns_.begin(c);
    piece.u1 = c == last ? line.u1 : columns_.begin(c + 1);
    if (!(piece.u0 < piece.u1)) continue;
    find_in_cell(cell(c), piece, tolerance);
    if (found_.empty()) continue;
    if constexpr (kRaise) rebuild(cell(c), piece);
    for (const Span& span : found_) {
      if (above.size() > first_span) {
        append_span(above, span, least_);
      } else {
        above.push_back(span);
      }
    }
  }
  extend_to_ends(std::span(above).subspan(first_span), line, least_);
}

void ExactEnvelope::find_above(const Line& line, std::vector<Span>& above) { search<false>(line, above); }

void ExactEnvelope::raise(const Line& line, std::vector<Span>& above) { search<true>(line, above); }

double ExactEnvelope::height(double u) const {
  double highest = kNothing;
  // At the end of a piece its neighbours count, too, also in the next cell.
  const std::size_t first = columns_.at(u - least_), last = columns_.at(u + least_);
  for (std::size_t c = first; c <= last; ++c) {
    for (const Piece& p : cell(c)) {
      if (p.u0 <= u + least_ && u <= p.u1 + least_) highest = std::max(highest, p.height(std::clamp(u, p.u0, p.u1)));
    }
  }
  return highest;
}

double ExactEnvelope::height_beside(double u, int side) const {
  const double at = u + 2 * (side < 0 ? -least_ : least_);
  for (const Piece& p : cell(columns_.at(at))) {
    if (p.u0 <= at && at <= p.u1) return p.height(std::clamp(u, p.u0, p.u1));
  }
  return kNothing;
}

PixelEnvelope::PixelEnvelope(const Columns& columns, ColumnRange own)
    : columns_(columns), own_(own), heights_(own.end - own.begin, kNothing) {}

template <bool kRaise>
void PixelEnvelope::search(const Line& line, std::vector<Span>& above) {
  const std::size_t first_span = above.size(), first = columns_.at(line.u0), last = columns_.at(line.u1);
  const double slope = (line.v1 - line.v0) / (line.u1 - line.u0);
  for (std::size_t c = std::max(first, own_.begin); c <= last && c < own_.end; ++c) {
    const double left = std::max(line.u0, columns_.begin(c));
    const double right = std::min(line.u1, columns_.begin(c + 1));
    const double height = line.v0 + slope * ((left + right) / 2 - line.u0);
    double& highest = heights_[c - own_.begin];
    if (!(height > highest)) continue;
    if constexpr (kRaise) highest = height;
    if (above.size() > first_span && above.back().to >= left) {
      above.back().to = right;
    } else {
      above.push_back({left, right});
    }
  }
}

void PixelEnvelope::find_above(const Line& line, std::vector<Span>& above) { search<false>(line, above); }

void PixelEnvelope::raise(const Line& line, std::vector<Span>& above) { search<true>(line, above); }

}  // namespace ligne::horizon
