#pragma once
/// Reads the order of painting of a ligne-drawing. It is most of a large file, so its pieces are read without a tree of
/// values.

#include <string>
#include <string_view>

#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

/// The text of a ligne-drawing with empty lists as order and regions, and the text of its order, empty if there is
/// none.
struct SplitDrawing {
  std::string rest;
  std::string_view order;  ///< a part of the given text
};

/// Throws InputError("FILE: ...") if the text is not an object.
SplitDrawing split_drawing(std::string_view json, const std::string& file);

/// Appends the pieces to ReadOrder::order and ReadOrder::pieces. Throws InputError.
void read_pieces(std::string_view array, const std::string& file, ReadOrder& to);

}  // namespace ligne
