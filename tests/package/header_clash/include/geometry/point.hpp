#pragma once

namespace outside {
struct Point {
  int x, y;
};
}  // namespace outside
