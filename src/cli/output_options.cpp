#include "cli/output_options.hpp"

#include <stdexcept>

#include "cli/option_helpers.hpp"

namespace ligne {

void add_output_options(CLI::App& app, OutputOptions& options, const std::string& formats) {
  CLI::Option* file = add_parsed(
      app, "-o,--output", "FILE", options.file,
      [](const std::string& text) {
        if (text.empty()) throw std::invalid_argument("the name of the file is empty");
        return text;
      },
      "file to write; - is standard output");
  CLI::Option* format = add_parsed(app, "--format", "NAME", options.format, parse_format, formats);
  for (CLI::Option* option : {file, format}) option->group("Output");
}

OutputFormat format_of(const OutputOptions& options) {
  if (!options.file) throw UsageError("--output", "there is no output file: -o FILE, or -o - --format NAME");
  if (options.format) return *options.format;
  if (*options.file == "-") throw UsageError("--output", "standard output needs a --format: " + list_of(kOutputFormatNames));
  try {
    return format_of_suffix(*options.file);
  } catch (const std::invalid_argument& e) {
    throw UsageError("--output", e.what());
  }
}

}  // namespace ligne
