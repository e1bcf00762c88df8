#include "scene/readers/json_place.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace ligne {
namespace {

using nlohmann::json;

/// Accepts everything, and records the place of the error that ends parsing.
struct PlaceOfError : nlohmann::json_sax<json> {
  std::size_t byte = 0;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&, const json::exception&) override {
    byte = position;
    return false;
  }
};

}  // namespace

std::size_t line_of_byte(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

std::size_t line_of_number_out_of_range(std::string_view text) {
  PlaceOfError place;
  json::sax_parse(text, &place);
  return line_of_byte(text, place.byte > 0 ? place.byte - 1 : 0);
}

}  // namespace ligne
