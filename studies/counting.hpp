#pragma once
/// Number types that count the operations done with them, for algorithms that are templates over the number type.
///
/// A number points to the tally in which it counts; a result uses the tally of its left operand. Sums, products, quotients,
/// comparisons and assignments to an existing variable are counted; copies into new variables or parameters are not.
/// CountedTable counts accesses to tables.

#include <cstdint>
#include <utility>
#include <vector>

namespace ligne::studies {

/// The seven kinds of operation that [Boulle1980] 2.3.3.4 counts.
struct Operations {
  std::uint64_t additions = 0, subtractions = 0, products = 0, quotients = 0, accesses = 0, tests = 0, assignments = 0;

  std::uint64_t sums() const { return additions + subtractions; }  ///< "+" of [Boulle1980] 3
  std::uint64_t total() const { return additions + subtractions + products + quotients + accesses + tests + assignments; }
  void operator+=(const Operations& o) {
    additions += o.additions;
    subtractions += o.subtractions;
    products += o.products;
    quotients += o.quotients;
    accesses += o.accesses;
    tests += o.tests;
    assignments += o.assignments;
  }
};

template <class T>
class Counted {
 public:
  Counted() = default;
  Counted(T value, Operations* tally) : value_(value), tally_(tally) {}
  Counted(const Counted&) = default;
  Counted& operator=(const Counted& o) {
    value_ = o.value_;
    tally_ = o.tally_;
    if (tally_) ++tally_->assignments;
    return *this;
  }

  T value() const { return value_; }
  Operations* tally() const { return tally_; }

  friend Counted operator+(const Counted& a, const Counted& b) {
    return a.result(&Operations::additions, a.value_ + b.value_);
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return a.result(&Operations::subtractions, a.value_ - b.value_);
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return a.result(&Operations::products, a.value_ * b.value_);
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return a.result(&Operations::quotients, a.value_ / b.value_);
  }
  friend bool operator<(const Counted& a, const Counted& b) { return a.tested(a.value_ < b.value_); }
  friend bool operator>(const Counted& a, const Counted& b) { return a.tested(a.value_ > b.value_); }
  friend bool operator<=(const Counted& a, const Counted& b) { return a.tested(a.value_ <= b.value_); }
  friend bool operator>=(const Counted& a, const Counted& b) { return a.tested(a.value_ >= b.value_); }
  friend bool operator==(const Counted& a, const Counted& b) { return a.tested(a.value_ == b.value_); }
  friend bool operator!=(const Counted& a, const Counted& b) { return a.tested(a.value_ != b.value_); }

  /// A constant that counts in this number's tally.
  Counted constant(T value) const { return {value, tally_}; }

 private:
  Counted result(std::uint64_t Operations::*kind, T value) const {
    if (tally_) ++(tally_->*kind);
    return {value, tally_};
  }
  bool tested(bool answer) const {
    if (tally_) ++tally_->tests;
    return answer;
  }

  T value_{};
  Operations* tally_ = nullptr;
};

/// Constants and logical connectives that work for plain and for counted numbers.
template <class T>
T constant_like(const T&, double value) {
  return static_cast<T>(value);
}
template <class T>
Counted<T> constant_like(const Counted<T>& like, double value) {
  return like.constant(static_cast<T>(value));
}
template <class T>
void count_test(const T&) {}
template <class T>
void count_test(const Counted<T>& like) {
  if (like.tally()) ++like.tally()->tests;
}

/// A table that counts its accesses.
template <class T>
class CountedTable {
 public:
  explicit CountedTable(Operations& tally) : tally_(&tally) {}
  CountedTable(std::vector<T> items, Operations& tally) : items_(std::move(items)), tally_(&tally) {}

  T& operator[](std::size_t i) {
    ++tally_->accesses;
    return items_[i];
  }
  const T& operator[](std::size_t i) const {
    ++tally_->accesses;
    return items_[i];
  }
  std::size_t size() const { return items_.size(); }
  void push_back(T item) {
    ++tally_->accesses;
    items_.push_back(std::move(item));
  }
  void pop_back() { items_.pop_back(); }
  const std::vector<T>& items() const { return items_; }

 private:
  std::vector<T> items_;
  Operations* tally_;
};

}  // namespace ligne::studies
