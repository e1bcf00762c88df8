#pragma once
/// Plain line charts as SVG, for the documents.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ligne::bench {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

struct Chart {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
};

/// Both axes begin at zero. Throws std::runtime_error when the file can not be written.
void write_chart(const std::filesystem::path& file, const Chart& chart);

}  // namespace ligne::bench
