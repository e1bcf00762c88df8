#pragma once
/// Tests of depth over a window.
///
/// [Boulle1980] compares the planes of two faces at the four corners of the window, and concludes that the faces penetrate
/// if their order differs there (its case 3). That is wrong where a face ends before the planes cross; the source then uses
/// the window round the intersector instead. Here a face is compared only where it lies: first over the common part of the
/// window and the face's bounding box, which decides most pairs; then at the corners of its contour clipped by the window,
/// where the difference of two planes has its extremes.

#include "visibility/common/depth_order.hpp"
#include "visibility/warnock/analysis.hpp"

namespace ligne::warnock {

/// The result of comparing a face with another.
struct DepthComparison {
  /// `first`: the face is nowhere behind by more than the tolerance, and somewhere in front by more; `second`: the opposite;
  /// `apart`: the face has no part in the window.
  DepthOrder order = DepthOrder::apart;
  bool clear = false;  ///< the depths differ everywhere by more than the tolerance
};

struct DepthCounts {
  std::uint64_t depths = 0;       ///< computed depths
  std::uint64_t comparisons = 0;  ///< compared pairs of faces
  std::uint64_t clipped = 0;      ///< of these, pairs that needed the exact contour
  void operator+=(const DepthCounts& o) {
    depths += o.depths;
    comparisons += o.comparisons;
    clipped += o.clipped;
  }
};

/// Compares `face` (an element of the window) with the plane of `cover`, over the part of `face` in the window.
DepthComparison compare_depth(const FaceTable& table, const Element& face, const Face& cover, const WindowShape& window,
                              DepthCounts& counts);

}  // namespace ligne::warnock
