#pragma once
/// glTF files that tests in text make of small ones by changes, with " ; " between them:
///
///     POINTER = JSON          sets a part of the file
///     -POINTER                leaves it out
///     + TYPE N [NUMBERS]      adds an accessor of elements of N numbers, which are float, int8, int16, uint8, uint16 or
///     uint32;
///                             with "normalized" behind them, such integers

#include "gltf_builder.hpp"
#include "main/script.hpp"

namespace ligne::gltf_test {

/// A triangle: accessor 0 holds its positions.
inline Builder triangle() {
  Builder b;
  b.mesh(b.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3), -1);
  return b;
}

inline void add_accessor(Builder& file, std::string_view text) {
  const std::string type = test::take_word(text);
  const int components = std::stoi(test::take_word(text));
  const bool is_normalized = text.ends_with(" normalized");
  const json numbers = json::parse(text.substr(0, text.find(']') + 1));
  if (type == "float") file.accessor(numbers.get<std::vector<float>>(), components);
  if (type == "int16") file.accessor(numbers.get<std::vector<std::int16_t>>(), components);
  if (type == "int8") file.accessor(numbers.get<std::vector<std::int8_t>>(), components);
  if (type == "uint8") file.accessor(numbers.get<std::vector<std::uint8_t>>(), components);
  if (type == "uint16") file.accessor(numbers.get<std::vector<std::uint16_t>>(), components);
  if (type == "uint32") file.accessor(numbers.get<std::vector<std::uint32_t>>(), components);
  json& accessor = file.root["accessors"].back();
  if (components == 4) accessor["type"] = "VEC4";
  if (components == 16) accessor["type"] = "MAT4";
  if (is_normalized) accessor["normalized"] = true;
}

/// The file with the changes; its accessors first.
inline std::string changed(Builder file, std::string_view text) {
  std::vector<std::string_view> changes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(" ; "), text.size());
    changes.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 3, text.size()));
  }
  for (const std::string_view change : changes)
    if (change.starts_with("+ ")) add_accessor(file, change.substr(2));
  file.text();
  for (std::string_view change : changes) {
    const std::string pointer = test::take_word(change);
    if (pointer.starts_with("-")) {
      const json::json_pointer at(pointer.substr(1));
      file.root.at(at.parent_pointer()).erase(at.back());
    } else if (pointer != "+") {
      test::take_word(change);
      file.root[json::json_pointer(pointer == "/" ? "" : pointer)] = json::parse(change);
    }
  }
  return file.root.dump();
}

}  // namespace ligne::gltf_test
