#pragma once
/// One drawing held against what the oracle says of its lines.

#include "drawing/drawing.hpp"
#include "support/judge.hpp"
#include "support/page_lines.hpp"

namespace ligne::test {

/// Two lines on each other are seen when they are so for longer than this.
inline constexpr double kTwiceMm = 0.002;

using oracle::Answer;
using oracle::EdgeClass;

/// The class of a drawing for one of the oracle, which knows no tangent lines.
inline LineClass drawn_class(EdgeClass c) { return c == EdgeClass::mesh ? LineClass::mesh : static_cast<LineClass>(c); }

/// A candidate line, with what the oracle says of it.
struct Candidate {
  bool intersection = false;
  bool proper = true;  ///< an intersection that must be drawn
  EdgeClass line_class = EdgeClass::undecided;
  Segment whole;  ///< the part in view, with what lies at the window's border
  std::vector<oracle::Interval> intervals;
  std::string words;
  Segment in_view{};  ///< of `whole` what is surely in view; of no length when nothing is
};

/// A part of what two faces have in common, however short.
struct Crossing {
  Segment whole;
  bool vague = false;  ///< its place is not known well
  Candidate candidate;
};

inline std::string words(const Segment& s) {
  char buffer[128];
  std::snprintf(buffer, sizeof buffer, "page mm (%.4f, %.4f) - (%.4f, %.4f)", s.from.x, s.from.y, s.to.x, s.to.y);
  return buffer;
}

inline Segment segment(const oracle::Interval& i) { return {i.from, i.to}; }

inline void add(Fault& fault, const Segment& place, const std::string& what) {
  const double length = place.length();
  fault.length_mm += length;
  if (length <= fault.worst_mm) return;
  fault.worst_mm = length;
  fault.place = what + ", " + words(place);
}

/// A visible or hidden stroke on the page.
struct DrawnStroke {
  Segment segment;
  Rect box;
  const Stroke* stroke;
};

inline Rect box_of(const Segment& s) { return {glm::min(s.from, s.to), glm::max(s.from, s.to)}; }

inline bool apart(const Rect& a, const Rect& b, double margin) {
  return a.min.x > b.max.x + margin || b.min.x > a.max.x + margin || a.min.y > b.max.y + margin ||
         b.min.y > a.max.y + margin;
}

/// All strokes, from left to right.
inline std::vector<DrawnStroke> strokes_of(const StrokeModel& model) {
  std::vector<DrawnStroke> result;
  for (const Stroke& s : model.strokes) {
    const Segment segment{model.lattice.to_mm(s.from), model.lattice.to_mm(s.to)};
    result.push_back({segment, box_of(segment), &s});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& l, const auto& r) { return l.box.min.x < r.box.min.x; });
  return result;
}

/// The parts of the segment that no stroke of those wanted covers within the tolerance, across and along.
template <class Wanted>
std::vector<Segment> open_parts(const Segment& segment, const std::vector<DrawnStroke>& strokes, double tolerance,
                                Wanted wanted) {
  const Rect box = box_of(segment);
  std::vector<Range> covered;
  for (const DrawnStroke& s : strokes) {
    if (s.box.min.x > box.max.x + tolerance) break;
    if (apart(box, s.box, tolerance) || !wanted(*s.stroke)) continue;
    if (const auto range = along(segment, s.segment, tolerance)) covered.push_back(*range);
  }
  std::vector<Segment> result;
  for (const Range& gap : gaps(std::move(covered), 0, segment.length()))
    if (gap.length() > tolerance) result.push_back({segment.at(gap.from), segment.at(gap.to)});
  return result;
}

/// One drawing held against the candidates.
class Comparison {
 public:
  Comparison(const StrokeModel& model, const std::vector<Candidate>& candidates, bool all_classes, double tolerance,
             double coincidence, Verdict& verdict)
      : strokes_(strokes_of(model)),
        candidates_(candidates),
        all_classes_(all_classes),
        tolerance_(tolerance),
        coincidence_(coincidence),
        verdict_(verdict) {}

  void visible_edge(const DrawnStroke& s, const Candidate* candidate) {
    if (!candidate) {
      if (s.segment.length() > 2 * tolerance_)
        add(verdict_.drawn_hidden, s.segment, "stroke of an edge that is not in view");
      return;
    }
    if (deviation(candidate->whole, s.segment) > tolerance_)
      add(verdict_.drawn_hidden, s.segment, "stroke beside its " + candidate->words);
    against_hidden(s, *candidate);
    const EdgeClass expected = candidate->line_class;
    if (expected == EdgeClass::undecided) return;
    if (drawn_class(expected) != s.stroke->line_class) {
      add(verdict_.wrong_class, s.segment, candidate->words + " drawn as " + std::string(name_of(*s.stroke)));
    } else if (!wanted(*candidate)) {
      add(verdict_.wrong_class, s.segment,
          candidate->words + " drawn although " + std::string(name_of(*s.stroke)) + " is not asked for");
    }
  }

  /// A stroke of class intersection, with the oracle's intersections of its two faces.
  void visible_intersection(const DrawnStroke& s, const std::vector<Crossing>& of_faces) {
    std::vector<Range> known;
    bool vague = false;
    for (const Crossing& c : of_faces) {
      against_hidden(s, c.candidate);
      vague = vague || c.vague;
      if (const auto range = along(s.segment, c.whole, tolerance_)) known.push_back(*range);
    }
    if (vague) return;
    for (const Range& gap : gaps(std::move(known), 0, s.segment.length())) {
      if (gap.length() <= tolerance_) continue;
      add(verdict_.drawn_hidden, {s.segment.at(gap.from), s.segment.at(gap.to)},
          "intersection of faces that have none there");
    }
  }

  void missing() {
    const auto visible = [](const Stroke& s) { return s.visible; };
    for (const Candidate& c : candidates_) {
      if (!wanted(c)) continue;
      // A line may give way to one of higher precedence, never to one of lower.
      const auto of_rank = [&](const Stroke& s) {
        return s.visible && (c.line_class == EdgeClass::undecided || s.line_class <= drawn_class(c.line_class));
      };
      for (const oracle::Interval& i : c.intervals) {
        if (i.answer != Answer::visible) continue;
        for (const Segment& open : open_parts(segment(i), strokes_, tolerance_, of_rank)) {
          const auto still_open = open_parts(open, strokes_, tolerance_, visible);
          for (const Segment& s : still_open) add(verdict_.missing, s, c.words);
          if (still_open.empty()) add(verdict_.wrong_class, open, c.words + " under a line of lower precedence");
        }
      }
    }
  }

  void uncovered() {
    for (const Candidate& c : candidates_) {
      if (!wanted(c)) continue;
      const auto open = open_parts(c.in_view, strokes_, tolerance_, [](const Stroke&) { return true; });
      for (const Segment& s : open) add(verdict_.uncovered, s, c.words);
    }
  }

  /// Strokes that lie on each other: visible on visible, and hidden ones on any.
  void twice() {
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      const DrawnStroke& a = strokes_[i];
      for (std::size_t k = i + 1; k < strokes_.size() && strokes_[k].box.min.x <= a.box.max.x + coincidence_; ++k) {
        const DrawnStroke& b = strokes_[k];
        if (apart(a.box, b.box, coincidence_)) continue;
        const double common = common_length(a.segment, b.segment, coincidence_);
        if (common <= kTwiceMm) continue;
        const Segment& shorter = a.segment.length() < b.segment.length() ? a.segment : b.segment;
        add(verdict_.twice, {shorter.from, shorter.at(common)},
            std::string(name_of(*a.stroke)) + " and " + std::string(name_of(*b.stroke)));
      }
    }
  }

  const std::vector<DrawnStroke>& strokes() const { return strokes_; }

 private:
  static std::string_view name_of(const Stroke& s) { return kLineClassNames[static_cast<std::size_t>(s.line_class)]; }

  bool wanted(const Candidate& c) const {
    if (c.intersection) return c.proper;
    return all_classes_ || (c.line_class != EdgeClass::undecided && c.line_class != EdgeClass::mesh);
  }

  void against_hidden(const DrawnStroke& s, const Candidate& candidate) {
    for (const oracle::Interval& i : candidate.intervals) {
      if (i.answer != Answer::hidden) continue;
      const auto range = along(segment(i), s.segment, tolerance_);
      if (!range || range->length() <= tolerance_) continue;
      add(verdict_.drawn_hidden, {segment(i).at(range->from), segment(i).at(range->to)}, candidate.words);
    }
  }

  std::vector<DrawnStroke> strokes_;
  const std::vector<Candidate>& candidates_;
  bool all_classes_;
  double tolerance_, coincidence_;
  Verdict& verdict_;
};

}  // namespace ligne::test
