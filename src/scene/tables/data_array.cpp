#include "scene/tables/data_array.hpp"

namespace ligne {

std::size_t element_count(std::span<const std::size_t> shape, std::size_t bytes_each, std::size_t bytes,
                          const std::string& name) {
  const std::size_t most = bytes / bytes_each;
  std::size_t count = 1;
  for (const std::size_t size : shape) {
    if (size == 0) return 0;
    if (count > most / size) {
      throw InputError(name,
                       "is truncated: its header declares more than the " + std::to_string(bytes) + " remaining bytes");
    }
    count *= size;
  }
  if (count > most)
    throw InputError(name, "is truncated: its header declares more than the " + std::to_string(bytes) + " remaining bytes");
  return count;
}

std::vector<double> from_column_major(const std::vector<double>& values, std::span<const std::size_t> shape) {
  std::vector<double> out(values.size());
  std::vector<std::size_t> index(shape.size(), 0), step(shape.size(), 1);
  for (std::size_t k = shape.size(); k-- > 1;) step[k - 1] = step[k] * shape[k];
  std::size_t at = 0;
  for (const double value : values) {
    out[at] = value;
    for (std::size_t k = 0; k < shape.size(); ++k) {
      at += step[k];
      if (++index[k] < shape[k]) break;
      at -= step[k] * shape[k];
      index[k] = 0;
    }
  }
  return out;
}

}  // namespace ligne
