/// ligne plot --fill: a stored order of painting, painted again without a study.

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/standard.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

const std::string kStoredScenes = LIGNE_SOURCE_DIR "/tests/corpus/";

class StoredOrderTest : public ProgramTest {
 protected:
  std::string written(const std::string& name, const Words& arguments) const {
    const Outcome outcome = run_well(arguments + Words{"-q", "-o", name});
    return outcome.status == 0 ? contents(file(name)) : "";
  }
};

/// The file of a new study that paints is the file of the stored one, to the last byte.
TEST_F(StoredOrderTest, IsPaintedAsByANewStudy) {
  for (const char* scene : {"cube_in_glass", "bricks", "cyclic_4", "cross_of_plates", "gear"}) {
    for (const char* method : {"newell", "bsp", "convex-tree"}) {
      for (const char* quality : {"exact", "clear"}) {
        const Words study{"draw",  kStoredScenes + scene + ".json", "--method", method, "--quality", quality, "--hidden",
                          "dashed"};
        ASSERT_NE(written("stored.json", study), "");
        for (const char* fill : {"material", "shade", "paper", "random"}) {
          const std::string by_study = written("new.svg", study + Words{"--fill", fill});
          const Words again{"plot", "stored.json", "--fill",
                            fill,   "--curves",    quality == std::string("clear") ? "on" : "off"};
          EXPECT_EQ(written("again.svg", again), by_study) << scene << ", " << method << ", " << quality << ", " << fill;
        }
      }
    }
  }
}

TEST_F(StoredOrderTest, HasOtherColoursScalesAndPages) {
  ASSERT_NE(written("stored.json", {"draw", kStoredScenes + "cube_in_glass.json", "--method", "newell"}), "");
  const std::string red = written("red.svg", "plot stored.json --fill material --material glass=#ff0000");
  expect_parts(red, {"fill=\"#f00\" fill-opacity=\"0.4\""});
  expect_no_parts(written("own.svg", "plot stored.json --fill material"), {"#f00"});
  expect_parts(written("small.svg", "plot stored.json --fill shade --scale 1:2 --page A5 --landscape"),
               {"width=\"210mm\" height=\"148mm\""});
  expect_parts(written("a.pdf", "plot stored.json --fill random"), {"%PDF"});
  const std::string two = written("two.svg", "plot stored.json stored.json --fill material --grid 2x1 --page A4");
  EXPECT_EQ(count_of(two, "<path") % 2, 0u);
  EXPECT_EQ(run("plot stored.json --fill material --material brick=red -o b.svg").error_lines(), 1u);
}

TEST_F(StoredOrderTest, MistakesAreToldInOneLine) {
  write("a.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='10mm' height='10mm'><path d='M1 1H5' stroke='red'/></svg>");
  ASSERT_NE(written("lines.json", {"draw", kStoredScenes + "bricks.json", "--method", "appel"}), "");
  ASSERT_NE(written("stored.json", {"draw", kStoredScenes + "bricks.json", "--method", "newell"}), "");
  const auto refused = [&](const Words& arguments, const std::string& part) {
    const Outcome outcome = run(arguments + Words("-o x.svg"));
    EXPECT_NE(outcome.status, 0);
    EXPECT_EQ(outcome.error_lines(), 1u);
    expect_parts(outcome.err, {part});
    EXPECT_FALSE(std::filesystem::exists(file("x.svg")));
  };
  refused("plot lines.json --fill material", "has no painting order; ligne draw --method newell");
  refused("plot a.svg --fill material", "--fill: paints a ligne-drawing that has an order");
  refused("plot stored.json --material stone=red", "--material: needs --fill material or shade");
  refused("plot stored.json --fill material --tile A5", "--tile: can not be combined with --fill");
  refused("plot stored.json --fill glow", "--fill: ");
  refused("plot stored.json --fill material --pen outline=1", "--fill: pens draw no filled faces");
  json broken = json::parse(contents(file("stored.json")));
  broken["order"][0]["material"] = 7;
  write("broken.json", broken.dump());
  refused("plot broken.json --fill material", "a piece of the order has a missing material");
  broken["order"][0].erase("material");
  write("older.json", broken.dump());
  refused("plot older.json --fill material", "piece 0 of the order: has no material; draw it again");
  broken["order"][0]["outer"] = json::array();
  write("empty.json", broken.dump());
  refused("plot empty.json --fill material", "piece 0 of the order: a contour has fewer than three points");
}

}  // namespace
}  // namespace ligne::test
