#pragma once
/// Order in depth of two surfaces where they overlap on the page.

#include <cstdint>

namespace ligne {

enum class DepthOrder : std::uint8_t {
  apart,     ///< they have no part of the page in common
  first,     ///< the first is in front
  second,    ///< the second is in front
  level,     ///< within the depth tolerance of each other all over
  crossing,  ///< the first is in front in one part, the second in another
};

}  // namespace ligne
