#pragma once
/// A cursor over the text of a JSON value, for long lists of numbers: a tree of values would take many times their
/// memory and their time.

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace ligne {

/// Thrown if the text does not have the requested form; `at` is the position in bytes.
struct JsonSyntaxError : std::runtime_error {
  explicit JsonSyntaxError(std::size_t place) : std::runtime_error("is not valid JSON"), at(place) {}
  std::size_t at;
};

class JsonCursor {
 public:
  explicit JsonCursor(std::string_view text) : text_(text) {}

  /// The place of the next token, in bytes.
  std::size_t place() {
    skip_blanks();
    return at_;
  }
  /// Skips the character if it comes next, and returns whether it did.
  bool take(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) throw JsonSyntaxError(at_);
  }
  bool at_end() {
    skip_blanks();
    return at_ == text_.size();
  }

  /// The characters between the quotes of a string, without resolving its escapes.
  std::string_view string();
  double number();
  /// Skips a value of any kind and returns its text. Brackets need not match their kinds.
  std::string_view value();

  /// Calls member(name) at the value of each member of an object. The call must skip the value.
  template <class Member>
  void for_each_member(Member member) {
    expect('{');
    if (take('}')) return;
    do {
      const std::string_view name = string();
      expect(':');
      member(name);
    } while (take(','));
    expect('}');
  }
  /// Calls item() at each item of an array. The call must skip the item.
  template <class Item>
  void for_each_item(Item item) {
    expect('[');
    if (take(']')) return;
    do item();
    while (take(','));
    expect(']');
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\r' || text_[at_] == '\t'))
      ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace ligne
