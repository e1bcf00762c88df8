#pragma once
/// Lines that edges of a mesh are, whatever the view.

#include <cstdint>

namespace ligne {

/// Values per edge; 0 for all others. A tangent line is no border of a smooth region.
inline constexpr std::uint8_t kCreaseLine = 1, kTangentLine = 2;

}  // namespace ligne
