#pragma once
/// The report of a run as JSON.

#include <string>

#include "picture/run_report.hpp"

namespace ligne {

/// The report as JSON: {"format": "ligne-stats", "version": 1, "method", "counts", "seconds", "clear", "choices",
/// "stages", "processor_seconds"}. "clear" and "choices" are omitted if empty.
std::string report_json(const RunReport& report);

}  // namespace ligne
