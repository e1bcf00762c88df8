#include "visibility/horizon/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::horizon {
namespace {

/// The part of [a, b] on which a linear function with the values da, db at the ends is not negative; empty when from >= to.
Span not_negative(double a, double b, double da, double db) {
  if (da >= 0 && db >= 0) return {a, b};
  if (da < 0 && db < 0) return {a, a};
  const double zero = std::clamp(a + (b - a) * (da / (da - db)), a, b);
  return da < 0 ? Span{zero, b} : Span{a, zero};
}

double levelled(double d, double tolerance) { return std::abs(d) <= tolerance ? 0.0 : d; }

}  // namespace

Coverage::Coverage(const Columns& columns, ColumnRange own)
    : columns_(columns),
      own_(own),
      held_(with_neighbours(own, columns)),
      least_(kLeastPart * columns.extent()),
      cells_(held_.end - held_.begin) {}

double Coverage::tolerance(const Rim& rim) const {
  return kLevelPart * (std::max(columns_.extent(), std::abs(rim.v)) + std::abs(rim.slope) * columns_.extent());
}

void Coverage::cover(std::array<Corner, 3> c) {
  std::sort(c.begin(), c.end(), [](const Corner& a, const Corner& b) { return a.u < b.u; });
  if (!(c[2].u - c[0].u > least_)) return;  // an upright triangle seen edge on: without width it hides nothing
  const auto rim = [](const Corner& a, const Corner& b) { return Rim{a.u, a.v, (b.v - a.v) / (b.u - a.u)}; };
  const Rim across = rim(c[0], c[2]);
  const bool middle_is_high = c[1].v >= across.height(c[1].u);
  for (const int k : {0, 1}) {
    if (!(c[k + 1].u - c[k].u > least_)) continue;
    const Rim side = rim(c[k], c[k + 1]);
    cover_between(c[k].u, c[k + 1].u, middle_is_high ? across : side, middle_is_high ? side : across);
  }
}

void Coverage::cover_between(double u0, double u1, const Rim& lower, const Rim& upper) {
  const std::size_t first = columns_.at(u0), last = columns_.at(u1);
  for (std::size_t c = std::max(first, held_.begin); c <= last && c < held_.end; ++c) {
    const double from = c == first ? u0 : columns_.begin(c);
    const double to = c == last ? u1 : columns_.begin(c + 1);
    if (to - from > least_) add(cells_[c - held_.begin], {from, to, lower, upper});
  }
}

/// Appends a band to added_, or extends the band that it continues.
void Coverage::put(const Band& band) {
  if (band.u1 - band.u0 <= least_) return;
  for (auto b = added_.rbegin(); b != added_.rend(); ++b) {
    if (std::abs(b->u1 - band.u0) <= least_ && b->lower == band.lower && b->upper == band.upper) {
      b->u1 = band.u1;
      return;
    }
  }
  added_.push_back(band);
}

/// Adds `band` over [from, to], where no two rims cross, merged with the touched bands that it meets there.
void Coverage::add_over(double from, double to, Band band, const std::vector<Band>& touched) {
  const double u = (from + to) / 2;
  for (const Band& t : touched) {
    if (!(t.u0 < u && u < t.u1)) continue;
    const double slack = std::max({tolerance(t.lower), tolerance(t.upper), tolerance(band.lower), tolerance(band.upper)});
    const double low = t.lower.height(u), high = t.upper.height(u);
    if (low > band.upper.height(u) + slack || high < band.lower.height(u) - slack) {
      put({from, to, t.lower, t.upper});
      continue;
    }
    if (low < band.lower.height(u)) band.lower = t.lower;
    if (high > band.upper.height(u)) band.upper = t.upper;
  }
  put({from, to, band.lower, band.upper});
}

void Coverage::add(std::vector<Band>& cell, const Band& band) {
  touched_.clear();
  added_.clear();
  cuts_.assign({band.u0, band.u1});
  std::erase_if(cell, [&](const Band& b) {
    const double from = std::max(b.u0, band.u0), to = std::min(b.u1, band.u1);
    if (to - from <= least_) return false;
    const double slack = std::max({tolerance(b.lower), tolerance(b.upper), tolerance(band.lower), tolerance(band.upper)});
    const auto above = [&](const Rim& p, const Rim& q) {
      return p.height(from) > q.height(from) + slack && p.height(to) > q.height(to) + slack;
    };
    if (above(b.lower, band.upper) || above(band.lower, b.upper)) return false;
    touched_.push_back(b);
    return true;
  });
  for (const Band& t : touched_) {
    const double from = std::max(t.u0, band.u0), to = std::min(t.u1, band.u1);
    for (const double u : {from, to}) {
      if (band.u0 < u && u < band.u1) cuts_.push_back(u);
    }
    for (const Rim& p : {band.lower, band.upper}) {
      for (const Rim& q : {t.lower, t.upper}) {
        const double d0 = p.height(from) - q.height(from), d1 = p.height(to) - q.height(to);
        if ((d0 < 0) != (d1 < 0)) cuts_.push_back(std::clamp(from + (to - from) * (d0 / (d0 - d1)), from, to));
      }
    }
  }
  std::sort(touched_.begin(), touched_.end(), [](const Band& a, const Band& b) { return a.u0 < b.u0; });
  for (const Band& t : touched_) {
    if (t.u0 < band.u0) put({t.u0, std::min(t.u1, band.u0), t.lower, t.upper});
  }
  std::sort(cuts_.begin(), cuts_.end());
  double at = band.u0;
  for (const double cut : cuts_) {
    if (cut - at <= least_ && cut != band.u1) continue;
    if (cut > at) add_over(at, cut, band, touched_);
    at = cut;
  }
  for (const Band& t : touched_) {
    if (t.u1 > band.u1) put({std::max(t.u0, band.u1), t.u1, t.lower, t.upper});
  }
  cell.insert(cell.end(), added_.begin(), added_.end());
}

void Coverage::append_uncovered(double from, double to, double least, std::vector<Span>& hidden,
                                std::vector<Span>& uncovered) {
  std::sort(hidden.begin(), hidden.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
  hidden.push_back({to, to});
  double at = from;
  for (const Span& h : hidden) {
    if (h.from - at > least) append_span(uncovered, {at, h.from}, least);
    at = std::max(at, h.to);
  }
}

void Coverage::find_uncovered(const Line& line, std::vector<Span>& uncovered) {
  const std::size_t first_span = uncovered.size();
  const Rim rim{line.u0, line.v0, (line.v1 - line.v0) / (line.u1 - line.u0)};
  const double line_tolerance = tolerance(rim);
  const std::size_t first = columns_.at(line.u0), last = columns_.at(line.u1);
  std::vector<Span> found;
  for (std::size_t c = std::max(first, own_.begin); c <= last && c < own_.end; ++c) {
    const double from = c == first ? line.u0 : columns_.begin(c);
    const double to = c == last ? line.u1 : columns_.begin(c + 1);
    if (!(from < to)) continue;
    hidden_.clear();
    for (const Band& b : cells_[c - held_.begin]) {
      const double u0 = std::max(b.u0, from), u1 = std::min(b.u1, to);
      if (!(u0 < u1)) continue;
      const auto part = [&](const Rim& high, const Rim& low, double slack) {
        return not_negative(u0, u1, levelled(high.height(u0) - low.height(u0), slack),
                            levelled(high.height(u1) - low.height(u1), slack));
      };
      const Span over = part(rim, b.lower, std::max(line_tolerance, tolerance(b.lower)));
      const Span under = part(b.upper, rim, std::max(line_tolerance, tolerance(b.upper)));
      const Span both{std::max(over.from, under.from), std::min(over.to, under.to)};
      if (both.from < both.to) hidden_.push_back(both);
    }
    append_uncovered(from, to, least_, hidden_, found);
  }
  extend_to_ends(found, line, least_);
  uncovered.insert(uncovered.begin() + static_cast<std::ptrdiff_t>(first_span), found.begin(), found.end());
}

void Coverage::find_covered_beside(double u, double v0, double v1, int side, std::vector<Span>& covered) const {
  const double at = u + 2 * (side < 0 ? -least_ : least_);
  for (const Band& b : cells_[columns_.at(at) - held_.begin]) {
    if (!(b.u0 <= at && at <= b.u1)) continue;
    const double slack = std::max(tolerance(b.lower), tolerance(b.upper));
    const Span span{std::max(b.lower.height(at) - slack, v0), std::min(b.upper.height(at) + slack, v1)};
    if (span.from < span.to) covered.push_back(span);
  }
}

}  // namespace ligne::horizon
