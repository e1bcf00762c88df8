// ligne study: the names, what is refused, and the files that it writes.

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ligne::test {
namespace {

using StudyCommandTest = ProgramTest;

TEST_F(StudyCommandTest, ListsTheExperiments) {
  const Outcome outcome = run({"study", "--list"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("squares"), std::string::npos);
  EXPECT_NE(outcome.out.find("Boulle 2.3.3.4"), std::string::npos);
}

TEST_F(StudyCommandTest, WritesTablesAndPlots) {
  const Outcome outcome =
      run({"study", "translation", "--size", "small", "--json", "t.json", "--csv", "t.csv", "--svg", "t.svg"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Figure 2.56"), std::string::npos);
  const auto json = nlohmann::json::parse(contents(file("t.json")));
  EXPECT_EQ(json["format"], "ligne-study");
  EXPECT_EQ(json["size"], "small");
  EXPECT_EQ(json["experiments"].size(), 1u);
  EXPECT_EQ(contents(file("t.csv")).rfind("experiment,table,row,column,kind,value\n", 0), 0u);
  const std::string svg = contents(file("t.svg"));
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST_F(StudyCommandTest, StandardOutputHasWhatWasAskedFor) {
  const Outcome outcome = run({"study", "windows", "--size", "small", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["experiments"][0]["name"], "windows");
}

TEST_F(StudyCommandTest, StudiesModelsBesideItsOwnScenes) {
  const Outcome outcome = run({"study", "coherence", "cube.obj", "--size", "small"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("| cube | 256 |"), std::string::npos) << outcome.out;
}

TEST_F(StudyCommandTest, RefusesInOneLine) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"study"}, {"study", "nothing"}, {"study", "squares", "--size", "huge"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments.back();
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
  }
  EXPECT_EQ(run({"study", "windows", "--size", "small", "--svg", "w.svg"}).status, 1) << "it has no plot";
  EXPECT_FALSE(exists("w.svg"));
  EXPECT_EQ(run({"study", "coherence", "none.obj"}).status, 1);
}

}  // namespace
}  // namespace ligne::test
