// Makes surfaces of the data sets of a text.

#include <algorithm>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"

namespace ligne {
namespace {

std::string numbered_sets(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " data set, number 0" : " data sets, numbered from 0");
}

/// Number of blocks in a data set.
std::size_t block_count(const Table& table, RowRange set) {
  const auto begins_before = [](const RowRange& range, std::size_t row) { return range.begin < row; };
  const std::vector<RowRange>& blocks = table.blocks();
  return static_cast<std::size_t>(std::lower_bound(blocks.begin(), blocks.end(), set.end, begins_before) -
                                  std::lower_bound(blocks.begin(), blocks.end(), set.begin, begins_before));
}

/// The surfaces of the data sets; empty if a data set makes no surface by itself. Either all must have several blocks,
/// or all one, since some writers put two lines between blocks too.
std::vector<GridSurface> separate_surfaces(const Table& table, const std::string& name, const GridChoice& choice,
                                           Warnings& warnings) {
  Warnings unasked;
  const bool has_blocks = block_count(table, table.data_sets().front()) > 1;
  for (const RowRange& set : table.data_sets()) {
    if ((block_count(table, set) > 1) != has_blocks) return {};
  }
  for (const RowRange& set : table.data_sets()) {
    try {
      surface_of_data_set(table, set, name, choice, unasked);
    } catch (const InputError&) {
      return {};
    }
  }
  std::vector<GridSurface> surfaces;
  for (const RowRange& set : table.data_sets()) surfaces.push_back(surface_of_data_set(table, set, name, choice, warnings));
  return surfaces;
}

}  // namespace

std::vector<GridSurface> read_text_surfaces(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice) {
  const Table table = read_table(as_text(bytes, name), name, warnings);
  const std::vector<RowRange>& sets = table.data_sets();
  std::vector<GridSurface> surfaces;
  if (choice.data_set) {
    if (*choice.data_set >= sets.size()) {
      throw InputError(name,
                       "has " + numbered_sets(sets.size()) + ", and none of number " + std::to_string(*choice.data_set));
    }
    surfaces.push_back(surface_of_data_set(table, sets[*choice.data_set], name, choice, warnings));
    return surfaces;
  }
  if (sets.size() > 1) surfaces = separate_surfaces(table, name, choice, warnings);
  if (surfaces.empty()) surfaces.push_back(surface_of_data_set(table, {0, table.rows()}, name, choice, warnings));
  return surfaces;
}

}  // namespace ligne
