#include "bindings/values.hpp"

#include "files/message_text.hpp"
#include "picture/errors.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

bool is_number(py::handle value) {
  return !PyBool_Check(value.ptr()) && (PyFloat_Check(value.ptr()) || PyIndex_Check(value.ptr()));
}

bool is_text(py::handle value) { return py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__"); }

std::string plain_text(const std::string& option, py::handle value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::hasattr(value, "__fspath__")) return py::module_::import("os").attr("fspath")(value).cast<std::string>();
  if (PyBool_Check(value.ptr())) return value.cast<bool>() ? "on" : "off";
  if (PyFloat_Check(value.ptr())) return py::repr(py::float_(value.cast<double>())).cast<std::string>();
  if (PyIndex_Check(value.ptr()))
    return py::str(py::int_(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr())))).cast<std::string>();
  if (py::hasattr(value, "__float__"))
    return py::repr(py::float_(py::reinterpret_borrow<py::object>(value))).cast<std::string>();
  throw RequestError(
      option, "a " + std::string(py::str(py::type::handle_of(value).attr("__name__"))) + " is not a valid value for it");
}

}  // namespace

bool is_sequence(py::handle value) { return !is_text(value) && PySequence_Check(value.ptr()) != 0; }

std::string text_of(const std::string& option, py::handle value, char separator) {
  if (!is_sequence(value)) return plain_text(option, value);
  std::string text;
  bool first = true;
  for (const py::handle item : value) {
    if (!first) text += separator;
    first = false;
    text += plain_text(option, item);
  }
  return text;
}

std::vector<std::string> texts_of(const std::string& option, py::handle value) {
  std::vector<std::string> texts;
  if (py::isinstance<py::dict>(value)) {
    for (const auto& [key, item] : value.cast<py::dict>())
      texts.push_back(text_of(option, key) + "=" + text_of(option, item));
    return texts;
  }
  bool numbers = is_sequence(value);
  if (numbers) {
    for (const py::handle item : value) numbers = numbers && is_number(item);
  }
  if (!is_sequence(value) || numbers) return {text_of(option, value)};
  for (const py::handle item : value) texts.push_back(text_of(option, item));
  return texts;
}

bool flag_of(const std::string& option, py::handle value) {
  if (PyBool_Check(value.ptr())) return value.cast<bool>();
  throw RequestError(option, "is neither True nor False");
}

}  // namespace ligne::python
