#pragma once
/// Layout of help texts.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

/// The common options of a command. Its short help lists only these.
struct CommonOptions {
  std::string_view command;
  std::vector<std::string_view> names;
};
inline const CommonOptions kCommonOptions[] = {
    {"draw", {"help",      "edges", "crease", "hidden", "quality", "profile", "method", "only",   "hide",  "view",
              "direction", "eye",   "target", "fov",    "frames",  "fill",    "light",  "hatch",  "page",  "landscape",
              "margin",    "scale", "output", "format", "dpi",     "device",  "pens",   "report", "quiet", "pen-width"}},
    {"surface",
     {"help",      "grid",   "parametric", "x",      "y",         "lines",          "z-range", "aspect", "every",
      "contours",  "points", "curve",      "colors", "ridgeline", "contour-labels", "hatch",   "fill",   "hidden",
      "azimuth",   "view",   "elevation",  "axes",   "x-label",   "y-label",        "z-label", "page",   "margin",
      "pen-width", "output", "format",     "dpi",    "device",    "pens",           "quiet",   "title",  "outline"}},
    {"plot", {"help",      "skip",   "fill",     "occlude", "hatch",  "hatch-spacing", "hatch-angle", "page",
              "landscape", "margin", "scale",    "tile",    "output", "dpi",           "device",      "pens",
              "format",    "pen",    "optimize", "report",  "split",  "preview",       "quiet",       "pen-width"}}};

/// Formats "--fov DEG [35]   meaning", with the default in brackets. Exclusions between options are left to the error
/// messages. Wraps text at kWidth columns.
class HelpFormatter : public CLI::Formatter {
 public:
  /// `all`: lists every option of a command, not only the common ones.
  explicit HelpFormatter(bool all) : all_(all) { column_width(kColumn); }

  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    if (option->get_type_size() != 0) {
      if (!option->get_type_name().empty()) text += " " + option->get_type_name();
      if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
    }
    if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) text += "...";
    return text;
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string line = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    std::string text;
    std::size_t column = line.size();
    const auto begin_line = [&] {
      text += line + '\n';
      line.assign(kColumn, ' ');
      column = kColumn;
    };
    if (column >= kColumn) begin_line();
    line.resize(kColumn, ' ');
    column = kColumn;
    std::istringstream words(make_option_desc(option));
    for (std::string word; words >> word;) {
      if (column > kColumn && column + 1 + word.size() > kWidth) begin_line();
      if (column > kColumn) line += ' ';
      line += word;
      column = line.size();
    }
    return text + line + '\n';
  }

  std::string make_group(std::string group, bool is_positional, std::vector<const CLI::Option*> options) const override {
    if (!is_positional && common_) {
      std::erase_if(options, [&](const CLI::Option* option) { return is_left_out(option); });
      if (options.empty()) return {};
    }
    // Leaves one blank line between groups, not two.
    const bool follows_a_group = !is_positional && group != "Options";
    const std::string text = CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
    return follows_a_group && text.starts_with('\n') ? text.substr(1) : text;
  }

  std::string make_footer(const CLI::App* app) const override {
    if (!common_) return CLI::Formatter::make_footer(app);
    const std::vector<const CLI::Option*> options = app->get_options();
    const auto rest = std::ranges::count_if(options, [&](const CLI::Option* option) { return is_left_out(option); });
    return "\n" + std::to_string(rest) + " more options: ligne help " + app->get_name() + " all\n" +
           CLI::Formatter::make_footer(app);
  }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const auto* const common = std::ranges::find(kCommonOptions, app->get_name(), &CommonOptions::command);
    common_ = all_ || common == std::end(kCommonOptions) ? nullptr : common;
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    // Removes the blank lines of omitted groups.
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
    return text;
  }

 private:
  static constexpr std::size_t kColumn = 30, kWidth = 110;

  bool is_left_out(const CLI::Option* option) const {
    const std::vector<std::string>& names = option->get_lnames().empty() ? option->get_snames() : option->get_lnames();
    return !option->get_positional() && std::ranges::find(common_->names, names.front()) == common_->names.end();
  }

  bool all_;
  mutable const CommonOptions* common_ = nullptr;  ///< common options of the current command; null: lists all
};

}  // namespace ligne
