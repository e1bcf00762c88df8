// muParser evaluates; its input has been checked before (scene/surfaces/formula/formula_text.hpp). Its bulk mode is not
// used, since that starts its own threads and the work is already distributed to threads.

#include "scene/surfaces/formula/formula_evaluator.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>

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
    case mu::ecUNEXPECTED_VAR:
      return token + " is not expected here";
    case mu::ecUNEXPECTED_EOF:
      return "ends too early";
    case mu::ecUNEXPECTED_ARG:
      return "several values in parentheses without a function";
    case mu::ecTOO_MANY_PARAMS:
      return "too many arguments for " + token;
    case mu::ecTOO_FEW_PARAMS:
      return "too few arguments for " + token;
    case mu::ecMISSING_ELSE_CLAUSE:
      return "'?' without its ':'";
    case mu::ecMISPLACED_COLON:
      return "':' without its '?'";
    case mu::ecINTERNAL_ERROR:
      return "its parts do not fit together";
    default:
      return token + " is not understood";
  }
}

}  // namespace

struct FormulaEvaluator::Parser {
  mu::Parser parser;

  void define(const FormulaText& formula, std::vector<double>& values) {
    parser.ClearFun();
    parser.ClearConst();
    for (std::size_t i = 0; i < values.size(); ++i) {
      parser.DefineVar(std::string(formula.language.variables[i]), &values[i]);
    }
    for (const FormulaConstant& constant : formula_constants()) {
      parser.DefineConst(std::string(constant.name), constant.value);
    }
    for (const FormulaFunction& function : formula_functions()) {
      std::visit([&](auto call) { parser.DefineFun(std::string(function.name), call); }, function.call);
    }
    parser.SetExpr(formula.text);
  }
};

FormulaEvaluator::FormulaEvaluator(const FormulaText& formula)
    : parser_(std::make_unique<Parser>()), values_(formula.language.variables.size()), uses_(formula.uses) {
  try {
    parser_->define(formula, values_);
    parser_->parser.Eval();
  } catch (const mu::ParserError& error) {
    // Positions count from 0; -1 means that the parser knows none.
    const std::size_t last = formula.columns.size() - 1;
    const std::size_t place = error.GetPos() < 0 ? last : std::min(static_cast<std::size_t>(error.GetPos()), last);
    throw formula_error(formula.language, formula.columns[place], cause_of(error));
  }
  if (parser_->parser.GetNumResults() != 1) throw formula_error(formula.language, 1, "gives more than one value");
}

FormulaEvaluator::~FormulaEvaluator() = default;

double FormulaEvaluator::operator()(std::span<const double> values) {
  std::copy(values.begin(), values.end(), values_.begin());
  const double result = parser_->parser.Eval();
  return std::isfinite(result) ? result : std::numeric_limits<double>::quiet_NaN();
}

FormulaEvaluators::FormulaEvaluators(FormulaText formula) : formula_(std::move(formula)) {
  idle_.push_back(std::make_unique<FormulaEvaluator>(formula_));
}

std::unique_ptr<FormulaEvaluator> FormulaEvaluators::take() const {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<FormulaEvaluator> evaluator = std::move(idle_.back());
      idle_.pop_back();
      return evaluator;
    }
  }
  return std::make_unique<FormulaEvaluator>(formula_);
}

}  // namespace ligne
