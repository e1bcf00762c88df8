#pragma once
/// The names of colours. Private to plotting.

#include <cstdint>
#include <optional>
#include <string_view>

namespace ligne {

/// Red, green and blue as 0xrrggbb of a name of CSS in small letters; nothing where it is none.
std::optional<std::uint32_t> color_named(std::string_view name);

}  // namespace ligne
