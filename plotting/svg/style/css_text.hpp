#pragma once
/// The signs of CSS: comments, strings, brackets, names and declarations. Private to plotting.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ligne::svg {

std::string without_comments(std::string_view css);

/// The first of these characters that stands outside strings and brackets of any kind; npos where there is none. One that
/// opens a bracket is found where it opens it.
std::size_t find_outside(std::string_view text, std::string_view wanted);

/// Takes what comes before the bracket that closes this text, and the bracket itself; all where there is none.
std::string_view take_block(std::string_view& text, char closing);

/// Takes a name from the beginning, with its escapes ("\31 0") resolved; empty where there is none.
std::string take_css_name(std::string_view& text);

struct Declaration {
  std::string name, value;
  bool important = false;
};

/// The declarations of "name: value; name: value". Rules between them are left out.
std::vector<Declaration> declarations(std::string_view text);

/// Whether rules stand between the declarations.
bool has_rules(std::string_view declarations);

}  // namespace ligne::svg
