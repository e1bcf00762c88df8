#include "visibility/atherton_weiler/facet_clip.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

// Many clip faces over one subject: the page is halved again and again, and each half has only the clip faces that meet it. A half that one
// of them covers is done: nothing is seen there. Halving changes no result: a part of an edge is decided by all faces that meet its
// half, whole as they are, and parts that go on across a border are put together when the edges are linked.

namespace ligne::atherton_weiler {
namespace {

/// Adjustable: up to so many clip faces are laid over the subject at once.
constexpr std::size_t kFewClips = 10;
constexpr int kDeepest = 24;

/// Cuts [from, to] to where low <= 2 (a + t d) <= high. Exact: 2 low and 2 a have 27 bits.
bool cut_range(double a, double d, std::int64_t low, std::int64_t high, SegmentParameter& from, SegmentParameter& to) {
  if (d == 0) return 2 * a > static_cast<double>(low) && 2 * a < static_cast<double>(high);
  const double at_low = static_cast<double>(low) - 2 * a, at_high = static_cast<double>(high) - 2 * a;
  const SegmentParameter enter = d > 0 ? SegmentParameter{at_low, 2 * d} : SegmentParameter{-at_high, -2 * d};
  const SegmentParameter leave = d > 0 ? SegmentParameter{at_high, 2 * d} : SegmentParameter{-at_low, -2 * d};
  if (compare(from, enter) < 0) from = enter;
  if (compare(leave, to) < 0) to = leave;
  return compare(from, to) < 0;
}

}  // namespace

ClipPart whole_facet(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t facet) {
  const Facet& f = facets[facet];
  ClipPart part;
  part.count = 3;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t v = f.v[k], w = f.v[(k + 1) % 3];
    ContourEdge& e = part.edges[k];
    e.reversed = v > w;
    e.segment = e.reversed ? LatticeSegment{vertices[w].p, vertices[v].p} : LatticeSegment{vertices[v].p, vertices[w].p};
    e.source = side_source(facet, k);
  }
  return part;
}

ClipPart left_of(const ClipPart& triangle, const LatticeSegment& line) {
  std::array<double, 3> at{};
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ContourEdge& e = triangle.edges[k];
    at[k] = orientation(line.a, line.b, e.reversed ? e.segment.b : e.segment.a);
    left += at[k] > 0;
    right += at[k] < 0;
  }
  if (right == 0) return triangle;
  ClipPart part;
  if (left == 0) return part;
  SegmentParameter ends[2];
  int n = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double first = at[k], last = at[(k + 1) % 3];
    ContourEdge e = triangle.edges[k];
    if (first * last < 0) {
      const SegmentParameter t = crossing(e.segment, line);
      ((first < 0) == e.reversed ? e.to : e.from) = t;
      ends[n++] = crossing(line, e.segment);
    } else if (last == 0 && first != 0 && n < 2) {
      ends[n++] = crossing(line, e.segment);
    }
    if (first > 0 || last > 0) part.edges[part.count++] = e;
  }
  ContourEdge cut;
  cut.segment = line;
  cut.from = compare(ends[0], ends[1]) < 0 ? ends[0] : ends[1];
  cut.to = compare(ends[0], ends[1]) < 0 ? ends[1] : ends[0];
  cut.source = kCutSource;
  part.edges[part.count++] = cut;
  return part;
}

FacetClip::Lines::Lines(const ClipPart& part) : line{}, count(part.count) {
  for (std::uint32_t k = 0; k < count; ++k) {
    const ContourEdge& e = part.edges[k];
    const double dx = e.dx(), dy = e.dy(), x = 2 * double(e.segment.a.x), y = 2 * double(e.segment.a.y);
    line[k] = {-dy, dx, dy * x - dx * y};
  }
}

FacetClip::Meeting FacetClip::Lines::meet(const Window& w) const {
  // Five numbers below 2^55 are rounded: the sum is off by less than this.
  constexpr double kDoubt = 64;
  const double x0 = static_cast<double>(w.x0), x1 = static_cast<double>(w.x1), y0 = static_cast<double>(w.y0), y1 = static_cast<double>(w.y1);
  bool covers = true;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Line& l = line[k];
    const double ax0 = l.a * x0, ax1 = l.a * x1, by0 = l.b * y0, by1 = l.b * y1;
    if (std::max(ax0, ax1) + std::max(by0, by1) + l.c < -kDoubt) return Meeting::apart;
    covers = covers && std::min(ax0, ax1) + std::min(by0, by1) + l.c > kDoubt;
  }
  return covers ? Meeting::covers : Meeting::meets;
}

std::vector<ContourEdge>& FacetClip::level(std::size_t k) {
  if (out_->size() <= k) out_->resize(k + 1);
  return (*out_)[k];
}

/// A side that two clip faces have in common, one on each bank, bounds nothing of the two together: how often all of them wind round a place
/// is the same without it. So a surface of many facets is laid over the subject as one face, by its rim.
void FacetClip::pair_sides() {
  sides_.clear();
  partner_.assign(4 * clips_.size(), kNoPartner);
  for (std::uint32_t i = 0; i < clips_.size(); ++i) {
    for (std::uint32_t k = 0; k < clips_[i].form.count; ++k) {
      const ContourEdge& e = clips_[i].form.edges[k];
      const bool whole = e.source != kCutSource && e.from.num == 0 && e.to.num == e.to.den;
      if (whole) sides_.push_back({e.segment, clips_[i].transparent, e.reversed, i, k});
    }
  }
  const auto place = [](const Side& s) { return std::tuple(s.segment.a.x, s.segment.a.y, s.segment.b.x, s.segment.b.y, s.transparent); };
  std::sort(sides_.begin(), sides_.end(), [&](const Side& a, const Side& b) {
    const auto pa = place(a), pb = place(b);
    return pa != pb ? pa < pb : std::tuple(a.reversed, a.clip) < std::tuple(b.reversed, b.clip);
  });
  for (std::size_t i = 0; i < sides_.size();) {
    std::size_t back = i;
    while (back < sides_.size() && place(sides_[back]) == place(sides_[i]) && !sides_[back].reversed) ++back;
    std::size_t end = back;
    while (end < sides_.size() && place(sides_[end]) == place(sides_[i])) ++end;
    for (std::size_t k = i, other = back; k < back && other < end; ++k, ++other) {
      partner_[4 * sides_[k].clip + sides_[k].number] = sides_[other].clip;
      partner_[4 * sides_[other].clip + sides_[other].number] = sides_[k].clip;
    }
    i = end;
  }
}

/// Whether the opaque clip faces hide all of the subject: when no rim of theirs passes over its inside, what holds at one place of it holds
/// everywhere, and each whole facet among them hides a place.
bool FacetClip::covered() const {
  bool hides = false;
  for (std::uint32_t i = 0; i < clips_.size(); ++i) {
    if (clips_[i].transparent) continue;
    bool whole = true;
    for (std::uint32_t k = 0; k < clips_[i].form.count; ++k) {
      const ContourEdge& edge = clips_[i].form.edges[k];
      whole = whole && edge.source != kCutSource;
      if (!is_paired(i, k) && passes_over_subject(edge)) return false;
    }
    hides = hides || whole;
  }
  return hides;
}

void FacetClip::finish(std::vector<std::vector<ContourEdge>>& out) {
  out_ = &out;
  if (clip_count() == 0) {
    std::vector<ContourEdge>& seen = level(0);
    seen.insert(seen.end(), subject_.edges.begin(), subject_.edges.begin() + subject_.count);
    return;
  }
  pair_sides();
  listed_.assign(clips_.size(), list_number_ = 0);
  if (covered()) return;
  Window window{INT64_MAX, INT64_MAX, INT64_MIN, INT64_MIN};
  for (std::uint32_t k = 0; k < subject_.count; ++k) {
    for (const LatticePoint p : {subject_.edges[k].segment.a, subject_.edges[k].segment.b}) {
      window = {std::min<std::int64_t>(window.x0, 2 * std::int64_t{p.x} - 1), std::min<std::int64_t>(window.y0, 2 * std::int64_t{p.y} - 1),
                std::max<std::int64_t>(window.x1, 2 * std::int64_t{p.x} + 1), std::max<std::int64_t>(window.y1, 2 * std::int64_t{p.y} + 1)};
    }
  }
  std::vector<std::uint32_t> all(clips_.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  if (all.size() <= kFewClips || !faces_.empty()) {
    borders_in(window, all, true);
  } else {
    split(window, all, 0);
  }
}

void FacetClip::split(const Window& window, std::span<const std::uint32_t> list, int depth) {
  if (Lines(subject_).meet(window) == Meeting::apart) return;
  std::vector<std::uint32_t> kept;
  kept.reserve(list.size());
  for (const std::uint32_t i : list) {
    const Meeting m = lines_[i].meet(window);
    if (m == Meeting::covers && !clips_[i].transparent) return;
    if (m != Meeting::apart) kept.push_back(i);
  }
  const std::int64_t width = window.x1 - window.x0, height = window.y1 - window.y0;
  // Lists that do not become shorter are of sides through one place, or of transparent faces; deeper halves would only repeat them.
  const bool shorter = depth == 0 || depth % 6 != 0 || kept.size() < list.size();
  if (kept.size() <= kFewClips || depth >= kDeepest || std::max(width, height) <= 8 || !shorter) {
    borders_in(window, kept, false);
    return;
  }
  Window a = window, b = window;
  if (width >= height) {
    a.x1 = b.x0 = window.x0 + width / 4 * 2;
  } else {
    a.y1 = b.y0 = window.y0 + height / 4 * 2;
  }
  split(a, kept, depth + 1);
  split(b, kept, depth + 1);
}

/// Whether the edge's segment lies on the outer side of a side of the subject, or along it. There it borders nothing of the subject that a side
/// of the subject does not border too.
bool FacetClip::beside_subject(const ContourEdge& edge) const {
  if (edge.source == kCutSource) return false;
  for (std::uint32_t k = 0; k < subject_.count; ++k) {
    const ContourEdge& side = subject_.edges[k];
    const double a = orientation(side.segment.a, side.segment.b, edge.segment.a), b = orientation(side.segment.a, side.segment.b, edge.segment.b);
    if (side.reversed ? a >= 0 && b >= 0 : a <= 0 && b <= 0) return true;
  }
  return false;
}

/// Whether the edge's segment has points in the inside of the subject; true also where only the line of a cut does.
bool FacetClip::passes_over_subject(const ContourEdge& edge) const {
  if (beside_subject(edge)) return false;
  int left = 0, right = 0;
  for (std::uint32_t k = 0; k < subject_.count; ++k) {
    const ContourEdge& side = subject_.edges[k];
    const double at = orientation(edge.segment.a, edge.segment.b, side.reversed ? side.segment.b : side.segment.a);
    left += at > 0;
    right += at < 0;
  }
  return left > 0 && right > 0;
}

void FacetClip::borders_in(const Window& window, std::span<const std::uint32_t> list, bool whole) {
  ++list_number_;
  for (const std::uint32_t i : list) listed_[i] = list_number_;
  overlay_.clear();
  for (std::uint32_t k = 0; k < subject_.count; ++k) overlay_.add(subject_.edges[k], 0);
  for (const std::uint32_t i : list) {
    const ClipPart& part = clips_[i].form;
    for (std::uint32_t k = 0; k < part.count; ++k) {
      if (!is_paired(i, k)) overlay_.add(part.edges[k], clips_[i].transparent ? 2 : 1);
    }
  }
  for (const Clip<ContourFace>& face : faces_) overlay_.add(face.form, face.transparent ? 2 : 1);
  constexpr std::int32_t kUnseen = -1;
  const auto level_of = [](const std::array<std::int32_t, 3>& winding) {
    return winding[0] > 0 && winding[1] <= 0 ? std::max(winding[2], 0) : kUnseen;
  };
  for (std::size_t i = 0; i < overlay_.size(); ++i) {
    const ContourEdge edge = overlay_.edge(i);
    if (i >= subject_.count && beside_subject(edge)) continue;
    SegmentParameter from = edge.from, to = edge.to;
    if (!whole && !(cut_range(edge.segment.a.x, edge.segment.dx(), window.x0, window.x1, from, to) &&
                    cut_range(edge.segment.a.y, edge.segment.dy(), window.y0, window.y1, from, to))) {
      continue;
    }
    const auto add = [&](std::int32_t k, SegmentParameter f, SegmentParameter t, bool reversed, bool goes_on) {
      if (k == kUnseen) return;
      std::vector<ContourEdge>& out = level(static_cast<std::size_t>(k));
      if (goes_on && !out.empty() && out.back().source == edge.source && out.back().segment == edge.segment &&
          out.back().reversed == reversed && compare(out.back().to, f) == 0) {
        out.back().to = t;
      } else {
        out.push_back({edge.segment, f, t, edge.source, reversed});
      }
    };
    overlay_.for_each_part(i, from, to, [&](SegmentParameter f, SegmentParameter t, const Banks& b, bool corner) {
      const std::int32_t left = level_of(b.left), right = level_of(b.right);
      if (left == right) return;
      add(left, f, t, false, !corner);
      add(right, f, t, true, !corner);
    });
  }
}

}  // namespace ligne::atherton_weiler
