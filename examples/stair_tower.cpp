#include <array>
#include <cmath>
#include <numbers>

#include "models.hpp"

namespace ligne::examples {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kStepsPerTurn = 18, kSteps = 40;
constexpr double kStepAngle = 2 * kPi / kStepsPerTurn, kRiser = 0.17;
constexpr double kStairRadius = 1.75, kRailRadius = 1.66;
constexpr int kColumns = 8;
constexpr double kColumnCircle = 2.75, kEaves = 7.6;

void add_turned_quads(Solid& solid, const Frame& frame, std::span<const ProfilePoint> profile, int segments) {
  add_turned(solid, frame, profile, segments, Annuli::quadrilaterals);
}

Point2 polar(double r, double angle) { return r * Point2(std::cos(angle), std::sin(angle)); }

Solid plinth() {
  Solid solid{"plinth", {}, {}};
  const ProfilePoint profile[] = {{0, -0.54},    {3.9, -0.54}, {3.9, -0.36}, {3.55, -0.36},
                                  {3.55, -0.18}, {3.2, -0.18}, {3.2, 0},     {0, 0}};
  add_turned_quads(solid, {}, profile, 64);
  return solid;
}

Solid newel() {
  Solid solid{"newel", {}, {}};
  const ProfilePoint profile[] = {{0, -0.05},   {0.4, -0.05},         {0.4, 0.12},
                                  {0.28, 0.22}, {0.28, kEaves + 0.1}, {0, kEaves + 0.1}};
  add_turned_quads(solid, {}, profile, 36);
  return solid;
}

/// Wedge-shaped slats, each reaching a little under the next and into the newel.
Solid steps() {
  Solid solid{"steps", {}, {}};
  constexpr double inner = 0.2, thickness = 0.06, nosing = 0.25;
  constexpr int rim_pieces = 3;
  for (int i = 0; i < kSteps; ++i) {
    const double from = kStepAngle * (i - nosing), to = kStepAngle * (i + 1);
    std::vector<Point2> outline{polar(inner, from)};
    for (int k = 0; k <= rim_pieces; ++k) outline.push_back(polar(kStairRadius, from + (to - from) * k / rim_pieces));
    outline.push_back(polar(inner, to));
    const double top = kRiser * (i + 1);
    solid.add_prism({}, outline, top - thickness, top);
  }
  return solid;
}

/// Height of the middle of the rail above the floor at an angle.
double rail_height(double angle) { return kRiser * (angle / kStepAngle + 0.5) + 0.95; }

Solid balusters() {
  Solid solid{"balusters", {}, {}};
  for (int i = 0; i < kSteps; ++i) {
    const double angle = kStepAngle * (i + 0.5);
    solid.add_prism({}, circle(polar(kRailRadius, angle), 0.022, 13, angle), kRiser * (i + 1) - 0.03, rail_height(angle));
  }
  return solid;
}

/// A helical rail of rectangular section. Its upper and lower sides are twisted, so all sides are triangles.
Solid rail() {
  Solid solid{"rail", {}, {}};
  constexpr double half_width = 0.045, half_height = 0.03;
  constexpr int pieces_per_step = 3, pieces = (kSteps - 1) * pieces_per_step;
  std::vector<Ring> sections;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = kStepAngle * (0.5 + static_cast<double>(i) / pieces_per_step);
    const double h = rail_height(angle);
    Ring section;
    for (const auto& [dr, dh] : {std::pair{-half_width, -half_height},
                                 {half_width, -half_height},
                                 {half_width, half_height},
                                 {-half_width, half_height}}) {
      section.push_back(static_cast<std::uint32_t>(solid.vertices.size()));
      solid.vertices.push_back(Frame{}.at(polar(kRailRadius + dr, angle), h + dh));
    }
    if (!sections.empty()) {
      const Ring& last = sections.back();
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        solid.faces.push_back({{last[next], last[k], section[k]}, {}});
        solid.faces.push_back({{last[next], section[k], section[next]}, {}});
      }
    }
    sections.push_back(std::move(section));
  }
  solid.add_top(sections.front());
  solid.add_bottom(sections.back());
  return solid;
}

Solid columns() {
  Solid solid{"columns", {}, {}};
  const ProfilePoint profile[] = {{0, -0.05},    {0.25, -0.05}, {0.25, 0.12},  {0.21, 0.16},  {0.21, 0.24},
                                  {0.15, 0.32},  {0.15, 2.6},   {0.125, 6.5},  {0.15, 6.52},  {0.15, 6.6},
                                  {0.125, 6.62}, {0.125, 6.72}, {0.235, 6.86}, {0.235, 7.02}, {0, 7.02}};
  for (int i = 0; i < kColumns; ++i) {
    Frame frame;
    frame.origin = frame.at(polar(kColumnCircle, 2 * kPi * (i + 0.5) / kColumns), 0);
    add_turned_quads(solid, frame, profile, 16);
  }
  return solid;
}

Solid entablature() {
  Solid solid{"entablature", {}, {}};
  const ProfilePoint profile[] = {{2.5, 7},     {3.0, 7},     {3.0, 7.2},     {3.04, 7.2},
                                  {3.04, 7.45}, {3.25, 7.55}, {3.25, kEaves}, {2.5, kEaves}};
  add_turned_quads(solid, {}, profile, 64);
  return solid;
}

constexpr double kDomeRadius = 2.85, kDomeBase = kEaves + 0.2;

Solid dome() {
  Solid solid{"dome", {}, {}};
  constexpr int rings = 10;
  std::vector<ProfilePoint> profile{
      {0, kEaves - 0.05}, {kDomeRadius + 0.12, kEaves - 0.05}, {kDomeRadius + 0.12, kDomeBase}, {kDomeRadius, kDomeBase}};
  for (int i = 1; i < rings; ++i) {
    const double angle = kPi / 2 * i / rings;
    profile.push_back({kDomeRadius * std::cos(angle), kDomeBase + kDomeRadius * std::sin(angle)});
  }
  profile.push_back({0, kDomeBase + kDomeRadius});
  add_turned_quads(solid, {}, profile, 48);
  return solid;
}

/// Ribs over the dome, above the columns; their lower edge lies inside the dome.
Solid ribs() {
  Solid solid{"ribs", {}, {}};
  constexpr int pieces = 16;
  constexpr double half_width = 0.06, outer = kDomeRadius + 0.07, inner = kDomeRadius - 0.1;
  constexpr double last_angle = 80 * kPi / 180;
  for (int i = 0; i < kColumns; ++i) {
    const double around = 2 * kPi * (i + 0.5) / kColumns;
    const Point2 out = polar(1, around), side(-out.y, out.x);
    std::vector<Ring> sections;
    for (int k = 0; k <= pieces; ++k) {
      const double angle = last_angle * k / pieces;
      Ring section;
      for (const auto& [r, s] :
           {std::pair{inner, -half_width}, {outer, -half_width}, {outer, half_width}, {inner, half_width}}) {
        section.push_back(static_cast<std::uint32_t>(solid.vertices.size()));
        solid.vertices.push_back(Frame{}.at(r * std::cos(angle) * out + s * side, kDomeBase - 0.03 + r * std::sin(angle)));
      }
      if (!sections.empty()) solid.add_wall(sections.back(), section);
      sections.push_back(std::move(section));
    }
    solid.add_bottom(sections.front());
    solid.add_top(sections.back());
  }
  return solid;
}

Solid lantern() {
  Solid solid{"lantern", {}, {}};
  constexpr double base = kDomeBase + kDomeRadius;
  std::vector<ProfilePoint> profile{{0, base - 0.2},     {0.62, base - 0.2}, {0.62, base + 0.06}, {0.46, base + 0.12},
                                    {0.46, base + 0.75}, {0.6, base + 0.82}, {0.6, base + 0.9},   {0.42, base + 1.08},
                                    {0.2, base + 1.25},  {0.06, base + 1.4}, {0.04, base + 1.5}};
  constexpr double ball = 0.12, ball_centre = base + 1.5 + 0.11;
  for (int i = 1; i <= 7; ++i) {
    const double angle = -kPi / 2 + kPi * (i + 0.9) / 9;
    profile.push_back({ball * std::cos(angle), ball_centre + ball * std::sin(angle)});
  }
  profile.push_back({0, ball_centre + ball});
  add_turned_quads(solid, {}, profile, 30);
  return solid;
}

}  // namespace

Model stair_tower() {
  return {{plinth(), newel(), steps(), balusters(), rail(), columns(), entablature(), dome(), ribs(), lantern()}};
}

}  // namespace ligne::examples
