#pragma once
/// The covers of the squares of the page, found from facets that come one by one and are not stored. See docs/streaming.md.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "visibility/common/occluded_cells.hpp"
#include "visibility/stream/stream_facet.hpp"

namespace ligne {

/// All facets are added twice, in any order and from several threads: first their depths, then, after find_layers(), they
/// themselves; after find_covers() can_be_left_out() says which of them no drawing needs.
///
/// A square's facets fall into layers by their slices of depth: a layer is a run of slices in which something lies. Of the
/// first two layers of each square a sum of signed numbers of the facets' sides is kept: zero says that the layer covers the
/// square, or that nothing of it does, and a count of the facets over the middle which of the two. Two sides that are not
/// one have the same number with a chance of 2^-64.
class PageLayers {
 public:
  static constexpr std::size_t kBytesPerSquare = 41;

  PageLayers(const PageSquares& squares, std::int64_t margin) : squares_(squares), margin_(margin), of_(squares.count()) {}

  void add_depths(const StreamFacet& facet);
  void find_layers();
  void add(const StreamFacet& facet);
  /// `blanks`: whether squares may be blank; the sides of smooth layers are no lines then. `crease_cosine`: normals of
  /// neighbours whose product is below it make a crease.
  void find_covers(bool blanks, double crease_cosine);
  bool can_be_left_out(const StreamFacet& facet) const;

  /// To be called in the end: empties this.
  OccludedCells take_blank();
  std::size_t blank_count() const;

 private:
  static constexpr std::uint8_t kNoSlice = 0xff;
  struct Square {
    /// First the slices in which something lies, as bits; then the last slices of the first two layers, a byte each; then
    /// that of the cover.
    std::atomic<std::uint64_t> slices{0};
    std::array<std::atomic<std::uint64_t>, 2> sum{};   ///< of signed sides, by layer
    std::array<std::atomic<std::uint32_t>, 2> over{};  ///< facets over the middle, by layer
    std::atomic<std::uint64_t> looks{0};               ///< of the first layer, see StreamFacet::looks
  };

  template <class Visit>
  void for_each_square(const StreamFacet& facet, Visit visit) const;
  static std::uint8_t layer_end(const Square& square, int layer) {
    return static_cast<std::uint8_t>(square.slices.load(std::memory_order_relaxed) >> (8 * layer));
  }

  PageSquares squares_;
  std::int64_t margin_;  ///< steps by which squares are widened
  std::vector<Square> of_;
  std::vector<std::uint8_t> blank_;
};

}  // namespace ligne
