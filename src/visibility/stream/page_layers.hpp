#pragma once
/// Finds the covers of the squares of the page from facets that come one by one and are not stored. See
/// docs/streaming.md.

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "visibility/common/occluded_cells.hpp"
#include "visibility/stream/stream_facet.hpp"

namespace ligne {

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
