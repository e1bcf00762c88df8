#include "visibility/registry.hpp"

#include <array>

#include "visibility/appel/appel.hpp"
#include "visibility/atherton_weiler/atherton_weiler.hpp"

namespace ligne {

std::span<const Method* const> all_methods() {
  static const AppelMethod appel;
  static const AthertonWeilerMethod atherton_weiler;
  static const std::array<const Method*, 2> methods{&appel, &atherton_weiler};
  return methods;
}

const Method* find_method(std::string_view name) {
  if (name == "auto") return all_methods().front();
  for (const Method* method : all_methods()) {
    if (method->traits().name == name) return method;
  }
  return nullptr;
}

}  // namespace ligne
