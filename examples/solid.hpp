#pragma once
/// Building blocks of the example models: closed solids of polygon faces with holes.
///
/// Notation: a solid is built in a frame (origin, x, y, axis), right-handed; `h` runs along the axis. A ring is a list of
/// vertices that turns counter-clockwise seen from the tip of the axis.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace ligne::examples {

using Point2 = glm::dvec2;
using Point3 = glm::dvec3;
using Ring = std::vector<std::uint32_t>;

struct Frame {
  Point3 origin{0, 0, 0};
  Point3 x{1, 0, 0}, y{0, 1, 0}, axis{0, 0, 1};

  Point3 at(Point2 p, double h) const { return origin + x * p.x + y * p.y + axis * h; }
};

struct Face {
  Ring outer;
  std::vector<Ring> holes;
};

/// One object of a model.
struct Solid {
  std::string name;
  std::vector<Point3> vertices;
  std::vector<Face> faces;

  Ring add_ring(const Frame& frame, std::span<const Point2> outline, double h);
  /// Side walls between two rings of one length, `upper` further along the axis; outside is away from the axis, or towards
  /// it for the wall of a bore. Quadrilaterals, and two triangles where rounding would bend one.
  void add_wall(const Ring& lower, const Ring& upper);
  void add_bore_wall(const Ring& lower, const Ring& upper);
  /// A flat face that looks along the axis, or against it.
  void add_top(const Ring& outer, const std::vector<Ring>& holes = {});
  void add_bottom(const Ring& outer, const std::vector<Ring>& holes = {});
  /// A straight prism over the outline.
  void add_prism(const Frame& frame, std::span<const Point2> outline, double from, double to);
};

/// A point of a profile that is turned about the axis.
struct ProfilePoint {
  double r = 0, h = 0;
};

/// Turns a profile, written counter-clockwise in (r, h). A profile that begins and ends on the axis (r = 0) gives a full
/// body, any other is closed from its last point to its first and gives a ring.
enum class Annuli { faces_with_holes, quadrilaterals };
void add_turned(Solid& solid, const Frame& frame, std::span<const ProfilePoint> profile, int segments,
                Annuli annuli = Annuli::faces_with_holes);

/// Regular polygon; the first corner lies at angle `phase`.
std::vector<Point2> circle(Point2 centre, double radius, int segments, double phase = 0);

struct Model {
  std::vector<Solid> solids;
};

/// The files' text. Lengths are rounded to a ten-thousandth of a unit, so that the bytes do not depend on the last bit of a
/// sine. OBJ has no faces with holes.
std::string scene_text(const Model& model);
std::string obj_text(const Model& model);

}  // namespace ligne::examples
