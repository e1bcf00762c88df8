#include "visibility/horizon/grid_axis.hpp"

#include <algorithm>
#include <numeric>

namespace ligne::horizon {
namespace {

/// Distance, as a part of the axis, within which an eye counts as over a sample.
constexpr double kSamePart = 0x1p-40;

std::optional<double> to_near_sample(const std::vector<double>& samples, std::optional<double> eye) {
  if (!eye) return eye;
  const auto above = std::lower_bound(samples.begin(), samples.end(), *eye);
  const double least = kSamePart * (samples.back() - samples.front());
  if (above != samples.end() && *above - *eye <= least) return *above;
  if (above != samples.begin() && *eye - *(above - 1) <= least) return *(above - 1);
  return eye;
}

}  // namespace

GridAxis::GridAxis(const std::vector<double>& samples, std::size_t stride, std::optional<double> eye)
    : sample_count(samples.size()), eye_(to_near_sample(samples, eye)) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    at.push_back(samples[i]);
    sample.push_back(i);
    fraction.push_back(0);
    drawn.push_back(stride != 0 && (i % stride == 0 || i + 1 == samples.size()));
    if (eye_ && i + 1 < samples.size() && samples[i] < *eye_ && *eye_ < samples[i + 1]) {
      at.push_back(*eye_);
      sample.push_back(i);
      fraction.push_back((*eye_ - samples[i]) / (samples[i + 1] - samples[i]));
      drawn.push_back(false);
    }
  }
}

std::vector<GridAxis::Part> GridAxis::parts(double forward) const {
  std::vector<std::size_t> ascending(at.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  const auto away = [&](double sign) {
    Part part{ascending, sign};
    if (sign < 0) std::reverse(part.order.begin(), part.order.end());
    return part;
  };
  if (!eye_) return {away(forward < 0 ? -1 : 1)};
  if (*eye_ <= at.front()) return {away(1)};
  if (*eye_ >= at.back()) return {away(-1)};
  const auto here = std::lower_bound(at.begin(), at.end(), *eye_) - at.begin();
  const std::size_t beyond = fraction[static_cast<std::size_t>(here)] > 0 ? 0 : 1;
  const auto extra = static_cast<std::ptrdiff_t>(beyond);
  Part up{{ascending.begin() + here - extra, ascending.end()}, 1, beyond},
      down{{ascending.begin(), ascending.begin() + here + 1 + extra}, -1, beyond};
  std::reverse(down.order.begin(), down.order.end());
  return {up, down};
}

}  // namespace ligne::horizon
