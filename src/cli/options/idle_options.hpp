#pragma once
/// Options without effect in combination with the others of a command line: one table for all commands.

#include <string>
#include <string_view>
#include <vector>

#include "picture/requests.hpp"

namespace ligne {

/// The parts of a command line that decide which options have an effect.
struct CommandUse {
  std::string_view command;          ///< "draw"
  std::vector<std::string> given{};  ///< names of the given options, such as "--dpi" and "-x"
  OutputFormat format = OutputFormat::svg;
  bool by_pens = false;   ///< true if the drawing is divided among pens
  bool svg_input = true;  ///< plot: true if a drawing is an SVG
};

/// An option without effect, and the reason as a phrase.
struct IdleOption {
  std::string option, why;
};

/// The options without effect, in the order of the table. Options that would change the picture in another format are
/// refused elsewhere (check() of PictureRequest).
std::vector<IdleOption> idle_options(const CommandUse& use);

/// Warns of these options, one line each.
void warn_of_idle_options(const CommandUse& use);

}  // namespace ligne
