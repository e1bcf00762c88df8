#pragma once
/// Lists of transparent faces in front of what is visible, as shared layers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"

namespace ligne {

/// Lists of transparent faces, from front to back. A list is the index of its frontmost layer; each layer stores a face and
/// the list behind it. Equal lists have equal indices, so comparing two lists means comparing two numbers.
class TransparentLayers {
 public:
  static constexpr std::uint32_t kEmptyList = 0;  ///< the empty list

  struct Layer {
    std::uint32_t face = 0;             ///< face of the scene
    std::uint32_t behind = kEmptyList;  ///< list behind the face; its index is smaller
  };

  /// Puts a face in front of a list, and returns the new list.
  std::uint32_t over(std::uint32_t face, std::uint32_t behind);

  /// Adds all lists of `other`. Returns the index here of each list there.
  std::vector<std::uint32_t> merge(const TransparentLayers& other);

  bool empty() const { return layers_.size() == 1; }
  /// Calls visit(face) for the faces of a list, from front to back.
  template <class Visit>
  void for_each(std::uint32_t list, Visit visit) const {
    for (; list != kEmptyList; list = layers_[list].behind) visit(layers_[list].face);
  }

 private:
  std::vector<Layer> layers_{1};  ///< the first stands for the empty list
  KeyTable numbers_;              ///< indices of the layers, by face and list behind
};

/// A visible face, or paper (kNone), behind a list of transparent faces.
struct SeenFace {
  std::uint32_t face = 0;
  std::uint32_t in_front = TransparentLayers::kEmptyList;
};

/// The colour of a visible face on white paper, composed from front to back. color_of(face) returns N components: one for
/// gray, three for red, green and blue. opacity_of(face) returns a number. All are in [0, 1]. `seen.face` is opaque.
template <std::size_t N, class ColorOf, class OpacityOf>
std::array<double, N> seen_color(const TransparentLayers& layers, const SeenFace& seen, ColorOf color_of,
                                 OpacityOf opacity_of) {
  std::array<double, N> sum{};
  double left = 1;  // share of the light that passes all faces so far
  const auto add = [&](const std::array<double, N>& color, double opacity) {
    for (std::size_t c = 0; c < N; ++c) sum[c] += left * opacity * color[c];
    left *= 1 - opacity;
  };
  layers.for_each(seen.in_front, [&](std::uint32_t face) { add(color_of(face), opacity_of(face)); });
  if (seen.face != kNone) add(color_of(seen.face), 1);
  for (double& component : sum) component += left;  // paper
  return sum;
}

}  // namespace ligne
