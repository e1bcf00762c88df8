#pragma once
/// The result of an experiment: tables that compare the source's figures with ours, charts, and a sentence.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "studies/results/chart.hpp"

namespace ligne::studies {

/// The contents of a column. Counts, and measures computed from counts, are equal on every machine; times are not.
enum class ColumnKind : std::uint8_t { label, source, words, count, measure, time };
inline constexpr std::string_view kColumnKindNames[] = {"label", "source", "words", "count", "measure", "time"};

/// Empty, words, a count, or a number.
using Cell = std::variant<std::monostate, std::string, std::uint64_t, double>;

struct Column {
  std::string name;  ///< with its unit, if any
  ColumnKind kind = ColumnKind::label;
};

/// Every table has one column of kind `source`: the statement of the source about the row, or kNoFigure.
struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows{};
};
inline constexpr std::string_view kNoFigure = "no figure";

/// The outcome of an experiment compared with its source.
enum class Finding : std::uint8_t { holds, in_part, no_longer };
inline constexpr std::string_view kFindingNames[] = {"holds", "holds in part", "no longer holds"};

struct Result {
  std::vector<Table> tables{};
  std::vector<Chart> charts{};
  Finding finding = Finding::holds;
  std::string sentence{};  ///< statement of the finding
};

/// Index of the column with that name, which must exist.
inline std::size_t column_of(const Table& table, std::string_view name) {
  std::size_t i = 0;
  while (table.columns.at(i).name != name) ++i;
  return i;
}

inline std::uint64_t count_in(const Table& table, std::size_t row, std::string_view column) {
  return std::get<std::uint64_t>(table.rows.at(row).at(column_of(table, column)));
}

inline double number_in(const Table& table, std::size_t row, std::string_view column) {
  return std::get<double>(table.rows.at(row).at(column_of(table, column)));
}

}  // namespace ligne::studies
