#include "oracle/oracle.hpp"

#include "oracle/parts.hpp"

namespace oracle {
namespace {

/// A line that is nearer to a face's plane than this part of the scene's size lies in it.
constexpr double kTouchPart = 0x1p-44;
/// Roundings of the library's projection, of the largest coordinate (docs/numerics.md, "Object::precision").
constexpr double kProjectionRounding = 0x1p-50;
/// Parts of a line that are shorter are not asked about: they lie within a micrometre of two changes.
constexpr double kShortestMm = 2.5 * kMicrometre;
/// Lines shorter than this on the page are seen end on.
constexpr double kEndOnMm = 2 * kMicrometre;

using Interval1 = std::pair<Exact, Exact>;

/// Do the closed intervals together cover all of [from, to]?
bool cover_all(std::vector<Interval1> intervals, double from, double to) {
  std::sort(intervals.begin(), intervals.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
  Exact reached(from);
  for (const auto& [first, second] : intervals) {
    if (first > reached) return false;
    if (second > reached) reached = second;
    if (reached >= to) return true;
  }
  return false;
}

/// The answer at one place of the line.
Part answer_at(double tau, const std::vector<FaceOverLine>& faces) {
  std::vector<Interval1> surely_before;
  bool maybe_covered = false, left = false, right = false;
  for (const FaceOverLine& face : faces) {
    const Exact behind = face.behind(Exact(tau));
    if (behind < -face.delta) continue;
    const bool before = behind > 0, surely = behind > face.delta;
    for (auto& [first, second] : face.cover(tau)) {
      maybe_covered = maybe_covered || (first < 1 && second > -1);
      left = left || (before && first < 0 && second >= 0);
      right = right || (before && first <= 0 && second > 0);
      if (surely) surely_before.emplace_back(std::move(first), std::move(second));
    }
  }
  Part part;
  part.exactly_hidden = left && right;
  if (!maybe_covered) part.answer = Answer::visible;
  if (part.exactly_hidden && cover_all(std::move(surely_before), -1, 1)) part.answer = Answer::hidden;
  return part;
}

/// Adds a part behind the others; those of one answer become one.
void append(std::vector<Part>& parts, const Part& part) {
  if (part.tau0 >= part.tau1) return;
  if (!parts.empty() && parts.back().answer == part.answer && parts.back().exactly_hidden == part.exactly_hidden) {
    parts.back().tau1 = part.tau1;
  } else {
    parts.push_back(part);
  }
}

double size_of(const ligne::Scene& scene) {
  double largest = 0;
  for (const Point3& p : scene.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

double input_error(const ligne::Scene& scene) {
  double error = kProjectionRounding * size_of(scene);
  for (const ligne::Object& object : scene.objects) error = std::max(error, object.precision);
  return error;
}

}  // namespace

Oracle::State::State(const ligne::Scene& scene, const View& v, double crease_degrees, Glass glass)
    : view(v),
      projection(v),
      faces(make_faces(scene, projection, input_error(scene))),
      edges(make_edges(scene, faces, crease_degrees)),
      touch_distance(kTouchPart * size_of(scene)),
      input_error_mm(v.scale * input_error(scene)) {
  if (glass == Glass::is_clear)
    for (std::size_t f = 0; f < scene.face_material.size(); ++f)
      faces[f].clear = scene.materials[scene.face_material[f]].opacity < 1;
  find_intersections();
}

double Oracle::State::delta(const Face& face, const Line& line) const {
  const double m = std::max(projection.magnification(line.a), projection.magnification(line.b));
  const double g = face.gradient;
  return (kMicrometre * (1 + g) + 2 * input_error_mm * m * (m + g) + face.slack_mm) / projection.mm_z();
}

bool Oracle::State::lies_in_plane(const Vector3& p, const Face& face) const {
  const Exact height = dot(face.normal, p - face.centre);  // times the length of the normal
  return height * height <= Exact(touch_distance) * Exact(touch_distance) * dot(face.normal, face.normal);
}

std::optional<std::array<double, 2>> Oracle::State::part_in_view(const Vector3& a, const Vector3& b) const {
  const SightPoint pa = projection.sight_point(a), pb = projection.sight_point(b);
  double from = 0, to = 1;
  // Keeps where a value that is linear along the segment is not negative.
  const auto clip = [&](double value_a, double value_b) {
    if (value_a < 0 && value_b < 0) to = -1;
    if (value_a < 0 && value_b >= 0) from = std::max(from, value_a / (value_a - value_b));
    if (value_a >= 0 && value_b < 0) to = std::min(to, value_a / (value_a - value_b));
  };
  const auto weight = [&](const SightPoint& p) { return projection.perspective() ? to_double(p.f) : 1; };
  if (projection.perspective()) clip(to_double(pa.f - projection.near()), to_double(pb.f - projection.near()));
  const double x0 = projection.x_of(view.window.min.x - kMicrometre), x1 = projection.x_of(view.window.max.x + kMicrometre);
  const double y0 = projection.y_of(view.window.min.y - kMicrometre), y1 = projection.y_of(view.window.max.y + kMicrometre);
  clip(to_double(pa.x) - x0 * weight(pa), to_double(pb.x) - x0 * weight(pb));
  clip(x1 * weight(pa) - to_double(pa.x), x1 * weight(pb) - to_double(pb.x));
  clip(to_double(pa.y) - y0 * weight(pa), to_double(pb.y) - y0 * weight(pb));
  clip(y1 * weight(pa) - to_double(pa.y), y1 * weight(pb) - to_double(pb.y));
  if (!(from < to)) return {};
  return std::array<double, 2>{from, to};
}

std::optional<LineInView> Oracle::State::line_in_view(const Vector3& a, const Vector3& b) const {
  const auto part = part_in_view(a, b);
  if (!part) return {};
  const auto page_point = [&](double t) { return projection.page_point(projection.sight_point(a + Exact(t) * (b - a))); };
  LineInView result{(*part)[0], (*part)[1], Line(page_point((*part)[0]), page_point((*part)[1]), projection)};
  if (result.line.length_mm < kEndOnMm) return {};
  return result;
}

std::vector<Part> Oracle::State::judge(const Line& line, const Vector3& a, const Vector3& b,
                                       std::span<const std::uint32_t> own_faces) const {
  std::vector<FaceOverLine> before;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const Face& face = faces[f];
    if (!face.hides || face.clear || std::find(own_faces.begin(), own_faces.end(), f) != own_faces.end()) continue;
    if (!line.box.meets(face.box, 2 * kMicrometre / projection.mm_x(), 2 * kMicrometre / projection.mm_y())) continue;
    const double delta_here = delta(face, line);
    if (face.box.z0 > line.box.z1 + delta_here || line.surely_beside(face)) continue;
    FaceOverLine over(face, line);
    over.delta = delta_here;
    if (over.behind_a < -delta_here && over.behind_b < -delta_here) continue;
    if (lies_in_plane(a, face) && lies_in_plane(b, face)) continue;
    over.find_corners(line);
    before.push_back(std::move(over));
  }
  std::vector<double> places;
  for (const FaceOverLine& face : before) add_changes(face, 1, places);
  add_crossings(before, 1, 2 * kShortestMm / line.length_mm, places);

  std::vector<Part> parts;
  double reached = 0;
  for (const auto& [from, to] : parts_between(places, kShortestMm / line.length_mm)) {
    append(parts, {reached, from});
    Part part = answer_at((from + to) / 2, before);
    part.tau0 = from, part.tau1 = to;
    append(parts, part);
    reached = to;
  }
  append(parts, {reached, 1});
  return parts;
}

namespace {

/// The part of the page segment that lies inside the window and not within a micrometre of its border; empty when from > to.
std::array<double, 2> part_surely_in_view(Point2 a, Point2 b, const ligne::Rect& window) {
  double from = 0, to = 1;
  const auto clip = [&](double value_a, double value_b) {
    if (value_a < 0 && value_b < 0) to = -1;
    if (value_a < 0 && value_b >= 0) from = std::max(from, value_a / (value_a - value_b));
    if (value_a >= 0 && value_b < 0) to = std::min(to, value_a / (value_a - value_b));
  };
  for (int axis = 0; axis < 2; ++axis) {
    const double low = window.min[axis] + kMicrometre, high = window.max[axis] - kMicrometre;
    clip(a[axis] - low, b[axis] - low);
    clip(high - a[axis], high - b[axis]);
  }
  return {from, to};
}

/// Calls give(tau0, tau1, at_border) for the pieces of [tau0, tau1] inside and outside of the part surely in view.
template <class Give>
void split_at_border(double tau0, double tau1, const std::array<double, 2>& in_view, Give give) {
  const double from = std::clamp(in_view[0], tau0, tau1), to = std::clamp(in_view[1], from, tau1);
  if (in_view[0] > in_view[1]) return give(tau0, tau1, true);
  if (tau0 < from) give(tau0, from, true);
  if (from < to) give(from, to, false);
  if (to < tau1) give(to, tau1, true);
}

/// The visibility of the segment from a to b in the model.
std::vector<Interval> visibility(const Oracle::State& state, const Vector3& a, const Vector3& b,
                                 std::span<const std::uint32_t> own_faces) {
  const auto in_view = state.line_in_view(a, b);
  if (!in_view) return {};
  const auto& [t0, t1, line] = *in_view;
  const Projection& projection = state.projection;
  // With weights w the page parameter tau is the model parameter tau w0 / ((1 - tau) w1 + tau w0); w is minus one over z.
  const double w0 = projection.perspective() ? -1 / to_double(line.a.z) : 1;
  const double w1 = projection.perspective() ? -1 / to_double(line.b.z) : 1;
  const auto parameter = [&, from = t0, to = t1](double tau) {
    return from + (to - from) * tau * w0 / ((1 - tau) * w1 + tau * w0);
  };
  const Point2 from = projection.page_mm(line.a), to = projection.page_mm(line.b);
  const std::array<double, 2> surely = part_surely_in_view(from, to, state.view.window);
  std::vector<Interval> result;
  for (const Part& p : state.judge(line, a, b, own_faces)) {
    split_at_border(p.tau0, p.tau1, surely, [&](double tau0, double tau1, bool at_border) {
      const bool open = at_border && p.answer == Answer::visible;
      result.push_back({parameter(tau0), parameter(tau1), from + tau0 * (to - from), from + tau1 * (to - from),
                        open ? Answer::undecided : p.answer, p.exactly_hidden, at_border});
    });
  }
  return result;
}

}  // namespace

Oracle::Oracle(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass)
    : state_(std::make_unique<State>(scene, view, crease_degrees, glass)) {}
Oracle::~Oracle() = default;

std::span<const Edge> Oracle::edges() const { return state_->edges; }
std::span<const Intersection> Oracle::intersections() const { return state_->intersections; }

std::vector<Interval> Oracle::visible_intervals(std::size_t index) const {
  const Edge& edge = state_->edges[index];
  return visibility(*state_, exact(edge.a), exact(edge.b), edge.faces);
}

std::vector<Interval> Oracle::intersection_intervals(std::size_t index) const {
  const CrossingLine& crossing = state_->crossings[index];
  const Projection& projection = state_->projection;
  return visibility(*state_, projection.model_point(crossing.a), projection.model_point(crossing.b), crossing.own_faces);
}

std::vector<FaceHit> Oracle::faces_at(Point2 page_mm) const {
  const Projection& projection = state_->projection;
  const Exact x(projection.x_of(page_mm.x)), y(projection.y_of(page_mm.y));
  std::vector<std::pair<Exact, FaceHit>> hits;
  for (std::uint32_t f = 0; f < state_->faces.size(); ++f) {
    const Face& face = state_->faces[f];
    if (!face.hides || x < face.box.x0 || x > face.box.x1 || y < face.box.y0 || y > face.box.y1) continue;
    bool inside = false, on_side = false;
    for (const auto& [i, k] : face.sides) {
      const PagePoint &p = face.corners[i], &q = face.corners[k];
      const Exact turn = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
      const Exact along = (q.x - p.x) * (x - p.x) + (q.y - p.y) * (y - p.y);
      const Exact square = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
      if (turn == 0 && along >= 0 && along <= square) on_side = true;
      if ((p.y > y) != (q.y > y) && (turn > 0) == (q.y > p.y)) inside = !inside;
    }
    if (!inside && !on_side) continue;
    Exact z = face.plane.z(x, y);
    hits.push_back({z, {f, projection.depth_mm(z), on_side}});
  }
  std::stable_sort(hits.begin(), hits.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
  std::vector<FaceHit> result;
  for (const auto& [z, hit] : hits) result.push_back(hit);
  return result;
}

double Oracle::distance_to_sides(Point2 page_mm) const {
  double nearest = 1e300;
  for (const Face& face : state_->faces) {
    for (const auto& [i, k] : face.sides) {
      const Point2 p = state_->projection.page_mm(face.corners[i]), q = state_->projection.page_mm(face.corners[k]);
      const Point2 d = q - p, v = page_mm - p;
      const double square = d.x * d.x + d.y * d.y;
      const double u = square > 0 ? std::clamp((v.x * d.x + v.y * d.y) / square, 0.0, 1.0) : 0;
      nearest = std::min(nearest, std::hypot(v.x - u * d.x, v.y - u * d.y));
    }
  }
  return nearest;
}

}  // namespace oracle
