/// Tests of experiments that are written as text, in the folder scripts. A step is "EXPERIMENT TABLE", the experiment at
/// small size and a table of it by its number. Checks, where OP is = != < > <= or >=:
///
///     finding WORDS                 holds, holds in part, or no longer holds
///     "COLUMN" is N 'A WORD' ...    all its values
///     [ROWS: ] EXPRESSION OP EXPRESSION [+- TOLERANCE]   for each row, "0 3:" for those, or "1/4:" for rows 1, 5, 9 ...
///
/// An expression is a formula of numbers, of "COLUMN" in the row, "COLUMN"@-1 in the row before and "COLUMN"@2 in row 2, and
/// of `rows`, their number.

#include "main/script.hpp"
#include "studies/results/result_text.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne::studies {
namespace {

const Result& small_result(const std::string& name) {
  static std::map<std::string, Result> results;
  const auto found = results.find(name);
  if (found != results.end()) return found->second;
  const Experiment* const experiment = find_experiment(name);
  if (!experiment) throw std::invalid_argument("there is no experiment " + name);
  return results[name] = experiment->run({StudySize::small, {}});
}

double value_in(const Table& table, std::size_t row, std::string_view column) {
  const auto& value = table.rows.at(row).at(column_of(table, column));
  return std::holds_alternative<double>(value) ? std::get<double>(value)
                                               : static_cast<double>(std::get<std::uint64_t>(value));
}

/// All values of a column, as they are written.
std::vector<std::string> words_in(const Table& table, std::string_view column) {
  std::vector<std::string> words;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto& value = table.rows[row].at(column_of(table, column));
    const bool is_word = std::holds_alternative<std::string>(value);
    words.push_back(is_word ? std::get<std::string>(value) : test::as_text(value_in(table, row, column)));
  }
  return words;
}

/// The rows that "0 3" or "1/4" name.
std::vector<std::size_t> rows_named(const std::string& text, std::size_t count) {
  std::vector<std::size_t> rows;
  const std::size_t slash = text.find('/');
  if (slash == text.npos) {
    for (const std::string& word : test::words_of(text)) rows.push_back(std::stoul(word));
  } else {
    for (std::size_t i = std::stoul(text); i < count; i += std::stoul(text.substr(slash + 1))) rows.push_back(i);
  }
  return rows;
}

/// The expression with its columns in the row; the text behind the closing quote of a column may name another row.
double value_of(std::string text, const Table& table, std::size_t row) {
  for (std::size_t at; (at = text.find('"')) != text.npos;) {
    const std::size_t end = text.find('"', at + 1);
    std::size_t behind = end + 1, in = row;
    if (behind < text.size() && text[behind] == '@') {
      const int number = std::stoi(text.substr(behind + 1));
      in = text[behind + 1] == '-' ? row - static_cast<std::size_t>(-number) : static_cast<std::size_t>(number);
      behind = text.find_first_not_of("0123456789", behind + 2);
    }
    const std::string value = test::as_text(value_in(table, in, text.substr(at + 1, end - at - 1)));
    text = text.substr(0, at) + value + (behind < text.size() ? text.substr(behind) : "");
  }
  if (const std::size_t at = text.find("rows"); at != text.npos) text.replace(at, 4, std::to_string(table.rows.size()));
  return test::number_of(text);
}

void check_values(const std::string& check, const Table& table) {
  std::vector<std::size_t> rows(table.rows.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const std::size_t colon = check.find(": ");
  if (colon != check.npos) rows = rows_named(check.substr(0, colon), rows.size());
  const std::string text = colon == check.npos ? check : check.substr(colon + 2);
  for (const std::string op : {" = ", " != ", " <= ", " >= ", " < ", " > "}) {
    const std::size_t at = text.find(op), tolerance = text.find(" +- ");
    if (at == text.npos) continue;
    EXPECT_FALSE(rows.empty());
    for (const std::size_t row : rows) {
      const double left = value_of(text.substr(0, at), table, row);
      const double right = value_of(text.substr(at + op.size(), tolerance - at - op.size()), table, row);
      const double slack = tolerance == text.npos ? 0 : test::number_of(text.substr(tolerance + 4));
      EXPECT_TRUE(test::holds(left, op.substr(1, op.size() - 2), right, slack))
          << "row " << row << ": " << left << op << right;
    }
    return;
  }
  ADD_FAILURE() << "no check";
}

[[maybe_unused]] const bool scripts_are_added =
    test::add_scripts(LIGNE_SOURCE_DIR "/tests/study/scripts", [](const test::Script& script) {
      for (const test::ScriptStep& step : script.steps) {
        std::string_view rest = step.line;
        const Result& result = small_result(test::take_word(rest));
        const Table& table = result.tables.at(std::stoul(std::string(rest)));
        for (const std::string& check : step.checks) {
          SCOPED_TRACE(step.place + ": " + step.line + " | " + check);
          const std::size_t is = check.find("\" is ");
          if (check.starts_with("finding ")) {
            EXPECT_EQ(kFindingNames[static_cast<std::size_t>(result.finding)], check.substr(8));
          } else if (is != check.npos) {
            EXPECT_EQ(words_in(table, check.substr(1, is - 1)), test::words_of(check.substr(is + 5)));
          } else {
            check_values(check, table);
          }
        }
      }
    });

}  // namespace
}  // namespace ligne::studies
