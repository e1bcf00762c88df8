#include "cli/options/parametric_options.hpp"

#include <vector>

#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {

void add_parametric(OptionGroup& group, SurfaceRequest& request, const std::string& help) {
  const auto take = [&request](const std::vector<std::string>& xyz) {
    request.parametric.push_back({xyz[0], xyz[1], xyz[2]});
  };
  group.add_repeatable_tuple("--parametric", "X Y Z", 3, take, help);
}

void add_parameter_ranges(OptionGroup& group, SurfaceRequest& request) {
  group
      .add_repeatable(
          "-u", "A:B[:N]", [&request](const std::string& text) { request.u.push_back(parse_range(text)); },
          "range of u of a parametric surface and number of curves (repeatable: for the next surface)")
      .standard("0:2*pi:40");
  group
      .add_repeatable(
          "-v", "A:B[:N]", [&request](const std::string& text) { request.v.push_back(parse_range(text)); },
          "range of v, likewise")
      .standard("0:2*pi:40");
}

}  // namespace ligne
