#pragma once
#include <string>

namespace outside {
struct View {
  std::string name;
};
}  // namespace outside
