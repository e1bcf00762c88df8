#include <unistd.h>

#include "cli/memory_limit.hpp"
#include "cli/options/idle_options.hpp"
#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/placement.hpp"
#include "picture/run_report.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

/// The complaint of the function about the text, or "" when it takes it.
const auto complaint = [](const auto& function) { return test::failure_of(function); };

TEST(ParseNumber, TakesNumbersWholeOnly) {
  EXPECT_EQ(parse_number("12"), 12);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+2"), 2);
  EXPECT_EQ(parse_number("1e3"), 1000);
  for (const char* text : {"", " 1", "1 ", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "abc", "12mm", "+-1", "+", "--1"}) {
    EXPECT_NE(complaint([&] { parse_number(text); }), "") << text;
  }
  EXPECT_EQ(complaint([] { parse_number("abc"); }), "\"abc\" is not a number");
  EXPECT_EQ(complaint([] { parse_number(""); }), "an empty text is not a number");
}

TEST(ParseNumber, Intervals) {
  EXPECT_EQ(parse_between("179.9", 0, 180, "degrees"), 179.9);
  EXPECT_EQ(complaint([] { parse_between("200", 0, 180, "degrees"); }), "200 is not between 0 and 180 degrees");
  EXPECT_NE(complaint([] { parse_between("0", 0, 180, "degrees"); }), "");
  EXPECT_NE(complaint([] { parse_between("180", 0, 180, "degrees"); }), "");
  EXPECT_EQ(parse_within("0", 0, 180, "degrees"), 0);
  EXPECT_EQ(parse_within("180", 0, 180, "degrees"), 180);
  EXPECT_EQ(complaint([] { parse_within("-1", 0, 180, ""); }), "-1 is not from 0 to 180");
  EXPECT_EQ(parse_positive("0.1"), 0.1);
  EXPECT_EQ(complaint([] { parse_positive("0"); }), "0 is not greater than 0");
}

TEST(ParseCount, WholeNumbersOfARange) {
  EXPECT_EQ(parse_count("1", 1, 8), 1u);
  EXPECT_EQ(parse_count("8", 1, 8), 8u);
  for (const char* text : {"0", "9", "-1", "1.5", "", "99999999999999999999", "2x"}) {
    EXPECT_NE(complaint([&] { parse_count(text, 1, 8); }), "") << text;
  }
}

TEST(ParsePoint, ThreeNumbers) {
  EXPECT_EQ(parse_point("1,-2,3.5"), Point3(1, -2, 3.5));
  EXPECT_EQ(parse_point("0,0,0"), Point3(0, 0, 0));
  for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,2,", "a,b,c", "1, 2,3", "1;2;3", "1,2,nan"}) {
    EXPECT_NE(complaint([&] { parse_point(text); }), "") << text;
  }
  EXPECT_EQ(complaint([] { parse_vector("0,0,-0"); }), "\"0,0,-0\" has no direction");
}

TEST(ParseEdges, ListsAndGroups) {
  const LineClasses some = parse_edges("outline,mesh");
  EXPECT_TRUE(some.has(LineClass::outline) && some.has(LineClass::mesh));
  EXPECT_THROW(parse_edges("horizon"), std::invalid_argument) << "the curves of surfaces are no edges of models";
  EXPECT_FALSE(parse_edges("all").has(LineClass::horizon));
  EXPECT_FALSE(some.has(LineClass::crease) || some.has(LineClass::border) || some.has(LineClass::intersection));
  EXPECT_EQ(parse_edges("feature").bits, parse_edges("outline,crease,border,intersection,tangent").bits);
  EXPECT_EQ(parse_edges("all").bits, parse_edges("feature,mesh").bits);
  EXPECT_TRUE(parse_edges("all,shadow").has(LineClass::shadow));
  EXPECT_FALSE(parse_edges("all").has(LineClass::shadow)) << "borders of shadows are no edges of models";
  EXPECT_EQ(
      complaint([] { parse_edges("outline,edges"); }),
      "\"edges\" is not one of outline, border, intersection, crease, tangent, mesh, profile, shadow, suggestive, ridge, valley, "
      "detail, feature or all");
  EXPECT_NE(complaint([] { parse_edges(""); }), "");
  EXPECT_NE(complaint([] { parse_edges("outline,"); }), "");
}

TEST(ParseScale, FitOrRatio) {
  EXPECT_FALSE(parse_scale("fit"));
  EXPECT_EQ(parse_scale("1:50"), 0.02);
  EXPECT_EQ(parse_scale("2.5:1"), 2.5);
  for (const char* text : {"", "1", "0:1", "1:0", "-1:2", "1:2:3", "Fit", "1e300:1e-300", "a:b", ":"}) {
    EXPECT_NE(complaint([&] { parse_scale(text); }), "") << text;
  }
}

TEST(ParseUnit, NamesAndMillimetres) {
  EXPECT_EQ(parse_unit_mm("mm"), 1);
  EXPECT_EQ(parse_unit_mm("cm"), 10);
  EXPECT_EQ(parse_unit_mm("m"), 1000);
  EXPECT_EQ(parse_unit_mm("in"), 25.4);
  EXPECT_EQ(parse_unit_mm("304.8"), 304.8);
  for (const char* text : {"", "ft", "0", "-1", "1mm"}) EXPECT_NE(complaint([&] { parse_unit_mm(text); }), "") << text;
}

TEST(ParseAxis, Letters) {
  EXPECT_EQ(parse_axis("x"), Axis::x);
  EXPECT_EQ(parse_axis("y"), Axis::y);
  EXPECT_EQ(parse_axis("z"), Axis::z);
  EXPECT_EQ(complaint([] { parse_axis("w"); }), "\"w\" is not one of x, y or z");
}

TEST(OutputFormats, BySuffixOrName) {
  EXPECT_EQ(format_of_suffix("a.svg"), OutputFormat::svg);
  EXPECT_EQ(format_of_suffix("folder.svg/A B.PDF"), OutputFormat::pdf);
  EXPECT_EQ(format_of_suffix("é.Png"), OutputFormat::png);
  EXPECT_EQ(format_of_suffix("x.tar.json"), OutputFormat::json);
  for (const char* name : {"a", "a.", "a.svgz", ".svg", "a.svg/b"}) {
    EXPECT_NE(complaint([&] { format_of_suffix(name); }), "") << name;
  }
  EXPECT_EQ(complaint([] { format_of_suffix("a.dxf"); }),
            "\"a.dxf\" does not end in .svg, .pdf, .png, .json, .hpgl, .plt, .gcode or .nc, and there is no --format");
  EXPECT_EQ(parse_format("json"), OutputFormat::json);
  EXPECT_NE(complaint([] { parse_format("SVG "); }), "");
}

constexpr Rect kWide{{0, 0}, {40, 10}}, kTall{{0, 0}, {10, 40}}, kSquare{{0, 0}, {10, 10}};

bool lies(const Page& page) { return page.width_mm > page.height_mm; }

TEST(PageOrientation, FollowsThePicture) {
  const PageRequest options;
  EXPECT_TRUE(lies(page_for(options, kWide)));
  EXPECT_FALSE(lies(page_for(options, kTall)));
  EXPECT_FALSE(lies(page_for(options, kSquare)));
  EXPECT_FALSE(lies(page_for(options, Rect{})));
  EXPECT_TRUE(lies(page_for(options, {{0, 5}, {3, 5}}))) << "a line across";
  EXPECT_FALSE(lies(page_for(options, {{5, 0}, {5, 3}}))) << "a line down";
  EXPECT_FALSE(lies(page_for(options, {{5, 5}, {5, 5}}))) << "a point";
}

TEST(PageOrientation, IsAsAskedFor) {
  PageRequest options;
  options.landscape = true;
  EXPECT_TRUE(lies(page_for(options, kTall)));
  options = {};
  options.portrait = true;
  EXPECT_FALSE(lies(page_for(options, kWide)));
  options = {};
  options.size.page = {300, 100, 10};
  options.size.explicit_size = true;
  EXPECT_TRUE(lies(page_for(options, kTall)));
  options.portrait = true;
  EXPECT_EQ(page_for(options, kWide).height_mm, 300);
}

TEST(PageSize, NamesTurnAndSizesStay) {
  EXPECT_FALSE(parse_page_size("A3").explicit_size);
  EXPECT_FALSE(parse_page_size("letter").explicit_size);
  const PageSize size = parse_page_size("20cmx15cm");
  EXPECT_TRUE(size.explicit_size);
  EXPECT_DOUBLE_EQ(size.page.width_mm, 200);
  EXPECT_DOUBLE_EQ(size.page.height_mm, 150);
  EXPECT_THROW(parse_page_size("A9"), std::invalid_argument);
}

TEST(PageMargin, MustLeaveSomething) {
  PageRequest options;
  options.margin_mm = 104.9;
  EXPECT_NO_THROW(check(options));
  EXPECT_EQ(page_for(options, kTall).margin_mm, 104.9);
  options.margin_mm = 105;
  EXPECT_THROW(check(options), RequestError);
}

TEST(PageScale, UnitAndRatioMultiply) {
  PageRequest options;
  EXPECT_FALSE(options.page_mm_per_unit(1));
  options.scale = 0.02;
  options.unit_mm = 1000;
  EXPECT_DOUBLE_EQ(*options.page_mm_per_unit(1), 20);
  options.unit_mm.reset();
  EXPECT_DOUBLE_EQ(*options.page_mm_per_unit(10), 0.2);
}

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
  test::expect_parts(text, {"  total  "});
  const std::string json = report_json(report);
  test::expect_parts(json, {"\"format\": \"ligne-stats\"", "\"edges\": 12"});
  EXPECT_LT(json.find("\"read\""), json.find("\"write\""));
}

/// Sizes as people write them, and what control groups say.

constexpr double kMega = 1024 * 1024, kGiga = 1024 * kMega;

TEST(MemoryText, IsReadInPowersOf1024) {
  const std::pair<const char*, double> texts[] = {
      {"1", 1},           {"4096", 4096},      {"64K", 65536},          {"64k", 65536},       {"1.5G", 1.5 * kGiga},
      {"2GB", 2 * kGiga}, {"2GiB", 2 * kGiga}, {"500mib", 500 * kMega}, {"1T", 1024 * kGiga}, {"1e3B", 1000},
  };
  for (const auto& [text, bytes] : texts) EXPECT_EQ(parse_memory(text).bytes, bytes) << text;
}

TEST(MemoryText, NoneAndZeroAreNoLimit) {
  for (const char* text : {"none", "0", "0G"}) EXPECT_TRUE(std::isinf(parse_memory(text).bytes)) << text;
}

TEST(MemoryText, OtherwiseHasNoMeaning) {
  for (const char* text :
       {"", "M", "64X", "64MM", "64M ", " 64M", "-1", "-64M", "5apples", "nan", "inf", "1e400", "none G"}) {
    EXPECT_THROW(parse_memory(text), std::invalid_argument) << text;
  }
}

TEST(MemoryText, IsWrittenAsItIsRead) {
  const std::pair<double, const char*> sizes[] = {{0, "0"},
                                                  {999, "999"},
                                                  {1023, "1023"},
                                                  {1024, "1K"},
                                                  {64 * kMega, "64M"},
                                                  {1.5 * kGiga, "1.5G"},
                                                  {1000 * kMega, "1000M"}};
  for (const auto& [bytes, text] : sizes) EXPECT_EQ(bytes_text(bytes), text);
}

/// A folder in the place of "/".
class ControlGroups : public testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() / ("ligne-groups-" + std::to_string(getpid()));
    std::filesystem::remove_all(root_);
  }
  void TearDown() override { std::filesystem::remove_all(root_); }
  void write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text << '\n';
  }
  std::filesystem::path root_;
};

TEST_F(ControlGroups, AbsentOnesLimitNothing) { EXPECT_EQ(group_memory(root_), std::nullopt); }

TEST_F(ControlGroups, OfVersion2CountWithThoseThatTheyArePartOf) {
  write("proc/self/cgroup", "0::/user.slice/work.scope");
  write("sys/fs/cgroup/user.slice/work.scope/memory.max", "max");
  EXPECT_EQ(group_memory(root_), std::nullopt);
  write("sys/fs/cgroup/user.slice/memory.max", "300000");
  EXPECT_EQ(group_memory(root_), 300000u);
  write("sys/fs/cgroup/user.slice/work.scope/memory.max", "200000");
  EXPECT_EQ(group_memory(root_), 200000u);
  write("sys/fs/cgroup/memory.max", "100000");
  EXPECT_EQ(group_memory(root_), 100000u);
}

TEST_F(ControlGroups, OfVersion1AreThoseOfTheMemoryController) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:hugetlb,memory:/b/c\n0::/");
  write("sys/fs/cgroup/memory/b/memory.limit_in_bytes", "400000");
  write("sys/fs/cgroup/memory/a/memory.limit_in_bytes", "1");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712");
  EXPECT_EQ(group_memory(root_), 400000u);
}

TEST_F(ControlGroups, OfAContainerMayHaveANameThatIsNotSeenInside) {
  write("proc/self/cgroup", "0::/../../outside");
  write("sys/fs/cgroup/memory.max", "500000");
  EXPECT_EQ(group_memory(root_), 500000u);
}

TEST(MemoryOfTheMachine, IsKnown) {
  const double bytes = usual_memory_limit().bytes;
  EXPECT_GT(bytes, 0);
  EXPECT_TRUE(std::isfinite(bytes));
}

TEST(IdleOptionTable, TellsWhatIsMissing) {
  EXPECT_TRUE(idle_options({"draw", {"--dpi", "--hidden"}, OutputFormat::png}).empty());
  const auto idle = idle_options({"plot", {"--skip", "--dpi"}, OutputFormat::hpgl, true, false});
  ASSERT_EQ(idle.size(), 2u);
  EXPECT_EQ(idle[0].option, "--dpi");
  EXPECT_EQ(idle[1].why, "has no effect without an SVG input");
}

}  // namespace
}  // namespace ligne
