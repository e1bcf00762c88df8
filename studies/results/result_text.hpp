#pragma once
/// Results as Markdown, CSV and JSON.

#include <span>
#include <string>

#include "studies/experiments.hpp"

namespace ligne::studies {

struct Outcome {
  const Experiment* experiment = nullptr;
  Result result;
};

/// Markdown: a heading, the tables and the sentence.
std::string text_of(const Outcome& outcome);

/// One line per cell that is no label: experiment, table, row, column, kind, value. The row is named by its label cells.
std::string csv_of(std::span<const Outcome> outcomes);

/// {"format": "ligne-study", "version": 1, "size", "experiments": [...]}; docs/study.md has the schema.
std::string json_of(std::span<const Outcome> outcomes, StudySize size);

/// All experiments: name, section and title.
std::string list_of_experiments();

}  // namespace ligne::studies
