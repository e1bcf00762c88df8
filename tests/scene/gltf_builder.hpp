#pragma once
/// Small glTF files, written by the tests themselves.

#include <nlohmann/json.hpp>

#include "main/script.hpp"
#include "support/test.hpp"

namespace ligne::gltf_test {

using nlohmann::json;

inline std::string base64(std::span<const std::uint8_t> bytes) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63];
  }
  return out;
}

/// Collects buffer views and accessors in one buffer.
class Builder {
 public:
  json root{{"asset", {{"version", "2.0"}}}, {"buffers", json::array()}, {"bufferViews", json::array()},
            {"accessors", json::array()},    {"meshes", json::array()},  {"nodes", json::array()}};

  /// Adds a buffer view that holds the values; returns its index.
  template <class T>
  int view(const std::vector<T>& values) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size() * sizeof(T)}});
    const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes_.insert(bytes_.end(), from, from + values.size() * sizeof(T));
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  template <class T>
  static int component_type() {
    if (std::is_same_v<T, float>) return 5126;
    const int size = sizeof(T) == 1 ? 5120 : sizeof(T) == 2 ? 5122 : 5124;
    return size + (std::is_unsigned_v<T> ? 1 : 0);
  }

  template <class T>
  int accessor(const std::vector<T>& values, int components) {
    root["accessors"].push_back({{"bufferView", view(values)},
                                 {"componentType", component_type<T>()},
                                 {"count", values.size() / static_cast<std::size_t>(components)},
                                 {"type", components == 3 ? "VEC3" : "SCALAR"}});
    return static_cast<int>(root["accessors"].size()) - 1;
  }

  /// Adds a mesh of one primitive and a node with it; no index accessor when it is negative.
  json& mesh(int positions, int indices, int mode = 4) {
    json primitive{{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
    if (indices >= 0) primitive["indices"] = indices;
    root["meshes"].push_back({{"primitives", json::array({primitive})}});
    root["nodes"].push_back({{"mesh", root["meshes"].size() - 1}});
    return root["meshes"].back()["primitives"][0];
  }

  /// The file as text, its buffer as data uri.
  std::string text() {
    close_buffer();
    if (!root["buffers"][0].contains("uri")) {
      root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes_);
    }
    return root.dump();
  }

  /// The file as GLB.
  std::string glb() {
    close_buffer();
    std::string text = root.dump();
    while (text.size() % 4 != 0) text += ' ';
    std::string binary(bytes_.begin(), bytes_.end());
    while (binary.size() % 4 != 0) binary += '\0';
    const auto word = [](std::size_t w) { return test::raw(static_cast<std::uint32_t>(w)); };
    return "glTF" + word(2) + word(12 + 8 + text.size() + 8 + binary.size()) + word(text.size()) + "JSON" + text +
           word(binary.size()) + std::string("BIN\0", 4) + binary;
  }

 private:
  void close_buffer() {
    if (root["buffers"].empty()) root["buffers"].push_back({{"byteLength", bytes_.size()}});
  }

  std::vector<std::uint8_t> bytes_;
};

/// The unit square of two triangles: accessor 0 holds the positions, accessor 1 the indices.
inline Builder square() {
  Builder b;
  const int positions = b.accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
  b.mesh(positions, b.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, 1));
  return b;
}

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

/// A small file as tests in text change it, with " ; " between the changes; accessors are added first:
///
///     POINTER = JSON          sets a part of the file
///     -POINTER                leaves it out
///     + TYPE N [NUMBERS]      adds an accessor of elements of N numbers, which are float, int8, int16, uint8, uint16 or
///                             uint32; with "normalized" behind them, such integers
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
