#include "scene/surfaces/thinned_heights.hpp"

#include <algorithm>
#include <utility>

namespace ligne {
namespace {

std::size_t kept_count(std::size_t n, std::size_t step) { return (n - 1 + step - 1) / step + 1; }

std::vector<double> at_places(const std::vector<double>& positions, const std::vector<std::size_t>& places) {
  std::vector<double> kept;
  kept.reserve(places.size());
  for (const std::size_t i : places) kept.push_back(positions[i]);
  return kept;
}

class ThinnedHeights : public HeightSource {
 public:
  ThinnedHeights(std::unique_ptr<HeightSource> whole, const std::vector<std::size_t>& columns, std::vector<std::size_t> rows)
      : HeightSource(at_places(whole->x(), columns), at_places(whole->y(), rows)),
        whole_(std::move(whole)),
        columns_(columns),
        rows_(std::move(rows)) {
    set_unit(whole_->unit());
  }

  void read_row(std::size_t j, std::span<double> z) const override {
    std::vector<double> row(whole_->x().size());
    whole_->read_row(rows_[j], row);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = row[columns_[i]];
  }

 private:
  std::unique_ptr<HeightSource> whole_;
  std::vector<std::size_t> columns_, rows_;
};

}  // namespace

std::size_t thinning_step(std::size_t columns, std::size_t rows, const GridChoice& choice) {
  if (!choice.may_thin || columns < 2 || rows < 2) return 1;
  std::size_t step = 1;
  while (kept_count(columns, step) > kMostGridSamples / kept_count(rows, step)) ++step;
  if (step == 1 || !choice.every) return step;
  // The step divides `every`, so that the requested curves keep their rows and columns.
  while (step < *choice.every && *choice.every % step != 0) ++step;
  return step <= *choice.every ? step : 1;
}

std::vector<std::size_t> kept_places(std::size_t n, std::size_t step) {
  std::vector<std::size_t> places;
  places.reserve(kept_count(n, step));
  for (std::size_t i = 0; i + 1 < n; i += step) places.push_back(i);
  places.push_back(n - 1);
  return places;
}

void warn_of_thinning(std::size_t columns, std::size_t rows, std::size_t step, Warnings& warnings) {
  warnings.add("grid of " + std::to_string(columns) + " x " + std::to_string(rows) + " samples thinned: 1 of " +
               std::to_string(step) + " rows and columns is drawn; -x and -y choose a part");
}

std::unique_ptr<HeightSource> thinned_heights(std::unique_ptr<HeightSource> heights, const GridChoice& choice,
                                              Warnings& warnings) {
  const std::size_t columns = heights->x().size(), rows = heights->y().size();
  const std::size_t step = heights->function() ? 1 : thinning_step(columns, rows, choice);
  if (step == 1) return heights;
  warn_of_thinning(columns, rows, step, warnings);
  auto thinned = std::make_unique<ThinnedHeights>(std::move(heights), kept_places(columns, step), kept_places(rows, step));
  thinned->set_thinned_by(step);
  return thinned;
}

}  // namespace ligne
