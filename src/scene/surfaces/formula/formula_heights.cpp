#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "scene/surfaces/formula/formula_evaluator.hpp"
#include "scene/surfaces/formula/height_function.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {
namespace {

class FormulaAt : public HeightFunction::At {
 public:
  FormulaAt(FormulaEvaluator& evaluator, std::array<bool, 3> log_axes) : evaluator_(evaluator), log_axes_(log_axes) {}

  double operator()(double x, double y) override {
    std::array<double, kFormulaVariables.size()> values{log_axes_[0] ? std::pow(10, x) : x,
                                                        log_axes_[1] ? std::pow(10, y) : y, 0, 0};
    if (evaluator_.uses(2)) values[2] = std::hypot(values[0], values[1]);
    if (evaluator_.uses(3)) values[3] = std::atan2(values[1], values[0]);
    const double z = evaluator_(values);
    if (!log_axes_[2]) return z;
    return z > 0 ? std::log10(z) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  FormulaEvaluator& evaluator_;
  std::array<bool, 3> log_axes_;
};

class FormulaSurface : public HeightFunction {
 public:
  FormulaSurface(const std::string& formula, std::array<bool, 3> log_axes)
      : evaluators_(prepare_formula(formula)), log_axes_(log_axes) {}

  void use(FunctionRef<void(At&)> work) const override {
    evaluators_.use([&](FormulaEvaluator& evaluator) {
      FormulaAt at(evaluator, log_axes_);
      work(at);
    });
  }

 private:
  FormulaEvaluators evaluators_;
  std::array<bool, 3> log_axes_;
};

class FunctionHeights : public HeightSource {
 public:
  FunctionHeights(std::shared_ptr<const HeightFunction> function, std::vector<double> x, std::vector<double> y)
      : HeightSource(std::move(x), std::move(y)), function_(std::move(function)) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    function_->use([&](HeightFunction::At& at) {
      for (std::size_t i = 0; i < z.size(); ++i) z[i] = at(x()[i], y()[j]);
    });
  }

 private:
  std::shared_ptr<const HeightFunction> function_;
};

}  // namespace

std::shared_ptr<const HeightFunction> formula_function(const std::string& formula, std::array<bool, 3> log_axes) {
  return std::make_shared<FormulaSurface>(formula, log_axes);
}

std::unique_ptr<HeightSource> heights_of(std::shared_ptr<const HeightFunction> function, std::vector<double> x,
                                         std::vector<double> y) {
  return std::make_unique<FunctionHeights>(std::move(function), std::move(x), std::move(y));
}

std::unique_ptr<HeightSource> formula_heights(const std::string& formula, std::vector<double> x, std::vector<double> y) {
  return heights_of(formula_function(formula), std::move(x), std::move(y));
}

}  // namespace ligne
