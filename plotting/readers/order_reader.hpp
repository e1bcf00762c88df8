#pragma once
/// The order of painting of a ligne-drawing, which is most of a large file: its pieces are read without a tree of values.

#include <string>
#include <string_view>

#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

/// A ligne-drawing whose order and regions are empty lists, and the text of its order; empty where it has none.
struct SplitDrawing {
  std::string rest;
  std::string_view order;  ///< a part of the text that was given
};

/// Throws InputError("FILE: ...") for what is no object.
SplitDrawing split_drawing(std::string_view json, const std::string& file);

/// Appends the pieces to ReadOrder::order and ReadOrder::pieces. Throws InputError.
void read_pieces(std::string_view array, const std::string& file, ReadOrder& to);

}  // namespace ligne
