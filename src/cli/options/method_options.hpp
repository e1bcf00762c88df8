#pragma once
/// Options that say which lines are drawn and how they are found.

#include <string>
#include <utility>
#include <vector>

#include "picture/requests.hpp"
#include "visibility/method.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// The options of lines and methods on the command line, beside the request.
struct MethodChoice {
  bool edges_given = false;
  std::vector<std::pair<const MethodParameter*, std::string>> parameters;  ///< options that only some methods have
};

/// `one_method`: with --method.
void add_line_options(CLI::App& app, LineRequest& request, MethodChoice& choice, bool one_method = true);

/// Adds --method for those that compile, and the parameters of that.
void add_compile_options(CLI::App& app, const Method*& method, MethodChoice& choice);

/// The methods' own options that were given: name and value.
std::vector<std::pair<std::string, std::string>> named(const MethodChoice& choice);

/// Their names.
std::vector<std::string> names_of(const MethodChoice& choice);

/// The values for the method's own parameters. Throws RequestError for one that it does not have, or not with this value.
MethodSettings settings_of(const MethodChoice& choice, const Method& method);

}  // namespace ligne
