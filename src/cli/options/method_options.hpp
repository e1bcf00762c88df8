#pragma once
/// Options for the drawn lines and the visibility method.

#include <string>
#include <utility>
#include <vector>

#include "picture/requests.hpp"
#include "visibility/method.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// Options of lines and methods that the request does not hold.
struct MethodChoice {
  bool edges_given = false;
  std::vector<std::pair<const MethodParameter*, std::string>> parameters;  ///< given options that only some methods have
};

/// `one_method`: adds --method.
void add_line_options(CLI::App& app, LineRequest& request, MethodChoice& choice, bool one_method = true);

/// Adds --method for methods that compile, and the parameters of compiling.
void add_compile_options(CLI::App& app, const Method*& method, MethodChoice& choice);

/// The given options of the methods themselves: name and value.
std::vector<std::pair<std::string, std::string>> named(const MethodChoice& choice);

/// The names of these options.
std::vector<std::string> names_of(const MethodChoice& choice);

/// The values of the method's own parameters. Throws RequestError for a parameter that the method does not have, or a wrong
/// value.
MethodSettings settings_of(const MethodChoice& choice, const Method& method);

}  // namespace ligne
