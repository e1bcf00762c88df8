#include "plotting/writers/json_values.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "base/no_index.hpp"
#include "plotting/writers/number_text.hpp"

namespace ligne {

std::string json_string(std::string_view text) {
  using nlohmann::json;
  return json(std::string(text)).dump(-1, ' ', false, json::error_handler_t::replace);
}

void append_integer(std::string& out, std::uint64_t value) {
  char text[kNumberBytes];
  out.append(text, write_fixed(text, static_cast<std::int64_t>(value), 0, false));
}

void append_point(std::string& out, Point2 p, int decimals) {
  out += '[';
  append_rounded(out, p.x, decimals);
  out += ',';
  append_rounded(out, p.y, decimals);
  out += ']';
}

void append_numbers(std::string& out, std::span<const double> numbers) {
  append_list(out, numbers, [&](double number) { append_shortest(out, number); });
}

void append_face(std::string& out, std::uint32_t face) {
  if (face == kNone) {
    out += "null";
  } else {
    append_integer(out, face);
  }
}

void append_coordinates(std::string& out, const Point3& p) { append_numbers(out, std::array{p.x, p.y, p.z}); }

}  // namespace ligne
