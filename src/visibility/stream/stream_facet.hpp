#pragma once
/// A triangle on its way from the file to the page.

#include <array>
#include <cstdint>

#include "view/projected_scene.hpp"

namespace ligne {

/// Depths are counted in so many slices.
inline constexpr int kSlices = 64;

/// The facts that the passes over a file need of a triangle.
struct StreamFacet {
  enum class Kind : std::uint8_t {
    none,     ///< two corners in one place: no face
    outside,  ///< part of it is not in view
    odd,      ///< seen edge on, or nearly so: it covers nothing, and its sides may be lines
    plain,
  };
  Kind kind = Kind::none;
  std::array<LatticePoint, 3> p{};         ///< clockwise on the page where the kind is plain
  std::array<std::uint64_t, 3> corner{};   ///< number of the corner's place in space
  std::uint8_t nearest = 0, farthest = 0;  ///< slices that it lies in, with its tolerances
  std::uint64_t looks = 0;                 ///< see add_looks()
};

/// Which way facets look, packed so that those of many can be put together: six bytes with the largest of the normals'
/// components along x, -x, y, -y, z, -z, from 0 for -1 to 254 for 1; a byte of bits.
enum LookBit : std::uint64_t {
  kLooksOdd = std::uint64_t{1} << 48,
  kLooksHere = std::uint64_t{1} << 49,   ///< a face looks at the viewer
  kLooksAway = std::uint64_t{1} << 50,   ///< one looks away
  kLooksRight = std::uint64_t{1} << 51,  ///< one is wound clockwise on the page
  kLooksLeft = std::uint64_t{1} << 52,
};
std::uint64_t packed_look(const Point3& unit_normal, std::uint64_t bits);
std::uint64_t put_together(std::uint64_t a, std::uint64_t b);
/// Whether all looks that were put together are of faces that neighbours make neither outlines nor creases with: none is
/// odd, all look one way, and no two normals have a product below the cosine.
bool look_alike(std::uint64_t looks, double crease_cosine);

/// Makes facets of the triangles of a scene that is not in memory.
class StreamFacets {
 public:
  /// `precision`: Object::precision; `largest`: coordinate; `near`, `far`: depths of all that is in view, in mm.
  StreamFacets(const View& view, double precision, double largest, double near, double far);

  StreamFacet make(const Point3* corners) const;
  /// Where a point of space is drawn, and its depth; in mm.
  std::array<double, 3> page_place(const Point3& p) const;
  const ProjectedScene& page() const { return page_; }
  /// Steps by which squares are widened.
  std::int64_t margin() const { return margin_; }

 private:
  std::uint8_t slice(double z) const;

  ProjectedScene page_;  ///< without a scene: view, lattice and tolerances
  struct Volume;
  double precision_, sight_rounding_, near_, per_mm_, pad_mm_, least_height_;
  std::int64_t margin_;
};

/// Number of a place: equal for equal places, else different but for a chance of 2^-64.
std::uint64_t place_number(const Point3& p);

}  // namespace ligne
