#pragma once
/// Values of Python as words of options, so that a number, a tuple and a text mean what they mean on the command line.

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

namespace ligne::python {

/// Whether the value is a sequence other than a text.
bool is_sequence(pybind11::handle value);

/// A text or a path as it is, a number in its shortest form, a sequence as its values with `separator` between them. Throws
/// RequestError of the option for anything else.
std::string text_of(const std::string& option, pybind11::handle value, char separator = ',');

/// One text for each value of an option that may be given several times: a dictionary gives "KEY=VALUE" each, a sequence
/// that is not a sequence of numbers one for each of its values.
std::vector<std::string> texts_of(const std::string& option, pybind11::handle value);

/// True or False. Throws RequestError of the option for anything else.
bool flag_of(const std::string& option, pybind11::handle value);

}  // namespace ligne::python
