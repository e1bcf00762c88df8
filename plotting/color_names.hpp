#pragma once
/// The names of colours. Private to plotting.

#include <cstdint>
#include <optional>
#include <string_view>

namespace ligne {

/// The colour of a CSS name in lower case, as 0xrrggbb; nothing if there is no such name.
std::optional<std::uint32_t> color_named(std::string_view name);

}  // namespace ligne
