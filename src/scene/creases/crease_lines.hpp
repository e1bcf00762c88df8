#pragma once
/// View-independent classes of edges.

#include <cstdint>

namespace ligne {

/// Values of lists with one element per edge; other edges have 0. Smooth regions end at crease lines, not at tangent
/// lines. An edge of more than two faces that is kFoldLine is an outline in the view.
inline constexpr std::uint8_t kCreaseLine = 1, kTangentLine = 2, kFoldLine = 3;

}  // namespace ligne
