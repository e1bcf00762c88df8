#pragma once
/// Lists of transparent faces in front of what is visible, as shared layers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/key_table.hpp"
#include "base/no_index.hpp"

namespace ligne {

/// Lists of transparent faces. A list is the index of its frontmost layer, and each layer has the index of the rest of
/// the list. Equal lists have one index, so comparing two of them is comparing two numbers.
class TransparentLayers {
 public:
  static constexpr std::uint32_t kEmptyList = 0;  ///< the empty list

  struct Layer {
    std::uint32_t face = 0;             ///< face of the scene
    std::uint32_t behind = kEmptyList;  ///< the rest of the list; its index is smaller
  };

  /// The list that begins with `face` and goes on with `behind`.
  std::uint32_t over(std::uint32_t face, std::uint32_t behind);

  /// Adds the layers of other lists. Returns the new index of each of their indices.
  std::vector<std::uint32_t> merge(const TransparentLayers& other);

  bool empty() const { return layers_.size() == 1; }
  /// Calls visit(face) for the faces of a list, from front to back.
  template <class Visit>
  void for_each(std::uint32_t list, Visit visit) const {
    for (; list != kEmptyList; list = layers_[list].behind) visit(layers_[list].face);
  }

 private:
  std::vector<Layer> layers_{1};  ///< the first stands for the empty list
  KeyTable numbers_;              ///< by face and rest
};

/// A colour on white paper, composed from front to back. N components, each in [0, 1]: one of gray, three of colours.
template <std::size_t N>
class SeenColor {
 public:
  /// Adds a face behind those added so far.
  void add(const std::array<double, N>& color, double opacity) {
    for (std::size_t c = 0; c < color.size(); ++c) color_[c] += left_ * opacity * color[c];
    left_ *= 1 - opacity;
  }

  /// The sum, with paper behind all faces.
  std::array<double, N> on_paper() const {
    std::array<double, N> sum = color_;
    for (double& component : sum) component += left_;
    return sum;
  }

 private:
  std::array<double, N> color_{};
  double left_ = 1;  ///< share of the light that passes all faces
};

/// A visible face, or paper (kNone), behind a list of transparent faces.
struct SeenFace {
  std::uint32_t face = 0;
  std::uint32_t in_front = TransparentLayers::kEmptyList;
};

/// The colour of a visible face on white paper. color_of(face) gives N components, opacity_of(face) a number, both in
/// [0, 1]; the face behind the list is opaque.
template <std::size_t N, class ColorOf, class OpacityOf>
std::array<double, N> seen_color(const TransparentLayers& layers, const SeenFace& seen, ColorOf color_of,
                                 OpacityOf opacity_of) {
  SeenColor<N> color;
  layers.for_each(seen.in_front, [&](std::uint32_t face) { color.add(color_of(face), opacity_of(face)); });
  if (seen.face != kNone) color.add(color_of(seen.face), 1);
  return color.on_paper();
}

}  // namespace ligne
