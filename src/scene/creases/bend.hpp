#pragma once
/// The kind of an edge by the angle of its faces alone.

#include <cstdint>

namespace ligne {

enum class Bend : std::uint8_t {
  none,
  weak,    ///< above half of the crease angle: a crease may continue over it
  strong,  ///< above the crease angle
  firm,    ///< a corner, regardless of its surroundings
};

}  // namespace ligne
