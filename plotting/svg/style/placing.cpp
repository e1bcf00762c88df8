#include "plotting/svg/style/placing.hpp"

#include <algorithm>
#include <string>

namespace ligne::svg {
namespace {

/// A property, and the values besides "none", "normal" and "auto" that change nothing.
struct NotRendered {
  std::string_view name;
  std::string_view harmless;
  bool may_be_attribute;
};

constexpr NotRendered kNotDrawn[] = {{"text-decoration", "", true},
                                     {"text-decoration-line", "", true},
                                     {"text-transform", "", false},
                                     {"direction", "ltr", true},
                                     {"font-variant", "tabular-nums", true},
                                     {"inline-size", "0", false},
                                     {"shape-inside", "", false},
                                     {"text-orientation", "mixed", false},
                                     {"offset-path", "", false},
                                     {"zoom", "1", false},
                                     {"mask-image", "", false},
                                     {"-webkit-mask", "", false},
                                     {"perspective", "", false},
                                     {"stroke-alignment", "center", true},
                                     {"glyph-orientation-vertical", "0", true}};

}  // namespace

void set_placing(Placing& placing, std::string_view name, std::string_view value, const Viewport& port) {
  std::optional<Matrix>& target = name == "translate" ? placing.translate
                                  : name == "rotate"  ? placing.rotate
                                                      : placing.scale;
  if (value == "none") return target.reset();
  std::string list(trimmed(value));
  std::ranges::replace(list, ' ', ',');
  target = transform(std::string(name) + "(" + list + ")", &port);
}

std::optional<Matrix> together(const Placing& placing) {
  std::optional<Matrix> all;
  for (const std::optional<Matrix>* one : {&placing.translate, &placing.rotate, &placing.scale, &placing.transform}) {
    if (*one) all = all ? *all * **one : **one;
  }
  return all;
}

bool changes_what_is_drawn(std::string_view name, std::string_view value, bool is_attribute) {
  return std::ranges::any_of(kNotDrawn, [&](const NotRendered& property) {
    return property.name == name && (property.may_be_attribute || !is_attribute) && value != property.harmless &&
           !value.starts_with("none") && value != "initial" && value != "0" && value != "1";
  });
}

}  // namespace ligne::svg
