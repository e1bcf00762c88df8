#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

TEST_F(ProgramTest, CompareAsJsonHasOneSchemaForAllMethods) {
  const Outcome outcome = run({"compare", "cube.obj", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
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

TEST_F(ProgramTest, CompareOfSomeMethodsAsCsv) {
  const Outcome outcome = run({"compare", "cube.obj", "--methods", "newell,warnock", "--resolution", "64", "--csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::vector<std::string> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].rfind("method,exact,drawn,note,resolution_mm,", 0), 0u);
  // In the order of ligne methods; the option is that of warnock alone.
  EXPECT_EQ(lines[1].rfind("warnock,no,yes,", 0), 0u) << lines[1];
  EXPECT_EQ(lines[2].rfind("newell,yes,yes,", 0), 0u) << lines[2];
}

TEST_F(ProgramTest, ComparePageNeedsNothingElse) {
  const Outcome outcome = run({"compare", "cube.obj", "--html", "cube.html", "-o", "table.txt"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const std::string page = contents(file("cube.html"));
  EXPECT_EQ(page.rfind("<!doctype html>", 0), 0u);
  for (const char* from_outside : {"http:", "https:", "src=", "@import", "<script", "<link"}) {
    EXPECT_EQ(page.find(from_outside), std::string::npos) << from_outside;
  }
  EXPECT_NE(page.find("exact methods draw the same lines"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(contents(file("table.txt")).find("appel"), std::string::npos);
}

TEST_F(ProgramTest, CompareRefusesWhatMakesNoSense) {
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), {"compare", "cube.obj"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
  };
  refused({"--methods", "magic"}, "--methods: \"magic\" is not one of auto");
  refused({"--methods", "appel,appel"}, "--methods: \"appel\" is there twice");
  refused({"--methods", "auto"}, "--methods: auto is one of the others");
  refused({"--methods", "appel", "--resolution", "64"}, "--resolution: none of the methods has such an option");
  refused({"--json", "--csv"}, "--");
  EXPECT_EQ(new_files(), std::vector<std::string>{});
}

TEST_F(ProgramTest, StatsSayWhichRuleChose) {
  const Outcome outcome = run({"draw", "cube.obj", "-o", "x.svg", "--stats"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("rule 3: any other scene"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace ligne::test
