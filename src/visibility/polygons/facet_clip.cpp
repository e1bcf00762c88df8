// If many clip faces lie over one subject, the window is halved recursively, and each half gets only the clip faces
// that meet it. A half that they cover is finished: nothing is visible there. Halving changes no result: all faces that
// meet a half, unclipped, decide the parts of edges in it, and linking the edges joins parts across a border of halves.
// The sides of halves are odd numbers of half steps, so that no corner lies on them and no side runs along them.

#include "visibility/polygons/facet_clip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/hash.hpp"

namespace ligne {
namespace {

/// A window that this many rims cross, or fewer, is not halved. Adjustable.
constexpr std::size_t kFewRims = 24;
constexpr int kDeepest = 24;

/// Bound on the error when a line of a face is evaluated in half steps: five numbers below 2^55 are rounded.
constexpr double kDoubt = 64;

/// Clips [from, to] to low <= 2 (a + t d) <= high. Exact: 2 low and 2 a have 27 bits.
bool cut_range(double a, double d, double low, double high, SegmentParameter& from, SegmentParameter& to) {
  if (d == 0) return 2 * a > low && 2 * a < high;
  const double at_low = low - 2 * a, at_high = high - 2 * a;
  const SegmentParameter enter = d > 0 ? SegmentParameter{at_low, 2 * d} : SegmentParameter{-at_high, -2 * d};
  const SegmentParameter leave = d > 0 ? SegmentParameter{at_high, 2 * d} : SegmentParameter{-at_low, -2 * d};
  if (compare(from, enter) < 0) from = enter;
  if (compare(leave, to) < 0) to = leave;
  return compare(from, to) < 0;
}

/// Whether the segment lies beside the window. False where rounding leaves it open.
bool beside(const LatticeSegment& s, const FacetClip::Window& w) {
  const double ax = 2 * double(s.a.x), ay = 2 * double(s.a.y), bx = 2 * double(s.b.x), by = 2 * double(s.b.y);
  if (std::max(ax, bx) <= w.x0 || std::min(ax, bx) >= w.x1 || std::max(ay, by) <= w.y0 || std::min(ay, by) >= w.y1)
    return true;
  const double dx = s.dx(), dy = s.dy(), c = dy * ax - dx * ay;
  const double x0 = -dy * w.x0, x1 = -dy * w.x1, y0 = dx * w.y0, y1 = dx * w.y1;
  return std::min(x0, x1) + std::min(y0, y1) + c > kDoubt || std::max(x0, x1) + std::max(y0, y1) + c < -kDoubt;
}

std::size_t hash_of(const LatticeSegment& s) {
  std::uint64_t h = 0;
  for (const std::int32_t v : {s.a.x, s.a.y, s.b.x, s.b.y}) h = extend_hash(h, static_cast<std::uint32_t>(v));
  return h;
}

}  // namespace

FacetClip::Lines::Lines(const ClipPart& part) : count(part.count) {
  for (std::uint32_t k = 0; k < count; ++k) {
    const ContourEdge& e = part.edges[k];
    const double dx = e.dx(), dy = e.dy(), x = 2 * double(e.segment.a.x), y = 2 * double(e.segment.a.y);
    line[k] = {-dy, dx, dy * x - dx * y};
  }
}

FacetClip::Meeting FacetClip::Lines::meet(const Window& w) const {
  bool covers = true;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Line& l = line[k];
    const double ax0 = l.a * w.x0, ax1 = l.a * w.x1, by0 = l.b * w.y0, by1 = l.b * w.y1;
    if (std::max(ax0, ax1) + std::max(by0, by1) + l.c < -kDoubt) return Meeting::apart;
    covers = covers && std::min(ax0, ax1) + std::min(by0, by1) + l.c > kDoubt;
  }
  return covers ? Meeting::covers : Meeting::meets;
}

bool FacetClip::Lines::surely_inside(double x, double y) const {
  for (std::uint32_t k = 0; k < count; ++k) {
    if (line[k].a * x + line[k].b * y + line[k].c <= kDoubt) return false;
  }
  return true;
}

void FacetClip::begin(const ClipPart& subject) {
  subject_ = subject;
  subject_lines_ = Lines(subject);
  clips_.clear();
  lines_.clear();
  faces_.clear();
  sides_.clear();
  listed_.clear();
  list_number_ = 0;
}

FacetClip::Number FacetClip::add(const ClipPart& clip, bool transparent) {
  clips_.push_back({clip, transparent});
  lines_.emplace_back(clip);
  sides_.add(clip, transparent);
  listed_.push_back(0);
  return static_cast<Number>(clips_.size() - 1);
}

std::vector<ContourEdge>& FacetClip::level(std::size_t k) {
  if (out_->size() <= k) out_->resize(k + 1);
  return (*out_)[k];
}

void FacetClip::begin_list(std::span<const Number> list) {
  ++list_number_;
  for (const Number i : list) listed_[i] = list_number_;
}

/// Whether a side of a clip face is a rim: the list has no partner across it.
bool FacetClip::is_rim(Number clip, std::uint32_t side) const {
  const std::uint32_t partner = sides_.partner(clip, side);
  return partner == kNone || listed_[partner] != list_number_;
}

/// Finds a point, in half steps, that surely lies inside the subject and the window.
bool FacetClip::find_inner_point(const Window& window, double& x, double& y) const {
  struct Place {
    double x, y;
  };
  std::array<Place, 8> places, cut;
  std::size_t n = 0;
  for (std::uint32_t k = 0; k < subject_.count; ++k) {
    const ContourEdge& e = subject_.edges[k];
    const LatticePoint p = e.reversed ? e.segment.b : e.segment.a;
    places[n++] = {2 * double(p.x), 2 * double(p.y)};
  }
  const auto clip = [&](auto inside) {
    std::size_t m = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Place &a = places[i], &b = places[i + 1 == n ? 0 : i + 1];
      const double at_a = inside(a), at_b = inside(b);
      if (at_a >= 0 && m < cut.size()) cut[m++] = a;
      if ((at_a >= 0) != (at_b >= 0) && m < cut.size()) {
        const double t = at_a / (at_a - at_b);
        cut[m++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      }
    }
    places = cut;
    n = m;
  };
  clip([&](const Place& p) { return p.x - window.x0; });
  clip([&](const Place& p) { return window.x1 - p.x; });
  clip([&](const Place& p) { return p.y - window.y0; });
  clip([&](const Place& p) { return window.y1 - p.y; });
  if (n < 3) return false;
  // The weights are unequal because the centre may well lie on a side of a regular mesh.
  double sum = 0, weight = 1;
  x = y = 0;
  for (std::size_t i = 0; i < n; ++i, weight *= 0.8) {
    x += weight * places[i].x;
    y += weight * places[i].y;
    sum += weight;
  }
  x /= sum;
  y /= sum;
  return x > window.x0 && x < window.x1 && y > window.y0 && y < window.y1 && subject_lines_.surely_inside(x, y);
}

/// Starts at a clip face over some point of the subject and visits its neighbours, across the sides that pass over the
/// subject. If none of these sides is a rim, the patch covers the whole subject in the window, as it covers the point.
/// Other surfaces do not matter, even if the list contains some of their clip faces without neighbours.
bool FacetClip::covers(std::span<const Number> list, const Window& window) {
  double x = 0, y = 0;
  if (!find_inner_point(window, x, y)) return false;
  begin_list(list);
  const std::uint32_t listed = list_number_;
  for (const Number start : list) {
    if (clips_[start].transparent || listed_[start] != listed || !lines_[start].surely_inside(x, y)) continue;
    const std::uint32_t reached = ++list_number_;
    bool rim = false;
    patch_.assign(1, start);
    listed_[start] = reached;
    for (std::size_t n = 0; n < patch_.size() && !rim; ++n) {
      const ClipPart& part = clips_[patch_[n]].form;
      for (std::uint32_t k = 0; k < part.count && !rim; ++k) {
        const std::uint32_t partner = sides_.partner(patch_[n], k);
        if (partner != kNone && listed_[partner] == reached) continue;
        if (beside(part.edges[k].segment, window) || !passes_over_subject(part.edges[k])) continue;
        // The partner is not listed, or belongs to a patch with a rim.
        rim = partner == kNone || listed_[partner] != listed;
        if (rim) break;
        listed_[partner] = reached;
        patch_.push_back(partner);
      }
    }
    if (!rim) return true;
  }
  return false;
}

void FacetClip::finish(std::vector<std::vector<ContourEdge>>& out) {
  out_ = &out;
  if (clip_count() == 0) {
    std::vector<ContourEdge>& seen = level(0);
    seen.insert(seen.end(), subject_.edges.begin(), subject_.edges.begin() + subject_.count);
    return;
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Window window{kFar, kFar, -kFar, -kFar};
  for (std::uint32_t k = 0; k < subject_.count; ++k) {
    for (const LatticePoint p : {subject_.edges[k].segment.a, subject_.edges[k].segment.b}) {
      window = {std::min(window.x0, 2 * double(p.x) - 1), std::min(window.y0, 2 * double(p.y) - 1),
                std::max(window.x1, 2 * double(p.x) + 1), std::max(window.y1, 2 * double(p.y) + 1)};
    }
  }
  std::vector<Number> all(clips_.size());
  for (Number i = 0; i < all.size(); ++i) all[i] = i;
  if (faces_.empty()) {
    split(window, all, 0);
  } else {
    borders_in(window, all, true);
  }
}

void FacetClip::split(const Window& window, std::span<const Number> list, int depth) {
  if (subject_lines_.meet(window) == Meeting::apart) return;
  std::vector<Number> kept;
  kept.reserve(list.size());
  for (const Number i : list) {
    const Meeting m = lines_[i].meet(window);
    if (m == Meeting::covers && !clips_[i].transparent) return;
    if (m != Meeting::apart) kept.push_back(i);
  }
  begin_list(kept);
  std::size_t rims = 0;
  for (const Number i : kept) {
    const ClipPart& part = clips_[i].form;
    for (std::uint32_t k = 0; k < part.count; ++k) rims += is_rim(i, k) && !beside(part.edges[k].segment, window);
  }
  const double width = window.x1 - window.x0, height = window.y1 - window.y0;
  // A list does not become shorter if its sides pass through one point, or if its faces are transparent; smaller halves
  // would only repeat it.
  const bool shorter = depth == 0 || depth % 6 != 0 || kept.size() < list.size();
  if (rims <= kFewRims || depth >= kDeepest || std::max(width, height) <= 8 || !shorter) {
    borders_in(window, kept, depth == 0);
    return;
  }
  if (covers(kept, window)) return;
  Window a = window, b = window;
  if (width >= height) {
    a.x1 = b.x0 = window.x0 + 2 * std::floor(width / 4);
  } else {
    a.y1 = b.y0 = window.y0 + 2 * std::floor(height / 4);
  }
  split(a, kept, depth + 1);
  split(b, kept, depth + 1);
}

/// Whether the edge's segment lies outside a side of the subject, or along it. There it bounds nothing of the subject
/// that the subject's own side does not bound.
bool FacetClip::beside_subject(const ContourEdge& edge) const {
  if (edge.source == kCutSource) return false;
  for (std::uint32_t k = 0; k < subject_.count; ++k) {
    const ContourEdge& side = subject_.edges[k];
    const double a = orientation(side.segment.a, side.segment.b, edge.segment.a),
                 b = orientation(side.segment.a, side.segment.b, edge.segment.b);
    if (side.reversed ? a >= 0 && b >= 0 : a <= 0 && b <= 0) return true;
  }
  return false;
}

/// Whether the edge's segment has points inside the subject; for a cut, whether its whole line has.
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

void FacetClip::borders_in(const Window& window, std::span<const Number> list, bool whole) {
  begin_list(list);
  overlay_.clear();
  for (std::uint32_t k = 0; k < subject_.count; ++k) overlay_.add(subject_.edges[k], 0);
  for (const Number i : list) {
    const ClipPart& part = clips_[i].form;
    for (std::uint32_t k = 0; k < part.count; ++k) {
      if (is_rim(i, k)) overlay_.add(part.edges[k], clips_[i].transparent ? 2 : 1);
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
    const auto add = [&](std::int32_t k, SegmentParameter f, SegmentParameter t, bool reversed, bool continues) {
      if (k == kUnseen) return;
      std::vector<ContourEdge>& out = level(static_cast<std::size_t>(k));
      if (continues && !out.empty() && out.back().source == edge.source && out.back().segment == edge.segment &&
          out.back().reversed == reversed && compare(out.back().to, f) == 0) {
        out.back().to = t;
      } else {
        out.push_back({edge.segment, f, t, edge.source, reversed});
      }
    };
    overlay_.for_each_part(i, from, to, [&](SegmentParameter f, SegmentParameter t, const EdgeSides& b, bool corner) {
      const std::int32_t left = level_of(b.left), right = level_of(b.right);
      if (left == right) return;
      add(left, f, t, false, !corner);
      add(right, f, t, true, !corner);
    });
  }
}

void SharedSides::clear() {
  sides_.clear();
  partner_.clear();
  ++round_;
}

void SharedSides::add(const ClipPart& clip, bool transparent) {
  const auto first = static_cast<std::uint32_t>(partner_.size());
  partner_.resize(partner_.size() + kMostSides, kNone);
  for (std::uint32_t k = 0; k < clip.count; ++k) {
    const ContourEdge& e = clip.edges[k];
    if (e.source == kCutSource || e.from.num != 0 || e.to.num != e.to.den) continue;
    sides_.push_back({e.segment, transparent, e.reversed, first + k});
    if (2 * sides_.size() > slots_.size()) {
      grow();
    } else {
      insert(static_cast<std::uint32_t>(sides_.size() - 1));
    }
  }
}

void SharedSides::grow() {
  slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), {});
  round_ = 1;
  for (std::uint32_t i = 0; i < sides_.size(); ++i) insert(i);
}

void SharedSides::insert(std::uint32_t side) {
  const Side& s = sides_[side];
  std::uint32_t& partner = partner_[s.number];
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash_of(s.segment) & mask;
  for (; slots_[i].round == round_; i = (i + 1) & mask) {
    const Side& other = sides_[slots_[i].side];
    if (partner == kNone && partner_[other.number] == kNone && other.reversed != s.reversed &&
        other.transparent == s.transparent && other.segment == s.segment) {
      partner = other.number / kMostSides;
      partner_[other.number] = s.number / kMostSides;
    }
  }
  slots_[i] = {round_, side};
}

}  // namespace ligne
