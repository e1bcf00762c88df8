#include "check.hpp"

#include "base/parallel.hpp"
#include "support/page_lines.hpp"

namespace ligne::check {

namespace {

/// A part of an edge on the page, with its samples.
class SampledEdge {
 public:
  /// The part [from, to] of the segment a b (unit box).
  SampledEdge(const PageMap& map, const Point3& a, const Point3& b, Part part, double step_mm)
      : map_(map), a_(a + (b - a) * part.from), b_(a + (b - a) * part.to) {
    wa_ = map.homogeneous(a_).w, wb_ = map.homogeneous(b_).w;
    length_ = glm::distance(map.page(a_), map.page(b_));
    count_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length_ / step_mm)));
  }
  std::size_t size() const { return count_; }
  double length_mm() const { return length_; }
  double share_mm() const { return length_ / static_cast<double>(count_); }
  /// Sample i, moved along the edge on the page, but not beyond its end.
  Point3 sample(std::size_t i, double moved_mm = 0) const {
    double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count_);
    if (moved_mm != 0 && length_ > 0) u = std::clamp(u + moved_mm / length_, 0.0, 1.0);
    return a_ + (b_ - a_) * parameter_in_space(u, wa_, wb_);
  }

 private:
  const PageMap& map_;
  Point3 a_, b_;
  double wa_ = 1, wb_ = 1, length_ = 0;
  std::size_t count_ = 1;
};

constexpr double kAlong[] = {-1, -0.5, 0.5, 1};  ///< places along the edge, in tolerances
constexpr int kCircle = 8;

bool visible_along(const Sight& sight, const SampledEdge& edge, std::size_t i, double tolerance, double reach_mm) {
  return std::none_of(std::begin(kAlong), std::end(kAlong), [&](double part) {
    return sight.blocked(edge.sample(i, part * reach_mm), tolerance, Touching::strict);
  });
}

/// `own_faces`: those that meet at the edge. A place beside the edge that they hide is judged on them: where the surface
/// beside a line is seen, the line is within the tolerance of what is seen.
bool hidden_around(const Sight& sight, const PageMap& map, const SampledEdge& edge, std::size_t i,
                   std::span<const std::uint32_t> own_faces, double tolerance, double reach_mm) {
  const auto blocked = [&](const Point3& q) { return sight.blocked(q, tolerance, Touching::generous); };
  for (const double part : kAlong)
    if (!blocked(edge.sample(i, part * reach_mm))) return false;
  const Point3 q = edge.sample(i);
  for (int k = 0; k < kCircle; ++k) {
    const double angle = 2 * 3.14159265358979323846 * k / kCircle;
    const Point3 beside = map.shifted(q, {reach_mm * std::cos(angle), reach_mm * std::sin(angle)});
    if (!blocked(beside)) return false;
    for (const std::uint32_t face : own_faces) {
      const auto on_face = sight.in_front(beside, face);
      if (on_face && !blocked(*on_face)) return false;
    }
  }
  return true;
}

using test::PageLines;

using PageSegment = std::array<Point2, 2>;  ///< page mm

/// Bits of a segment, whichever way it runs.
struct SegmentKey {
  std::array<std::uint64_t, 6> bits{};
  friend bool operator==(const SegmentKey&, const SegmentKey&) = default;
};
struct SegmentHash {
  std::size_t operator()(const SegmentKey& k) const {
    std::uint64_t h = 0;
    for (const std::uint64_t b : k.bits) h = (h ^ b) * 0x9e3779b97f4a7c15ull, h ^= h >> 29;
    return h;
  }
};
SegmentKey segment_key(const Point3& a, const Point3& b) {
  std::array<double, 3> p{a.x, a.y, a.z}, q{b.x, b.y, b.z};
  if (q < p) std::swap(p, q);
  SegmentKey key;
  for (std::size_t k = 0; k < 3; ++k) {
    key.bits[k] = std::bit_cast<std::uint64_t>(p[k] + 0.0);  // + 0.0 makes one zero of the two
    key.bits[k + 3] = std::bit_cast<std::uint64_t>(q[k] + 0.0);
  }
  return key;
}

class Checker {
 public:
  Checker(const Scene& scene, const DrawingFile& drawing, const CheckOptions& options)
      : scene_(scene),
        drawing_(drawing),
        options_(options),
        checked_(make_checked_scene(scene)),
        map_(drawing.model_to_page, checked_.box, drawing.window, drawing.near_distance),
        sight_(checked_, map_),
        kinds_(checked_.edges.size()) {
    parallel_for(kinds_.size(), [&](std::size_t e) {
      kinds_[e] = possible_kinds(checked_, checked_.edges[e], map_, options_.crease_degrees);
    });
  }

  Report run() {
    const PageLines drawn = visible_strokes();
    const PageLines visible = lines_of(check_edges(drawn));
    check_strokes(visible);
    if (options_.kinds & kIntersection) check_intersections(drawn);
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const Finding& l, const Finding& r) { return l.length_mm > r.length_mm; });
    return std::move(report_);
  }

 private:
  /// Findings on one stroke or edge.
  struct Tally {
    double length = 0, wrong = 0, undecided = 0, visible = 0;
    Point2 at{0, 0};
    const char* what = nullptr;
    std::vector<PageSegment> seen;  ///< parts of an edge round its visible samples
    void add_wrong(double mm, Point2 place) {
      if (wrong == 0) at = place;
      wrong += mm;
    }
  };

  /// Edges of the model where a stroke says that it comes from.
  struct Source {
    std::uint8_t kinds = 0;  ///< classes of all edges there
    std::vector<std::uint32_t> faces;
  };

  Source intersection_source(const DrawnStroke& stroke) const {
    Source source{kIntersection, {}};
    for (const auto& face : stroke.faces)
      if (face && *face < checked_.faces.size()) source.faces.push_back(*face);
    return source;
  }

  /// `visible`: where edges that should or may be drawn are visible.
  void check_strokes(const PageLines& visible) {
    std::unordered_map<SegmentKey, Source, SegmentHash> sources;
    for (std::size_t e = 0; e < kinds_.size(); ++e) {
      const CheckedEdge& edge = checked_.edges[e];
      Source& source = sources[segment_key(scene_.vertices[edge.v0], scene_.vertices[edge.v1])];
      source.kinds |= kinds_[e];
      source.faces.insert(source.faces.end(), edge.faces.begin(), edge.faces.end());
    }
    std::vector<Tally> tallies(drawing_.strokes.size());
    parallel_for(tallies.size(), [&](std::size_t i) {
      const DrawnStroke& stroke = drawing_.strokes[i];
      if (!stroke.visible) return;
      const auto found = sources.find(segment_key(stroke.ends[0], stroke.ends[1]));
      if (stroke.kind == kIntersection) {
        tallies[i] = check_stroke(stroke, intersection_source(stroke), visible);
      } else {
        tallies[i] = check_stroke(stroke, found == sources.end() ? Source{} : found->second, visible);
      }
    });
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& t = tallies[i];
      report_.drawn += t.length;
      report_.drawn_undecided += t.undecided;
      if (t.wrong == 0) continue;
      (t.what == kMisplaced ? report_.misplaced : t.what == kHidden ? report_.hidden_drawn : report_.no_line) += t.wrong;
      const DrawnStroke& s = drawing_.strokes[i];
      report_.findings.push_back(
          {std::string(t.what) + " (" + std::string(name_of(s.kind)) + ")", t.wrong, t.at, s.edge, s.ends[0], s.ends[1]});
    }
  }

  Tally check_stroke(const DrawnStroke& stroke, const Source& source, const PageLines& visible) const {
    const Point3 a = checked_.box.into(stroke.ends[0]), b = checked_.box.into(stroke.ends[1]);
    const SampledEdge edge(map_, a, b, {stroke.interval[0], stroke.interval[1]}, options_.step_mm);
    Tally tally;
    tally.length = glm::distance(stroke.points[0], stroke.points[1]);
    const Point2 middle = (stroke.points[0] + stroke.points[1]) * 0.5;
    for (std::size_t k = 0; k < 2; ++k) {
      const Point2 owed = map_.page(a + (b - a) * stroke.interval[k]);
      if (!(glm::distance(owed, stroke.points[k]) <= options_.tolerance_mm)) tally.what = kMisplaced;
    }
    if (!(source.kinds & stroke.kind)) tally.what = source.kinds == 0 ? kNoEdge : kOtherClass;
    if (!(options_.kinds & stroke.kind)) tally.what = kNotAsked;
    if (tally.what != nullptr) {
      tally.add_wrong(tally.length, middle);
      return tally;
    }
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const Point3 q = edge.sample(i);
      if (!sight_.blocked(q, checked_.largest_tolerance, Touching::generous)) continue;
      if (hidden_around(sight_, map_, edge, i, source.faces, checked_.largest_tolerance, options_.tolerance_mm)) {
        tally.what = kHidden;
        tally.add_wrong(edge.share_mm(), map_.page(q));
      } else if (!is_near(visible, map_.page(q))) {  // else a line is owed here, whosever it is
        tally.undecided += edge.share_mm();
      }
    }
    return tally;
  }

  PageLines visible_strokes() const {
    std::vector<PageSegment> segments;
    for (const DrawnStroke& s : drawing_.strokes)
      if (s.visible) segments.push_back(s.points);
    return lines_of(segments);
  }

  PageLines lines_of(const std::vector<PageSegment>& segments) const {
    constexpr double kCellMm = 0.5;
    PageLines lines(map_.window(), kCellMm);
    for (const PageSegment& s : segments) lines.add(s[0], s[1]);
    return lines;
  }

  bool is_near(const PageLines& lines, Point2 p) const {
    return lines.distance(p, 2 * options_.tolerance_mm) <= options_.tolerance_mm;
  }

  /// Gives back where edges that should or may be drawn are visible.
  std::vector<PageSegment> check_edges(const PageLines& drawn) {
    std::vector<PageSegment> seen;
    std::vector<Tally> tallies(checked_.edges.size());
    parallel_for(tallies.size(), [&](std::size_t e) {
      if (!(kinds_[e] & options_.kinds)) return;
      tallies[e] = check_edge(checked_.edges[e], drawn);
      const bool owed = (kinds_[e] & ~options_.kinds) == 0;  // else it may be drawn, and may be left out
      if (!owed) tallies[e].wrong = tallies[e].undecided = tallies[e].visible = 0;
    });
    for (std::size_t e = 0; e < tallies.size(); ++e) {
      const Tally& t = tallies[e];
      report_.visible += t.visible;
      report_.missing += t.wrong;
      report_.missing_undecided += t.undecided;
      seen.insert(seen.end(), t.seen.begin(), t.seen.end());
      if (t.wrong == 0) continue;
      const CheckedEdge& edge = checked_.edges[e];
      const auto kind = static_cast<LineKind>(kinds_[e] & (~kinds_[e] + 1));
      report_.findings.push_back({"visible but not drawn (" + std::string(name_of(kind)) + ")", t.wrong, t.at, std::nullopt,
                                  scene_.vertices[edge.v0], scene_.vertices[edge.v1]});
    }
    return seen;
  }

  Tally check_edge(const CheckedEdge& candidate, const PageLines& drawn) const {
    Tally tally;
    const Point3 &a = checked_.points[candidate.v0], &b = checked_.points[candidate.v1];
    const auto part = map_.clip(a, b, options_.tolerance_mm);
    if (!part) return tally;
    const SampledEdge edge(map_, a, b, *part, options_.step_mm);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const Point3 q = edge.sample(i);
      const Point2 at = map_.page(q);
      if (sight_.blocked(q, candidate.tolerance, Touching::strict)) continue;
      const double half = edge.share_mm() / 2;
      tally.seen.push_back({map_.page(edge.sample(i, -half)), map_.page(edge.sample(i, half))});
      if (is_near(drawn, at)) {
        tally.visible += edge.share_mm();
      } else if (visible_along(sight_, edge, i, candidate.tolerance, options_.tolerance_mm)) {
        tally.visible += edge.share_mm();
        tally.add_wrong(edge.share_mm(), at);
      } else {
        tally.undecided += edge.share_mm();
      }
    }
    return tally;
  }

  void check_intersections(const PageLines& drawn) {
    for (const SeenCrossing& c : find_intersections_seen(checked_, map_, sight_, options_)) {
      report_.intersections_seen += c.length_mm;
      if (is_near(drawn, c.at)) continue;
      report_.intersections_missing += c.length_mm;
      report_.findings.push_back(
          {"intersection visible but not drawn: faces " + std::to_string(c.faces[0]) + " and " + std::to_string(c.faces[1]),
           c.length_mm, c.at, std::nullopt, checked_.box.out_of(c.point), checked_.box.out_of(c.point)});
    }
  }

  static constexpr const char* kHidden = "drawn although hidden";
  static constexpr const char* kMisplaced = "not where its edge is";
  static constexpr const char* kNoEdge = "drawn, but no edge of the model";
  static constexpr const char* kOtherClass = "drawn in a class that the edge does not have";
  static constexpr const char* kNotAsked = "drawn in a class that is not asked for";

  const Scene& scene_;
  const DrawingFile& drawing_;
  const CheckOptions& options_;
  CheckedScene checked_;
  PageMap map_;
  Sight sight_;
  std::vector<std::uint8_t> kinds_;
  Report report_;
};

}  // namespace

double Report::share(double length) const {
  const double whole = drawn > 0 ? drawn : visible;
  return length > 0 ? length / whole : 0;
}

Report check_drawing(const Scene& scene, const DrawingFile& drawing, const CheckOptions& options) {
  return Checker(scene, drawing, options).run();
}

std::string to_text(const Report& report, std::size_t worst) {
  std::string text;
  char line[400];
  const auto put = [&](const char* name, double length) {
    std::snprintf(line, sizeof line, "%-44s %12.3f mm %9.4f %%\n", name, length, 100 * report.share(length));
    text += line;
  };
  put("drawn", report.drawn);
  put("drawn although hidden", report.hidden_drawn);
  put("drawn at the wrong place", report.misplaced);
  put("drawn, but no line of the classes asked for", report.no_line);
  put("drawn, undecided", report.drawn_undecided);
  put("edges visible", report.visible);
  put("edges visible but not drawn", report.missing);
  put("edges not drawn, undecided", report.missing_undecided);
  put("intersections seen (estimate)", report.intersections_seen);
  put("intersections seen but not drawn (estimate)", report.intersections_missing);
  for (std::size_t i = 0; i < std::min(worst, report.findings.size()); ++i) {
    const Finding& f = report.findings[i];
    const std::string edge = f.edge ? "edge " + std::to_string(*f.edge) : "edge -";
    std::snprintf(line, sizeof line, "  %8.3f mm at (%.3f, %.3f): %s; %s (%.9g, %.9g, %.9g)-(%.9g, %.9g, %.9g)\n",
                  f.length_mm, f.at.x, f.at.y, f.what.c_str(), edge.c_str(), f.a.x, f.a.y, f.a.z, f.b.x, f.b.y, f.b.z);
    text += line;
  }
  return text;
}

}  // namespace ligne::check
