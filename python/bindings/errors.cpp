#include "bindings/errors.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <initializer_list>
#include <new>
#include <string>

#include "files/file_error.hpp"
#include "picture/errors.hpp"
#include "picture/models/memory.hpp"
#include "plotting/writers/output_file.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

/// Never freed, since they must outlive the interpreter.
struct Exceptions {
  PyObject *error = nullptr, *input = nullptr, *dtype = nullptr, *request = nullptr, *memory = nullptr;
  PyObject *file = nullptr, *missing_file = nullptr, *output = nullptr, *missing_folder = nullptr;
};
Exceptions exceptions;

/// The text is the message, also for an OSError with a number and a file.
PyObject* add(py::module_& module, const char* name, const char* text, std::initializer_list<PyObject*> bases) {
  py::dict members;
  members["__str__"] = py::reinterpret_borrow<py::object>(PyExc_BaseException).attr("__str__");
  py::tuple list(bases.size());
  std::size_t i = 0;
  for (PyObject* base : bases) list[i++] = py::reinterpret_borrow<py::object>(base);
  PyObject* made = PyErr_NewExceptionWithDoc((std::string("ligne.") + name).c_str(), text, list.ptr(), members.ptr());
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

void raise_os_error(PyObject* type, const std::string& text, const std::string& file, int error) {
  py::object value = py::reinterpret_borrow<py::object>(type)(text);
  value.attr("errno") = error;
  value.attr("filename") = file;
  PyErr_SetObject(type, value.ptr());
}

bool is_missing(int error) { return error == ENOENT || error == ENOTDIR; }

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const RequestError& e) {
    raise_request(e);
  } catch (const FileError& e) {
    raise_os_error(is_missing(e.error()) ? exceptions.missing_file : exceptions.file, e.what(), e.file(), e.error());
  } catch (const OutputError& e) {
    raise_os_error(is_missing(e.error()) ? exceptions.missing_folder : exceptions.output, e.what(), e.file().string(),
                   e.error());
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
  exceptions.error = add(module, "Error", "Base class of the errors of ligne.", {PyExc_Exception});
  exceptions.input = add(module, "InputError", "A file or an array can not be used; the text names it and the place.",
                         {exceptions.error, PyExc_ValueError});
  exceptions.dtype = add(module, "DtypeError", "An array has an unsupported dtype; the text names it.",
                         {exceptions.error, PyExc_TypeError});
  exceptions.request =
      add(module, "RequestError",
          "An option has an invalid value, or two options can not be combined; `option` is its name, or empty.",
          {exceptions.error, PyExc_ValueError});
  exceptions.memory = add(module, "MemoryLimitError", "The work would take more memory than there is, or than max_memory.",
                          {exceptions.error, PyExc_MemoryError});
  exceptions.file =
      add(module, "FileError", "The system can not read a file; `filename` names it.", {exceptions.input, PyExc_OSError});
  exceptions.missing_file = add(module, "MissingFileError", "There is no such file; `filename` names it.",
                                {exceptions.file, PyExc_FileNotFoundError});
  exceptions.output =
      add(module, "OutputError", "A file can not be written; `filename` names it.", {exceptions.error, PyExc_OSError});
  exceptions.missing_folder =
      add(module, "MissingFolderError", "The folder of a file does not exist; `filename` names the file.",
          {exceptions.output, PyExc_FileNotFoundError});
  py::register_exception_translator(&translate);
}

}  // namespace ligne::python
