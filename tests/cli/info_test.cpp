#include <nlohmann/json.hpp>

#include "draw_program.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

TEST_F(ProgramTest, InfoTextNamesEveryMethod) {
  const json methods = json::parse(run("methods --json").out);
  EXPECT_EQ(methods["format"], "ligne-methods");
  ASSERT_FALSE(methods["methods"].empty());
  const Outcome info = run_well("info square.obj --stats");
  expect_parts(info.err, {"topology"});
  const std::string list = run("methods").out;
  int defaults = 0;
  for (const json& method : methods["methods"]) {
    const std::string name = method["name"];
    expect_parts(info.out, {"\n  " + name + " "});
    expect_parts(list, {name, method["paper"].get<std::string>()});
    defaults += method["default"].get<bool>();
    ASSERT_EQ(method["parts"].size(), 7u) << name;
    std::string symbols;
    for (const json& part : method["parts"]) {
      symbols += part["symbol"].get<std::string>() + ' ';
      EXPECT_FALSE(part["text"].get<std::string>().empty()) << name;
    }
    EXPECT_EQ(symbols, "MD Td Psi sigma Ti RI MV ");
  }
  EXPECT_EQ(defaults, 1);
  expect_parts(info.out, {"open: 4 border edges"});
}

TEST_F(ProgramTest, CompareAsJsonHasOneSchemaForAllMethods) {
  const Outcome outcome = run_well("compare cube.obj --json");
  EXPECT_EQ(outcome.err, "");
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found["format"], "ligne-compare");
  EXPECT_EQ(found["version"], 1);
  EXPECT_EQ(found["reference"], "appel");
  EXPECT_EQ(found["traits"]["faces"], 6);
  EXPECT_EQ(found["auto"]["method"], "appel");
  const json& methods = found["methods"];
  ASSERT_GT(methods.size(), 5u);
  for (const json& m : methods) {
    EXPECT_TRUE(m["drawn"]) << m["name"];
    ASSERT_EQ(m.size(), methods[0].size()) << m["name"];
    for (const auto& [key, value] : methods[0].items()) EXPECT_TRUE(m.contains(key)) << m["name"] << " " << key;
    for (const auto& [key, value] : methods[0]["operations"].items()) EXPECT_TRUE(m["operations"].contains(key));
    if (m["exact"] == true) {
      EXPECT_EQ(m["differs_mm"], 0) << m["name"];
    }
  }
  ASSERT_EQ(found["differences_mm"].size(), methods.size());
}

}  // namespace
}  // namespace ligne::test
