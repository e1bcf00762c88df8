#pragma once
/// Finds the occluders of each square of the page from a stream of facets, without storing them. See docs/streaming.md.

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/common/occluded_cells.hpp"

namespace ligne {

/// Number of slices into which the range of depths is divided.
inline constexpr int kSlices = 64;

/// The data of a triangle that the passes over a file need.
struct StreamFacet {
  enum class Kind : std::uint8_t {
    none,     ///< two corners coincide: no face
    outside,  ///< a part of it is out of view
    odd,      ///< seen (nearly) edge on: it covers nothing, and its sides may be lines
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
std::uint64_t merged_looks(std::uint64_t a, std::uint64_t b);
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

/// All facets are added twice, in any order and from several threads: first with add_depths(), then, after
/// find_layers(), with add(). After find_covers(), can_be_left_out() says which facets no drawing needs.
///
/// A square's facets fall into layers by their slices of depth: a layer is a run of occupied slices. For the first two
/// layers of each square a sum adds signed numbers of the facets' sides. A sum of zero means that no border of the
/// layer passes through the square; the number of facets over its centre then tells a full layer from an empty one. Two
/// different sides get the same number with a chance of 2^-64.
class PageLayers {
 public:
  static constexpr std::size_t kBytesPerSquare = 41;

  PageLayers(const PageSquares& squares, std::int64_t margin) : squares_(squares), margin_(margin), of_(squares.count()) {}

  void add_depths(const StreamFacet& facet);
  void find_layers();
  void add(const StreamFacet& facet);
  /// `blanks`: whether squares may be blank; then the sides in smooth layers are not lines. `crease_cosine`: two
  /// neighbours form a crease if the product of their normals is below it.
  void find_covers(bool blanks, double crease_cosine);
  bool can_be_left_out(const StreamFacet& facet) const;

  /// Moves the blank squares out of this object, which is empty afterwards.
  OccludedCells take_blank();
  std::size_t blank_count() const;

 private:
  static constexpr std::uint8_t kNoSlice = 0xff;
  struct Square {
    /// First the occupied slices, as bits; after find_layers() the last slices of the first two layers, a byte each;
    /// after find_covers() the last slice of the cover.
    std::atomic<std::uint64_t> slices{0};
    std::array<std::atomic<std::uint64_t>, 2> sum{};   ///< sums of signed side numbers, by layer
    std::array<std::atomic<std::uint32_t>, 2> over{};  ///< numbers of facets over the centre, by layer
    std::atomic<std::uint64_t> looks{0};               ///< looks of the first layer, see StreamFacet::looks
  };

  template <class Visit>
  void for_each_square(const StreamFacet& facet, Visit visit) const;
  static std::uint8_t layer_end(const Square& square, int layer) {
    return static_cast<std::uint8_t>(square.slices.load(std::memory_order_relaxed) >> (8 * layer));
  }

  PageSquares squares_;
  std::int64_t margin_;  ///< width added round each square, in lattice steps
  std::vector<Square> of_;
  std::vector<std::uint8_t> blank_;
};

}  // namespace ligne
