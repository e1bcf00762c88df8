#pragma once
/// The index that means "none".

#include <cstdint>

namespace ligne {

inline constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace ligne
