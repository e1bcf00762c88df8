#include <numbers>
#include <thread>

#include "height_tools.hpp"

namespace ligne {
namespace {

using namespace height_test;

double value(const std::string& formula, double x, double y) {
  return heights_of(*formula_heights(formula, {x, x + 1}, {y, y + 1}))[0][0];
}

std::string error(const std::string& formula) {
  return error_line([&] { formula_heights(formula, {0, 1}, {0, 1}); });
}

TEST(FormulaHeights, RowsAreThoseOfY) {
  expect_grid(*formula_heights("10*x + y", {1, 2, 3}, {4, 5}), {1, 2, 3}, {4, 5}, {{14, 24, 34}, {15, 25, 35}});
}

TEST(FormulaHeights, OperatorsBindAsInMathematics) {
  EXPECT_EQ(value("-x^2", 2, 3), -4);
  EXPECT_EQ(value("2^3^2", 0, 0), 512);
  EXPECT_EQ(value("2^-1", 0, 0), 0.5);
  EXPECT_EQ(value("x ** 2 + y**3", 2, 3), 31);
  EXPECT_EQ(value("x - y - 1", 2, 3), -2);
  EXPECT_EQ(value("x/y/2", 6, 3), 1);
  EXPECT_EQ(value("1 + 2*3", 0, 0), 7);
  EXPECT_EQ(value("(1 + 2)*3", 0, 0), 9);
  EXPECT_EQ(value("x--y", 2, 3), 5);
  EXPECT_EQ(value("2*-x", 2, 3), -4);
  EXPECT_EQ(value(".5e1 + 1.", 0, 0), 6);
}

TEST(FormulaHeights, ComparisonsAndChoices) {
  EXPECT_EQ(value("x <= 2 && y > 3 || x == 2", 2, 3), 1);
  EXPECT_EQ(value("x != 2", 2, 3), 0);
  EXPECT_EQ(value("x < y ? 1 : 2", 2, 3), 1);
  EXPECT_EQ(value("x >= y ? 1 : x == 2 ? 5 : 6", 2, 3), 5);
  EXPECT_EQ(value("if(x > y, 1, if(x == 2, 7, 8))", 2, 3), 7);
  EXPECT_TRUE(std::isnan(value("if(sqrt(-x), 1, 2)", 2, 3)));
}

TEST(FormulaHeights, VariablesAndConstants) {
  EXPECT_EQ(value("r", 3, 4), 5);
  EXPECT_EQ(value("theta", -1, 0), std::numbers::pi);
  EXPECT_EQ(value("theta", 0, -2), -std::numbers::pi / 2);
  EXPECT_EQ(value("pi", 0, 0), std::numbers::pi);
  EXPECT_EQ(value("e", 0, 0), std::numbers::e);
  EXPECT_EQ(value("sin ( x )", 1, 0), std::sin(1.0));
}

TEST(FormulaHeights, Functions) {
  const double x = 0.3, y = -0.7;
  const std::vector<std::pair<std::string, double>> cases{{"sin(x)", std::sin(x)},
                                                          {"cos(x)", std::cos(x)},
                                                          {"tan(x)", std::tan(x)},
                                                          {"asin(x)", std::asin(x)},
                                                          {"acos(x)", std::acos(x)},
                                                          {"atan(x)", std::atan(x)},
                                                          {"atan2(y, x)", std::atan2(y, x)},
                                                          {"sinh(x)", std::sinh(x)},
                                                          {"cosh(x)", std::cosh(x)},
                                                          {"tanh(x)", std::tanh(x)},
                                                          {"sqrt(x)", std::sqrt(x)},
                                                          {"exp(x)", std::exp(x)},
                                                          {"log(x)", std::log(x)},
                                                          {"log10(x)", std::log10(x)},
                                                          {"log2(x)", std::log2(x)},
                                                          {"abs(y)", 0.7},
                                                          {"min(x, y, 3)", y},
                                                          {"max(x, y, -3)", x},
                                                          {"min(x)", x},
                                                          {"floor(y)", -1},
                                                          {"ceil(y)", 0},
                                                          {"round(y)", -1},
                                                          {"round(-2.5)", -3},
                                                          {"sign(y)", -1},
                                                          {"sign(0)", 0},
                                                          {"mod(5, 3)", 2},
                                                          {"mod(-1, 3)", 2},
                                                          {"mod(1, -3)", -2},
                                                          {"mod(-3, 3)", 0},
                                                          {"hypot(3, 4)", 5}};
  for (const auto& [formula, expected] : cases) EXPECT_DOUBLE_EQ(value(formula, x, y), expected) << formula;
}

TEST(FormulaHeights, WhatIsNoFiniteNumberIsAHole) {
  for (const char* formula :
       {"1/x", "x/x", "log(x)", "sqrt(-1)", "asin(2)", "exp(1000)", "mod(1, x)", "min(1, 0/x)", "max(0/x, 1)"}) {
    EXPECT_TRUE(std::isnan(value(formula, 0, 0))) << formula;
  }
  EXPECT_DOUBLE_EQ(value("atan(1/x)", 0, 0), std::numbers::pi / 2) << "infinite on the way, finite in the end";
}

TEST(FormulaHeights, ErrorsNameTheColumn) {
  EXPECT_EQ(error(""), "formula:1: is empty");
  EXPECT_EQ(error(" \t"), "formula:1: is empty");
  EXPECT_EQ(error("x + foo"), "formula:5: unknown name 'foo'; there are x, y, r, theta, pi and e");
  EXPECT_EQ(error("x + foo (x)").find("formula:5: unknown function 'foo'; there are sin cos tan "), 0u);
  EXPECT_NE(error("foo(x)").find(" erf "), std::string::npos);
  EXPECT_EQ(error("X"), "formula:1: unknown name 'X'; there are x, y, r, theta, pi and e");
  EXPECT_EQ(error("1 + sin"), "formula:5: function 'sin' without its arguments in parentheses");
  EXPECT_EQ(error("2x"), "formula:2: an operator is missing before 'x'");
  EXPECT_EQ(error("x (y)"), "formula:3: an operator is missing before '('");
  EXPECT_EQ(error("x = 3"), "formula:3: nothing can be assigned; == compares");
  EXPECT_EQ(error("x + \"abc\""), "formula:5: character '\"' has no meaning in a formula");
  EXPECT_EQ(error("x\u20ac"), "formula:2: character '\xE2\x82\xAC' has no meaning in a formula");
  EXPECT_EQ(error("1e999"), "formula:1: '1e999' is out of the range of numbers");
  EXPECT_EQ(error("x + ."), "formula:5: '.' is not a number");
  EXPECT_EQ(error("(x + (y)"), "formula:1: '(' without its ')'");
  EXPECT_EQ(error("x + y)"), "formula:6: ')' without its '('");
  EXPECT_EQ(error("x, y"), "formula:2: ',' outside the arguments of a function");
  EXPECT_EQ(error("(x, y)"), "formula:7: several values in parentheses that belong to no function");
  EXPECT_EQ(error("x + "), "formula:5: ends too early");
  EXPECT_EQ(error("x  */ y"), "formula:5: '/' is not expected here");
  EXPECT_EQ(error("()"), "formula:2: ')' is not expected here");
  EXPECT_EQ(error("hypot(1)"), "formula:8: too few arguments for 'hypot'");
  EXPECT_EQ(error("sin(1, 2)"), "formula:9: too many arguments for 'sin'");
  EXPECT_EQ(error("x ? y"), "formula:6: '?' without its ':'");
  EXPECT_EQ(error("x : y"), "formula:5: ':' without its '?'");
  EXPECT_EQ(error("(x ? y) : 1"), "formula:12: parts of it do not belong together");
  EXPECT_EQ(error(std::string("x\0y", 3)), "formula:2: character '\\x00' has no meaning in a formula");
}

TEST(FormulaHeights, HostileLengths) {
  EXPECT_EQ(error(std::string(1'000'000, '(')), "formula:10001: is longer than 10000 characters");
  EXPECT_EQ(error(std::string(10'000, '(')), "formula:10000: '(' without its ')'");
  std::string nested(4'000, '(');
  nested.append("x").append(4'000, ')');
  EXPECT_EQ(value(nested, 2, 3), 2);
  std::string sum = "x";
  while (sum.size() + 2 <= 10'000) sum += "+1";
  EXPECT_EQ(value(sum, 0, 0), 4999);
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

TEST(Formula, PrintedCharactersAndMoreFunctions) {
  expect_grid(*formula_heights("x² + y³ − 2·x", {1, 2, 3}, {1, 2}), {1, 2, 3}, {1, 2}, {{0, 1, 4}, {7, 8, 11}});
  expect_grid(*formula_heights("ln(e^x) + pow(y,2) + cbrt(8) + erf(0) + sec(0)", {1, 2}, {1, 2}), {1, 2}, {1, 2},
              {{5, 6}, {8, 9}});
  EXPECT_EQ(error("x²y").substr(0, 40), "formula:4: an operator is missing before");
  EXPECT_EQ(error("²"), "formula:1: '^' is not expected here");
}

}  // namespace
}  // namespace ligne
