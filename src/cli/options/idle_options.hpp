#pragma once
/// Options that do nothing beside the others of a command line: one table for all commands.

#include <string>
#include <string_view>
#include <vector>

#include "picture/requests.hpp"

namespace ligne {

/// A command line, as far as it decides on what its options can do.
struct CommandUse {
  std::string_view command;          ///< "draw"
  std::vector<std::string> given{};  ///< names of the options that are there, such as "--dpi" and "-x"
  OutputFormat format = OutputFormat::svg;
  bool by_pens = false;   ///< the drawing is dealt out to pens
  bool svg_input = true;  ///< plot: a drawing is an SVG
};

/// An option that does nothing, and why: a phrase.
struct IdleOption {
  std::string option, why;
};

/// In the order of the table. Options that would change the picture, were it of another format, are refused elsewhere
/// (check() of PictureRequest).
std::vector<IdleOption> idle_options(const CommandUse& use);

/// Warns of them, a line each.
void warn_of_idle_options(const CommandUse& use);

}  // namespace ligne
