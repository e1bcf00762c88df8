// For every separator the cells of the first lines are counted. The separator with the largest share of numbers wins.
// Ties are decided by the order of kSeparators, since a comma can be a decimal comma where semicolons separate, and
// tabs can occur among the blanks of a table set by hand.

#include "scene/tables/cell_style.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr std::array<char, 5> kSeparators{';', ',', '\t', '|', ' '};
/// Largest number of lines, and of their cells, that are examined.
constexpr std::size_t kLines = 500, kCells = 50'000;
/// Length of a cell above which it can not be a number before a comment.
constexpr std::size_t kLongestCell = 100;
/// Largest difference of equal scores.
constexpr double kSameScore = 1e-9;

bool is_quote(char c) { return c == '"' || c == '\''; }

/// Position after the quote that closes the first one and after the blanks that follow, where the cell ends; npos if
/// the quote is not closed.
std::size_t end_of_quoted(std::string_view line, char separator) {
  const char quote = line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] != quote) continue;
    if (i + 1 < line.size() && line[i + 1] == quote) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    if (separator == ' ') return end == line.size() || is_blank(line[end]) ? end : std::string_view::npos;
    while (end < line.size() && is_blank(line[end]) && line[end] != separator) ++end;
    return end == line.size() || line[end] == separator ? end : std::string_view::npos;
  }
  return std::string_view::npos;
}

/// Removes leading blanks that do not separate cells.
std::string_view without_blanks(std::string_view line, char separator) {
  while (!line.empty() && is_blank(line.front()) && line.front() != separator) line.remove_prefix(1);
  return line;
}

/// The separator of thousands in digits with blanks or apostrophes between them; 0 for others. `bare` gets the text
/// without it.
char grouped_by(std::string_view cell, std::string& bare) {
  if (cell.find_first_not_of("+-0123456789,. '") != std::string_view::npos) return '\0';
  for (const char separator : {' ', '\''}) {
    if (cell.find(separator) == std::string_view::npos) continue;
    bare = cell;
    NumberStyle style{false, separator};
    std::string point(cell);
    std::replace(point.begin(), point.end(), ',', '.');
    if (cell_value(point, style).kind != CellKind::number) return '\0';
    std::erase(bare, separator);
    return separator;
  }
  return '\0';
}

struct Evidence {
  std::size_t cells = 0, numbers = 0;
  std::map<std::size_t, std::size_t> counts;  ///< number of lines per number of cells
  std::size_t lines = 0;
  CommaEvidence commas;
  char grouped = '\0';

  void add(const CommaEvidence& found) {
    commas.decimal |= found.decimal;
    commas.thousands |= found.thousands;
    commas.either |= found.either;
    commas.point |= found.point;
    commas.grouped_point |= found.grouped_point;
    commas.both |= found.both;
  }

  std::size_t most_common_count() const {
    const auto best = std::ranges::max_element(counts, [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == counts.end() ? 0 : best->first;
  }

  double score() const {
    const std::size_t columns = most_common_count();
    if (cells == 0 || columns < 2) return 0;
    const auto share = [](std::size_t part, std::size_t all) {
      return static_cast<double>(part) / static_cast<double>(all);
    };
    return share(numbers, cells) * (1 + share(counts.at(columns), lines));
  }
};

Evidence evidence_of(std::string_view text, char separator) {
  Evidence found;
  LineReader reader(text);
  for (std::string_view line; found.lines < kLines && found.cells < kCells && reader.next(line);) {
    std::string_view row = without_comment(line, separator);
    if (row.empty()) continue;
    ++found.lines;
    std::size_t cells = 0;
    for (bool ended = false; !ended; ++cells) {
      const std::string_view raw = take_cell(row, separator, ended);
      const CellValue value = cell_value(raw, {});
      const std::string cell = value.kind == CellKind::missing ? "" : cell_text(raw);
      std::string bare = cell;
      const char grouped = grouped_by(cell, bare);
      const CommaEvidence commas = comma_evidence(bare);
      if (grouped != '\0') found.grouped = grouped;
      found.add(commas);
      found.numbers +=
          value.kind != CellKind::word || grouped != '\0' || commas.decimal || commas.thousands || commas.either;
    }
    found.cells += cells;
    ++found.counts[cells];
  }
  return found;
}

void decide_numbers(const Evidence& found, CellStyle& style) {
  const CommaEvidence& commas = found.commas;
  NumberStyle& numbers = style.numbers;
  if (commas.decimal != commas.thousands) {
    numbers.decimal_comma = commas.decimal;
    if (commas.thousands) numbers.thousands = ',';
  } else if (commas.either && !commas.decimal) {
    // All commas precede groups of three digits.
    const bool is_thousands = style.separator == ',' || commas.point;
    numbers.decimal_comma = !is_thousands;
    if (is_thousands) numbers.thousands = ',';
    style.doubtful_comma = !commas.point;
  }
  if (numbers.decimal_comma && (commas.both || commas.grouped_point) && !commas.point) {
    numbers.thousands = '.';
    style.doubtful_point = !commas.both;
  }
  if (numbers.thousands == '\0') numbers.thousands = found.grouped;
}

}  // namespace

std::string_view take_cell(std::string_view& line, char separator, bool& ended) {
  const bool by_blanks = separator == ' ';
  line = by_blanks ? trimmed(line) : without_blanks(line, separator);
  std::size_t end = std::string_view::npos;
  if (!line.empty() && is_quote(line.front())) end = end_of_quoted(line, separator);
  if (end == std::string_view::npos) {
    end = 0;
    while (end < line.size() && !(by_blanks ? is_blank(line[end]) : line[end] == separator)) ++end;
  }
  const std::string_view cell = trimmed(line.substr(0, end));
  ended = end == line.size();
  line.remove_prefix(ended ? end : end + 1);
  if (by_blanks && trimmed(line).empty()) ended = true;
  return cell;
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (bool ended = false; !ended;) cells.push_back(take_cell(line, separator, ended));
  return cells;
}

bool is_comment_line(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && (line.front() == '%' || line.front() == '!' || line.starts_with("//") ||
                           (line.front() == '#' && !begins_with_sheet_error(line)));
}

std::string_view without_comment(std::string_view line, char separator) {
  if (is_comment_line(line)) return {};
  std::string_view row = line;
  if (line.find('#') != std::string_view::npos) {
    std::size_t begin = 0;  // start of the cell
    bool at_begin = true;   // only blanks so far in the cell
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (at_begin && is_quote(line[i])) {
        const std::size_t end = end_of_quoted(line.substr(i), separator);
        if (end != std::string_view::npos) i += end;
        if (i >= line.size()) break;
      }
      if (line[i] == '#' && !begins_with_sheet_error(line.substr(i))) {
        const std::string_view before = line.substr(begin, i - begin);
        const bool behind_blank = i > 0 && is_blank(line[i - 1]);
        const bool is_number = !at_begin && before.size() < kLongestCell && cell_value(before, {}).kind == CellKind::number;
        if ((at_begin && behind_blank) || is_number) {
          row = line.substr(0, i);
          break;
        }
      }
      if (separator == ' ' ? is_blank(line[i]) : line[i] == separator) {
        begin = i + 1;
        at_begin = true;
      } else if (!is_blank(line[i])) {
        at_begin = false;
      }
    }
  }
  if (trimmed(row).empty()) return {};
  if (separator != '\t') return trimmed(row);
  while (row.back() != '\t' && is_blank(row.back())) row.remove_suffix(1);
  while (row.front() != '\t' && is_blank(row.front())) row.remove_prefix(1);
  return row;
}

CellStyle cell_style(std::string_view text) {
  CellStyle style;
  Evidence best;
  double score = -1;
  for (const char separator : kSeparators) {
    const std::string_view sample = text;
    if (separator != ' ' && sample.find(separator) == std::string_view::npos) continue;
    Evidence found = evidence_of(sample, separator);
    const double at = found.score();
    if (at <= score + kSameScore) continue;
    score = at;
    style.separator = separator;
    best = std::move(found);
  }
  decide_numbers(best, style);
  return style;
}

}  // namespace ligne
