#pragma once
/// The syntax of CSS: comments, strings, brackets, names and declarations. Private to plotting.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ligne::svg {

std::string without_comments(std::string_view css);

/// Position of the first of these characters outside strings and brackets; npos if there is none. An opening bracket
/// counts as outside.
std::size_t find_outside(std::string_view text, std::string_view wanted);

/// Removes the text up to its closing bracket with the bracket, or all of it if there is none. Returns the text before
/// it.
std::string_view take_block(std::string_view& text, char closing);

/// Removes a name from the beginning and returns it with its escapes ("\31 0") resolved; empty if there is none.
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
