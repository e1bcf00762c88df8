#pragma once
/// Values of a JSON text, appended to it. Private to plotting.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/point.hpp"

namespace ligne {

/// The text as a JSON string, with quotes. Bytes that are not UTF-8 are replaced.
std::string json_string(std::string_view text);

void append_integer(std::string& out, std::uint64_t value);

/// Appends "[x,y]", rounded to the decimals.
void append_point(std::string& out, Point2 p, int decimals);

/// Appends "[item,item,...]": append_item(item) for each item.
template <class Items, class AppendItem>
void append_list(std::string& out, const Items& items, const AppendItem& append_item) {
  out += '[';
  bool is_first = true;
  for (const auto& item : items) {
    if (!std::exchange(is_first, false)) out += ',';
    append_item(item);
  }
  out += ']';
}

/// Appends "[n,n,...]", each in its shortest form that reads back as the same double.
void append_numbers(std::string& out, std::span<const double> numbers);

/// Appends "[x,y,z]", as append_numbers() does.
void append_coordinates(std::string& out, const Point3& p);

/// Appends the number of a face or of a surface; null for kNone.
void append_face(std::string& out, std::uint32_t face);

}  // namespace ligne
