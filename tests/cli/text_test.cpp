#include "files/message_text.hpp"

#include <gtest/gtest.h>

#include "picture/run_report.hpp"

namespace ligne {
namespace {

TEST(Text, NumbersForPeople) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(180), "180");
  EXPECT_EQ(rounded(1.0 / 3, 3), "0.333");
  EXPECT_EQ(duration(0.01234), "12.34 ms");
  EXPECT_EQ(duration(2.5), "2.50 s");
}

TEST(Stages, AreTimedAndToldInOrder) {
  RunReport report;
  report.method = "appel";
  report.study.count("edges", 12);
  EXPECT_EQ(timed(report.stages, "read", [] { return 7; }), 7);
  timed(report.stages, "write", [] {});
  ASSERT_EQ(report.stages.seconds.size(), 2u);
  EXPECT_EQ(report.stages.seconds[0].first, "read");
  EXPECT_EQ(report.stages.seconds[1].first, "write");
  const std::string text = report_text(report);
  EXPECT_EQ(text.rfind("method appel\n  edges  12\nstages\n", 0), 0u) << text;
  EXPECT_NE(text.find("  total  "), std::string::npos) << text;
  const std::string json = report_json(report);
  EXPECT_NE(json.find("\"format\": \"ligne-stats\""), std::string::npos);
  EXPECT_NE(json.find("\"edges\": 12"), std::string::npos);
  EXPECT_LT(json.find("\"read\""), json.find("\"write\""));
}

}  // namespace
}  // namespace ligne
