#pragma once
/// A triangle on its way from the file to the page.

#include <array>
#include <cstdint>

#include "view/projected_scene.hpp"

namespace ligne {

/// Number of slices into which the range of depths is divided.
inline constexpr int kSlices = 64;

/// The data of a triangle that the passes over a file need.
struct StreamFacet {
  enum class Kind : std::uint8_t {
    none,     ///< two corners coincide: no face
    outside,  ///< a part of it is out of view
    odd,      ///< seen edge on, or nearly so: it covers nothing, and its sides may be lines
    plain,
  };
  Kind kind = Kind::none;
  std::array<LatticePoint, 3> p{};         ///< corners, clockwise on the page if the kind is plain
  std::array<std::uint64_t, 3> corner{};   ///< number of the corner's place in space
  std::uint8_t nearest = 0, farthest = 0;  ///< first and last slice that it occupies, tolerances included
  std::uint64_t looks = 0;                 ///< see packed_look()
};

/// Orientations of facets, packed so that many can be merged: six bytes with the largest components of the normals
/// along x, -x, y, -y, z, -z, from 0 for -1 to 254 for 1, and then these bits.
enum LookBit : std::uint64_t {
  kLooksOdd = std::uint64_t{1} << 48,
  kLooksHere = std::uint64_t{1} << 49,   ///< some face faces the viewer
  kLooksAway = std::uint64_t{1} << 50,   ///< some face faces away
  kLooksRight = std::uint64_t{1} << 51,  ///< some face is wound clockwise on the page
  kLooksLeft = std::uint64_t{1} << 52,
};
std::uint64_t packed_look(const Point3& unit_normal, std::uint64_t bits);
std::uint64_t put_together(std::uint64_t a, std::uint64_t b);
/// Whether no two of the merged faces can form an outline or a crease as neighbours: none is odd, all face one way, and
/// no two normals have a product below the cosine.
bool look_alike(std::uint64_t looks, double crease_cosine);

/// Makes facets from the triangles of a scene that is not in memory.
class StreamFacets {
 public:
  /// `precision`: Object::precision; `largest`: largest coordinate; `near`, `far`: range of depths in view, in mm.
  StreamFacets(const View& view, double precision, double largest, double near, double far);

  StreamFacet make(const Point3* corners) const;
  /// The place of a point on the page, and its depth, in mm.
  std::array<double, 3> page_place(const Point3& p) const;
  const ProjectedScene& page() const { return page_; }
  /// Width added round each square, in lattice steps.
  std::int64_t margin() const { return margin_; }

 private:
  std::uint8_t slice(double z) const;

  ProjectedScene page_;  ///< only its view, lattice and tolerances; it has no faces
  double precision_, sight_rounding_, near_, per_mm_, pad_mm_, least_height_;
  std::int64_t margin_;
};

/// Number of a place: equal for equal places; two different places get one number with a chance of 2^-64.
std::uint64_t place_number(const Point3& p);

}  // namespace ligne
