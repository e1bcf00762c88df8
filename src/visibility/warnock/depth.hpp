#pragma once
/// Tests of depth over a window.
///
/// [Boulle1980] compares the planes of two faces at the four corners of the window, and concludes that they penetrate when
/// they change places there (its case 3). That is wrong where a face ends before the planes cross; it then took the window
/// round the intersector instead. Here a face is compared where it is: first over the common part of the window and of the
/// box round the face, which decides most pairs, then at the corners of its contour cut by the window, where the difference
/// of two planes has its extremes.

#include "visibility/common/depth_order.hpp"
#include "visibility/warnock/analysis.hpp"

namespace ligne::warnock {

/// Whether it is behind by more than the tolerance all over; what touches anywhere is not.
struct DepthComparison {
  /// One face, the first, to another. `first`: nowhere behind it by more than the tolerance, somewhere before it by more;
  /// `second`: the other way round; `apart`: it has no part in the window.
  DepthOrder order = DepthOrder::apart;
  bool clear = false;  ///< nowhere within the tolerance
};

struct DepthCounts {
  std::uint64_t depths = 0;       ///< depths computed
  std::uint64_t comparisons = 0;  ///< pairs of faces
  std::uint64_t clipped = 0;      ///< of them those that needed the exact contour
  void operator+=(const DepthCounts& o) {
    depths += o.depths;
    comparisons += o.comparisons;
    clipped += o.clipped;
  }
};

/// `face` (an element of the window) to the plane of `cover`, over what `face` has of the window.
DepthComparison compare_depth(const FaceTable& table, const Element& face, const Face& cover, const Window& window,
                              DepthCounts& counts);

}  // namespace ligne::warnock
