#include "support/judge.hpp"

#include <glm/vec4.hpp>

#include "linework/overlaps/coincident_strokes.hpp"
#include "main/tier.hpp"
#include "support/comparison.hpp"
#include "view/cull.hpp"
#include "view/tolerances.hpp"

namespace ligne::test {
namespace {

// Every stroke lies where its source says: its two points on the page are matrix x source edge at its interval, as the JSON
// drawing promises (docs/drawing-format.md).

/// Half a step each for the ends of the line on which the stroke lies, and for the stroke's own end; rounded up for
/// intersections, whose lines are found between points of the lattice.
constexpr double kSteps = 3;
/// A parameter carries the roundings of two quotients and of the weights between page and model.
constexpr double kParameterRounding = 0x1p-50;
/// Four products, three sums and a quotient, and a translation that was itself a sum.
constexpr double kMatrixRounding = 0x1p-49;

struct Place {
  Point2 mm{0, 0};
  double error_mm = 0;
};

Place page_place(const View& view, const SourceEdge& source, double t) {
  const Point3 p = source.ends[0] + t * (source.ends[1] - source.ends[0]);
  const glm::dvec4 h = view.model_to_page * glm::dvec4(p, 1);
  glm::dvec4 sizes(0);
  for (int i = 0; i < 4; ++i) sizes += glm::abs(view.model_to_page[i]) * (i < 3 ? std::abs(p[i]) : 1.0);
  const Point2 mm{h.x / h.w, h.y / h.w};
  const double size = std::max(sizes.x, sizes.y) + sizes.w * std::max(std::abs(mm.x), std::abs(mm.y));
  return {mm, kMatrixRounding * size / std::abs(h.w)};
}

/// How far the end is from where it ought to be, less what rounding explains.
double distance(const View& view, const SourceEdge& source, double t, Point2 end, double tolerance_mm, Place& place) {
  place = page_place(view, source, t);
  const Place before = page_place(view, source, t - kParameterRounding);
  const Place after = page_place(view, source, t + kParameterRounding);
  const double along = std::max(glm::distance(before.mm, place.mm), glm::distance(after.mm, place.mm));
  return glm::distance(place.mm, end) - (tolerance_mm + along + place.error_mm);
}

/// The ends of strokes that are farther from their places than `tolerance_mm` and what is rounded on the way: points to the
/// lattice, parameters and the product with the matrix to doubles. Shadows and lines of no face are not asked.
Fault misplaced(const StrokeModel& model, const Scene& scene, const Topology& topology, const View& view,
                double tolerance_mm) {
  Fault fault;
  const double tolerance = tolerance_mm + kSteps * model.lattice.step_mm;
  for (const Stroke& s : model.strokes) {
    SourceEdge source;
    if (s.source < topology.edges.size()) {
      const Edge& edge = topology.edges[s.source];
      source.ends = {scene.vertices[edge.v0], scene.vertices[edge.v1]};
    } else if (s.source >= model.edge_count) {
      source = model.intersections[s.source - model.edge_count];
    } else {
      continue;
    }
    for (const bool last : {false, true}) {
      const Point2 end = model.lattice.to_mm(last ? s.to : s.from);
      Place place;
      if (!(distance(view, source, last ? s.t_to : s.t_from, end, tolerance, place) <= 0))
        add(fault, {place.mm, end}, "end of a stroke of edge " + std::to_string(s.source) + " beside its place");
    }
  }
  return fault;
}

constexpr double kCreaseDegrees = 30;
/// The end of a line that gave way is put onto the other one: within the tolerance across, and as far along.
constexpr double kEndsOfTwo = 1.5;

std::string words(const char* what, const Point3& a, const Point3& b) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, "%s (%.9g, %.9g, %.9g) - (%.9g, %.9g, %.9g)", what, a.x, a.y, a.z, b.x, b.y, b.z);
  return buffer;
}

/// The worse one of the drawings without and with hidden strokes counts.
void keep_worse(Fault& fault, const Fault& other) {
  if (other.length_mm > fault.length_mm) fault = other;
}

using EdgeKey = std::tuple<std::uint32_t, std::array<double, 3>, std::array<double, 3>>;

EdgeKey key_of(std::uint32_t object, const Point3& a, const Point3& b) {
  std::array<double, 3> p{a.x + 0.0, a.y + 0.0, a.z + 0.0}, q{b.x + 0.0, b.y + 0.0, b.z + 0.0};
  if (q < p) std::swap(p, q);
  return {object, p, q};
}

Point3 axis_vector(Axis axis) { return {axis == Axis::x ? 1 : 0, axis == Axis::y ? 1 : 0, axis == Axis::z ? 1 : 0}; }

}  // namespace

oracle::View oracle_view(const CameraRequest& request, const View& view) {
  oracle::View result;
  const Camera& camera = view.camera;
  result.perspective = camera.perspective;
  result.direction = request.direction ? *request.direction : camera.forward;
  result.eye = camera.eye;
  result.target = request.target ? *request.target : camera.eye + camera.forward * camera.target_distance;
  result.up = request.up ? *request.up : axis_vector(request.up_axis);
  // Looking along the up vector the library takes another one. That only turns the page: here the camera's own does.
  constexpr double kParallelSine = 1e-3;
  if (glm::length(glm::cross(glm::normalize(result.up), camera.forward)) < kParallelSine) result.up = -camera.down;
  result.scale = view.scale;
  result.offset = view.offset;
  result.window = view.window;
  return result;
}

struct JudgedView::Lines {
  std::vector<Candidate> candidates;
  std::map<std::uint32_t, std::size_t> of_edge;  ///< edge of the topology -> candidate, for those in view
  std::map<std::array<std::uint32_t, 2>, std::vector<Crossing>> of_faces;  ///< intersections by their faces
  bool has_proper_intersections = false;
  std::size_t intervals = 0;  ///< of all candidates
};

namespace {

/// The accuracy for which the oracle is made.
constexpr double kOracleMm = 0.001;

/// The view on a page `by` times smaller.
oracle::View smaller(oracle::View view, double by) {
  view.scale /= by;
  view.offset /= by;
  view.window.min /= by;
  view.window.max /= by;
  return view;
}

std::vector<oracle::Interval> larger(std::vector<oracle::Interval> intervals, double by) {
  for (oracle::Interval& i : intervals) {
    i.from *= by;
    i.to *= by;
  }
  return intervals;
}

}  // namespace

bool is_glass(const Scene& scene, std::uint32_t face) {
  return !scene.face_material.empty() && scene.materials[scene.face_material[face]].opacity < 1;
}

bool has_glass(const Scene& scene) {
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f)
    if (is_glass(scene, f)) return true;
  return false;
}

JudgedView::JudgedView(const Scene& scene, std::string name, const StandardView& standard, double accuracy_mm)
    : scene_(scene),
      name_(std::move(name)),
      standard_(standard),
      accuracy_mm_(accuracy_mm),
      topology_(build_topology(scene)),
      view_(make_view(scene, make_camera(standard.camera, scene), standard.sheet.frame, standard.sheet.page,
                      standard.sheet.scale)),
      has_glass_(has_glass(scene)) {}

namespace {

oracle::View view_of(const StandardView& standard, const View& view, double accuracy_mm) {
  return smaller(oracle_view(standard.camera, view), accuracy_mm / kOracleMm);
}

}  // namespace

const oracle::Oracle& JudgedView::oracle() const {
  if (!oracle_) oracle_ = std::make_unique<oracle::Oracle>(scene_, view_of(standard_, view_, accuracy_mm_), kCreaseDegrees);
  return *oracle_;
}

void JudgedView::ask() const {
  if (lines_) return;
  const auto answers = [&](oracle::Glass glass) {
    return oracle::answers_of(scene_, view_of(standard_, view_, accuracy_mm_), kCreaseDegrees, glass);
  };
  lines_ = std::make_unique<Lines>(lines_of(answers(oracle::Glass::hides), Edges::all));
  if (!has_glass_) return;
  const oracle::Answers clear = answers(oracle::Glass::is_clear);
  behind_ = std::make_unique<Lines>(lines_of(clear, Edges::all));
  opaque_ = std::make_unique<Lines>(lines_of(clear, Edges::without_glass));
}

JudgedView::Lines JudgedView::lines_of(const oracle::Answers& answers, Edges edges) const {
  Lines lines;
  const double by = accuracy_mm_ / kOracleMm;
  const auto is_out = [&](auto... faces) { return edges == Edges::without_glass && (is_glass(scene_, faces) || ...); };
  std::map<EdgeKey, std::uint32_t> numbers;
  std::uint32_t object = 0;
  for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
    const Edge& edge = topology_.edges[e];
    while (edge.v0 >= scene_.objects[object].vertex_end) ++object;
    numbers[key_of(object, scene_.vertices[edge.v0], scene_.vertices[edge.v1])] = e;
  }
  const auto add_candidate = [&](Candidate candidate) {
    if (candidate.intervals.empty()) return false;
    lines.intervals += candidate.intervals.size();
    candidate.whole = {candidate.intervals.front().from, candidate.intervals.back().to};
    bool first = true;
    for (const oracle::Interval& i : candidate.intervals) {
      if (i.at_border) continue;
      candidate.in_view = {first ? i.from : candidate.in_view.from, i.to};
      first = false;
    }
    lines.candidates.push_back(std::move(candidate));
    return true;
  };
  for (std::size_t i = 0; i < answers.edges.size(); ++i) {
    const oracle::Edge& edge = answers.edges[i];
    if (!edge.faces.empty() && std::ranges::all_of(edge.faces, [&](std::uint32_t f) { return is_out(f); })) continue;
    const std::string what = words(("object " + std::to_string(edge.object) + " edge").c_str(), edge.a, edge.b);
    if (!add_candidate({false, true, edge.edge_class, {}, larger(answers.edge_intervals[i], by), what})) continue;
    const auto number = numbers.find(key_of(edge.object, edge.a, edge.b));
    if (number != numbers.end()) lines.of_edge[number->second] = lines.candidates.size() - 1;
  }
  for (std::size_t i = 0; i < answers.intersections.size(); ++i) {
    const oracle::Intersection& x = answers.intersections[i];
    if (is_out(x.face0, x.face1)) continue;
    const std::string faces = "intersection of faces " + std::to_string(x.face0) + " and " + std::to_string(x.face1);
    const Segment page{x.page_a * by, x.page_b * by};
    Candidate candidate{true,
                        x.proper,
                        EdgeClass::intersection,
                        {},
                        larger(answers.intersection_intervals[i], by),
                        words(faces.c_str(), x.a, x.b)};
    lines.of_faces[{x.face0, x.face1}].push_back({page, x.vague, candidate});
    lines.has_proper_intersections |= x.proper;
    add_candidate(std::move(candidate));
  }
  return lines;
}

JudgedView::~JudgedView() = default;

bool JudgedView::has_intersections() const {
  ask();
  return lines_->has_proper_intersections;
}

namespace {

constexpr std::pair<const char*, Fault Verdict::*> kFaults[] = {{"drawn although hidden", &Verdict::drawn_hidden},
                                                                {"missing", &Verdict::missing},
                                                                {"drawn twice", &Verdict::twice},
                                                                {"neither visible nor hidden", &Verdict::uncovered},
                                                                {"beside its place", &Verdict::misplaced},
                                                                {"wrong class", &Verdict::wrong_class}};

std::string report(const Verdict& verdict) {
  std::string text;
  for (const auto& [name, kind] : kFaults) {
    const Fault& fault = verdict.*kind;
    if (fault.length_mm == 0) continue;
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "  %s: %.4f mm, worst %.4f mm: ", name, fault.length_mm, fault.worst_mm);
    text += buffer + fault.place + "\n";
  }
  return text;
}

}  // namespace

/// Compares a drawing of the method with the answers of one oracle. Of all drawings compared the worst counts.
void JudgedView::compare(StrokeModel model, const Lines& lines, const MethodTraits& traits, const ProjectedScene& projected,
                         bool all, bool hidden, Verdict& verdict) const {
  // A stroke that gave way lies within the coincidence tolerance of the one that stands; the ends of both are rounded to the
  // lattice.
  const double coincidence = coincidence_mm(projected), limited = accuracy_mm_ > kOracleMm ? accuracy_mm_ : 0;
  const double tolerance = std::max({traits.tolerance_mm, limited, coincidence + 2 * projected.lattice.step_mm});
  Verdict drawing;
  drawing.misplaced = misplaced(model, scene_, topology_, view_, 0);
  remove_coincident_strokes(model, coincidence);
  keep_worse(drawing.misplaced, misplaced(model, scene_, topology_, view_, kEndsOfTwo * coincidence));
  // A little less than the tolerance: what lies just at it may be told either way.
  constexpr double kInside = 0.9;
  Comparison comparison(model, lines.candidates, all, tolerance, kInside * coincidence, drawing);
  for (const DrawnStroke& s : comparison.strokes()) {
    if (!s.stroke->visible) continue;
    if (s.stroke->source < model.edge_count) {
      const auto found = lines.of_edge.find(s.stroke->source);
      comparison.visible_edge(s, found == lines.of_edge.end() ? nullptr : &lines.candidates[found->second]);
    } else {
      const SourceEdge& source = model.intersections[s.stroke->source - model.edge_count];
      const auto found =
          lines.of_faces.find({std::min(source.faces[0], source.faces[1]), std::max(source.faces[0], source.faces[1])});
      comparison.visible_intersection(s, found == lines.of_faces.end() ? std::vector<Crossing>{} : found->second);
    }
  }
  comparison.missing();
  comparison.twice();
  count_checks(Check::drawings);
  count_checks(Check::intervals, lines.intervals);
  if (hidden) comparison.uncovered();
  for (const auto& [name, kind] : kFaults) keep_worse(verdict.*kind, drawing.*kind);
}

Verdict JudgedView::judge(const Method& method, const std::string& edges, const MethodSettings& settings, Cull cull) const {
  const MethodTraits& traits = method.traits();
  Verdict verdict;
  if (!(traits.products & kStrokes)) {
    verdict.skipped = "does not produce lines";
    return verdict;
  }
  if (!traits.penetration && has_intersections()) {
    verdict.skipped = "does not draw penetrating faces, which the scene has";
    return verdict;
  }
  const bool all = edges == "all";
  EdgeSelection selection{{}, kCreaseDegrees};
  for (std::size_t c = 0; c < kLineClassCount; ++c)
    if (all || static_cast<LineClass>(c) != LineClass::mesh) selection.classes.add(static_cast<LineClass>(c));
  ProjectedScene projected = project(scene_, topology_, view_, selection);
  if (cull == Cull::on) ligne::cull(projected, find_back_faces(scene_, topology_, view_));
  ask();
  const Lines& lines = !has_glass_ || traits.transparency == TransparencyMode::opaque ? *lines_
                       : traits.transparency == TransparencyMode::left_out            ? *opaque_
                                                                                      : *behind_;
  for (const bool hidden : {false, true}) {
    if (hidden && cull == Cull::on) break;  // the lines of back faces are gone
    VisibilityOptions options;
    options.hidden_strokes = hidden;
    options.settings = settings;
    options.wanted = static_cast<std::uint8_t>(~kPixels);  // are not judged, and take more time than all else
    VisibilityResult result = method.compute_visibility(projected, options);
    if (!result.unsupported_reason.empty()) {
      verdict.skipped = result.unsupported_reason;
      return verdict;
    }
    if (!result.strokes) {
      verdict.faults = "  gives no strokes, although its traits say so\n";
      return verdict;
    }
    if (has_glass_ && traits.transparency == TransparencyMode::left_out && result.left_out.empty()) {
      verdict.faults = "  leaves transparent faces out and does not say so\n";
      return verdict;
    }
    compare(*result.strokes, lines, traits, projected, all, hidden, verdict);
    if (!has_glass_ || traits.transparency != TransparencyMode::seen_through) continue;
    for (Stroke& s : result.strokes->strokes) s.visible = s.visible && s.level == 0;
    compare(std::move(*result.strokes), *lines_, traits, projected, all, hidden, verdict);
  }
  for (const Candidate& c : lines.candidates) {
    for (const oracle::Interval& i : c.intervals) {
      if (i.at_border) continue;
      verdict.line_mm += segment(i).length();
      if (i.answer == Answer::undecided) verdict.undecided_mm += segment(i).length();
    }
  }
  verdict.faults = report(verdict);
  if (!verdict.faults.empty()) {
    verdict.faults = name_ + ", view " + standard_.name + ", method " + std::string(traits.name) + ", edges " + edges +
                     (cull == Cull::on ? ", culled" : "") + "\n" + verdict.faults + "  ligne draw tests/corpus/" + name_ +
                     ".json " + standard_.options + " --method " + std::string(traits.name) + " --edges " + edges +
                     (cull == Cull::on ? " --cull" : "") + " -o x.svg\n";
  }
  return verdict;
}

}  // namespace ligne::test
