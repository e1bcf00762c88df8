#include "visibility/watkins/exact/stretch_study.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ligne::watkins {
namespace {

/// Distance in lattice steps at which ends of stretches and of hidden intervals count as equal: they are computed in
/// different ways.
constexpr double kSamePlaceSteps = 0x1p-10;

/// True if both sides of [t0, t1] are known to be hidden, each by one interval.
bool hidden_all_along(const LineState& state, double t0, double t1, double slack) {
  bool left = false, right = false;
  for (const HiddenInterval& h : state.hidden) {
    if (h.from > t0 + slack || h.to < t1 - slack) continue;
    left |= h.sides != HiddenSides::right;
    right |= h.sides != HiddenSides::left;
    if (left && right) return true;
  }
  return false;
}

}  // namespace

StretchStudy::StretchStudy(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
                           std::span<const SweepLine> lines, double coincidence_steps, SpanMethodKind kind,
                           ScanEffort& effort)
    : vertices_(vertices),
      facets_(facets),
      lines_(lines),
      coincidence_steps_(coincidence_steps),
      spans_(make_span_method<double>(kind)),
      effort_(effort),
      marks_(facets.size()) {}

void StretchStudy::study(std::uint32_t index, LineState& state, Point2 from, Point2 to, const Cover& left,
                         const Cover& right) {
  const SweepLine& l = lines_[index];
  const PageLine line(l.from, l.to, l.face0, l.face1);
  const bool steep = std::abs(line.dy) > std::abs(line.dx);
  const auto parameter = [&](Point2 p) {
    return std::clamp(steep ? (p.y - line.p0.y) / line.dy : (p.x - line.p0.x) / line.dx, 0.0, 1.0);
  };
  double t0 = parameter(from), t1 = parameter(to);
  if (t0 > t1) std::swap(t0, t1);
  const double slack = kSamePlaceSteps / line.size;
  if (t1 - t0 <= slack) return;
  ++counts_.stretches;
  if (hidden_all_along(state, t0, t1, slack)) {
    ++counts_.carried;
    return;
  }
  effort_.spend(state.tested.size() + left.size() + right.size());
  candidates_.clear();
  mark_tested(state);
  const double z_far = std::max(line.z(t0), line.z(t1));
  add_candidates(line, z_far, left, true);
  add_candidates(line, z_far, right, false);
  if (candidates_.empty()) {
    ++counts_.in_front;
    return;
  }
  if (candidates_.size() > 1) {
    propose(line, t0 + (t1 - t0) / 2);
    for (const std::uint32_t i : proposed_) {
      if (candidates_[i].facet == kNone) continue;
      test(line, candidates_[i].facet, state);
      candidates_[i].facet = kNone;
    }
    if (hidden_all_along(state, t0, t1, slack)) return;
  }
  for (const Candidate& c : candidates_) {
    if (c.facet != kNone) test(line, c.facet, state);
  }
}

void StretchStudy::mark_tested(const LineState& state) {
  if (++study_ == 0) {  // wraps around after 2^32 studies
    std::fill(marks_.begin(), marks_.end(), Mark{});
    study_ = 1;
  }
  for (const std::uint32_t f : state.tested) marks_[f] = {study_, kNone};
}

void StretchStudy::add_candidates(const PageLine& line, double z_far, const Cover& cover, bool left) {
  for (const std::uint32_t f : cover) {
    const Facet& facet = facets_[f];
    if (facet.z_near > z_far || facet.face == line.face0 || facet.face == line.face1) continue;
    Mark& mark = marks_[f];
    if (mark.study != study_) {
      mark = {study_, static_cast<std::uint32_t>(candidates_.size())};
      candidates_.push_back({f, left, !left});
    } else if (mark.candidate != kNone) {
      candidates_[mark.candidate].right = true;
    }
  }
}

/// The scan line crosses the line at t, one step to either side. Its abscissa is 0 on the line.
void StretchStudy::propose(const PageLine& line, double t) {
  ++counts_.studied;
  const bool down = comes_before(line.p0, line.p1);
  const double length = std::hypot(line.dx, line.dy) * (down ? 1 : -1);
  const double nx = line.dy / length, ny = -line.dx / length;  // to the right
  const double x = line.p0.x + t * line.dx, y = line.p0.y + t * line.dy;
  segments_.clear();
  for (std::uint32_t i = 0; i < candidates_.size(); ++i) {
    const Candidate& c = candidates_[i];
    const Facet& facet = facets_[c.facet];
    const double from = c.left ? -1 : 0, to = c.right ? 1 : 0;
    segments_.push_back({from, to, depth(facet, x + from * nx, y + from * ny), depth(facet, x + to * nx, y + to * ny), i});
  }
  std::sort(segments_.begin(), segments_.end(), [](const auto& a, const auto& b) { return comes_before(a, b); });
  spans_->study(segments_, found_);
  assert(are_left_to_right(found_));
  proposed_.clear();
  for (const VisibleSpan& s : found_) {
    if (s.x0 <= 0 && s.x1 >= 0) proposed_.push_back(segments_[s.segment].face);
  }
}

void StretchStudy::test(const PageLine& line, std::uint32_t facet, LineState& state) {
  ++counts_.facet_tests;
  state.tested.push_back(facet);
  const HiddenInterval h =
      hidden_interval(line, facets_[facet], vertices_.data(), {0, 1}, coincidence_steps_, state.near_side);
  if (h.sides != HiddenSides::none) state.hidden.push_back(h);
}

double StretchStudy::depth(const Facet& facet, double x, double y) const {
  const ProjectedVertex &a = vertices_[facet.v[0]], &b = vertices_[facet.v[1]], &c = vertices_[facet.v[2]];
  const double abx = double(b.p.x) - a.p.x, aby = double(b.p.y) - a.p.y, acx = double(c.p.x) - a.p.x,
               acy = double(c.p.y) - a.p.y;
  const double qx = x - a.p.x, qy = y - a.p.y;
  const double area = abx * acy - aby * acx;
  const double v = (qx * acy - qy * acx) / area, w = (abx * qy - aby * qx) / area;
  return a.z + v * (b.z - a.z) + w * (c.z - a.z);
}

}  // namespace ligne::watkins
