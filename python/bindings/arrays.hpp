#pragma once
/// Arrays of numpy. Input is read in place; output keeps its owner alive.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <pybind11/numpy.h>

namespace ligne::python {

/// Makes the array read-only and returns it.
template <class T>
pybind11::array_t<T> read_only(pybind11::array_t<T> array) {
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// A read-only array over `data`, which belongs to `owner`.
template <class T>
pybind11::array_t<T> view(const T* data, std::vector<pybind11::ssize_t> shape, pybind11::handle owner) {
  return read_only(pybind11::array_t<T>(std::move(shape), data, owner));
}

/// A read-only array that owns the values.
template <class T>
pybind11::array_t<T> owned(std::vector<T>&& values, std::vector<pybind11::ssize_t> shape) {
  auto held = std::make_unique<std::vector<T>>(std::move(values));
  const pybind11::capsule owner(held.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  const T* data = held.release()->data();
  return view<T>(data, std::move(shape), owner);
}

}  // namespace ligne::python
