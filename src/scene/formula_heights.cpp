// muParser evaluates; what it is given has been looked through first (scene/formula_text.hpp). Its bulk mode is not used: it starts
// threads of its own, and the rows are dealt out to threads already.

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "scene/formula_text.hpp"
#include "scene/height_source.hpp"
#include "scene/text_lines.hpp"

namespace ligne {
namespace {

std::string cause_of(const mu::ParserError& error) {
  const std::string token = shown(error.GetToken());
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_OPERATOR:
    case mu::ecUNEXPECTED_ARG_SEP:
    case mu::ecUNEXPECTED_PARENS:
    case mu::ecUNEXPECTED_FUN:
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR: return token + " is not expected here";
    case mu::ecUNEXPECTED_EOF: return "ends too early";
    case mu::ecUNEXPECTED_ARG: return "several values in parentheses that belong to no function";
    case mu::ecTOO_MANY_PARAMS: return "too many arguments for " + token;
    case mu::ecTOO_FEW_PARAMS: return "too few arguments for " + token;
    case mu::ecMISSING_ELSE_CLAUSE: return "'?' without its ':'";
    case mu::ecMISPLACED_COLON: return "':' without its '?'";
    case mu::ecINTERNAL_ERROR: return "parts of it do not belong together";
    default: return token + " is not understood";
  }
}

/// One parser with the variables it reads; for one thread at a time.
class Evaluator {
 public:
  /// Throws InputError.
  explicit Evaluator(const FormulaText& formula) : uses_(formula.uses) {
    try {
      define(formula);
      parser_.Eval();
    } catch (const mu::ParserError& error) {
      // Positions count from 0, and are -1 where the parser knows of none.
      const std::size_t last = formula.columns.size() - 1;
      const std::size_t place = error.GetPos() < 0 ? last : std::min(static_cast<std::size_t>(error.GetPos()), last);
      throw formula_error(formula.columns[place], cause_of(error));
    }
    if (parser_.GetNumResults() != 1) throw formula_error(1, "gives more than one value");
  }
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// NaN where the formula is not a finite number.
  double operator()(double x, double y) {
    x_ = x;
    y_ = y;
    if (uses_[2]) r_ = std::hypot(x, y);
    if (uses_[3]) theta_ = std::atan2(y, x);
    const double z = parser_.Eval();
    return std::isfinite(z) ? z : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  void define(const FormulaText& formula) {
    parser_.ClearFun();
    parser_.ClearConst();
    double* const variables[] = {&x_, &y_, &r_, &theta_};
    for (std::size_t i = 0; i < kFormulaVariables.size(); ++i) {
      parser_.DefineVar(std::string(kFormulaVariables[i]), variables[i]);
    }
    for (const FormulaConstant& constant : formula_constants()) {
      parser_.DefineConst(std::string(constant.name), constant.value);
    }
    for (const FormulaFunction& function : formula_functions()) {
      std::visit([&](auto call) { parser_.DefineFun(std::string(function.name), call); }, function.call);
    }
    parser_.SetExpr(formula.text);
  }

  mu::Parser parser_;
  std::array<bool, 4> uses_;
  double x_ = 0, y_ = 0, r_ = 0, theta_ = 0;
};

class FormulaHeights : public HeightSource {
 public:
  FormulaHeights(FormulaText formula, std::vector<double> x, std::vector<double> y)
      : HeightSource(std::move(x), std::move(y)), formula_(std::move(formula)) {
    idle_.push_back(std::make_unique<Evaluator>(formula_));
  }

  void read_row(std::size_t j, std::span<double> z) const override {
    std::unique_ptr<Evaluator> evaluator = take();
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = (*evaluator)(x()[i], y()[j]);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(evaluator));
  }

 private:
  /// An evaluator that nobody else uses: as many come to be as rows are read at a time.
  std::unique_ptr<Evaluator> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Evaluator> evaluator = std::move(idle_.back());
        idle_.pop_back();
        return evaluator;
      }
    }
    return std::make_unique<Evaluator>(formula_);
  }

  FormulaText formula_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Evaluator>> idle_;  ///< guarded by mutex_
};

}  // namespace

std::unique_ptr<HeightSource> formula_heights(const std::string& formula, std::vector<double> x, std::vector<double> y) {
  return std::make_unique<FormulaHeights>(prepare_formula(formula), std::move(x), std::move(y));
}

}  // namespace ligne
