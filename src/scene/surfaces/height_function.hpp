#pragma once
/// A formula z = f(x, y) as a function of the plane in which a surface is sampled.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "scene/surfaces/formula_evaluator.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

class HeightFunction {
 public:
  /// Along an axis of `log_axes` coordinates are decimal logarithms: of x and y before the formula has them, of z behind it.
  /// Throws InputError that names the column of a mistake: "formula:COLUMN: cause".
  explicit HeightFunction(const std::string& formula, std::array<bool, 3> log_axes = {});

  /// The function for one thread. It gives NaN where there is no height.
  class At {
   public:
    At(FormulaEvaluator& evaluator, std::array<bool, 3> log_axes) : evaluator_(evaluator), log_axes_(log_axes) {}
    double operator()(double x, double y);

   private:
    FormulaEvaluator& evaluator_;
    std::array<bool, 3> log_axes_;
  };

  /// Calls work(at) with an At that nobody else uses meanwhile.
  template <class Work>
  void use(Work&& work) const {
    evaluators_.use([&](FormulaEvaluator& evaluator) {
      At at(evaluator, log_axes_);
      work(at);
    });
  }

 private:
  FormulaEvaluators evaluators_;
  std::array<bool, 3> log_axes_;
};

/// Its heights over a grid of positions.
std::unique_ptr<HeightSource> heights_of(std::shared_ptr<const HeightFunction> function, std::vector<double> x,
                                         std::vector<double> y);

}  // namespace ligne
