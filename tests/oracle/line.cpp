#include "oracle/parts.hpp"

namespace oracle {

Line::Line(const PagePoint& from, const PagePoint& to, const Projection& projection)
    : a(from), b(to), dx(to.x - from.x), dy(to.y - from.y) {
  const double x_mm = to_double(dx) * projection.mm_x(), y_mm = to_double(dy) * projection.mm_y();
  length_mm = std::hypot(x_mm, y_mm);
  box.add(a);
  box.add(b);
  if (length_mm == 0) return;
  ox = Exact(-y_mm / length_mm * kMicrometre / projection.mm_x());
  oy = Exact(x_mm / length_mm * kMicrometre / projection.mm_y());
  det_ = dx * oy - dy * ox;
  a_mm = projection.page_mm(a);
  direction_mm = {x_mm / length_mm, y_mm / length_mm};
}

bool Line::surely_beside(const Face& face) const {
  // Page coordinates have errors of 2^-52 of their size and few roundings follow.
  constexpr double kRoundings = 0x1p-44;
  bool left = true, right = true;
  for (const Point2& p : face.corners_mm) {
    const double x = p.x - a_mm.x, y = p.y - a_mm.y, across = direction_mm.x * y - direction_mm.y * x;
    const double margin =
        2 * kMicrometre + kRoundings * (std::abs(p.x) + std::abs(p.y) + std::abs(a_mm.x) + std::abs(a_mm.y));
    left = left && across > margin;
    right = right && across < -margin;
  }
  return left || right;
}

FaceOverLine::FaceOverLine(const Face& f, const Line& line)
    : face(&f), behind_a(line.a.z - f.plane.z(line.a.x, line.a.y)), behind_b(line.b.z - f.plane.z(line.b.x, line.b.y)) {}

void FaceOverLine::find_corners(const Line& line) {
  corners.reserve(face->corners.size());
  for (const PagePoint& p : face->corners) {
    Corner corner{line.tau(p), line.s(p)};
    corner.tau_rounded = to_double(corner.tau);
    corner.s_rounded = to_double(corner.s);
    corners.push_back(std::move(corner));
  }
}

// The cross-section meets a side when one end of it is beyond tau and the other is not; between the places sorted by s the
// face is entered and left in turn.
std::vector<std::pair<Exact, Exact>> FaceOverLine::cover(double tau) const {
  std::vector<Exact> crossings;
  const Exact here(tau);
  for (const auto& [i, k] : face->sides) {
    const Corner &p = corners[i], &q = corners[k];
    if ((p.tau > here) == (q.tau > here)) continue;
    crossings.push_back(p.s == q.s ? p.s : p.s + (here - p.tau) * (q.s - p.s) / (q.tau - p.tau));
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<Exact, Exact>> parts;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    if (!parts.empty() && parts.back().second == crossings[k]) {
      parts.back().second = crossings[k + 1];  // two sides that lie on each other: nothing is between them
    } else {
      parts.emplace_back(crossings[k], crossings[k + 1]);
    }
  }
  return parts;
}

namespace {

using Corner = FaceOverLine::Corner;

/// Where the segment from p to q has the height `level` in s; requires that its ends are on different sides of it.
double tau_at(const Corner& p, const Corner& q, double level) {
  return p.tau_rounded + (level - p.s_rounded) / (q.s_rounded - p.s_rounded) * (q.tau_rounded - p.tau_rounded);
}

bool within_line(double tau) { return tau > 0 && tau < 1; }

/// A side's part near the line: from and to in tau, with its s there.
struct NearPart {
  double tau0, tau1, s0, s1;
};

std::optional<NearPart> near_part(const Corner& p, const Corner& q, double reach) {
  double from = 0, to = 1;                               // parameters on the side
  const auto clip = [&](double value0, double value1) {  // keeps where the value, linear along the side, is not negative
    if (value0 < 0 && value1 < 0) to = -1;
    if (value0 < 0 && value1 >= 0) from = std::max(from, value0 / (value0 - value1));
    if (value0 >= 0 && value1 < 0) to = std::min(to, value0 / (value0 - value1));
  };
  clip(reach - p.s_rounded, reach - q.s_rounded);
  clip(reach + p.s_rounded, reach + q.s_rounded);
  clip(p.tau_rounded, q.tau_rounded);
  clip(1 - p.tau_rounded, 1 - q.tau_rounded);
  if (from >= to) return {};
  const auto at = [&](double u, double v0, double v1) { return v0 + u * (v1 - v0); };
  NearPart part{at(from, p.tau_rounded, q.tau_rounded), at(to, p.tau_rounded, q.tau_rounded),
                at(from, p.s_rounded, q.s_rounded), at(to, p.s_rounded, q.s_rounded)};
  if (part.tau0 > part.tau1) part = {part.tau1, part.tau0, part.s1, part.s0};
  return part;
}

}  // namespace

void add_changes(const FaceOverLine& over, double reach, std::vector<double>& places) {
  const auto add = [&](double tau) {
    if (within_line(tau)) places.push_back(tau);
  };
  for (const auto& [i, k] : over.face->sides) {
    const Corner &p = over.corners[i], &q = over.corners[k];
    for (const double level : {-reach, 0.0, reach})
      if ((p.s_rounded < level) != (q.s_rounded < level)) add(tau_at(p, q, level));
    if (std::abs(p.s_rounded) <= reach) add(p.tau_rounded);
  }
  const double behind_a = to_double(over.behind_a), behind_b = to_double(over.behind_b);
  for (const double level : {-over.delta, 0.0, over.delta})
    if ((behind_a < level) != (behind_b < level)) add((level - behind_a) / (behind_b - behind_a));
}

void add_crossings(const std::vector<FaceOverLine>& faces, double reach, double longest, std::vector<double>& places) {
  std::vector<NearPart> sides;
  for (const FaceOverLine& over : faces) {
    for (const auto& [i, k] : over.face->sides) {
      const auto part = near_part(over.corners[i], over.corners[k], reach);
      if (part && part->tau1 - part->tau0 > longest) sides.push_back(*part);
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const NearPart &a = sides[i], &b = sides[k];
      const double from = std::max(a.tau0, b.tau0), to = std::min(a.tau1, b.tau1);
      if (from >= to) continue;
      const auto gap = [&](double tau) {
        const auto s = [&](const NearPart& p) { return p.s0 + (tau - p.tau0) / (p.tau1 - p.tau0) * (p.s1 - p.s0); };
        return s(a) - s(b);
      };
      const double gap0 = gap(from), gap1 = gap(to);
      if ((gap0 < 0) != (gap1 < 0)) places.push_back(from + gap0 / (gap0 - gap1) * (to - from));
    }
  }
}

std::vector<std::array<double, 2>> parts_between(std::vector<double> places, double shortest) {
  places.insert(places.end(), {0.0, 1.0});
  std::sort(places.begin(), places.end());
  std::vector<std::array<double, 2>> parts;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (places[i + 1] - places[i] > shortest) parts.push_back({places[i], places[i + 1]});
  return parts;
}

}  // namespace oracle
