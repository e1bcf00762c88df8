#pragma once
/// The index that stands for none.

#include <cstdint>

namespace ligne {

inline constexpr std::uint32_t kNone = 0xffffffffu;

}  // namespace ligne
