#include "bindings/errors.hpp"

#include <algorithm>
#include <exception>
#include <initializer_list>
#include <new>
#include <string>

#include "files/input_error.hpp"
#include "picture/errors.hpp"
#include "picture/memory.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

/// Never freed: they must outlive the interpreter's own end.
struct Exceptions {
  PyObject *error = nullptr, *input = nullptr, *dtype = nullptr, *request = nullptr, *memory = nullptr;
};
Exceptions exceptions;

PyObject* add(py::module_& module, const char* name, const char* text, std::initializer_list<PyObject*> bases) {
  py::tuple list(bases.size());
  std::size_t i = 0;
  for (PyObject* base : bases) list[i++] = py::reinterpret_borrow<py::object>(base);
  PyObject* made = PyErr_NewExceptionWithDoc((std::string("ligne.") + name).c_str(), text, list.ptr(), nullptr);
  if (!made) throw py::error_already_set();
  module.add_object(name, py::reinterpret_borrow<py::object>(made));
  return made;
}

void raise_request(const RequestError& e) {
  std::string option = e.field(), text = e.what();
  std::replace(option.begin(), option.end(), '-', '_');
  text.replace(0, option.size(), option);
  py::object value = py::reinterpret_borrow<py::object>(exceptions.request)(text);
  value.attr("option") = option;
  PyErr_SetObject(exceptions.request, value.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const RequestError& e) {
    raise_request(e);
  } catch (const InputError& e) {
    PyErr_SetString(exceptions.input, e.what());
  } catch (const DtypeError& e) {
    PyErr_SetString(exceptions.dtype, e.what());
  } catch (const std::bad_alloc& e) {
    const auto* known = dynamic_cast<const MemoryError*>(&e);
    PyErr_SetString(exceptions.memory, known ? known->what() : "not enough memory");
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const std::runtime_error& e) {
    PyErr_SetString(exceptions.error, e.what());
  }
}

}  // namespace

void add_errors(py::module_& module) {
  exceptions.error = add(module, "Error", "Whatever ligne raises of its own.", {PyExc_Exception});
  exceptions.input = add(module, "InputError", "A file or an array can not be used; the text names it and the place.",
                         {exceptions.error, PyExc_ValueError});
  exceptions.dtype = add(module, "DtypeError", "An array holds a kind of values that it can not have; the text names it.",
                         {exceptions.error, PyExc_TypeError});
  exceptions.request = add(module, "RequestError",
                           "A value of an option has no meaning, or two do not go together; `option` is its name, or empty.",
                           {exceptions.error, PyExc_ValueError});
  exceptions.memory = add(module, "MemoryLimitError", "The work would take more memory than there is, or than max_memory.",
                          {exceptions.error, PyExc_MemoryError});
  py::register_exception_translator(&translate);
}

}  // namespace ligne::python
