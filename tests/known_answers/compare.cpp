#include "compare.hpp"

namespace ligne::test {
namespace {

struct Interval {
  double from, to;  ///< mm from the start of a segment
};

/// A place seen from a segment: how far along it and how far beside it, in mm.
struct Place {
  double along, beside;
};

double length(const PageSegment& s) { return glm::length(s.to - s.from); }

Place place(const PageSegment& s, Point2 p) {
  const Point2 d = (s.to - s.from) / length(s), v = p - s.from;
  return {glm::dot(d, v), std::abs(d.x * v.y - d.y * v.x)};
}

bool same_kind(const PageSegment& a, const PageSegment& b) { return a.line_class == b.line_class && a.visible == b.visible; }

/// Depths agree at `along` mm on the segment.
bool at_depth(const PageSegment& s, double along, double z, const CompareTolerance& tolerance) {
  const double slope = (s.z_to - s.z_from) / length(s);
  return std::abs(s.z_from + slope * along - z) <= tolerance.depth * (1 + std::abs(slope));
}

std::string text(const PageSegment& s, std::optional<Interval> part = {}) {
  const Point2 d = (s.to - s.from) / length(s);
  const Point2 a = part ? s.from + d * part->from : s.from, b = part ? s.from + d * part->to : s.to;
  std::ostringstream out;
  out.precision(10);
  out << (s.visible ? "visible " : "hidden ") << kLineClassNames[static_cast<std::size_t>(s.line_class)] << ' ' << s.label;
  if (part) out << ", its part";
  out << " (" << a.x << ", " << a.y << ") - (" << b.x << ", " << b.y << ") mm on the page";
  return out.str();
}

/// Where `drawn` lies on `expected`, when it lies on it as a whole.
std::optional<Interval> interval_on(const PageSegment& expected, const PageSegment& drawn,
                                    const CompareTolerance& tolerance) {
  Place a = place(expected, drawn.from), b = place(expected, drawn.to);
  if (std::max(a.beside, b.beside) > tolerance.line) return {};
  if (!at_depth(expected, a.along, drawn.z_from, tolerance) || !at_depth(expected, b.along, drawn.z_to, tolerance))
    return {};
  if (a.along > b.along) std::swap(a, b);
  if (a.along < -tolerance.end || b.along > length(expected) + tolerance.end) return {};
  return Interval{a.along, b.along};
}

/// Turned round.
PageSegment reversed(PageSegment s) {
  std::swap(s.from, s.to);
  std::swap(s.z_from, s.z_to);
  return s;
}

/// `a` and `b` as one segment when b continues a straight on from a's end.
std::optional<PageSegment> joined(const PageSegment& a, const PageSegment& b, const CompareTolerance& tolerance) {
  if (!same_kind(a, b) || glm::length(b.from - a.to) > tolerance.line) return {};
  const Place end = place(a, b.to);
  if (end.beside > tolerance.line || end.along < length(a)) return {};
  if (!at_depth(a, length(a), b.z_from, tolerance) || !at_depth(a, end.along, b.z_to, tolerance)) return {};
  PageSegment both = a;
  both.to = b.to;
  both.z_to = b.z_to;
  both.label += " + " + b.label;
  return both;
}

/// Segments that continue each other become one: a method need not cut its strokes where the answer cuts its own.
std::vector<PageSegment> join_straight(std::vector<PageSegment> segments, const CompareTolerance& tolerance) {
  for (std::size_t i = 0; i < segments.size();) {
    bool grown = false;
    for (std::size_t k = 0; k < segments.size() && !grown; ++k) {
      if (k == i) continue;
      for (const PageSegment& a : {segments[i], reversed(segments[i])})
        for (const PageSegment& b : {segments[k], reversed(segments[k])}) {
          if (grown) continue;
          if (const auto both = joined(a, b, tolerance)) {
            segments[i] = *both;
            grown = true;
          }
        }
      if (grown) segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (grown) {
      i = 0;
    } else {
      ++i;
    }
  }
  return segments;
}

}  // namespace

CompareTolerance tolerance_of_lattice(double step_mm) {
  const double r = step_mm / std::numbers::sqrt2;
  return {2 * r, 2 * r / kLeastCrossingSine + r, kDepthMm};
}

std::vector<std::string> overlaps(const std::vector<PageSegment>& segments, const CompareTolerance& tolerance) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = i + 1; k < segments.size(); ++k) {
      const PageSegment &a = segments[i], &b = segments[k];
      if (!(length(a) > tolerance.end) || !(length(b) > tolerance.end)) continue;
      // The part of a beside which b runs; two lines that part at an angle are beside each other at one of its ends only.
      Place p = place(a, b.from), q = place(a, b.to);
      if (p.along > q.along) std::swap(p, q);
      const Interval common{std::max(0.0, p.along), std::min(length(a), q.along)};
      if (common.to - common.from <= tolerance.end) continue;
      const Point2 d = (a.to - a.from) / length(a);
      const double beside = std::max(place(b, a.from + d * common.from).beside, place(b, a.from + d * common.to).beside);
      if (beside <= tolerance.line) found.push_back("twice: " + text(a, common) + " and " + text(b));
    }
  }
  return found;
}

std::vector<std::string> differences(const std::vector<PageSegment>& expected, const std::vector<PageSegment>& drawn,
                                     const CompareTolerance& tolerance) {
  const std::vector<PageSegment> lines = join_straight(expected, tolerance);
  std::vector<std::vector<Interval>> covered(lines.size());
  std::vector<std::string> found;
  for (const PageSegment& d : drawn) {
    bool known = false;
    for (std::size_t i = 0; i < lines.size() && !known; ++i) {
      if (!same_kind(lines[i], d)) continue;
      if (const auto interval = interval_on(lines[i], d, tolerance)) {
        covered[i].push_back(*interval);
        known = true;
      }
    }
    if (!known) found.push_back("not expected: " + text(d));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto& parts = covered[i];
    std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    parts.push_back({length(lines[i]), length(lines[i])});
    double reached = 0;
    for (const Interval& part : parts) {
      if (part.from > reached + tolerance.end) found.push_back("missing: " + text(lines[i], Interval{reached, part.from}));
      reached = std::max(reached, part.to);
    }
  }
  const auto twice = overlaps(drawn, tolerance);
  found.insert(found.end(), twice.begin(), twice.end());
  return found;
}

}  // namespace ligne::test
