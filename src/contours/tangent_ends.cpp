#include "contours/tangent_ends.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

constexpr double kEndCellMm = 2;
/// An end nearer to a line than this meets it: more than roundings of the lattice, less than any pen.
constexpr double kTouchingMm = 0.02;
/// Parameters of an edge that differ by less are equal. Strokes are cut at lattice points, which are coarser.
constexpr double kSameParameter = 1e-6;

double distance_to(const OutlineSegment& s, Point2 p) {
  return glm::distance(p, s.from + nearest_on_segment(p, s.from, s.to) * (s.to - s.from));
}

/// A tangent edge as a walk passes it.
struct Step {
  const TangentEdge* edge = nullptr;
  bool forward = true;  ///< from its v0 to its v1
  double begin = 0;     ///< fraction of the edge, in the direction of the walk
};

/// A node of a contour on a tangent edge, and a change of the line there.
struct Plan {
  std::uint32_t chain = kNone, node = kNone;
  const TangentEdge* edge = nullptr;
  EndOfStroke end{};                      ///< to be led to the node, or to be cut back to it
  std::vector<std::uint32_t> vertices{};  ///< between the node and the end, from the node on
  std::vector<std::uint32_t> cut{};       ///< strokes that go as a whole
  std::uint32_t shortened = kNone;        ///< the stroke that is cut at the node; kNone: the line is led on
};

class TangentEnds {
 public:
  TangentEnds(StrokeModel& model, const View& view, const SmoothContours& contours, const std::vector<SeenContour>& seen,
              const Scene& scene)
      : model_(model),
        view_(view),
        contours_(contours),
        seen_(seen),
        scene_(scene),
        curves_(kEndCellMm),
        lines_(kEndCellMm) {
    file_strokes();
    if (pieces_.empty()) return;
    is_crossed_.resize(contours.tangents.size(), 0);
    for (std::uint32_t e = 0; e < contours.tangents.size(); ++e) {
      arms_.push_back({contours.tangents[e].edge.v0, e});
      arms_.push_back({contours.tangents[e].edge.v1, e});
    }
    std::ranges::sort(arms_,
                      [](const Arm& l, const Arm& r) { return std::pair(l.vertex, l.edge) < std::pair(r.vertex, r.edge); });
    for_visible_curves([&](const OutlineSegment& s) { curves_.expect(s.from, s.to); });
    for_visible_curves([&](const OutlineSegment& s) { curves_.add(s); });
  }

  void run() {
    if (pieces_.empty()) return;
    std::vector<Plan> plans = find_plans();
    keep_free_ends(plans);
    apply(plans);
  }

 private:
  /// A seen node of a contour on a tangent edge.
  struct Crossing {
    std::uint32_t chain = 0, node = 0;
    const TangentEdge* edge = nullptr;
  };

  std::vector<Plan> find_plans() {
    std::vector<Crossing> crossings;
    for (std::uint32_t c = 0; c < seen_.size(); ++c) {
      const ContourChain& chain = contours_.chains[c];
      for (std::uint32_t i = chain.closed ? 1 : 0; i < chain.nodes.size(); ++i) {
        const ContourNode& node = chain.nodes[i];
        if (node.edge[0] == kNone || node.is_corner || !is_seen(c, i)) continue;
        const TangentEdge* edge = edge_between(node.edge[0], node.edge[1]);
        if (!edge) continue;
        crossings.push_back({c, i, edge});
        is_crossed_[number_of(*edge)] = 1;
      }
    }
    std::vector<Plan> plans;
    for (const Crossing& crossing : crossings) {
      if (auto plan = plan_for(crossing)) plans.push_back(std::move(*plan));
    }
    return plans;
  }

  /// Carries the plans out in their order, each end and each stroke that is cut once.
  void apply(const std::vector<Plan>& plans) {
    std::vector<std::uint8_t> is_cut(model_.strokes.size(), 0), is_moved(2 * model_.strokes.size(), 0);
    for (const Plan& plan : plans) {
      std::uint8_t& is_end_moved = is_moved[2 * std::size_t{plan.end.stroke} + plan.end.first];
      const auto cuts = [&](std::uint32_t s) {
        return is_cut[s] || is_moved[2 * std::size_t{s}] || is_moved[2 * std::size_t{s} + 1];
      };
      if (is_end_moved || is_cut[plan.end.stroke]) continue;
      if (plan.shortened != kNone && (cuts(plan.shortened) || std::ranges::any_of(plan.cut, cuts))) continue;
      is_end_moved = 1;
      for (const std::uint32_t s : plan.cut) is_cut[s] = 1;
      if (plan.shortened == kNone) {
        lead_on(plan);
      } else {
        is_moved[2 * std::size_t{plan.shortened} + plan.end.first] = 1;
        shorten(plan);
      }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < model_.strokes.size(); ++i) {
      if (i >= is_cut.size() || !is_cut[i]) model_.strokes[kept++] = model_.strokes[i];
    }
    model_.strokes.resize(kept);
  }

  std::size_t number_of(const TangentEdge& edge) const {
    return static_cast<std::size_t>(&edge - contours_.tangents.data());
  }

  /// A visible stroke of a tangent edge.
  struct Piece {
    std::uint32_t source = 0;
    double from = 0, to = 1;
    std::uint32_t stroke = kNone;
  };
  struct Arm {
    std::uint32_t vertex = 0, edge = 0;
  };

  Point2 mm(LatticePoint p) const { return model_.lattice.to_mm(p); }
  LatticePoint place_of(const EndOfStroke& end) const {
    const Stroke& s = model_.strokes[end.stroke];
    return end.first ? s.from : s.to;
  }

  void file_strokes() {
    for (std::uint32_t i = 0; i < model_.strokes.size(); ++i) {
      const Stroke& s = model_.strokes[i];
      if (s.visible && s.line_class == LineClass::tangent) pieces_.push_back({s.source, s.t_from, s.t_to, i});
    }
    std::ranges::sort(
        pieces_, [](const Piece& l, const Piece& r) { return std::pair(l.source, l.from) < std::pair(r.source, r.from); });
  }

  std::span<const Piece> pieces_of(std::uint32_t source) const {
    const auto first = std::ranges::lower_bound(pieces_, source, {}, &Piece::source);
    auto last = first;
    while (last != pieces_.end() && last->source == source) ++last;
    return {first, last};
  }

  std::span<const Arm> arms_at(std::uint32_t v) const {
    const auto first = std::ranges::lower_bound(arms_, v, {}, &Arm::vertex);
    const auto last = std::ranges::upper_bound(arms_, v, {}, &Arm::vertex);
    return {first, last};
  }

  const TangentEdge* edge_between(std::uint32_t a, std::uint32_t b) const {
    for (const Arm& arm : arms_at(a)) {
      const TangentEdge& edge = contours_.tangents[arm.edge];
      if (edge.edge.v0 == b || edge.edge.v1 == b) return &edge;
    }
    return nullptr;
  }

  bool is_seen(std::uint32_t c, double at) const {
    return std::ranges::any_of(seen_[c].runs, [&](const ContourRun& run) {
      return run.state >= 0 && run.from <= at && at <= run.to && run.from < run.to;
    });
  }

  template <class Visit>
  void for_visible_curves(Visit visit) const {
    for (std::uint32_t c = 0; c < seen_.size(); ++c) {
      for (const ContourRun& run : seen_[c].runs) {
        if (run.state < 0) continue;
        const std::vector<CurvePoint> points = seen_[c].curve.part(run.from, run.to);
        for (std::size_t i = 1; i < points.size(); ++i) {
          OutlineSegment s{points[i - 1].mm, points[i].mm};
          const auto segment = static_cast<std::size_t>(points[i - 1].at);
          s.chain = c;
          s.beside_mm = segment < seen_[c].beside_mm.size() ? seen_[c].beside_mm[segment] : 0;
          visit(s);
        }
      }
    }
  }

  /// Whether a point of the page lies beside a visible part of the contour by no more than is permitted.
  bool is_beside(std::uint32_t c, Point2 p, double reach_mm) const {
    bool found = false;
    curves_.near(p - Point2(reach_mm), p + Point2(reach_mm),
                 [&](const OutlineSegment& s) { found = found || (s.chain == c && distance_to(s, p) <= s.beside_mm); });
    return found;
  }

  Point2 page(std::uint32_t v) const { return page_point(view_, scene_.vertices[v]); }

  /// The step onto the only other tangent edge at the end of a step. Walks end before the next edge that a contour
  /// crosses, so each edge is passed twice at the most.
  std::optional<Step> next(const Step& step) const {
    const std::uint32_t v = step.forward ? step.edge->edge.v1 : step.edge->edge.v0;
    const auto arms = arms_at(v);
    if (arms.size() != 2) return std::nullopt;
    const TangentEdge* edge = &contours_.tangents[arms[0].edge];
    if (edge == step.edge) edge = &contours_.tangents[arms[1].edge];
    if (is_crossed_[number_of(*edge)]) return std::nullopt;
    return Step{edge, edge->edge.v0 == v, 0};
  }

  /// The part of a piece in the direction of a step, and its stroke.
  struct Span {
    double from, to;
    std::uint32_t stroke;
  };
  std::vector<Span> spans_of(const Step& step) const {
    std::vector<Span> spans;
    for (const Piece& p : pieces_of(step.edge->source)) {
      spans.push_back(step.forward ? Span{p.from, p.to, p.stroke} : Span{1 - p.to, 1 - p.from, p.stroke});
    }
    if (!step.forward) std::ranges::reverse(spans);
    return spans;
  }

  std::optional<Plan> plan_for(const Crossing& crossing) const {
    const std::uint32_t c = crossing.chain, i = crossing.node;
    const TangentEdge& edge = *crossing.edge;
    const ContourNode& node = contours_.chains[c].nodes[i];
    const Point3 &p = scene_.vertices[edge.edge.v0], &q = scene_.vertices[edge.edge.v1];
    const double t = nearest_on_segment(node.on_mesh, p, q);
    const bool forward = edge.edge.v1 == node.edge[0];
    const Step to_front{&edge, forward, forward ? t : 1 - t}, to_back{&edge, !forward, forward ? 1 - t : t};
    for (const Span& s : spans_of(to_back)) {
      if (s.from < to_back.begin - kSameParameter && s.to > to_back.begin + kSameParameter) {
        return cut_of(c, i, to_back, s);
      }
    }
    return gap_of(c, i, to_front);
  }

  /// Finds the visible line ahead of a node that is hidden there.
  std::optional<Plan> gap_of(std::uint32_t c, std::uint32_t i, Step step) const {
    Plan plan{c, i, step.edge};
    const double reach = contours_.chains[c].nodes[i].most_mm;
    for (;;) {
      for (const Span& s : spans_of(step)) {
        if (s.to <= step.begin + kSameParameter) continue;
        if (s.from <= step.begin + kSameParameter && plan.vertices.empty()) return std::nullopt;  // it ends here
        plan.end = {s.stroke, step.forward};
        if (!is_beside(c, mm(place_of(plan.end)), reach)) return std::nullopt;
        return plan;
      }
      const std::uint32_t v = step.forward ? step.edge->edge.v1 : step.edge->edge.v0;
      if (!is_beside(c, page(v), reach)) return std::nullopt;
      plan.vertices.push_back(v);
      const auto after = next(step);
      if (!after) return std::nullopt;
      step = *after;
    }
  }

  /// Finds the end of the visible line that goes on behind a node. `first`: the stroke at the node.
  std::optional<Plan> cut_of(std::uint32_t c, std::uint32_t i, Step step, Span first) const {
    Plan plan{c, i, step.edge};
    plan.shortened = first.stroke;
    const double reach = contours_.chains[c].nodes[i].most_mm;
    Span last = first;
    for (;;) {
      plan.end = {last.stroke, !step.forward};
      if (!is_beside(c, mm(place_of(plan.end)), reach)) return std::nullopt;
      if (last.to < 1 - kSameParameter) return plan;
      const auto after = next(step);
      if (!after) return std::nullopt;
      const std::vector<Span> spans = spans_of(*after);
      if (spans.empty() || spans.front().from > kSameParameter) return plan;
      step = *after;
      last = spans.front();
      plan.cut.push_back(last.stroke);
    }
  }

  /// Drops the plans for ends that meet another visible line.
  void keep_free_ends(std::vector<Plan>& plans) {
    const Point2 around(kTouchingMm);
    for (const Plan& plan : plans) {
      const Point2 p = mm(place_of(plan.end));
      lines_.expect(p - around, p + around);
    }
    for (std::uint32_t i = 0; i < model_.strokes.size(); ++i) {
      const Stroke& s = model_.strokes[i];
      if (!s.visible || s.line_class == LineClass::mesh) continue;
      OutlineSegment line{mm(s.from), mm(s.to)};
      line.chain = i;
      lines_.add(line);
    }
    for_visible_curves([&](OutlineSegment s) {
      s.chain = kNone;
      lines_.add(s);
    });
    std::erase_if(plans, [&](const Plan& plan) {
      const Point2 p = mm(place_of(plan.end));
      bool meets = false;
      lines_.near(p - around, p + around, [&](const OutlineSegment& s) {
        meets = meets || (s.chain != plan.end.stroke && distance_to(s, p) <= kTouchingMm && !is_cut_line(plan, s.chain));
      });
      return meets;
    });
  }

  static bool is_cut_line(const Plan& plan, std::uint32_t stroke) {
    return stroke != kNone && (stroke == plan.shortened || std::ranges::find(plan.cut, stroke) != plan.cut.end());
  }

  /// A point of the new line.
  struct Place {
    LatticePoint at;
    double z = 0, w = 1;
  };

  Place place_of_node(const Plan& plan) const {
    const CurvePoint p = seen_[plan.chain].curve.point_at(plan.node);
    return {model_.lattice.snap(p.mm), p.depth, p.weight};
  }

  void lead_on(const Plan& plan) {
    const Stroke old = model_.strokes[plan.end.stroke];
    std::vector<Place> way{place_of_node(plan)};
    for (const std::uint32_t v : plan.vertices) {
      const HomogeneousPoint h = to_homogeneous(view_, scene_.vertices[v]);
      way.push_back({model_.lattice.snap(page(v)), h.z / h.w, h.w});
    }
    way.push_back(plan.end.first ? Place{old.from, old.z_from, old.w_from} : Place{old.to, old.z_to, old.w_to});
    const TangentEdge* edge = plan.edge;
    for (std::size_t k = 1; k < way.size(); ++k) {
      const Place &a = way[k - 1], &b = way[k];
      if (a.at == b.at) continue;
      Stroke s = old;
      s.from = a.at;
      s.to = b.at;
      s.t_from = 0;
      s.t_to = 1;
      s.z_from = static_cast<float>(a.z);
      s.z_to = static_cast<float>(b.z);
      if (view_.camera.perspective) s.w_from = static_cast<float>(a.w), s.w_to = static_cast<float>(b.w);
      s.source = model_.edge_count + static_cast<std::uint32_t>(model_.intersections.size());
      model_.intersections.push_back({{to_model_point(view_, mm(s.from), s.z_from), to_model_point(view_, mm(s.to), s.z_to)},
                                      {edge->edge.face0, edge->edge.face1},
                                      false});
      model_.strokes.push_back(s);
    }
  }

  /// Ends the line at the node.
  void shorten(const Plan& plan) {
    Stroke& s = model_.strokes[plan.shortened];
    const TangentEdge* edge = plan.edge;
    const ContourNode& node = contours_.chains[plan.chain].nodes[plan.node];
    const bool first = edge->edge.v0 == node.edge[1];  // the back of the line comes first
    const double t = std::clamp(
        nearest_on_segment(node.on_mesh, scene_.vertices[edge->edge.v0], scene_.vertices[edge->edge.v1]), s.t_from, s.t_to);
    const Place place = place_of_node(plan);
    (first ? s.from : s.to) = place.at;
    (first ? s.t_from : s.t_to) = t;
    (first ? s.z_from : s.z_to) = static_cast<float>(place.z);
    if (view_.camera.perspective) (first ? s.w_from : s.w_to) = static_cast<float>(place.w);
  }

  StrokeModel& model_;
  const View& view_;
  const SmoothContours& contours_;
  const std::vector<SeenContour>& seen_;
  const Scene& scene_;
  std::vector<Piece> pieces_;             ///< sorted by source and parameter
  std::vector<std::uint8_t> is_crossed_;  ///< per tangent edge: 1 if a seen contour crosses it
  std::vector<Arm> arms_;                 ///< ends of tangent edges, sorted by vertex
  SegmentFinder curves_;                  ///< visible contours; OutlineSegment::chain is the contour
  SegmentFinder lines_;                   ///< visible lines; OutlineSegment::chain is the stroke, or kNone for contours
};

}  // namespace

void end_tangents_on_contours(StrokeModel& model, const View& view, const SmoothContours& contours,
                              const std::vector<SeenContour>& seen, const Scene& scene) {
  if (!contours.tangents.empty()) TangentEnds(model, view, contours, seen, scene).run();
}

}  // namespace ligne
