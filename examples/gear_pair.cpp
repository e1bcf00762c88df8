#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "models.hpp"

namespace ligne::examples {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kModule = 5;
constexpr double kPressureAngle = 20 * kPi / 180;
constexpr double kBacklash = 0.12;  ///< by which a tooth is thinner than its gap on the pitch circle
constexpr double kWidth = 24;
constexpr int kTeeth = 28, kPinionTeeth = 17;
constexpr double kCentreDistance = kModule * (kTeeth + kPinionTeeth) / 2;
constexpr double kPlateFrom = -24, kPlateTo = -10;

double involute(double angle) { return std::tan(angle) - angle; }

/// Involute teeth (ISO 53 proportions: addendum 1, dedendum 1.25 modules). Tooth 0 stands at angle `phase`.
std::vector<Point2> teeth_outline(int teeth, double phase) {
  constexpr int flank_points = 7;
  const double pitch = kModule * teeth / 2, base = pitch * std::cos(kPressureAngle);
  const double tip = pitch + kModule, root = pitch - 1.25 * kModule;
  const double half_at_pitch = kPi / (2 * teeth) - kBacklash / (2 * pitch);
  const auto half_angle = [&](double r) {
    return half_at_pitch + involute(kPressureAngle) - involute(std::acos(std::min(1.0, base / r)));
  };
  const auto polar = [](double r, double angle) { return r * Point2(std::cos(angle), std::sin(angle)); };

  std::vector<std::pair<double, double>> flank;  // radius, half angle, from root to tip
  if (root < base) flank.emplace_back(root, half_angle(base));
  const double from = std::max(root, base);
  for (int i = 0; i < flank_points; ++i) {
    const double r = from + (tip - from) * i / (flank_points - 1);
    flank.emplace_back(r, half_angle(r));
  }
  std::vector<Point2> outline;
  for (int i = 0; i < teeth; ++i) {
    const double middle = phase + 2 * kPi * i / teeth;
    for (auto p = flank.begin(); p != flank.end(); ++p) outline.push_back(polar(p->first, middle - p->second));
    for (auto p = flank.rbegin(); p != flank.rend(); ++p) outline.push_back(polar(p->first, middle + p->second));
    outline.push_back(polar(root, middle + kPi / teeth));
  }
  return outline;
}

/// A bore with a keyway above it.
std::vector<Point2> keyed_bore(double radius, double key_width, double key_height) {
  constexpr int segments = 60;
  const double half = std::asin(key_width / 2 / radius);
  std::vector<Point2> outline;
  for (int i = 0; i <= segments; ++i) {
    const double angle = kPi / 2 + half + (2 * kPi - 2 * half) * i / segments;
    outline.push_back(radius * Point2(std::cos(angle), std::sin(angle)));
  }
  outline.emplace_back(key_width / 2, radius + key_height);
  outline.emplace_back(-key_width / 2, radius + key_height);
  return outline;
}

Solid gear() {
  Solid solid{"gear", {}, {}};
  const Frame frame;
  constexpr double web_from = 8, web_to = 16, hub_from = -6, hub_to = 32;
  const std::vector<Point2> teeth = teeth_outline(kTeeth, 0), rim = circle({0, 0}, 55, 96), hub = circle({0, 0}, 25, 72);
  const std::vector<Point2> bore = keyed_bore(14, 8, 3.3);

  const Ring teeth_low = solid.add_ring(frame, teeth, 0), teeth_high = solid.add_ring(frame, teeth, kWidth);
  const Ring rim_low = solid.add_ring(frame, rim, 0), rim_high = solid.add_ring(frame, rim, kWidth);
  const Ring rim_web_low = solid.add_ring(frame, rim, web_from), rim_web_high = solid.add_ring(frame, rim, web_to);
  const Ring hub_web_low = solid.add_ring(frame, hub, web_from), hub_web_high = solid.add_ring(frame, hub, web_to);
  const Ring hub_low = solid.add_ring(frame, hub, hub_from), hub_high = solid.add_ring(frame, hub, hub_to);
  const Ring bore_low = solid.add_ring(frame, bore, hub_from), bore_high = solid.add_ring(frame, bore, hub_to);

  std::vector<Ring> web_holes_low{hub_web_low}, web_holes_high{hub_web_high};
  constexpr int holes = 6;
  for (int i = 0; i < holes; ++i) {
    const double angle = kPi / 6 + 2 * kPi * i / holes;
    const std::vector<Point2> hole = circle(40.0 * Point2(std::cos(angle), std::sin(angle)), 10, 48);
    web_holes_low.push_back(solid.add_ring(frame, hole, web_from));
    web_holes_high.push_back(solid.add_ring(frame, hole, web_to));
    solid.add_bore_wall(web_holes_low.back(), web_holes_high.back());
  }

  solid.add_wall(teeth_low, teeth_high);
  solid.add_bottom(teeth_low, {rim_low});
  solid.add_top(teeth_high, {rim_high});
  solid.add_bore_wall(rim_low, rim_web_low);
  solid.add_bore_wall(rim_web_high, rim_high);
  solid.add_bottom(rim_web_low, web_holes_low);
  solid.add_top(rim_web_high, web_holes_high);
  solid.add_wall(hub_low, hub_web_low);
  solid.add_wall(hub_web_high, hub_high);
  solid.add_bottom(hub_low, {bore_low});
  solid.add_top(hub_high, {bore_high});
  solid.add_bore_wall(bore_low, bore_high);
  return solid;
}

Frame pinion_frame() { return {{kCentreDistance, 0, 0}}; }

Solid pinion() {
  Solid solid{"pinion", {}, {}};
  const Frame frame = pinion_frame();
  constexpr double hub_to = 32;
  // A gap of the pinion faces tooth 0 of the gear.
  const std::vector<Point2> teeth = teeth_outline(kPinionTeeth, kPi + kPi / kPinionTeeth), hub = circle({0, 0}, 25, 72);
  const Ring low = solid.add_ring(frame, teeth, 0), high = solid.add_ring(frame, teeth, kWidth);
  const Ring hub_low = solid.add_ring(frame, hub, kWidth), hub_high = solid.add_ring(frame, hub, hub_to);
  solid.add_bottom(low);
  solid.add_wall(low, high);
  solid.add_top(high, {hub_low});
  solid.add_wall(hub_low, hub_high);
  solid.add_top(hub_high);
  return solid;
}

Solid shaft() {
  Solid solid{"shaft", {}, {}};
  // Chamfered ends, and a centre hole in the front end.
  const ProfilePoint profile[] = {{0, -46}, {12.5, -46}, {14, -44.5}, {14, 48.5}, {12.5, 50}, {4, 50}, {0, 46}};
  add_turned(solid, pinion_frame(), profile, 60);
  return solid;
}

/// Outline of two circles with their common tangents.
std::vector<Point2> belt(double radius_1, double radius_2) {
  constexpr int segments = 64;
  const double lean = std::acos((radius_1 - radius_2) / kCentreDistance);
  std::vector<Point2> outline;
  for (int i = 0; i <= segments; ++i) {
    const double angle = lean + (2 * kPi - 2 * lean) * i / segments;
    outline.push_back(radius_1 * Point2(std::cos(angle), std::sin(angle)));
  }
  for (int i = 0; i <= segments; ++i) {
    const double angle = -lean + 2 * lean * i / segments;
    outline.push_back(Point2(kCentreDistance, 0) + radius_2 * Point2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

Solid plate() {
  Solid solid{"plate", {}, {}};
  const Frame frame;
  constexpr double chamfer = 2;
  const Ring low = solid.add_ring(frame, belt(96, 68), kPlateFrom);
  const Ring edge = solid.add_ring(frame, belt(96, 68), kPlateTo - chamfer);
  const Ring high = solid.add_ring(frame, belt(96 - chamfer, 68 - chamfer), kPlateTo);
  const std::vector<Point2> bore = circle({0, 0}, 17, 72);
  const Ring bore_low = solid.add_ring(frame, bore, kPlateFrom), bore_high = solid.add_ring(frame, bore, kPlateTo);
  solid.add_bottom(low, {bore_low});
  solid.add_wall(low, edge);
  solid.add_wall(edge, high);
  solid.add_top(high, {bore_high});
  solid.add_bore_wall(bore_low, bore_high);
  return solid;
}

/// Socket-head screws whose heads stand half sunk in the plate.
Solid screws() {
  Solid solid{"screws", {}, {}};
  const Point2 pinion_centre(kCentreDistance, 0);
  const auto around = [](Point2 centre, double radius, double degrees) {
    const double angle = degrees * kPi / 180;
    return centre + radius * Point2(std::cos(angle), std::sin(angle));
  };
  const Point2 places[] = {around({0, 0}, 86, 76),  around({0, 0}, 86, 140),       around({0, 0}, 86, 220),
                           around({0, 0}, 86, 284), around(pinion_centre, 58, 50), around(pinion_centre, 58, -50)};
  constexpr double head_from = kPlateTo - 4, head_to = kPlateTo + 5, socket_from = kPlateTo + 1;
  for (const Point2 place : places) {
    const std::vector<Point2> head = circle(place, 6, 36), chamfered = circle(place, 5.4, 36);
    const std::vector<Point2> socket = circle(place, 3.2, 6, kPi / 6);
    const Frame frame;
    const Ring low = solid.add_ring(frame, head, head_from), edge = solid.add_ring(frame, head, head_to - 0.6);
    const Ring high = solid.add_ring(frame, chamfered, head_to);
    const Ring socket_low = solid.add_ring(frame, socket, socket_from), socket_high = solid.add_ring(frame, socket, head_to);
    solid.add_bottom(low);
    solid.add_wall(low, edge);
    solid.add_wall(edge, high);
    solid.add_top(high, {socket_high});
    solid.add_bore_wall(socket_low, socket_high);
    solid.add_top(socket_low);
  }
  return solid;
}

}  // namespace

Model gear_pair() { return {{gear(), pinion(), shaft(), plate(), screws()}}; }

}  // namespace ligne::examples
