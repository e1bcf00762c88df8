#pragma once
/// Options whose text is read by a function of ours, so that every mistake gives one line of ours.

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "cli/errors.hpp"

namespace ligne {

/// Adds an option "NAMES KIND"; `parser` turns its text into the value of `target`. A std::invalid_argument of the parser
/// becomes a UsageError that begins with the option's name. `target` must outlive the parse.
template <class Target, class Parser>
CLI::Option* add_parsed(CLI::App& app, const std::string& names, const std::string& kind, Target& target, Parser parser,
                        const std::string& help) {
  const std::string shown = names.substr(names.rfind(',') + 1);
  return app
      .add_option_function<std::string>(
          names,
          [&target, parser = std::move(parser), shown](const std::string& text) {
            try {
              target = parser(text);
            } catch (const std::invalid_argument& e) {
              throw UsageError(shown, e.what());
            }
          },
          help)
      ->type_name(kind);
}

}  // namespace ligne
