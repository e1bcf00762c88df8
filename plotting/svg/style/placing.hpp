#pragma once
/// Properties that place an element, and properties that change it in ways that are not drawn. Private to plotting.

#include <optional>
#include <string_view>

#include "plotting/svg/values.hpp"

namespace ligne::svg {

/// The transform of an element, and the transforms that CSS gives one by one (CSS Transforms 2, 5).
struct Placing {
  std::optional<Matrix> translate{}, rotate{}, scale{}, transform{};
};

/// Sets one of "translate: 3px 4px", "rotate: 30deg" and "scale: 2". Throws std::invalid_argument for other values, and
/// for transforms that leave the plane.
void set_placing(Placing& placing, std::string_view name, std::string_view value, const Viewport& port);

/// The product of all, which applies `transform` first; nothing if there is none.
std::optional<Matrix> together(const Placing& placing);

/// Whether the property has a value that changes lines or letters in a way that is not drawn.
bool changes_what_is_drawn(std::string_view name, std::string_view value, bool is_attribute);

}  // namespace ligne::svg
