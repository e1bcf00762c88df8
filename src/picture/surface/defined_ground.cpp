#include "picture/surface/defined_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ligne {
namespace {

constexpr int kParts = 100;      ///< of a range
constexpr int kFineInParts = 8;  ///< samples in the part next to the last one with heights

struct GroundPlace {
  std::array<double, 2> at{};  ///< in parts of the two ranges
};

/// For each position, whether it has a height.
std::vector<char> heights_at(std::span<const std::shared_ptr<const HeightFunction>> functions, const Ground& ground,
                             const std::vector<GroundPlace>& places) {
  std::vector<char> found(places.size(), 0);
  const auto coordinate = [&](const GroundPlace& place, std::size_t axis) {
    const auto [from, to] = ground[axis];
    return place.at[axis] == kParts ? to : from + place.at[axis] * (to - from) / kParts;
  };
  for (const auto& function : functions) {
    function->use([&](HeightFunction::At& at) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (!found[i]) found[i] = std::isfinite(at(coordinate(places[i], 0), coordinate(places[i], 1)));
      }
    });
  }
  return found;
}

}  // namespace

Ground defined_ground(std::span<const std::shared_ptr<const HeightFunction>> functions, const Ground& ground,
                      const std::array<bool, 2>& open) {
  std::vector<GroundPlace> places;
  for (int x = 0; x <= kParts; ++x) {
    for (int y = 0; y <= kParts; ++y) places.push_back({{double(x), double(y)}});
  }
  std::array<std::array<int, 2>, 2> parts{{{kParts, 0}, {kParts, 0}}};
  const std::vector<char> found = heights_at(functions, ground, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!found[i]) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const int at = static_cast<int>(places[i].at[axis]);
      parts[axis] = {std::min(parts[axis][0], at), std::max(parts[axis][1], at)};
    }
  }
  Ground defined = ground;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!open[axis] || parts[axis][0] >= parts[axis][1]) continue;
    for (const int side : {0, 1}) {
      const int last = parts[axis][static_cast<std::size_t>(side)], outwards = side == 0 ? -1 : 1;
      if (last == side * kParts) continue;
      places.clear();
      for (int fine = 1; fine < kFineInParts; ++fine) {
        for (int across = 0; across <= kParts; ++across) {
          GroundPlace place;
          place.at[axis] = last + outwards * double(fine) / kFineInParts;
          place.at[1 - axis] = across;
          places.push_back(place);
        }
      }
      const bool goes_on = std::ranges::count(heights_at(functions, ground, places), char{1}) > 0;
      const auto [from, to] = ground[axis];
      defined[axis][static_cast<std::size_t>(side)] = from + (last + (goes_on ? outwards : 0)) * (to - from) / kParts;
    }
  }
  return defined;
}

}  // namespace ligne
