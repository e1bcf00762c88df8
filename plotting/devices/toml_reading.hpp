#pragma once
/// Typed access to TOML tables, with error messages that name file and line. Private to plotting.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "files/input_error.hpp"

namespace ligne {

/// One table of a TOML file. The functions that read a key return nothing, or an empty list, if the key is missing.
/// They throw InputError, "FILE:LINE: cause", if its value is of another type or out of range.
class TomlTable {
 public:
  /// The table must outlive this object. `file` is its name in error messages.
  TomlTable(const toml::table& table, std::string file) : table_(&table), file_(std::move(file)) {}

  /// Throws InputError with the line of `where`, or of the table itself if `where` is null.
  [[noreturn]] void fail(const std::string& cause, const toml::node* where = nullptr) const {
    const auto line = (where ? where->source() : table_->source()).begin.line;
    throw InputError(file_ + (line > 0 ? ":" + std::to_string(line) : ""), cause);
  }
  /// Fails if the table has a key that is not in the list.
  void only(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : *table_) {
      bool known = false;
      for (const std::string_view k : keys) known = known || key.str() == k;
      if (!known) fail("there is no key " + printable(key.str()), &value);
    }
  }
  const toml::node* find(std::string_view key) const { return table_->get(key); }
  bool has(std::string_view key) const { return find(key) != nullptr; }

  /// A string.
  std::optional<std::string> text(std::string_view key) const {
    return value<std::string>(key, std::string(key) + " is not a text", text_of);
  }
  /// An integer or a floating-point number, infinities included; NaN is an error.
  std::optional<double> number(std::string_view key) const {
    return value<double>(key, std::string(key) + " is not a number", number_of);
  }
  /// An integer from `low` to `high`, both included.
  std::optional<unsigned> count(std::string_view key, unsigned low, unsigned high) const {
    return value<unsigned>(key, std::string(key) + " is not a whole number" + range(low, high),
                           [=](const toml::node& node) { return count_of(node, low, high); });
  }
  std::optional<bool> flag(std::string_view key) const {
    return value<bool>(key, std::string(key) + " is neither true nor false",
                       [](const toml::node& node) { return node.value_exact<bool>(); });
  }
  /// A list of exactly `n` numbers.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t n) const {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    if (!array || array->size() != n) fail(std::string(key) + " is not a list of " + std::to_string(n) + " numbers", node);
    return list<double>(key, std::string(key) + " is not a number", number_of);
  }
  /// A list of integers from `low` to `high`, both included.
  std::vector<unsigned> counts(std::string_view key, unsigned low, unsigned high) const {
    return list<unsigned>(key, std::string(key) + " is not a list of whole numbers" + range(low, high),
                          [=](const toml::node& node) { return count_of(node, low, high); });
  }
  /// A list of strings.
  std::vector<std::string> texts(std::string_view key) const {
    return list<std::string>(key, std::string(key) + " is not a list of texts", text_of);
  }
  /// The tables of the array of tables [[key]].
  std::vector<TomlTable> tables(std::string_view key) const {
    return list<TomlTable>(key, "[[" + std::string(key) + "]] is not a list of tables", [this](const toml::node& node) {
      const toml::table* table = node.as_table();
      return table ? std::optional<TomlTable>(std::in_place, *table, file_) : std::nullopt;
    });
  }

 private:
  static std::optional<std::string> text_of(const toml::node& node) { return node.value_exact<std::string>(); }
  static std::optional<double> number_of(const toml::node& node) {
    if (const auto whole = node.value_exact<std::int64_t>()) return static_cast<double>(*whole);
    const auto value = node.value_exact<double>();
    return value && *value == *value ? value : std::nullopt;
  }
  static std::optional<unsigned> count_of(const toml::node& node, unsigned low, unsigned high) {
    const auto value = node.value_exact<std::int64_t>();
    return value && *value >= low && *value <= high ? std::optional(static_cast<unsigned>(*value)) : std::nullopt;
  }
  static std::string range(unsigned low, unsigned high) {
    return " from " + std::to_string(low) + " to " + std::to_string(high);
  }

  /// Returns the value that `read` finds in a node. Fails with `cause` if `read` finds none.
  template <class T, class Read>
  T read_or_fail(const toml::node& node, const std::string& cause, const Read& read) const {
    std::optional<T> value = read(node);
    if (!value) fail(cause, &node);
    return *std::move(value);
  }
  template <class T, class Read>
  std::optional<T> value(std::string_view key, const std::string& cause, const Read& read) const {
    const toml::node* node = find(key);
    return node ? std::optional<T>(read_or_fail<T>(*node, cause, read)) : std::nullopt;
  }
  template <class T, class Read>
  std::vector<T> list(std::string_view key, const std::string& cause, const Read& read) const {
    const toml::node* node = find(key);
    if (!node) return {};
    const toml::array* array = node->as_array();
    if (!array) fail(cause, node);
    std::vector<T> values;
    for (const toml::node& element : *array) values.push_back(read_or_fail<T>(element, cause, read));
    return values;
  }

  const toml::table* table_;
  std::string file_;
};

/// Parses the text of a TOML file. Throws InputError, "FILE:LINE: cause".
toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace ligne
