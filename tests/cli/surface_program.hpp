#pragma once
/// Runs `ligne surface` and measures what it draws.

#include "drawing_quantities.hpp"
#include "main/tier.hpp"
#include "program.hpp"

namespace ligne::test {

class SurfaceProgramTest : public ProgramTest {
 protected:
  Outcome surface(const Words& arguments, const Words& more) const { return run("surface" + arguments + more); }
  nlohmann::json drawn(const Words& arguments) const {
    const Outcome outcome = surface(arguments, "-o - --format json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.status == 0 ? nlohmann::json::parse(outcome.out) : nlohmann::json();
  }
  /// Length of the lines of each layer in mm.
  std::map<std::string, double> layers(const Words& arguments) const {
    const Outcome outcome = surface(arguments, "-o - --format svg");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return layers_of(outcome.out);
  }
  /// Lengths of the layers of an SVG.
  static std::map<std::string, double> layers_of(const std::string& svg) {
    std::map<std::string, double> lengths;
    std::string layer;
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);) {
      if (const auto id = line.find(" id=\""); line.starts_with("<g ")) {
        layer = line.substr(id + 5, line.find('"', id + 5) - id - 5);
      } else if (line.starts_with("<path d=\"M")) {
        lengths[layer] += path_length(line.substr(10, line.find('"', 10) - 10));
      }
    }
    return lengths;
  }
  void fails(const Words& arguments, int status, const std::string& message) const {
    const Outcome outcome = surface(arguments, {});
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: " + message, 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }

 private:
  /// "x y l dx dy dx dy ..." or "x y L x y x y ...", with or without Z at the end.
  static double path_length(std::string d) {
    const bool closed = d.back() == 'Z', relative = d.find('l') != std::string::npos;
    for (char& c : d)
      if (c == 'l' || c == 'L' || c == 'Z') c = ' ';
    std::istringstream numbers(d);
    double x = 0, y = 0, last_x = 0, last_y = 0, length = 0;
    numbers >> last_x >> last_y;
    const double first_x = last_x, first_y = last_y;
    while (numbers >> x >> y) {
      if (relative) x += last_x, y += last_y;
      length += std::hypot(x - last_x, y - last_y);
      last_x = x;
      last_y = y;
    }
    EXPECT_TRUE(numbers.eof()) << d;
    return closed ? length + std::hypot(first_x - last_x, first_y - last_y) : length;
  }
};

/// Page length of the visible strokes of a class, in model units of a parallel view.
inline double length(const nlohmann::json& drawing, const std::string& line_class) {
  const auto& m = drawing["view"]["matrix"];
  return length_mm(drawing, line_class, true) / std::hypot(m[0].get<double>(), m[1].get<double>(), m[2].get<double>());
}

}  // namespace ligne::test
