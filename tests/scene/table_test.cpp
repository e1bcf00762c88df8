// Tables of files, and thinned ones; cells, styles and names of columns: values/tables.txt.

#include "scene/tables/table.hpp"

#include "height_tools.hpp"
#include "scene/surfaces/thinned_heights.hpp"

namespace ligne {
namespace {

TEST(TableFiles, OneTerrainInThirteenHabits) {
  // All files hold these 16 x 12 heights; two are missing in some.
  const auto plain = height_test::heights_of(*height_test::grid(height_test::corpus_file("csv_quoted.csv")));
  ASSERT_EQ(plain.size(), 12u);
  for (const char* file :
       {"fortran_d.txt", "gp_blocks4.dat", "gp_nonuniform.dat", "json_nested.json", "miss_null.csv", "r_unquoted_header.csv",
        "surfer_dsaa.grd", "tsv_comma.tsv", "xyz_xtz.csv", "z.npy", "csv_quoted.csv.gz"}) {
    SCOPED_TRACE(file);
    Warnings warnings;
    const auto found = height_test::heights_of(*height_test::grid(height_test::corpus_file(file), warnings));
    ASSERT_EQ(found.size(), plain.size());
    std::size_t holes = 0;
    for (std::size_t j = 0; j < plain.size(); ++j) {
      ASSERT_EQ(found[j].size(), plain[j].size());
      for (std::size_t i = 0; i < plain[j].size(); ++i) {
        holes += std::isnan(found[j][i]);
        const double height = std::isnan(found[j][i]) ? plain[j][i] : found[j][i];
        EXPECT_NEAR(height, plain[j][i], 1e-6);
      }
    }
    EXPECT_LE(holes, 12u);
  }
}

// Grids of more samples than a page has places for.

using namespace height_test;

/// Heights that tell their place: the number of the row before the comma, that of the column behind it.
class CountedHeights : public HeightSource {
 public:
  CountedHeights(std::size_t columns, std::size_t rows) : HeightSource(counted(columns), counted(rows)) {}
  void read_row(std::size_t j, std::span<double> z) const override {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = static_cast<double>(j) + static_cast<double>(i) / 65536;
  }

 private:
  static std::vector<double> counted(std::size_t n) {
    std::vector<double> positions(n);
    for (std::size_t i = 0; i < n; ++i) positions[i] = 0.5 * static_cast<double>(i);
    return positions;
  }
};

GridChoice thinning(std::optional<unsigned> every = {}) { return {{}, every, true}; }

TEST(ThinnedHeights, AreThoseOfTheGrid) {
  Warnings warnings;
  auto whole = std::make_unique<CountedHeights>(9001, 3000);
  whole->set_unit(GroundUnit::degrees);
  const auto thinned = thinned_heights(std::move(whole), thinning(), warnings);
  EXPECT_EQ(thinned->thinned_by(), 2u);
  EXPECT_EQ(thinned->unit(), GroundUnit::degrees);
  ASSERT_EQ(thinned->x().size(), 4501u);
  ASSERT_EQ(thinned->y().size(), 1501u);
  EXPECT_EQ(thinned->y().back(), 0.5 * 2999);
  std::vector<double> row(4501);
  thinned->read_row(1500, row);
  EXPECT_EQ(row[4500], 2999 + 9000.0 / 65536);
  thinned->read_row(7, row);
  EXPECT_EQ(row[3], 14 + 6.0 / 65536);
  ASSERT_EQ(warnings.counts().size(), 1u);
  EXPECT_EQ(warnings.counts().begin()->first,
            "grid of 9001 x 3000 samples thinned: 1 of 2 rows and columns is drawn; -x and -y choose a part");
}

TEST(ThinnedHeights, SmallGridsStayWhatTheyAre) {
  EXPECT_EQ(thinning_step(10'000, 10'000, {}), 1u) << "nobody allows it";
  Warnings warnings;
  auto whole = std::make_unique<CountedHeights>(90, 30);
  const HeightSource* const before = whole.get();
  EXPECT_EQ(thinned_heights(std::move(whole), thinning(), warnings).get(), before);
  EXPECT_TRUE(warnings.counts().empty());
}

TEST(ThinnedHeights, PicturesAreThinnedWhileTheyAreRead) {
  constexpr std::size_t kColumns = 6000, kRows = 5000;
  std::string text = "P5 6000 5000 255\n";
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column) text += static_cast<char>((row * 7 + column * 3) % 251);
  Warnings warnings;
  const auto heights = read_grid(reader_test::bytes_of(text), "M", warnings, {}, nullptr, thinning());
  EXPECT_EQ(heights->thinned_by(), 2u);
  EXPECT_EQ(heights->x().size(), 3001u);
  EXPECT_EQ(heights->y().size(), 2501u);
  EXPECT_EQ(warnings.counts().size(), 1u);
  std::vector<double> row(3001);
  for (const std::size_t j : {std::size_t{0}, std::size_t{1}, std::size_t{1300}, std::size_t{2500}}) {
    heights->read_row(j, row);
    const auto y = static_cast<std::size_t>(heights->y()[j]);
    EXPECT_EQ(y, j == 2500 ? kRows - 1 : 2 * j);
    for (const std::size_t i : {std::size_t{0}, std::size_t{17}, std::size_t{3000}}) {
      const auto x = static_cast<std::size_t>(heights->x()[i]);
      EXPECT_EQ(row[i], static_cast<double>(((kRows - 1 - y) * 7 + x * 3) % 251));
    }
  }
}

}  // namespace
}  // namespace ligne
