// Segments that two faces have in common inside of both.

#include "oracle/parts.hpp"

namespace oracle {
namespace {

/// Where nearly parallel faces cross hangs on the last digits: the line of two faces whose depths differ by delta only this
/// many micrometres beside it is moved by the rounding of the page (a hundredth of delta) by up to half a micrometre.
constexpr double kWidestDoubt = 50;
/// Lines shorter than this are none.
constexpr double kShortestLineMm = 2.5 * kMicrometre;
/// Parts of a line that are shorter are not asked about.
constexpr double kShortestPartMm = 0.1 * kMicrometre;

bool covers(const FaceOverLine& face, double tau, double from, double to) {
  for (const auto& [first, second] : face.cover(tau))
    if (first <= from && second >= to) return true;
  return false;
}

bool covers_both_banks(const FaceOverLine& face, double tau) {
  for (const auto& [first, second] : face.cover(tau))
    if (first < 0 && second > 0) return true;
  return false;
}

/// How much the depth of `f` grows over that of `g` in one micrometre across the line.
double slope(const Face& f, const Face& g, const Line& line) {
  return to_double((f.plane.b - g.plane.b) * line.ox + (f.plane.c - g.plane.c) * line.oy);
}

/// The common line of the two planes over the part of the page where both faces can be.
std::optional<Line> common_line(const Face& f, const Face& g, const Projection& projection) {
  const Exact a = f.plane.a - g.plane.a, b = f.plane.b - g.plane.b, c = f.plane.c - g.plane.c;
  if (b == 0 && c == 0) return {};
  const double x0 = std::max(f.box.x0, g.box.x0), x1 = std::min(f.box.x1, g.box.x1);
  const double y0 = std::max(f.box.y0, g.box.y0), y1 = std::min(f.box.y1, g.box.y1);
  if (x0 > x1 || y0 > y1) return {};
  int above = 0, below = 0;
  for (const double x : {x0, x1}) {
    for (const double y : {y0, y1}) {
      const Exact d = a + b * x + c * y;
      above += d >= 0;
      below += d <= 0;
    }
  }
  if (above == 0 || below == 0) return {};
  // From one side of the common box to the other, in the direction in which the line is longer.
  const bool along_x = std::abs(to_double(c)) * projection.mm_x() >= std::abs(to_double(b)) * projection.mm_y();
  const auto at = [&](double v) {
    const Exact x = along_x ? Exact(v) : -(a + c * v) / b, y = along_x ? -(a + b * v) / c : Exact(v);
    return PagePoint{x, y, f.plane.z(x, y)};
  };
  const Line line(at(along_x ? x0 : y0), at(along_x ? x1 : y1), projection);
  if (line.length_mm < kShortestLineMm) return {};
  return line;
}

PagePoint point_at(const Line& line, double tau) {
  const Exact t(tau);
  return {line.a.x + t * line.dx, line.a.y + t * line.dy, line.a.z + t * (line.b.z - line.a.z)};
}

/// Collects parts of one line that are alike and follow each other.
class Collector {
 public:
  Collector(Oracle::State& state, const Line& line, std::uint32_t f, std::uint32_t g, bool vague,
            std::vector<std::uint32_t> own)
      : state_(state), line_(line), face0_(std::min(f, g)), face1_(std::max(f, g)), vague_(vague), own_(std::move(own)) {}
  ~Collector() { flush(); }

  void add(double tau0, double tau1, bool proper) {
    if (open_ && proper == proper_ && (tau0 - tau1_) * line_.length_mm <= 2 * kShortestPartMm) {
      tau1_ = tau1;
      return;
    }
    flush();
    open_ = true, tau0_ = tau0, tau1_ = tau1, proper_ = proper;
  }

 private:
  void flush() {
    if (!open_) return;
    open_ = false;
    CrossingLine crossing{point_at(line_, tau0_), point_at(line_, tau1_), own_};
    const Projection& projection = state_.projection;
    state_.intersections.push_back({face0_, face1_, to_point(projection.model_point(crossing.a)),
                                    to_point(projection.model_point(crossing.b)), projection.page_mm(crossing.a),
                                    projection.page_mm(crossing.b), proper_, vague_});
    state_.crossings.push_back(std::move(crossing));
  }

  Oracle::State& state_;
  const Line& line_;
  std::uint32_t face0_, face1_;
  bool vague_;
  std::vector<std::uint32_t> own_;
  bool open_ = false, proper_ = false;
  double tau0_ = 0, tau1_ = 0;
};

/// How many micrometres beside the line the two faces are apart by what may be wrong in both.
double doubt(const Oracle::State& state, const Face& f, const Face& g, const Line& line) {
  const double s = std::abs(slope(f, g, line)), depth = state.delta(f, line) + state.delta(g, line);
  return depth < kWidestDoubt * s ? std::max(1.0, depth / s) : kWidestDoubt + 1;
}

void cross_faces(Oracle::State& state, std::uint32_t f, std::uint32_t g) {
  const Face &face = state.faces[f], &other = state.faces[g];
  const auto line = common_line(face, other, state.projection);
  if (!line) return;
  const double reach = doubt(state, face, other, *line);
  if (line->surely_beside(face) || line->surely_beside(other)) return;
  FaceOverLine over_f(face, *line), over_g(other, *line);
  over_f.find_corners(*line);
  over_g.find_corners(*line);
  std::vector<double> places;
  add_changes(over_f, reach, places);
  add_changes(over_g, reach, places);
  const bool vague = reach > kWidestDoubt;
  Collector collector(state, *line, f, g, vague, {f, g});
  for (const auto& [from, to] : parts_between(places, kShortestPartMm / line->length_mm)) {
    const double middle = (from + to) / 2;
    if (!covers_both_banks(over_f, middle) || !covers_both_banks(over_g, middle)) continue;
    collector.add(from, to, !vague && covers(over_f, middle, -reach, reach) && covers(over_g, middle, -reach, reach));
  }
}

/// An edge that lies in a face, with one of its own faces before the face and another behind it: there the surface goes
/// through the face, although none of its faces does.
void cross_edge(Oracle::State& state, const Edge& edge, const Line& line, std::uint32_t g) {
  const Face& wall = state.faces[g];
  const Vector3 a = exact(edge.a), b = exact(edge.b);
  if (line.length_mm < kShortestLineMm || !line.box.meets(wall.box, 0, 0) || line.box.z0 > wall.box.z1 ||
      wall.box.z0 > line.box.z1 || line.surely_beside(wall) || !state.lies_in_plane(a, wall) ||
      !state.lies_in_plane(b, wall)) {
    return;
  }
  FaceOverLine over_wall(wall, line);
  over_wall.find_corners(line);

  // Which of the edge's faces go on before the wall, which behind it.
  struct Wing {
    std::uint32_t face;
    bool behind;
    double reach;
    bool wide;
  };
  std::vector<Wing> wings;
  for (const std::uint32_t f : edge.faces) {
    const Face& face = state.faces[f];
    if (!face.hides) continue;
    const double reach = doubt(state, face, wall, line), rise = slope(face, wall, line);
    FaceOverLine over(face, line);
    over.find_corners(line);
    for (const auto& [first, second] : over.cover(0.5)) {
      if (first == 0) wings.push_back({f, rise > 0, reach, second >= reach});
      if (second == 0) wings.push_back({f, rise < 0, reach, first <= -reach});
    }
  }
  for (const Wing& wing : wings) {
    const auto opposite = std::find_if(wings.begin(), wings.end(), [&](const Wing& w) { return w.behind != wing.behind; });
    if (opposite == wings.end()) continue;
    const double reach = std::max(wing.reach, opposite->reach);
    std::vector<double> places;
    add_changes(over_wall, reach, places);
    std::vector<std::uint32_t> own = edge.faces;
    own.push_back(g);
    const bool vague = reach > kWidestDoubt;
    Collector collector(state, line, wing.face, g, vague, own);
    for (const auto& [from, to] : parts_between(places, kShortestPartMm / line.length_mm)) {
      const double middle = (from + to) / 2;
      if (!covers_both_banks(over_wall, middle)) continue;
      collector.add(from, to, !vague && wing.wide && opposite->wide && covers(over_wall, middle, -reach, reach));
    }
  }
}

}  // namespace

void Oracle::State::find_intersections() {
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t g = f + 1; g < faces.size(); ++g) {
      const Box &a = faces[f].box, &b = faces[g].box;
      if (!faces[f].hides || !faces[g].hides || !a.meets(b, 0, 0) || a.z0 > b.z1 || b.z0 > a.z1) continue;
      cross_faces(*this, f, g);
    }
  }
  for (const Edge& edge : edges) {
    const auto line = edge.faces.size() > 1 ? line_in_view(exact(edge.a), exact(edge.b)) : std::nullopt;
    for (std::uint32_t g = 0; line && g < faces.size(); ++g) {
      if (!faces[g].hides || std::find(edge.faces.begin(), edge.faces.end(), g) != edge.faces.end()) continue;
      cross_edge(*this, edge, line->line, g);
    }
  }
}

}  // namespace oracle
