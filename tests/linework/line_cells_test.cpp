#include "linework/map/line_cells.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

TEST(WalkedCell, IsNoHairWhereStrokesAreLong) {
  const std::vector<Stroke> strokes(100, stroke({0, 0}, {3'000'000, 4'000'000}));
  EXPECT_EQ(walked_cell(strokes, 5000), 5000) << "few cells";
  EXPECT_EQ(walked_cell({}, 1e-6), 1e-6);
  for (const double wanted : {1.0, 1e-6}) {
    const LineCells grid(walked_cell(strokes, wanted));
    std::size_t cells = 0;
    for (const Stroke& s : strokes) grid.walk(s.from, s.to, wanted, [&](std::uint64_t) { return ++cells, false; });
    EXPECT_LT(cells, 1'000'000u) << wanted;
    EXPECT_GT(cells, 10'000u) << wanted;
  }
}

}  // namespace
}  // namespace ligne
