#include "studies/operations/thesis_spans.hpp"

namespace ligne::studies {

SpanRun ThesisSpans::merge() {
  const std::vector<PlaneSegment> s = counted();
  // A piece of the visible list; adjacent pieces share an end.
  struct Piece {
    double x0, x1;
    std::uint32_t id;
  };
  double low = 1e300, high = -1e300;
  for (const auto& segment : source_) {
    low = std::min(low, segment.x0);
    high = std::max(high, segment.x1);
  }
  std::vector<Piece> list{{low, high, kBackground}};
  for (std::uint32_t id = 0; id < s.size(); ++id) {
    std::size_t i = 0;
    ++run_.operations.accesses;
    while (real(list[i].x1) <= s[id].x0) {  // search from the head
      ++i;
      ++run_.operations.accesses;
    }
    while (i < list.size() && real(list[i].x0) < s[id].x1) {
      ++run_.operations.accesses;
      const Piece piece = list[i];
      const Real from = real(piece.x0) < s[id].x0 ? s[id].x0 : real(piece.x0);
      const Real to = real(piece.x1) > s[id].x1 ? s[id].x1 : real(piece.x1);
      // PRO: two depth tests, and the point of intersection if they differ.
      std::vector<Piece> common{{from.value(), to.value(), id}};
      if (test(piece.id != kBackground)) {
        const PlaneSegment& other = s[piece.id];
        const Real a0 = s[id].z(from), b0 = other.z(from), a1 = s[id].z(to), b1 = other.z(to);
        const bool first = a0 < b0, last = a1 < b1;
        if (!first && !last) {
          ++i;
          continue;
        }
        if (first != last) {
          const Real d0 = b0 - a0, d1 = b1 - a1, x = from + (to - from) * d0 / (d0 - d1);
          common = {{from.value(), x.value(), first ? id : piece.id}, {x.value(), to.value(), first ? piece.id : id}};
        }
      }
      std::vector<Piece> parts;
      if (real(piece.x0) < from) parts.push_back({piece.x0, from.value(), piece.id});
      parts.insert(parts.end(), common.begin(), common.end());
      if (to < real(piece.x1)) parts.push_back({to.value(), piece.x1, piece.id});
      // Each inserted piece sets its two links and those of its neighbours.
      run_.operations.assignments += 4 * parts.size();
      run_.operations.accesses += parts.size();
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), parts.begin(), parts.end());
      i += parts.size();
    }
  }
  for (const Piece& p : list) {
    if (p.id != kBackground) show(p.x0, p.x1, p.id);
  }
  return take();
}

std::uint32_t ThesisSpans::next_of(std::vector<std::uint32_t>& pile, const std::vector<bool>& ended) {
  std::uint32_t next = kBackground;
  while (test(!pile.empty()) && next == kBackground) {
    const std::uint32_t top = pile.back();
    pile.pop_back();
    ++run_.actions.pops;
    run_.operations.accesses += 2;
    if (test(!ended[top])) next = top;
  }
  ++run_.operations.assignments;
  return next;
}

/// Left ends precede right ends at equal places: case 3 of figure 2.47 requires it.
std::vector<ThesisSpans::End> ThesisSpans::sorted_ends() const {
  std::vector<End> ends;
  for (std::uint32_t i = 0; i < source_.size(); ++i) {
    ends.push_back({i, true});
    ends.push_back({i, false});
  }
  const auto x_of = [&](const End& e) { return e.left ? source_[e.segment].x0 : source_[e.segment].x1; };
  std::stable_sort(ends.begin(), ends.end(),
                   [&](const End& a, const End& b) { return x_of(a) != x_of(b) ? x_of(a) < x_of(b) : a.left && !b.left; });
  return ends;
}

SpanRun ThesisSpans::stack() {
  std::sort(source_.begin(), source_.end(), [](const auto& a, const auto& b) { return watkins::comes_before(a, b); });
  const std::vector<PlaneSegment> s = counted();
  const std::vector<End> ends = sorted_ends();
  const auto x_of = [&](const End& e) { return e.left ? source_[e.segment].x0 : source_[e.segment].x1; };
  std::vector<bool> ended(s.size(), false);
  std::vector<std::uint32_t> pile;
  std::uint32_t current = kBackground;
  Real right = real(0);
  StackActions& actions = run_.actions;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const End& e = ends[i];
    run_.operations.accesses += 1;
    const Real x = e.left ? s[e.segment].x0 : s[e.segment].x1;
    if (i > 0) {
      ++actions.searches;
      (x_of(e) == x_of(ends[i - 1]) ? actions.equal_ends : actions.shown) += 1;
    }
    if (test(current != kBackground)) show(right.value(), x.value(), current);
    right = x;
    if (test(current == kBackground) && e.left) {
      current = e.segment;
      ++run_.operations.assignments;
    }
    if (test(!e.left)) {
      ended[e.segment] = true;
      ++run_.operations.accesses;
      ++run_.operations.assignments;
      if (test(current == e.segment)) current = next_of(pile, ended);
      continue;
    }
    if (!test(e.segment != current)) continue;
    const PlaneSegment &old = s[current], &fresh = s[e.segment];
    run_.operations.accesses += 2;
    if (fresh.x0 == old.x1) {  // case 3
      current = e.segment;
      ++run_.operations.assignments;
      continue;
    }
    // Case 1: both begin at one place, and the sort has put the nearer one first. Case 2: the depths decide.
    const bool begins_alike = fresh.x0 == old.x0;
    if (!begins_alike) ++actions.depths;
    const bool nearer = !begins_alike && fresh.z0 < old.z(fresh.x0);
    ++actions.pushes;
    run_.operations.accesses += 1;
    run_.operations.assignments += 1;
    pile.push_back(nearer ? current : e.segment);
    if (nearer) {
      current = e.segment;
      ++run_.operations.assignments;
    }
  }
  return take();
}

SpanRun ThesisSpans::box(bool at_ends, double length) {
  std::sort(source_.begin(), source_.end(), [](const auto& a, const auto& b) { return watkins::comes_before(a, b); });
  const std::vector<PlaneSegment> s = counted();
  std::vector<std::uint32_t> all(s.size());
  double low = 1e300, high = -1e300;
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    all[i] = i;
    low = std::min(low, source_[i].x0);
    high = std::max(high, source_[i].x1);
  }
  if (length > 0) {
    low = 0;
    high = length;
  }
  if (low < high) study_box(s, all, real(low), real(high), at_ends);
  return take();
}

void ThesisSpans::Box::fit(std::uint32_t id, const Real& a, const Real& b, const Real& za, const Real& zb) {
  x0 = a;
  x1 = b;
  z0 = za < zb ? za : zb;
  z1 = za < zb ? zb : za;
  only = id;
  count = 1;
}

ThesisSpans::Box ThesisSpans::analyse(const std::vector<PlaneSegment>& s, const std::vector<std::uint32_t>& list,
                                      const Real& from, const Real& to) {
  Box box{.x0 = from, .x1 = from, .z0 = from, .z1 = from, .cut = from, .inside = {}};
  auto& [x0, x1, z0, z1, cut, have_cut, crossing, count, only, other, inside] = box;
  for (const std::uint32_t id : list) {
    run_.operations.accesses += 1;
    const PlaneSegment& n = s[id];
    if (n.x1 <= from || n.x0 >= to) continue;  // CONT
    inside.push_back(id);
    run_.operations.accesses += 1;
    // IS: the part of the segment in the span, and an end where the span may be divided.
    const bool begins = n.x0 > from, ends = n.x1 < to;
    const Real a = begins ? n.x0 : from, b = ends ? n.x1 : to;
    if (begins || ends) {
      cut = begins ? n.x0 : n.x1;
      have_cut = true;
    }
    const Real za = begins ? n.z0 : n.z(from), zb = ends ? n.z1 : n.z(to);
    if (test(count == 0)) {
      box.fit(id, a, b, za, zb);
      ++run_.operations.assignments;
      continue;
    }
    if (test(count == 1)) {
      const PlaneSegment& o = s[only];
      run_.operations.accesses += 1;
      if (a <= x0 && b >= x1 && n.z(x0) <= o.z(x0) && n.z(x1) <= o.z(x1)) {  // in front of the box
        box.fit(id, a, b, za, zb);
        ++run_.operations.assignments;
        continue;
      }
      if (a >= x0 && b <= x1 && za >= o.z(a) && zb >= o.z(b)) continue;  // hidden by it
      crossing = !begins && !ends && x0 == from && x1 == to;
      if (crossing) {
        other = id;
        const Real oz0 = o.z(from), oz1 = o.z(to), d0 = oz0 - za, d1 = oz1 - zb;
        cut = from + (to - from) * d0 / (d0 - d1);
        have_cut = true;
      }
    } else {
      crossing = false;
      if (a <= x0 && b >= x1 && n.z(x0) <= z0 && n.z(x1) <= z0) {
        box.fit(id, a, b, za, zb);
        run_.operations.assignments += 3;
        continue;
      }
    }
    run_.operations.assignments += 2;  // count and type
    ++count;
    if (a < x0) x0 = a;
    if (b > x1) x1 = b;
    const Real low = za < zb ? za : zb, high = za < zb ? zb : za;
    if (low < z0) z0 = low;
    if (high > z1) z1 = high;
  }
  return box;
}

void ThesisSpans::study_box(const std::vector<PlaneSegment>& s, const std::vector<std::uint32_t>& list, const Real& from,
                            const Real& to, bool at_ends) {
  ++run_.boxes;
  Box box = analyse(s, list, from, to);
  // Decision.
  if (test(box.count == 0)) return;
  if (test(box.count == 1)) return show(box.x0.value(), box.x1.value(), box.only);
  Real& cut = box.cut;
  if (test(box.crossing)) {
    const bool first = s[box.only].z(from) < s[box.other].z(from);
    show(from.value(), cut.value(), first ? box.only : box.other);
    return show(cut.value(), to.value(), first ? box.other : box.only);
  }
  // Control. At the width of a column the first segment of the list is shown; the sort has put the nearest first.
  if (to - from <= real(1)) return show(from.value(), to.value(), box.only);
  if (!at_ends || !box.have_cut) cut = real(std::floor((from.value() + to.value()) / 2));
  // If the ends of the part are not whole columns, as at crossings, a rounded cut may lie outside it.
  if (!(from.value() < cut.value() && cut.value() < to.value())) cut = real((from.value() + to.value()) / 2);
  study_box(s, box.inside, from, cut, at_ends);
  study_box(s, box.inside, cut, to, at_ends);
}

double difference_of(const std::vector<watkins::VisibleSpan>& a, const std::vector<watkins::VisibleSpan>& b) {
  std::vector<double> places;
  for (const auto* list : {&a, &b}) {
    for (const watkins::VisibleSpan& s : *list) {
      places.push_back(s.x0);
      places.push_back(s.x1);
    }
  }
  std::sort(places.begin(), places.end());
  const auto seen = [](const std::vector<watkins::VisibleSpan>& spans, double x) {
    for (const watkins::VisibleSpan& s : spans) {
      if (s.x0 < x && x < s.x1) return s.segment;
    }
    return 0xffffffffu;
  };
  double sum = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double middle = (places[i] + places[i + 1]) / 2;
    if (seen(a, middle) != seen(b, middle)) sum += places[i + 1] - places[i];
  }
  return sum;
}

}  // namespace ligne::studies
