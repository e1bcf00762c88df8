#include "picture/choice/face_spread.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Largest number of overlapping pairs along the privileged axis, as a part of those along the next one. Below a half the
/// two differ by more than the shape of the picture explains: that of a page differs from a square by a third.
constexpr double kPrivilegedPart = 0.5;

/// The number of pairs of faces of which one ends before the other begins.
std::uint64_t pairs_apart(std::span<const FaceExtent> faces, std::size_t axis) {
  std::vector<double> begins, ends;
  begins.reserve(faces.size());
  ends.reserve(faces.size());
  for (const FaceExtent& f : faces) {
    begins.push_back(f.low[axis]);
    ends.push_back(f.high[axis]);
  }
  std::sort(begins.begin(), begins.end());
  std::sort(ends.begin(), ends.end());
  std::uint64_t pairs = 0;
  std::size_t ended = 0;
  for (const double begin : begins) {
    while (ended < ends.size() && ends[ended] < begin) ++ended;
    pairs += ended;
  }
  return pairs;
}

}  // namespace

FaceSpread spread_of(std::span<const FaceExtent> faces) {
  FaceSpread spread;
  if (faces.size() < 2) return spread;
  const std::uint64_t n = faces.size(), all = n * (n - 1) / 2;
  std::array<std::uint64_t, 3> together{};
  parallel_tasks(3, [&](std::size_t axis) { together[axis] = all - pairs_apart(faces, axis); });
  std::size_t least = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    spread.apart[axis] = double(all - together[axis]) / double(all);
    if (together[axis] < together[least]) least = axis;
  }
  const std::uint64_t next = std::min(together[(least + 1) % 3], together[(least + 2) % 3]);
  if (double(together[least]) <= kPrivilegedPart * double(next) && together[least] < next) {
    spread.privileged = static_cast<int>(least);
  }
  return spread;
}

}  // namespace ligne
