#pragma once
/// Parts whose true edges and outlines are known, with meshes of any accuracy.

#include <variant>

#include "geometry/point.hpp"
#include "support/standard.hpp"

namespace ligne::test {

/// A piece of a profile in a plane: a straight line to its end, or an arc about a centre with the body to the left of the
/// way along it. It begins where the piece before it ends.
struct ProfilePiece {
  Point2 end{0, 0};
  Point2 centre{0, 0};
  double sweep = 0;  ///< radians, positive to the left; 0 for a line
};

/// A closed way round, counter-clockwise about the body, clockwise about a hole. It begins where the last piece ends.
using Profile = std::vector<ProfilePiece>;

/// A prism over profiles in x and y, the first outer and the others holes, from z = 0 to the height.
struct Extrusion {
  std::vector<Profile> profiles;
  double height = 0;
};

/// A profile in r and z, r >= 0, turned about z. Lines on the axis are none of the body.
struct Turning {
  Profile profile;
};

struct TruePart {
  std::string name;
  std::variant<Extrusion, Turning> shape;
};

/// Twelve parts with fillets, bores, bends and cones.
std::vector<TruePart> true_parts();

/// A binary STL file. Throws std::runtime_error if it can not be written.
void write_stl(const std::vector<std::array<Point3, 3>>& triangles, const std::filesystem::path& file);

/// Writes the part as binary STL with so many facets to a turn.
void write_mesh(const TruePart& part, int facets, const std::filesystem::path& file);

enum class TrueLine : std::uint8_t { sharp, tangent, outline };

/// A sample of a true line.
struct TruePoint {
  TrueLine kind = TrueLine::sharp;
  Point3 at{0, 0, 0};
  Point3 along{0, 0, 0};  ///< the length of the line that it stands for, in its direction
  double radius = 0;      ///< sum of the radii of the curves there that meshes have chords of, whose sags add up
  bool is_cusp = false;   ///< an outline turns back there on the page, and ends in the air if what is before is seen
  std::array<Point3, 2> normals{Point3(0.0), Point3(0.0)};  ///< of the surfaces that meet at an edge, outwards
};

/// The viewer of parallel projection, by the direction towards it, or of perspective, by the eye.
struct Viewer {
  Point3 at{0, 0, 1};
  bool is_eye = false;

  /// Unit vector from a point towards the viewer.
  Point3 from(const Point3& p) const;
};

/// The edges of the part and the outlines of its curved surfaces: all of them, whatever hides them. `step`: model units
/// between samples.
std::vector<TruePoint> true_lines(const TruePart& part, const Viewer& viewer, double step);

}  // namespace ligne::test
