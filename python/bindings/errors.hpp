#pragma once
/// Exceptions of the module.

#include <stdexcept>

#include <pybind11/pybind11.h>

namespace ligne::python {

/// An array has an unsupported type of numbers; becomes ligne.DtypeError.
class DtypeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Adds Error and its subclasses, and converts errors of the library to them.
void add_errors(pybind11::module_& module);

}  // namespace ligne::python
