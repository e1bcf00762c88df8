#pragma once
/// Converts values of Python to option texts, so that a number, a tuple and a text have the meaning of the command
/// line.

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

namespace ligne::python {

/// Whether the value is a sequence other than a text.
bool is_sequence(pybind11::handle value);

/// Returns a text or a path unchanged, a number in its shortest form, and a sequence as its values with `separator`
/// between them. Throws RequestError of the option for other values.
std::string text_of(const std::string& option, pybind11::handle value, char separator = ',');

/// Returns one text for each value of a repeatable option. A dictionary gives "KEY=VALUE" per entry; a sequence, unless
/// it is one of numbers, gives one text per value.
std::vector<std::string> texts_of(const std::string& option, pybind11::handle value);

/// Returns True or False. Throws RequestError of the option for other values.
bool flag_of(const std::string& option, pybind11::handle value);

}  // namespace ligne::python
