#include <cmath>
#include <numbers>

#include "models.hpp"

namespace ligne::examples {
namespace {

constexpr int kPipeSegments = 96;
const Frame kRight{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
const Frame kLeft{{0, 0, 0}, {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};
const Frame kUp{};

Solid run_pipe() {
  Solid solid{"run", {}, {}};
  // Bore 64, wall 8, weld-neck flanges with a raised face at both ends.
  const ProfilePoint profile[] = {{32, -122}, {52, -122}, {52, -120}, {76, -120}, {76, -104}, {50, -104}, {40, -92},
                                  {40, 92},   {50, 104},  {76, 104},  {76, 120},  {52, 120},  {52, 122},  {32, 122}};
  add_turned(solid, kRight, profile, kPipeSegments);
  return solid;
}

Solid branch() {
  Solid solid{"branch", {}, {}};
  // Its foot ends inside the wall of the run: above the bore (32) and below the outside at its own radius (33.4).
  constexpr double foot = 32.6;
  const ProfilePoint profile[] = {{16, foot}, {22, foot}, {22, 83},  {31, 94}, {56, 94},
                                  {56, 108},  {36, 108},  {36, 110}, {16, 110}};
  add_turned(solid, kUp, profile, kPipeSegments);
  return solid;
}

/// Studs with a nut on either side of a flange that reaches from `from` to `to`.
Solid studs(const std::string& name, const Frame& flange, int count, double circle_radius, double from, double to) {
  constexpr double pi = std::numbers::pi;
  constexpr double stud_radius = 4.5, nut_radius = 9, nut_height = 8, sunk = 1, end = 5, chamfer = 1;
  Solid solid{name, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + 0.5) / count;
    Frame frame = flange;
    frame.origin = flange.at(circle_radius * Point2(std::cos(angle), std::sin(angle)), 0);
    const double low = from - nut_height - end, high = to + nut_height + end;
    const ProfilePoint profile[] = {{0, low},
                                    {stud_radius - chamfer, low},
                                    {stud_radius, low + chamfer},
                                    {stud_radius, high - chamfer},
                                    {stud_radius - chamfer, high},
                                    {0, high}};
    add_turned(solid, frame, profile, 24);
    const std::vector<Point2> hexagon = circle({0, 0}, nut_radius, 6, angle);
    solid.add_prism(frame, hexagon, from - nut_height, from + sunk);
    solid.add_prism(frame, hexagon, to - sunk, to + nut_height);
  }
  return solid;
}

}  // namespace

Model pipe_tee() {
  return {{run_pipe(), branch(), studs("studs right", kRight, 8, 64, 104, 120), studs("studs left", kLeft, 8, 64, 104, 120),
           studs("studs top", kUp, 6, 46, 94, 108)}};
}

}  // namespace ligne::examples
