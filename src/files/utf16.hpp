#pragma once
/// Text in UTF-16, as spreadsheets and editors of Windows write it.

#include <cstddef>
#include <vector>

namespace ligne {

/// The bytes of a text in UTF-16 with a byte order mark, converted to UTF-8 without one. All other bytes stay as they are,
/// and so do texts with zero characters or halves of surrogate pairs: they are other data that begins alike.
std::vector<std::byte> as_utf8(std::vector<std::byte> bytes);

}  // namespace ligne
