#pragma once
/// Arrays for values that several threads write, which also get the memory from the system then.

#include <cstddef>
#include <memory>

namespace ligne {

/// So many values of a plain type, which are to be written before they are read: nothing is put into them first. Where a
/// vector is wanted, see large_vector.hpp.
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
