#pragma once
/// A function z = f(x, y) over the plane in which a surface is sampled.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {

class HeightSource;

class HeightFunction {
 public:
  virtual ~HeightFunction() = default;

  /// Evaluates the function in one thread. It gives NaN where there is no height.
  class At {
   public:
    virtual ~At() = default;
    virtual double operator()(double x, double y) = 0;
  };

  /// Whether the function never jumps and has no poles.
  virtual bool is_continuous() const { return false; }

  /// Calls work(at) with an At that nobody else uses meanwhile.
  virtual void use(FunctionRef<void(At&)> work) const = 0;
};

/// A formula. Along an axis of `log_axes`, coordinates are decimal logarithms: x and y before the formula gets them, z
/// after it. Throws InputError with the column of the mistake: "formula:COLUMN: cause".
std::shared_ptr<const HeightFunction> formula_function(const std::string& formula, std::array<bool, 3> log_axes = {});

/// Heights of a function at a grid of positions.
std::unique_ptr<HeightSource> heights_of(std::shared_ptr<const HeightFunction> function, std::vector<double> x,
                                         std::vector<double> y);

}  // namespace ligne
