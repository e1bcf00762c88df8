#include "cli/method_options.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

const Method* parse_method(const std::string& text) {
  if (const Method* method = find_method(text)) return method;
  std::vector<std::string_view> names{"auto"};
  for (const Method* method : all_methods()) names.push_back(method->traits().name);
  throw std::invalid_argument("\"" + text + "\" is not one of " + list_of(names));
}

}  // namespace

void add_method_options(CLI::App& app, MethodOptions& options) {
  options.edges = parse_edges("feature");
  CLI::Option* method =
      add_parsed(app, "--method", "NAME", options.method, parse_method, "visibility method, see: ligne methods")
          ->default_str("auto");
  CLI::Option* edges = add_parsed(app, "--edges", "LIST", options.edges, parse_edges,
                                  "of outline,crease,border,intersection,mesh; feature: the first four; all")
                           ->default_str("feature");
  CLI::Option* crease = add_parsed(
                            app, "--crease", "DEG", options.crease_degrees,
                            [](const std::string& text) { return parse_within(text, 0, 180, "degrees"); },
                            "angle between normals above which an edge is a crease")
                            ->default_str("30");
  CLI::Option* hidden =
      add_parsed(
          app, "--hidden", "HOW", options.hidden,
          [](const std::string& text) { return static_cast<HiddenLines>(parse_choice(text, kHiddenLinesNames)); },
          "hidden lines in a layer of their own: none dashed solid")
          ->default_str("none");
  CLI::Option* cull = app.add_flag("--cull", options.cull, "leave out back faces of closed, consistently wound objects");
  for (CLI::Option* option : {method, edges, crease, hidden, cull}) option->group("Lines");
}

const Method& method_of(const MethodOptions& options) {
  const Method* method = options.method ? options.method : find_method("auto");
  if (!method) throw UsageError("--method", "there is no default method");
  return *method;
}

}  // namespace ligne
