#include "picture/pages/frame_names.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "files/message_text.hpp"
#include "picture/errors.hpp"

namespace ligne {
namespace {

/// A placeholder for a number: from a percent sign to its letter.
struct NumberPlace {
  std::size_t begin = 0, end = 0;
  std::size_t width = 0;  ///< width to which the number is filled with zeros
};

constexpr std::size_t kWidestNumber = 9;

/// Finds the first placeholder from position `from` on.
std::optional<NumberPlace> find_place(const std::string& name, std::size_t from, char letter) {
  for (std::size_t i = name.find('%', from); i != std::string::npos; i = name.find('%', i + 1)) {
    std::size_t k = i + 1;
    std::size_t width = 0;
    if (k < name.size() && name[k] == '0') ++k;
    if (k < name.size() && name[k] >= '1' && name[k] <= '9') width = static_cast<std::size_t>(name[k++] - '0');
    if (k < name.size() && name[k] == letter) return NumberPlace{i, k + 1, std::min(width, kWidestNumber)};
  }
  return std::nullopt;
}

}  // namespace

std::string name_of(const std::string& name, const PicturePart& part) {
  return with_number(with_number(name, part.number), part.pen, 'p');
}

bool has_number_place(const std::string& name, char letter) { return find_place(name, 0, letter).has_value(); }

std::string with_number(const std::string& name, unsigned number, char letter) {
  const std::optional<NumberPlace> place = find_place(name, 0, letter);
  if (!place) return name;
  std::string digits = std::to_string(number);
  if (digits.size() < place->width) digits.insert(0, place->width - digits.size(), '0');
  return name.substr(0, place->begin) + digits + name.substr(place->end);
}

std::vector<std::string> numbered_names(const std::string& name, unsigned count) {
  if (count == 1) return {name};
  const std::optional<NumberPlace> place = find_place(name, 0, 'd');
  if (!place) {
    throw RequestError("output", shown(name) + " has no frame number, such as name%03d" + (name == "-" ? ".svg" : "") +
                                     "; only a PDF holds them all");
  }
  if (find_place(name, place->end, 'd')) throw RequestError("output", shown(name) + " has two frame numbers");
  std::vector<std::string> names;
  for (unsigned i = 1; i <= count; ++i) names.push_back(with_number(name, i, 'd'));
  return names;
}

}  // namespace ligne
