#include "geometry/polygons/convex_clip.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

// Phases: (1) corners are coded; a pair that lies apart, or a subject within, ends here. (2) Edges of each contour are
// divided where they enter and leave the other. (3) The parts inside, sorted by direction, are the contour of the
// intersection. (4) Parts of the clip contour that follow each other there, together with the part of the subject's contour
// that they cut off, are a contour outside.

namespace ligne {
namespace {

int sign_of(double v) { return (v > 0) - (v < 0); }
double dot(const ContourEdge& a, const ContourEdge& b) { return a.dx() * b.dx() + a.dy() * b.dy(); }
double turn(const ContourEdge& a, const ContourEdge& b) { return a.dx() * b.dy() - a.dy() * b.dx(); }

SegmentParameter first_parameter(const ContourEdge& e) { return e.reversed ? e.to : e.from; }
SegmentParameter last_parameter(const ContourEdge& e) { return e.reversed ? e.from : e.to; }

/// Side of the line of a segment on which the point of another segment lies.
int side_of_point(const LatticeSegment& line, const LatticeSegment& s, SegmentParameter t) {
  if (s == line) return 0;
  if (t.num == 0) return sign_of(orientation(line.a, line.b, s.a));
  if (t.num == t.den) return sign_of(orientation(line.a, line.b, s.b));
  return side(line, s, t);
}

/// Whether an edge ends exactly where the next one begins.
bool meets_exactly(const ContourEdge& edge, const ContourEdge& next) {
  const SegmentParameter end = last_parameter(edge), begin = first_parameter(next);
  if (turn(edge, next) != 0) {
    return side_of_point(next.segment, edge.segment, end) == 0 && side_of_point(edge.segment, next.segment, begin) == 0;
  }
  if (edge.segment == next.segment) return compare(end, begin) == 0;
  const bool at_ends = (end.num == 0 || end.num == end.den) && (begin.num == 0 || begin.num == begin.den);
  return at_ends && (end.num == 0 ? edge.segment.a : edge.segment.b) == (begin.num == 0 ? next.segment.a : next.segment.b);
}

/// Whether `a` comes before `b` when directions are turned positively from that of `base`.
bool comes_before(const ContourEdge& base, const ContourEdge& a, const ContourEdge& b) {
  const auto is_beyond_half = [&](const ContourEdge& e) {
    const double by = turn(base, e);
    return by < 0 || (by == 0 && dot(base, e) < 0);
  };
  const bool half_a = is_beyond_half(a), half_b = is_beyond_half(b);
  return half_a != half_b ? half_b : turn(a, b) > 0;
}

/// Smallest mean width, in lattice steps, of a part that is clear of rounding: four steps of the fine lattice. Rounding
/// moves the contour by one half of such a step.
constexpr double kClearWidth = 4.0 / (1 << kFineBits);

/// Whether rounding corners to the fine lattice can not make the contour vanish. Computed in doubles, whose errors here are
/// a thousandth of a step of the fine lattice.
bool is_clear(const EdgeLoop& loop) {
  const auto corner = [](const ContourEdge& e) {
    const double t = value(first_parameter(e));
    return Point2{e.segment.a.x + t * e.segment.dx(), e.segment.a.y + t * e.segment.dy()};
  };
  const Point2 origin = corner(loop.front());
  double twice_area = 0, length = 0;
  Point2 last{0, 0};
  for (std::size_t i = 1; i <= loop.size(); ++i) {
    const Point2 p = i == loop.size() ? Point2{0, 0} : corner(loop[i]) - origin;
    twice_area += last.x * p.y - last.y * p.x;
    length += std::abs(p.x - last.x) + std::abs(p.y - last.y);
    last = p;
  }
  return twice_area > kClearWidth * length;
}

/// The part of an edge inside a convex contour, as a range of parameters. It is empty if `from` is not before `to`.
struct Range {
  SegmentParameter from, to;
  bool is_empty = false;
};

/// `begin` and `end` are the codes of the two ends of the edge. On an edge along the contour, the inside of both must lie on
/// the same side.
Range range_inside(const ContourEdge& edge, const std::int8_t* begin, const std::int8_t* end, const EdgeLoop& contour) {
  Range range{edge.from, edge.to};
  if (edge.reversed) std::swap(begin, end);
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const std::int8_t low = begin[k], high = end[k];
    if (low >= 0 && high >= 0 && low + high > 0) continue;
    if (low <= 0 && high <= 0) {
      if (low == 0 && high == 0 && dot(edge, contour[k]) > 0) continue;
      range.is_empty = true;
      return range;
    }
    const SegmentParameter t = crossing(edge.segment, contour[k].segment);
    if (low < 0) {
      if (compare(range.from, t) < 0) range.from = t;
    } else if (compare(t, range.to) < 0) {
      range.to = t;
    }
  }
  return range;
}

/// Whether the line of some edge of the contour has both ends of an edge on it.
bool is_along(const std::int8_t* begin, const std::int8_t* end, std::size_t edges) {
  for (std::size_t k = 0; k < edges; ++k) {
    if (begin[k] == 0 && end[k] == 0) return true;
  }
  return false;
}

ContourEdge turned(ContourEdge edge) {
  edge.reversed = !edge.reversed;
  return edge;
}

ContourFace face_of(EdgeLoop loop, bool is_convex) {
  ContourFace face;
  face.contours.push_back(std::move(loop));
  face.is_convex = is_convex;
  return face;
}

}  // namespace

bool is_convex(const ContourFace& face) {
  if (face.contours.size() != 1 || face.contours[0].size() < 3) return false;
  const EdgeLoop& loop = face.contours[0];
  int half_turns = 0;  // directions pass that of the first edge or the opposite one: twice in all
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ContourEdge &edge = loop[i], &next = loop[i + 1 == loop.size() ? 0 : i + 1];
    const double by = turn(edge, next);
    if (by < 0 || (by == 0 && dot(edge, next) < 0)) return false;
    const auto is_upper = [](const ContourEdge& e) { return e.dy() > 0 || (e.dy() == 0 && e.dx() > 0); };
    half_turns += is_upper(edge) != is_upper(next);
  }
  if (half_turns != 2) return false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (!meets_exactly(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1])) return false;
  }
  return true;
}

/// Codes the corners of a contour against the edges of the other, edge after edge. False if one edge has all corners on its
/// line or outside: then the contours lie apart.
bool ConvexClip::code(const EdgeLoop& corners, const EdgeLoop& edges, Codes& codes) {
  codes.width = edges.size();
  codes.sides.resize(corners.size() * codes.width);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    bool has_inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int at = side_of_point(edges[k].segment, corners[i].segment, first_parameter(corners[i]));
      const int inward = edges[k].reversed ? -at : at;
      codes.sides[i * codes.width + k] = static_cast<std::int8_t>(inward);
      has_inside |= inward > 0;
    }
    signs_ += corners.size();
    if (!has_inside) return false;
  }
  return true;
}

void ConvexClip::divide_subject(const EdgeLoop& subject, const EdgeLoop& clip) {
  subject_parts_.clear();
  const auto add = [&](const ContourEdge& edge, SegmentParameter from, SegmentParameter to, Origin origin) {
    ContourEdge part = edge;
    part.from = from;
    part.to = to;
    subject_parts_.push_back({part, static_cast<std::uint32_t>(subject_parts_.size()), origin});
  };
  for (std::size_t i = 0; i < subject.size(); ++i) {
    const ContourEdge& e = subject[i];
    const Range in = range_inside(e, subject_codes_.of(i), subject_codes_.of(i + 1 == subject.size() ? 0 : i + 1), clip);
    const int length = in.is_empty ? -1 : compare(in.to, in.from);
    if (length < 0) {
      add(e, e.from, e.to, Origin::subject_outside);
      continue;
    }
    // Where length is 0, a corner of the clip contour touches the edge.
    const bool before = compare(e.from, in.from) < 0, after = compare(in.to, e.to) < 0;
    if (before && !e.reversed) add(e, e.from, in.from, Origin::subject_outside);
    if (after && e.reversed) add(e, in.to, e.to, Origin::subject_outside);
    if (length > 0) add(e, in.from, in.to, Origin::subject_inside);
    if (after && !e.reversed) add(e, in.to, e.to, Origin::subject_outside);
    if (before && e.reversed) add(e, e.from, in.from, Origin::subject_outside);
  }
}

/// Edges of the clip contour along the subject's contour are left out, as the subject's edges bound the results there.
void ConvexClip::find_clip_parts(const EdgeLoop& subject, const EdgeLoop& clip) {
  clip_parts_.clear();
  for (std::size_t k = 0; k < clip.size(); ++k) {
    const std::int8_t *begin = clip_codes_.of(k), *end = clip_codes_.of(k + 1 == clip.size() ? 0 : k + 1);
    if (is_along(begin, end, subject.size())) continue;
    const Range in = range_inside(clip[k], begin, end, subject);
    if (in.is_empty || compare(in.from, in.to) >= 0) continue;
    ContourEdge part = clip[k];
    part.from = in.from;
    part.to = in.to;
    clip_parts_.push_back({part, static_cast<std::uint32_t>(k), Origin::clip});
  }
}

/// Finds the contour of the intersection: the parts inside of both contours by direction. Parts of one contour that have the
/// same direction keep their order. If there are parts of the subject, one of them comes first.
void ConvexClip::find_inside() {
  const auto rotate_to_turn = [](std::vector<Part>::iterator first, std::vector<Part>::iterator last) {
    for (auto p = first; p != last; ++p) {
      if (turn((p == first ? last : p)[-1].edge, p->edge) == 0) continue;
      std::rotate(first, p, last);
      return;
    }
  };
  round_.clear();
  std::copy_if(subject_parts_.begin(), subject_parts_.end(), std::back_inserter(round_),
               [](const Part& p) { return p.origin == Origin::subject_inside; });
  const auto from_subject = static_cast<std::ptrdiff_t>(round_.size());
  rotate_to_turn(round_.begin(), round_.end());
  round_.insert(round_.end(), clip_parts_.begin(), clip_parts_.end());
  const auto middle = round_.begin() + from_subject;
  rotate_to_turn(middle, round_.end());
  if (from_subject > 0) {
    const ContourEdge base = round_.front().edge;
    const auto before = [&](const Part& a, const Part& b) { return comes_before(base, a.edge, b.edge); };
    std::rotate(middle, std::min_element(middle, round_.end(), before), round_.end());
    std::inplace_merge(round_.begin(), middle, round_.end(), before);
  }
  inside_.clear();
  for (const Part& part : round_) inside_.push_back(part.edge);
}

/// Whether the corner at which an edge of the clip contour begins lies on the subject's contour.
bool ConvexClip::touches(const Part& clip_part) const {
  const std::int8_t* code = clip_codes_.of(clip_part.number);
  return std::find(code, code + clip_codes_.width, std::int8_t{0}) != code + clip_codes_.width;
}

/// Finds the contours outside if the contours do not touch. Each is closed by a group of parts of the clip contour that
/// follow each other round the inside. False if they touch there or rounding has to decide.
bool ConvexClip::find_outside() {
  const std::size_t n = round_.size(), all = subject_parts_.size();
  if (round_.front().origin == Origin::clip) {  // the clip contour is a hole of the subject
    if (std::any_of(round_.begin(), round_.end(), [&](const Part& p) { return touches(p); })) return false;
    ContourFace& face = outside_.emplace_back();
    face.contours.resize(2);
    for (const Part& part : subject_parts_) face.contours[0].push_back(part.edge);
    for (std::size_t k = n; k-- > 0;) face.contours[1].push_back(turned(round_[k].edge));
    return true;
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t end = i + 1;
    for (; end < n && round_[end].origin == Origin::clip; ++end) {
      if (end > i + 1 && touches(round_[end])) return false;
    }
    EdgeLoop loop;
    const std::size_t next = round_[end == n ? 0 : end].number;
    for (std::size_t k = (round_[i].number + 1) % all; k != next; k = (k + 1) % all) {
      if (subject_parts_[k].origin != Origin::subject_outside) return false;
      loop.push_back(subject_parts_[k].edge);
    }
    const std::size_t of_clip = end - i - 1;
    if (loop.empty() != (of_clip == 0)) return false;
    if (of_clip == 0) continue;
    for (std::size_t k = end; k-- > i + 1;) loop.push_back(turned(round_[k].edge));
    if (loop.size() < 3 || !is_clear(loop)) return false;
    const ContourEdge &first = round_[i + 1].edge, &last = round_[end - 1].edge;
    outside_.push_back(face_of(std::move(loop), turn(first, last) == 0 && dot(first, last) > 0));
    i = end - 1;
  }
  return true;
}

/// Links the faces outside from all parts of their contours.
void ConvexClip::link_outside() {
  ++linked_;
  std::vector<ContourEdge> edges;
  for (const Part& part : subject_parts_) {
    if (part.origin == Origin::subject_outside) edges.push_back(part.edge);
  }
  for (const Part& part : clip_parts_) edges.push_back(turned(part.edge));
  outside_ = link_edges(std::move(edges), true);
  for (ContourFace& face : outside_) face.is_convex = is_convex(face);
}

ConvexMeeting ConvexClip::meet(const EdgeLoop& subject, const EdgeLoop& clip) {
  if (!code(subject, clip, subject_codes_)) return ConvexMeeting::apart;
  const auto is_outside = [](std::int8_t side) { return side < 0; };
  const std::vector<std::int8_t>& sides = subject_codes_.sides;
  if (std::none_of(sides.begin(), sides.end(), is_outside)) return ConvexMeeting::within;
  if (!code(clip, subject, clip_codes_)) return ConvexMeeting::apart;
  divide_subject(subject, clip);
  find_clip_parts(subject, clip);
  find_inside();
  if (inside_.size() < 3 || !is_clear(inside_)) return ConvexMeeting::thin;
  outside_.clear();
  if (!find_outside()) link_outside();
  return ConvexMeeting::cut;
}

}  // namespace ligne
