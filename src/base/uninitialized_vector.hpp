#pragma once
/// Arrays that several threads fill, so that the page faults of the fresh memory are parallel too.

#include <cstddef>
#include <memory>

namespace ligne {

/// An array of n elements of a trivial type, not initialized: each must be written before it is read. If a std::vector
/// is needed, see large_vector.hpp.
template <class T>
class UninitializedVector {
 public:
  explicit UninitializedVector(std::size_t n = 0) : values_(std::make_unique_for_overwrite<T[]>(n)) {}
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  T* data() { return values_.get(); }
  const T* data() const { return values_.get(); }

 private:
  std::unique_ptr<T[]> values_;
};

}  // namespace ligne
