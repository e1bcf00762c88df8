/// Options that do nothing beside the others.

#include "cli/options/idle_options.hpp"

#include "program.hpp"

namespace ligne::test {
namespace {

class IdleOptions : public ProgramTest {};

TEST_F(IdleOptions, AreWarnedOfByName) {
  EXPECT_EQ(run("draw cube.obj --dpi 99 -o a.svg").err, "ligne: --dpi: warning: has no effect without --shade-tone\n");
  EXPECT_EQ(run("draw cube.obj --dpi 99 -q -o a.svg").err, "");
  EXPECT_EQ(run("draw cube.obj --dpi 99 -o a.png").err, "");
  EXPECT_EQ(run("draw cube.obj --method watkins --shade --shade-tone smooth --dpi 99 -o a.svg").err, "");
  EXPECT_EQ(run("draw cube.obj --shade-tone smooth -o a.svg").err,
            "ligne: --shade-tone: warning: has no effect without --shade or --fill\n");
  EXPECT_EQ(run("draw cube.obj --join 1mm -o a.svg").err,
            "ligne: --join: warning: has no effect without pens or a --device or --optimize\n");
  EXPECT_EQ(run("surface x*y --sun 90 -o a.svg").err, "ligne: --sun: warning: has no effect without --hachures\n");
  const Outcome filled = run("draw cube.obj --fill shade -o a.hpgl");
  EXPECT_EQ(filled.status, kUsage);
  EXPECT_EQ(filled.err, "ligne: --fill: pens draw no filled faces; see --hatch\n");
}

TEST(IdleOptionTable, TellsWhatIsMissing) {
  EXPECT_TRUE(idle_options({"draw", {"--dpi", "--hidden"}, OutputFormat::png}).empty());
  const auto idle = idle_options({"plot", {"--skip", "--dpi"}, OutputFormat::hpgl, true, false});
  ASSERT_EQ(idle.size(), 2u);
  EXPECT_EQ(idle[0].option, "--dpi");
  EXPECT_EQ(idle[1].why, "has no effect without an SVG input");
}

}  // namespace
}  // namespace ligne::test
