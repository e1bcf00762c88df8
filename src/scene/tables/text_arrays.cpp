// Arrays as programs write them: MATLAB's [1 2; 3 4], the braces of C, and the arrays that numpy prints.

#include <algorithm>
#include <cctype>
#include <limits>

#include "files/message_text.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/tables/cell_value.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {
namespace {

constexpr char kEndOfCell[] = " \t\r\n,;[]{}()";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

class ArrayParser {
 public:
  ArrayParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// Whether a name and "=", or "array(", stands before the first array.
  bool begins_with_name() {
    skip(" \t\r\n");
    if (!is_letter(here())) return false;
    take_head();
    return has_name_ && here(1) != '\0' && (here() == '[' || here() == '{') &&
           std::string_view(" \t\r\n[{+-.0123456789nN").find(here(1)) != std::string_view::npos;
  }

  std::vector<DataArray> read() {
    std::vector<DataArray> arrays;
    for (skip(" \t\r\n,;"); at_ < text_.size(); skip(" \t\r\n,;")) {
      const std::string_view rest = text_.substr(at_);
      take_head();
      if (here() != '[' && here() != '{')
        throw error_at_line(name_, line_, shown(rest.substr(0, rest.find_first_of("\r\n"))) + " is not an array of numbers");
      arrays.push_back(take_array());
    }
    return arrays;
  }

 private:
  char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  /// Passes over these characters and comments.
  void skip(std::string_view characters) {
    while (at_ < text_.size()) {
      if (here() == '%' || here() == '#' || (here() == '/' && here(1) == '/')) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (characters.find(here()) != std::string_view::npos) {
        line_ += text_[at_++] == '\n';
      } else {
        return;
      }
    }
  }

  /// Passes over a name, or a declaration in C, up to a bracket: "z =", "double z[2][2] =", "z = np.array(".
  void take_head() {
    array_.name.clear();
    is_call_ = has_name_ = false;
    if (!is_letter(here())) return;
    const std::size_t equals = text_.find_first_of("=\n(", at_);
    if (equals != std::string_view::npos && text_[equals] == '=') {
      std::string_view head = text_.substr(at_, equals - at_);
      head = trimmed(head.substr(0, head.find('[')));
      array_.name = head.substr(head.find_last_of(" \t*") + 1);
      has_name_ = true;
      at_ = equals + 1;
      skip(" \t\r\n");
    }
    for (const std::string_view word : {"np.", "numpy.", "array("}) {
      if (!text_.substr(at_).starts_with(word)) continue;
      at_ += word.size();
      is_call_ = has_name_ = word == "array(";
    }
  }

  /// Ends a row. In C a comma may follow the last one.
  void end_row() {
    if (cells_ == 0) return;
    if (rows_++ == 0) columns_ = cells_;
    if (cells_ != columns_)
      throw error_at_line(name_, line_,
                          "row of " + std::to_string(cells_) + " numbers; those above have " + std::to_string(columns_));
    cells_ = 0;
  }

  void take_cell() {
    std::string_view cell = text_.substr(at_, text_.find_first_of(kEndOfCell, at_) - at_);
    at_ += cell.size();
    CellValue value = cell_value(cell, {});
    if (value.kind == CellKind::word && (cell.ends_with('f') || cell.ends_with('F')))  // of C
      value = cell_value(cell.substr(0, cell.size() - 1), {});
    if (cell.empty() || value.kind == CellKind::word)
      throw error_at_line(name_, line_, shown(cell.empty() ? text_.substr(at_, 1) : cell) + " in an array is not a number");
    array_.values.push_back(value.kind == CellKind::number ? value.value : std::numeric_limits<double>::quiet_NaN());
    ++cells_;
  }

  DataArray take_array() {
    const bool square = here() == '[';
    rows_ = columns_ = cells_ = 0;
    array_.values.clear();
    int depth = 0;
    bool nested = false, after_comma = false;
    do {
      skip(" \t\r");
      const char c = here();
      if (c == '[' || c == '{') {
        if (++depth > 2) throw error_at_line(name_, line_, "arrays of more than two dimensions are not read as text");
        nested = depth == 2;
      } else if (c == ']' || c == '}') {
        end_row();
        --depth;
      } else if (c == ';' || c == '\n') {
        line_ += c == '\n';
        if (square && !nested && !after_comma) end_row();
      } else if (c == '.' && square && !nested && text_.substr(at_).starts_with("...")) {  // MATLAB: goes on below
        at_ = std::min(text_.find('\n', at_), text_.size());
        ++line_;
      } else if (c == '\0') {
        throw error_at_line(name_, line_, "an array has no end");
      } else if (c != ',') {
        take_cell();
        after_comma = false;
        continue;
      }
      after_comma = c == ',' || (c == '\n' && after_comma);
      ++at_;
    } while (depth > 0);
    if (is_call_) at_ = std::min(text_.find(')', at_), text_.size() - 1) + 1;
    if (rows_ > 1 && here() == '\'') throw error_at_line(name_, line_, "transposed matrices are not read");
    skip("'");
    DataArray found = array_;
    found.shape = rows_ == 1 || columns_ == 1 ? std::vector{rows_ * columns_} : std::vector{rows_, columns_};
    return found;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0, line_ = 1;
  DataArray array_{};
  bool is_call_ = false, has_name_ = false;  ///< of the head
  std::size_t rows_ = 0, columns_ = 0, cells_ = 0;
};

}  // namespace

bool may_be_text_arrays(std::string_view text) { return ArrayParser(text, {}).begins_with_name(); }

std::vector<DataArray> read_text_arrays(std::string_view text, const std::string& name) {
  return ArrayParser(text, name).read();
}

}  // namespace ligne
