#include "picture/frame_names.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "files/message_text.hpp"
#include "picture/errors.hpp"

namespace ligne {
namespace {

/// A place for a number: from a percent sign to the d.
struct NumberPlace {
  std::size_t begin = 0, end = 0;
  std::size_t width = 0;  ///< filled with zeros
};

constexpr std::size_t kWidestNumber = 9;

/// The first place at or behind `from`.
std::optional<NumberPlace> find_place(const std::string& name, std::size_t from) {
  for (std::size_t i = name.find('%', from); i != std::string::npos; i = name.find('%', i + 1)) {
    std::size_t k = i + 1;
    std::size_t width = 0;
    if (k < name.size() && name[k] == '0') ++k;
    if (k < name.size() && name[k] >= '1' && name[k] <= '9') width = static_cast<std::size_t>(name[k++] - '0');
    if (k < name.size() && name[k] == 'd') return NumberPlace{i, k + 1, std::min(width, kWidestNumber)};
  }
  return std::nullopt;
}

}  // namespace

bool has_number_place(const std::string& name) { return find_place(name, 0).has_value(); }

std::vector<std::string> numbered_names(const std::string& name, unsigned count) {
  if (count == 1) return {name};
  const std::optional<NumberPlace> place = find_place(name, 0);
  if (!place) {
    throw RequestError("output", shown(name) + " has no place for the number of a frame: name%03d" +
                                     (name == "-" ? ".svg" : "") + "; only a PDF holds them all");
  }
  if (find_place(name, place->end)) throw RequestError("output", shown(name) + " has two places for the number of a frame");
  std::vector<std::string> names;
  for (unsigned i = 1; i <= count; ++i) {
    std::string number = std::to_string(i);
    if (number.size() < place->width) number.insert(0, place->width - number.size(), '0');
    names.push_back(name.substr(0, place->begin) + number + name.substr(place->end));
  }
  return names;
}

}  // namespace ligne
