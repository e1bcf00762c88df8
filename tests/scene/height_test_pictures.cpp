#include <thread>

#include "height_tools.hpp"

namespace ligne {
namespace {

using namespace height_test;

TEST(PointGrid, ScatteredPointsAreTriangulated) {
  // A plane, whatever the triangles; nothing beyond the convex hull.
  std::string text = "x,y,z\n";
  for (int k = 0; k < 200; ++k) {
    const double x = k * 37 % 101 + 0.25 * (k % 3), y = k * 61 % 97 + 0.125 * (k % 5);
    text += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(2 * x - y + 1) + "\n";
  }
  Warnings warnings;
  const auto source = grid(text, warnings);
  ASSERT_TRUE(source->function());
  std::vector<double> z(source->x().size());
  std::size_t inside = 0;
  for (std::size_t j = 0; j < source->y().size(); ++j) {
    source->read_row(j, z);
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (std::isnan(z[i])) continue;
      EXPECT_NEAR(z[i], 2 * source->x()[i] - source->y()[j] + 1, 2e-5);
      ++inside;
    }
  }
  EXPECT_GT(inside, z.size() * source->y().size() * 7 / 10);
  EXPECT_LT(inside, z.size() * source->y().size());
}

TEST(GridFile, WithoutAFile) {
  Warnings warnings;
  EXPECT_EQ(error_line([&] { read_grid(std::filesystem::path("absent.csv"), warnings); }),
            "absent.csv: there is no such file");
}

double value(const std::string& formula, double x, double y) {
  return heights_of(*formula_heights(formula, {x, x + 1}, {y, y + 1}))[0][0];
}

TEST(FormulaHeights, Functions) {
  const double x = 0.3, y = -0.7;
  const std::pair<const char*, double (*)(double)> of_x[] = {
      {"sin", std::sin},   {"cos", std::cos},   {"tan", std::tan},     {"asin", std::asin}, {"acos", std::acos},
      {"atan", std::atan}, {"sinh", std::sinh}, {"cosh", std::cosh},   {"tanh", std::tanh}, {"sqrt", std::sqrt},
      {"exp", std::exp},   {"log", std::log},   {"log10", std::log10}, {"log2", std::log2}, {"ln", std::log}};
  for (const auto& [name, function] : of_x) EXPECT_DOUBLE_EQ(value(std::string(name) + " ( x )", x, y), function(x)) << name;
  EXPECT_DOUBLE_EQ(value("atan2(y, x)", x, y), std::atan2(y, x));
  EXPECT_EQ(value("e", 0, 0), std::numbers::e);
}

TEST(FormulaHeights, SameFromSeveralThreads) {
  std::vector<double> positions(50);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = 0.1 * static_cast<double>(i);
  const auto source = formula_heights("sin(x)*cos(y) + r - theta", positions, positions);
  const auto expected = heights_of(*source);
  std::vector<std::vector<std::vector<double>>> found(4);
  std::vector<std::thread> threads;
  for (auto& heights : found) threads.emplace_back([&] { heights = heights_of(*source); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& heights : found) EXPECT_EQ(heights, expected);
}

}  // namespace
}  // namespace ligne
