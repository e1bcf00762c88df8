#pragma once
/// The effort after which a scan gives up.

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ligne::watkins {

/// Limits the effort of a scan. If hundreds of facets overlap all over the page, each of a million events examines hundreds
/// of them. The scan of a band may examine a multiple of its points; beyond it gives up, and its work is done by grid cells.
class ScanEffort {
 public:
  explicit ScanEffort(std::size_t points) : left_(kLooksPerPoint * std::max(points, kFewPoints)) {}

  void spend(std::uint64_t looks) { left_ -= std::min(left_, looks); }
  bool spent() const { return left_ == 0; }

 private:
  // Examined elements allowed per point; smallest number of points that counts. Tuned.
  static constexpr std::uint64_t kLooksPerPoint = 8192;
  static constexpr std::size_t kFewPoints = 4096;

  std::uint64_t left_;
};

}  // namespace ligne::watkins
