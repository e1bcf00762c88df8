#pragma once
/// Exceptions of the module.

#include <stdexcept>

#include <pybind11/pybind11.h>

namespace ligne::python {

/// An array of a kind of numbers that it can not have: becomes ligne.DtypeError.
class DtypeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Adds Error and all that derive from it, and how errors of the library become these.
void add_errors(pybind11::module_& module);

}  // namespace ligne::python
