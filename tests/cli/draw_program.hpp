#pragma once
/// Tools that tests of `ligne draw` share.

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ligne::test {

using nlohmann::json;

class DrawTest : public ProgramTest {
 protected:
  /// The JSON drawing of the arguments.
  json drawn(const Words& arguments) const {
    const Outcome outcome = run_well("draw" + arguments + "-o - --format json");
    EXPECT_EQ(outcome.err, "");
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
};

/// Numbers of strokes by class; hidden ones under "hidden".
inline std::map<std::string, int> strokes_by_class(const json& drawing) {
  std::map<std::string, int> counts;
  for (const json& stroke : drawing["strokes"])
    ++counts[stroke["visible"].get<bool>() ? stroke["class"].get<std::string>() : "hidden"];
  return counts;
}

}  // namespace ligne::test
