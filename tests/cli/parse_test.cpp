#include "picture/parse/parse.hpp"
#include "cli/memory_limit.hpp"
#include "cli/options/option_groups.hpp"
#include "files/message_text.hpp"
#include "main/script.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/placement.hpp"
#include "picture/run_report.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

std::string classes(LineClasses classes) {
  std::string names;
  for (std::size_t i = 0; i < kLineClassCount; ++i)
    if (classes.has(static_cast<LineClass>(i))) names += (names.empty() ? "" : " ") + std::string(kLineClassNames[i]);
  return names;
}
std::string point(const Point3& p) { return test::as_text(p.x, p.y, p.z); }
std::string format(OutputFormat f) { return std::string(kOutputFormatNames[static_cast<std::size_t>(f)]); }

/// "FILE TEXT; FILE TEXT", below a folder in the place of "/": the memory that control groups leave the process.
std::string memory_of_groups(const std::string& files) {
  const test::TemporaryFolder root;
  for (const std::string& file : test::parts_of(files, ';')) {
    std::string_view text = file;
    const std::string name = test::take_word(text);
    std::filesystem::create_directories((root / name).parent_path());
    root.write(name, std::string(text) + '\n');
  }
  const auto bytes = group_memory(root);
  return bytes ? std::to_string(*bytes) : "all";
}

/// "[landscape|portrait] [WxH] [margin:MM] BOX": the page for a picture of this extent, its corners or nothing.
std::string page_for_box(const std::string& text) {
  PageRequest request;
  Rect box;
  for (const std::string& word : test::words_of(text)) {
    const std::size_t comma = word.find(',');
    if (word == "landscape") request.landscape = true;
    if (word == "portrait") request.portrait = true;
    if (word.find('x') != word.npos) request.size = parse_page_size(word);
    if (word.starts_with("margin:")) request.margin_mm = std::stod(word.substr(7));
    if (comma != word.npos) box.extend({std::stod(word), std::stod(word.substr(comma + 1))});
  }
  check(request);
  const Page page = page_for(request, box);
  return test::as_text(page.width_mm, page.height_mm, page.margin_mm);
}

/// The functions of values/options.txt.
const test::TextFunctions kFunctions{
    {"number", [](auto& t) { return test::as_text(parse_number(t)); }},
    {"between-0-and-180", [](auto& t) { return test::as_text(parse_between(t, 0, 180, "degrees")); }},
    {"from-0-to-180", [](auto& t) { return test::as_text(parse_within(t, 0, 180, "")); }},
    {"positive", [](auto& t) { return test::as_text(parse_positive(t)); }},
    {"count-1-to-8", [](auto& t) { return test::as_text(parse_count(t, 1, 8)); }},
    {"point", [](auto& t) { return point(parse_point(t)); }},
    {"vector", [](auto& t) { return point(parse_vector(t)); }},
    {"edges", [](auto& t) { return classes(parse_edges(t)); }},
    {"scale", [](auto& t) { return parse_scale(t) ? test::as_text(*parse_scale(t)) : "fit"; }},
    {"unit", [](auto& t) { return test::as_text(parse_unit_mm(t)); }},
    {"axis", [](auto& t) { return std::string(1, "xyz"[static_cast<std::size_t>(parse_axis(t))]); }},
    {"suffix", [](auto& t) { return format(format_of_suffix(t)); }},
    {"format", [](auto& t) { return format(parse_format(t)); }},
    {"page",
     [](auto& t) {
       const PageSize size = parse_page_size(t);
       return test::as_text(size.page.width_mm, size.page.height_mm) + (size.explicit_size ? " as it is" : " may turn");
     }},
    {"page-for", page_for_box},
    {"memory", [](auto& t) { return test::as_text(parse_memory(t).bytes); }},
    {"control-groups", memory_of_groups},
    {"bytes", [](auto& t) { return bytes_text(std::stod(t)); }},
    {"shortest", [](auto& t) { return shortest(std::stod(t)); }},
    {"rounded-3", [](auto& t) { return rounded(std::stod(t), 3); }},
    {"duration", [](auto& t) { return duration(std::stod(t)); }},
};

[[maybe_unused]] const bool values_are_added = test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/cli/values", kFunctions);

TEST(PageScale, UnitAndRatioMultiply) {
  PageRequest options;
  EXPECT_FALSE(options.page_mm_per_unit(1));
  options.scale = 0.02;
  options.unit_mm = 1000;
  EXPECT_DOUBLE_EQ(*options.page_mm_per_unit(1), 20);
  options.unit_mm.reset();
  EXPECT_DOUBLE_EQ(*options.page_mm_per_unit(10), 0.2);
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
