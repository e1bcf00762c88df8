#include "picture/hatching/hatch_layers.hpp"

#include <utility>

#include "picture/errors.hpp"
#include "plotting/paths/optimize.hpp"

namespace ligne {

double closest_strokes_mm(const HatchRequest& request, double pen_mm) {
  constexpr double kSpacingPens = 4;  // adjustable
  return request.spacing_mm.value_or(kSpacingPens * pen_mm);
}

double HatchLayers::pen_mm(unsigned shade, const std::string& material) const {
  const double usual = hatch_.plot.style_of("hatch").width_mm;
  const double width = hatch_.pens().empty()
                           ? usual
                           : hatch_.pens().pen(hatch_.pens().pen_of("hatch", material, shade)).width_mm.value_or(usual);
  if (!(width > 0)) throw RequestError("hatch", "the pen has no width");
  return width;
}

std::uint32_t HatchLayers::number(unsigned shade, const std::string& material) {
  const unsigned by_shade = hatch_.pens().pen_of_shade.empty() ? 0 : shade;
  const std::string by_material = hatch_.pens().pen_of_material.empty() ? std::string() : material;
  for (std::uint32_t i = 0; i < layers_.size(); ++i) {
    if (layers_[i].shade == by_shade && layers_[i].material == by_material) return i;
  }
  Layer& layer = layers_.emplace_back();
  layer.name = "hatch";
  layer.material = by_material;
  layer.shade = by_shade;
  return static_cast<std::uint32_t>(layers_.size() - 1);
}

std::vector<Layer> HatchLayers::take() {
  if (const auto least_mm = hatch_.prepared.request.lines.least_mm) {
    for (Layer& layer : layers_) layer.lines = picked(layer.lines, long_strokes(layer.lines, *least_mm));
  }
  std::erase_if(layers_, [](const Layer& layer) { return layer.lines.size() == 0; });
  return std::move(layers_);
}

}  // namespace ligne
