#pragma once
/// Evaluates a formula at many places.

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "scene/surfaces/formula/formula_text.hpp"

namespace ligne {

/// A parser with its variables, for one thread at a time.
class FormulaEvaluator {
 public:
  /// Throws InputError for mistakes that only the parser finds.
  explicit FormulaEvaluator(const FormulaText& formula);
  ~FormulaEvaluator();
  FormulaEvaluator(const FormulaEvaluator&) = delete;
  FormulaEvaluator& operator=(const FormulaEvaluator&) = delete;

  /// `values` are those of the language's variables, in their order. Returns NaN if the result is not a finite number.
  double operator()(std::span<const double> values);
  /// Whether the formula uses the variable with this number.
  bool uses(std::size_t variable) const { return uses_[variable]; }

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::vector<double> values_;
  std::vector<bool> uses_;
};

/// Evaluators of one formula for any number of threads.
class FormulaEvaluators {
 public:
  /// Throws InputError as FormulaEvaluator does.
  explicit FormulaEvaluators(FormulaText formula);

  /// Calls work(evaluator) with an evaluator that nobody else uses meanwhile. There are as many evaluators as threads
  /// that work at the same time.
  template <class Work>
  void use(Work&& work) const {
    std::unique_ptr<FormulaEvaluator> evaluator = take();
    work(*evaluator);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(evaluator));
  }

 private:
  std::unique_ptr<FormulaEvaluator> take() const;

  FormulaText formula_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<FormulaEvaluator>> idle_;  ///< guarded by mutex_
};

}  // namespace ligne
