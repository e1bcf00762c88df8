#include "cli/commands/methods.hpp"

#include "cli/options/options.hpp"
#include "plotting/writers/output_file.hpp"
#include "report/listing.hpp"

namespace ligne {

void setup_methods(CLI::App& app, MethodsOptions& options) {
  CLI::App* methods = add_command(app, "methods", "Visibility methods: what each produces, exact or not, paper",
                                  "Example:\n  ligne methods --json");
  OptionGroup(*methods, "Options").add_flag("--json", options.json, "as JSON");
}

void run_methods(const MethodsOptions& options) { write_output("-", options.json ? methods_json() : methods_text()); }

}  // namespace ligne
