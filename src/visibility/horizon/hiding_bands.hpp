#pragma once
/// Horizons of bands of columns, which work in parallel. A band uses only the part of an edge over its columns, so no
/// band waits for another. All bands take the edges in the same order.

#include <vector>

#include "base/parallel.hpp"
#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/horizons.hpp"

namespace ligne::horizon {

template <class Horizon>
class HidingBands {
 public:
  explicit HidingBands(const Bands& bands) {
    for (std::size_t b = 0; b < bands.size(); ++b) bands_.push_back({Horizon(bands.columns(), bands.of_band(b)), {}, {}});
  }

  /// Finds the visible parts of the edges of the lists, in order.
  void take(std::vector<EdgeList>& lists) {
    parallel_tasks(bands_.size(), [&](std::size_t b) {
      for (EdgeList& list : lists) take(list, b);
    });
  }

  /// Largest gap over which spans of two bands are joined.
  double least() const { return bands_.front().horizon.least(); }

 private:
  struct Band {
    Horizon horizon;
    std::vector<Span> above, below;  ///< scratch
  };

  void take(EdgeList& list, std::size_t b) {
    Band& band = bands_[b];
    for (const std::uint32_t number : list.of_band[b]) {
      if constexpr (Horizon::kCovers) {
        if (number & EdgeList::kTriangle) {
          band.horizon.cover(list.triangles[number & ~EdgeList::kTriangle]);
          continue;
        }
      }
      HorizonEdge& edge = list.edges[number];
      if (edge.is_tested() && edge.first_band <= b && b <= edge.last_band) {
        band.above.clear();
        band.below.clear();
        const bool open = band.horizon.find_seen(edge, band.above, band.below);
        if (edge.line.upright()) edge.open = open;  // an upright line lies in one band
        for (const Span& span : band.above) list.seen[b].push_back({number, false, span});
        for (const Span& span : band.below) list.seen[b].push_back({number, true, span});
      }
      if constexpr (!Horizon::kCovers) {
        if (edge.upper || edge.lower) band.horizon.raise(edge);
      }
    }
  }

  std::vector<Band> bands_;
};

}  // namespace ligne::horizon
