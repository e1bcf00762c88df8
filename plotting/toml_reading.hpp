#pragma once
/// Reading of TOML tables with errors that name the line. Private to plotting.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "files/input_error.hpp"

namespace ligne {

/// One table of a TOML file. Every reader throws InputError, "FILE:LINE: what is wrong".
class TomlTable {
 public:
  TomlTable(const toml::table& table, std::string file) : table_(&table), file_(std::move(file)) {}

  [[noreturn]] void fail(const std::string& cause, const toml::node* where = nullptr) const {
    const auto line = (where ? where->source() : table_->source()).begin.line;
    throw InputError(file_ + (line > 0 ? ":" + std::to_string(line) : ""), cause);
  }
  /// Refuses keys that are not among these.
  void only(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : *table_) {
      bool known = false;
      for (const std::string_view k : keys) known = known || key.str() == k;
      if (!known) fail("there is no key " + printable(key.str()), &value);
    }
  }
  const toml::node* find(std::string_view key) const { return table_->get(key); }
  bool has(std::string_view key) const { return find(key) != nullptr; }

  std::optional<std::string> text(std::string_view key) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    auto value = node->value_exact<std::string>();
    if (!value) fail(std::string(key) + " is not a text", node);
    return value;
  }
  std::optional<double> number(std::string_view key) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    return number_of(*node, key);
  }
  std::optional<unsigned> count(std::string_view key, unsigned low, unsigned high) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->value_exact<std::int64_t>();
    if (!value || *value < low || *value > high) {
      fail(std::string(key) + " is not a whole number from " + std::to_string(low) + " to " + std::to_string(high), node);
    }
    return static_cast<unsigned>(*value);
  }
  std::optional<bool> flag(std::string_view key) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->value_exact<bool>();
    if (!value) fail(std::string(key).append(" is neither true nor false"), node);
    return value;
  }
  /// Exactly `n` numbers.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t n) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    if (!array || array->size() != n) fail(std::string(key) + " is not a list of " + std::to_string(n) + " numbers", node);
    std::vector<double> values;
    for (const toml::node& element : *array) values.push_back(number_of(element, key));
    return values;
  }
  /// A list of whole numbers; nothing: an empty one.
  std::vector<unsigned> counts(std::string_view key, unsigned low, unsigned high) const {
    const toml::node* node = find(key);
    if (!node) return {};
    const std::string cause =
        std::string(key) + " is not a list of whole numbers from " + std::to_string(low) + " to " + std::to_string(high);
    std::vector<unsigned> values;
    const toml::array* array = node->as_array();
    if (!array) fail(cause, node);
    for (const toml::node& element : *array) {
      const auto value = element.value_exact<std::int64_t>();
      if (!value || *value < low || *value > high) fail(cause, &element);
      values.push_back(static_cast<unsigned>(*value));
    }
    return values;
  }
  /// A list of texts; nothing: an empty one.
  std::vector<std::string> texts(std::string_view key) const {
    const toml::node* node = find(key);
    if (!node) return {};
    std::vector<std::string> values;
    const toml::array* array = node->as_array();
    if (!array) fail(std::string(key) + " is not a list of texts", node);
    for (const toml::node& element : *array) {
      const auto value = element.value_exact<std::string>();
      if (!value) fail(std::string(key) + " is not a list of texts", &element);
      values.push_back(*value);
    }
    return values;
  }
  /// The tables of [[key]].
  std::vector<TomlTable> tables(std::string_view key) const {
    const toml::node* node = find(key);
    if (!node) return {};
    std::vector<TomlTable> found;
    const toml::array* array = node->as_array();
    if (!array) fail("[[" + std::string(key) + "]] is not a list of tables", node);
    for (const toml::node& element : *array) {
      if (!element.is_table()) fail("[[" + std::string(key) + "]] is not a list of tables", &element);
      found.emplace_back(*element.as_table(), file_);
    }
    return found;
  }

 private:
  double number_of(const toml::node& node, std::string_view key) const {
    if (const auto whole = node.value_exact<std::int64_t>()) return static_cast<double>(*whole);
    const auto value = node.value_exact<double>();
    if (!value || *value != *value) fail(std::string(key) + " is not a number", &node);
    return *value;
  }

  const toml::table* table_;
  std::string file_;
};

/// Parses the text. Throws as TomlTable does.
toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace ligne
