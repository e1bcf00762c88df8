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

TEST_F(StoredOrderTest, MistakesAreToldInOneLine) {
  ASSERT_NE(written("stored.json", {"draw", kStoredScenes + "bricks.json", "--method", "newell"}), "");
  const auto refused = [&](const Words& arguments, const std::string& part) {
    expect_outcome(arguments + Words("-o x.svg"), kFailed, {part});
    EXPECT_FALSE(exists("x.svg"));
  };
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
