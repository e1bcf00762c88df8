#include "geometry/predicates.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace ligne {
namespace {

/// A sum of non-overlapping doubles in ascending order of size. Its value is the exact sum; its sign is that of the
/// last component that is not zero.
class Expansion {
 public:
  /// Adds x exactly: the rounding error of each two-sum stays as a component of its own.
  void add(double x) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = x + parts_[i];
      const double from_part = sum - x;
      parts_[i] = (x - (sum - from_part)) + (parts_[i] - from_part);
      x = sum;
    }
    parts_[size_++] = x;
  }
  /// Adds a b exactly, as the rounded product and its rounding error.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  int sign() const {
    for (std::size_t i = size_; i-- > 0;) {
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    }
    return 0;
  }

 private:
  std::array<double, 12> parts_{};  // six products of two parts each
  std::size_t size_ = 0;
};

int exact_orientation_sign(Point2 a, Point2 b, Point2 c) {
  // (a - c) x (b - c), expanded: the two products cx cy cancel.
  Expansion det;
  det.add_product(a.x, b.y);
  det.add_product(-a.y, b.x);
  det.add_product(b.x, c.y);
  det.add_product(-b.y, c.x);
  det.add_product(c.x, a.y);
  det.add_product(-c.y, a.x);
  return det.sign();
}

/// The rounding error of the difference a - b.
double difference_error(double a, double b) {
  const double difference = a - b;
  const double b_taken = a - difference;
  return (a - (difference + b_taken)) + (b_taken - b);
}

/// True when the differences of the coordinates from those of c are exact, as they mostly are in collinear input.
bool differences_are_exact(Point2 a, Point2 b, Point2 c) {
  return difference_error(a.x, c.x) == 0 && difference_error(b.y, c.y) == 0 && difference_error(a.y, c.y) == 0 &&
         difference_error(b.x, c.x) == 0;
}

}  // namespace

int orientation_sign(Point2 a, Point2 b, Point2 c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = kOrientationErrorBound * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  if (differences_are_exact(a, b, c)) {
    Expansion exact;
    exact.add_product(a.x - c.x, b.y - c.y);
    exact.add_product(c.y - a.y, b.x - c.x);
    return exact.sign();
  }
  return exact_orientation_sign(a, b, c);
}

}  // namespace ligne
