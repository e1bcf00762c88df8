#pragma once
/// Names of the files of a drawing in parts, or of successive views.

#include <string>
#include <vector>

#include "picture/pages/write_picture.hpp"

namespace ligne {

/// The names of `count` files. One file has `name` itself; otherwise 1, 2, ... replace its placeholder, such as %d or
/// %04d. Throws RequestError of "output" if the name does not have exactly one placeholder.
std::vector<std::string> numbered_names(const std::string& name, unsigned count);

/// Whether a name has a placeholder: %d, or %p for the letter p.
bool has_number_place(const std::string& name, char letter = 'd');

/// The name with the number in place of its placeholder; unchanged if it has none.
std::string with_number(const std::string& name, unsigned number, char letter = 'd');

/// The name of a part of a plot: its number replaces %d, its pen %p.
std::string name_of(const std::string& name, const PicturePart& part);

}  // namespace ligne
