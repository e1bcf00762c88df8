#include "visibility/horizon/grid_axis.hpp"

#include <algorithm>
#include <numeric>

namespace ligne::horizon {

GridAxis::GridAxis(const std::vector<double>& samples, std::size_t stride, std::optional<double> eye)
    : sample_count(samples.size()) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    at.push_back(samples[i]);
    sample.push_back(i);
    fraction.push_back(0);
    drawn.push_back(stride != 0 && (i % stride == 0 || i + 1 == samples.size()));
    if (eye && i + 1 < samples.size() && samples[i] < *eye && *eye < samples[i + 1]) {
      at.push_back(*eye);
      sample.push_back(i);
      fraction.push_back((*eye - samples[i]) / (samples[i + 1] - samples[i]));
      drawn.push_back(false);
    }
  }
}

std::vector<GridAxis::Part> GridAxis::parts(std::optional<double> eye, double forward) const {
  std::vector<std::size_t> ascending(at.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  const auto away = [&](double sign) {
    Part part{ascending, sign};
    if (sign < 0) std::reverse(part.order.begin(), part.order.end());
    return part;
  };
  if (!eye) return {away(forward < 0 ? -1 : 1)};
  if (*eye <= at.front()) return {away(1)};
  if (*eye >= at.back()) return {away(-1)};
  const auto here = std::lower_bound(at.begin(), at.end(), *eye) - at.begin();
  Part up{{ascending.begin() + here, ascending.end()}, 1}, down{{ascending.begin(), ascending.begin() + here + 1}, -1, false};
  std::reverse(down.order.begin(), down.order.end());
  return {up, down};
}

}  // namespace ligne::horizon
