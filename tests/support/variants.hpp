#pragma once
/// Every exact method in every way in which its own options let it work.

#include "support/standard.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {

struct Variant {
  const Method* method;
  MethodSettings settings;
  bool is_default;
  bool is_show;      ///< draws a debug layer beside the lines, which stay as they are (orders/show_test.cpp)
  std::string name;  ///< as on the command line, "watkins --set span-method=box"
};

/// Gives the settings without which a parameter has no effect.
inline MethodSettings needed_by(std::string_view parameter) {
  MethodSettings settings;
  for (const std::string_view of_polygons : {"clip", "zones", "inside"})
    if (parameter == of_polygons) settings.set("study", ParameterWord{1});
  return settings;
}

/// The exact methods as they are by default, and with every other word of every parameter that is a choice of words, one at
/// a time.
inline std::vector<Variant> variants() {
  std::vector<Variant> list;
  for (const Method* method : all_methods()) {
    if (!method->traits().exact) continue;  // held to their limits in all_methods_test.cpp
    const std::string name(method->traits().name);
    list.push_back({method, {}, true, false, name});
    for (const MethodParameter& p : method->traits().parameters) {
      if (p.is_imprecise) continue;  // held to their limits in tests/visibility
      if (p.high > 0) continue;      // a number, or a word in its place
      for (unsigned i = 0; i < p.words.size(); ++i) {
        if (p.words[i] == p.standard) continue;
        Variant v{method, needed_by(p.name), false, p.name == "show",
                  name + (p.is_experiment ? " --set " : " --") + std::string(p.name) + "=" + std::string(p.words[i])};
        v.settings.set(p.name, ParameterWord{i});
        list.push_back(std::move(v));
      }
    }
  }
  return list;
}

}  // namespace ligne::test
