#pragma once
/// The files of a drawing, or of successive views.

#include <string>
#include <vector>

#include "picture/pages/write_picture.hpp"

namespace ligne {

/// The names of `count` files: `name` itself for one; else its one place for a number, %d or %04d, holds 1, 2, ... Throws
/// RequestError of "output" where there is no such place, or more than one.
std::vector<std::string> numbered_names(const std::string& name, unsigned count);

/// Whether a name has a place for a number: %d, or %p with the letter p.
bool has_number_place(const std::string& name, char letter = 'd');

/// The name with the number in its place; as it is where it has none.
std::string with_number(const std::string& name, unsigned number, char letter = 'd');

/// The name of a part of a plot: its number for %d, its pen for %p.
std::string name_of(const std::string& name, const PicturePart& part);

}  // namespace ligne
