#pragma once
/// The layout of help texts.

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace ligne {

/// "--fov DEG [35]   what it means": the default in brackets, nothing about what goes with what (the errors say that).
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(30); }

  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    if (option->get_type_size() != 0) {
      if (!option->get_type_name().empty()) text += " " + option->get_type_name();
      if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
    }
    if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) text += "...";
    return text;
  }

  std::string make_group(std::string group, bool is_positional, std::vector<const CLI::Option*> options) const override {
    // One empty line between groups, not two.
    const bool follows_a_group = !is_positional && group != "Options";
    const std::string text = CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
    return follows_a_group && text.starts_with('\n') ? text.substr(1) : text;
  }
};

}  // namespace ligne
