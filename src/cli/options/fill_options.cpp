#include "cli/options/fill_options.hpp"

#include "cli/options/options.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {

void add_fill_options(CLI::App& app, FillRequest& request) {
  OptionGroup group(app, "Fills");
  group
      .add("--fill", "HOW", request.kind, parse_fill,
           "fill visible faces: none material shade paper random; needs a method that gives regions, an order, spans or "
           "pixels")
      .standard("none");
  group.add_repeatable(
      "--light", "X,Y,Z", [&request](const std::string& text) { request.lights.push_back(parse_vector(text)); },
      "direction of a parallel light that casts shadows; repeatable");
}

}  // namespace ligne
