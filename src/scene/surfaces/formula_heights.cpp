#include <array>
#include <cmath>
#include <utility>

#include "scene/surfaces/formula_evaluator.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {
namespace {

class FormulaHeights : public HeightSource {
 public:
  FormulaHeights(FormulaText formula, std::vector<double> x, std::vector<double> y)
      : HeightSource(std::move(x), std::move(y)), evaluators_(std::move(formula)) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    evaluators_.use([&](FormulaEvaluator& evaluator) {
      std::array<double, kFormulaVariables.size()> values{0, y()[j], 0, 0};
      for (std::size_t i = 0; i < z.size(); ++i) {
        values[0] = x()[i];
        if (evaluator.uses(2)) values[2] = std::hypot(values[0], values[1]);
        if (evaluator.uses(3)) values[3] = std::atan2(values[1], values[0]);
        z[i] = evaluator(values);
      }
    });
  }

 private:
  FormulaEvaluators evaluators_;
};

}  // namespace

std::unique_ptr<HeightSource> formula_heights(const std::string& formula, std::vector<double> x, std::vector<double> y) {
  return std::make_unique<FormulaHeights>(prepare_formula(formula), std::move(x), std::move(y));
}

}  // namespace ligne
