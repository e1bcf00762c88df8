#pragma once
/// The files of a drawing, or of successive views.

#include <string>
#include <vector>

namespace ligne {

/// The names of `count` files: `name` itself for one; else its one place for a number, %d or %04d, holds 1, 2, ... Throws
/// RequestError of "output" where there is no such place, or more than one.
std::vector<std::string> numbered_names(const std::string& name, unsigned count);

/// Whether a name has a place for a number.
bool has_number_place(const std::string& name);

}  // namespace ligne
