#include "visibility/registry.hpp"

#include <array>

#include "visibility/atherton_weiler/atherton_weiler.hpp"
#include "visibility/bsp/bsp.hpp"
#include "visibility/convex_tree/convex_tree.hpp"
#include "visibility/culling/culling.hpp"
#include "visibility/edges/appel.hpp"
#include "visibility/newell/newell.hpp"
#include "visibility/painter/painter.hpp"
#include "visibility/roberts/roberts.hpp"
#include "visibility/warnock/warnock.hpp"
#include "visibility/watkins/watkins.hpp"
#include "visibility/zbuffer/zbuffer.hpp"

namespace ligne {

std::span<const Method* const> all_methods() {
  static const AppelMethod appel;
  static const AthertonWeilerMethod atherton_weiler;
  static const WarnockMethod warnock;
  static const WatkinsMethod scan;
  static const NewellMethod newell;
  static const BspMethod bsp;
  static const ConvexTreeMethod convex_tree;
  static const ZBufferMethod depth_buffer;
  static const PainterMethod painter;
  static const CullingMethod culling;
  static const RobertsMethod roberts;
  static const std::array<const Method*, 11> methods{&appel,       &atherton_weiler, &warnock, &scan,    &newell, &bsp,
                                                     &convex_tree, &depth_buffer,    &painter, &culling, &roberts};
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
