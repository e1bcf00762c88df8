#include "visibility/registry.hpp"

#include <array>

#include "visibility/bsp/bsp.hpp"
#include "visibility/convex_tree/convex_tree.hpp"
#include "visibility/methods.hpp"

namespace ligne {

std::span<const Method* const> all_methods() {
  static const BspMethod bsp;
  static const ConvexTreeMethod convex_tree;
  static const std::array<const Method*, 11> methods{
      &appel_method(), &atherton_weiler_method(), &warnock_method(), &watkins_method(), &newell_method(), &bsp,
      &convex_tree,    &zbuffer_method(),         &painter_method(), &culling_method(), &roberts_method()};
  return methods;
}

const Method& default_method() { return *all_methods().front(); }

const Method* find_method(std::string_view name) {
  if (name == "auto") return &default_method();
  for (const Method* method : all_methods()) {
    if (method->traits().name == name) return method;
  }
  return nullptr;
}

const Method& region_method() {
  for (const Method* method : all_methods()) {
    if (method->traits().products & kRegions) return *method;
  }
  return default_method();
}

const MethodParameter* find_parameter(std::string_view name) {
  for (const Method* method : all_methods()) {
    for (const MethodParameter& parameter : method->traits().parameters) {
      if (parameter.name == name) return &parameter;
    }
  }
  return nullptr;
}

std::string methods_with(std::uint8_t products) {
  std::string names;
  for (const Method* method : all_methods()) {
    if (method->traits().products & products) names += (names.empty() ? "" : ", ") + std::string(method->traits().name);
  }
  return names;
}

}  // namespace ligne
