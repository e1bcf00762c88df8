#pragma once
/// Tools that the tests of surfaces' heights share.

#include "reader_tools.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"

namespace ligne {

/// The ends of so many equal intervals.
inline std::vector<double> evenly(double from, double to, std::size_t intervals) {
  std::vector<double> positions;
  for (std::size_t i = 0; i <= intervals; ++i)
    positions.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(intervals));
  return positions;
}

namespace height_test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// All heights, z[j][i] over x[i], y[j].
inline std::vector<std::vector<double>> heights_of(const HeightSource& source) {
  std::vector<std::vector<double>> z(source.y().size(), std::vector<double>(source.x().size()));
  for (std::size_t j = 0; j < z.size(); ++j) source.read_row(j, z[j]);
  return z;
}

inline std::unique_ptr<HeightSource> grid(const std::string& text, Warnings& warnings) {
  return read_grid(reader_test::bytes_of(text), "M", warnings);
}

inline std::unique_ptr<HeightSource> grid(const std::string& text) {
  Warnings warnings;
  auto source = grid(text, warnings);
  EXPECT_TRUE(warnings.counts().empty());
  return source;
}

using reader_test::error_line;

/// A file of the fuzzers' corpus of grids, "tiff/NAME" of that of TIFF files, or "shared/NAME" of the shared models.
inline std::string corpus_file(const std::string& name) {
  if (name.starts_with("shared/")) return test::bytes_of_file(LIGNE_MODELS_DIR "/" + name.substr(7));
  const std::string folder = LIGNE_SOURCE_DIR "/tests/fuzz/corpus/";
  return test::bytes_of_file(folder + (name.find('/') == name.npos ? "grid/" : "") + name);
}

/// Positions and heights are these; NaN is equal to NaN.
inline void expect_grid(const HeightSource& source, const std::vector<double>& x, const std::vector<double>& y,
                        const std::vector<std::vector<double>>& z) {
  EXPECT_EQ(source.x(), x);
  EXPECT_EQ(source.y(), y);
  const auto found = heights_of(source);
  ASSERT_EQ(found.size(), z.size());
  for (std::size_t j = 0; j < z.size(); ++j) {
    ASSERT_EQ(found[j].size(), z[j].size());
    for (std::size_t i = 0; i < z[j].size(); ++i)
      EXPECT_TRUE(std::isnan(z[j][i]) ? std::isnan(found[j][i]) : found[j][i] == z[j][i])
          << found[j][i] << ", not " << z[j][i] << ", at " << i << ", " << j;
  }
}

}  // namespace height_test
}  // namespace ligne
