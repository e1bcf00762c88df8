#pragma once
/// How much a scan may look at before it gives up.

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ligne::watkins {

/// Where hundreds of facets lie over each other on all of the page, each of a million events looks at hundreds of them. So
/// the scan of a band may look at a multiple of its points and no more; then it gives up, and what it was to find is looked
/// for cell by cell.
class ScanEffort {
 public:
  explicit ScanEffort(std::size_t points) : left_(kLooksPerPoint * std::max(points, kFewPoints)) {}

  void spend(std::uint64_t looks) { left_ -= std::min(left_, looks); }
  bool spent() const { return left_ == 0; }

 private:
  // Adjustable. Fewer points count as kFewPoints.
  static constexpr std::uint64_t kLooksPerPoint = 8192;
  static constexpr std::size_t kFewPoints = 4096;

  std::uint64_t left_;
};

}  // namespace ligne::watkins
