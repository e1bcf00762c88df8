#include "drawing/transparent_layers.hpp"

namespace ligne {

std::uint32_t TransparentLayers::over(std::uint32_t face, std::uint32_t behind) {
  std::uint32_t& number = numbers_[std::uint64_t{behind} << 32 | face];
  if (number == kNone) {
    number = static_cast<std::uint32_t>(layers_.size());
    layers_.push_back({face, behind});
  }
  return number;
}

std::vector<std::uint32_t> TransparentLayers::merge(const TransparentLayers& other) {
  std::vector<std::uint32_t> numbers(other.layers_.size(), kEmptyList);
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    numbers[i] = over(other.layers_[i].face, numbers[other.layers_[i].behind]);
  }
  return numbers;
}

}  // namespace ligne
