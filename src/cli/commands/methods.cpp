#include "cli/commands.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/options/options.hpp"
#include "picture/parse/parse_options.hpp"
#include "plotting/writers/output_file.hpp"
#include "report/listing.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

std::vector<const Method*> chosen(const std::vector<std::string>& names) {
  const std::span<const Method* const> all = all_methods();
  std::vector<const Method*> methods(all.begin(), names.empty() ? all.end() : all.begin());
  for (const std::string& name : names) {
    try {
      methods.push_back(parse_method(name));
    } catch (const std::invalid_argument& e) {
      throw UsageError("methods", e.what());
    }
    if (!methods.back()) methods.back() = &default_method();
  }
  return methods;
}

}  // namespace

void setup_methods(CLI::App& app, MethodsOptions& options) {
  CLI::App* methods = add_command(app, "methods", "List the visibility methods: products, precision, paper",
                                  "Examples:\n  ligne methods warnock\n  ligne methods --json");
  add_arguments(*methods, "METHOD", options.names, false, "methods to list, with their experimental settings (--set)");
  OptionGroup(*methods, "Options").add_flag("--json", options.json, "write JSON");
}

void run_methods(const MethodsOptions& options) {
  const std::vector<const Method*> methods = chosen(options.names);
  write_output("-", options.json ? methods_json(methods) : methods_text(methods, !options.names.empty()));
}

}  // namespace ligne
