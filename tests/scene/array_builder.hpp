#pragma once
/// Binary files of arrays and archives, made byte by byte.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace ligne::array_test {

template <typename Number>
inline std::string raw(Number value, std::endian order = std::endian::little) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}
inline std::string big(std::uint32_t value) { return raw(value, std::endian::big); }

inline std::string npy(const std::string& descr, const std::string& shape, const std::string& data, char version = 1,
                       const std::string& order = "False") {
  const std::string header = "{'descr': '" + descr + "', 'fortran_order': " + order + ", 'shape': (" + shape + "), }\n";
  const std::string length =
      version == 1 ? raw(static_cast<std::uint16_t>(header.size())) : raw(static_cast<std::uint32_t>(header.size()));
  return std::string("\x93NUMPY") + version + '\0' + length + header + data;
}

template <typename Number>
inline std::string numbers(std::initializer_list<double> values, std::endian order = std::endian::little) {
  std::string bytes;
  for (const double value : values) bytes += raw(static_cast<Number>(value), order);
  return bytes;
}

inline std::string mat_element(std::uint32_t type, const std::string& data) {
  return raw(type) + raw(static_cast<std::uint32_t>(data.size())) + data + std::string((8 - data.size() % 8) % 8, '\0');
}
inline std::string mat_matrix(const std::string& name, std::int32_t rows, std::int32_t columns, const std::string& data,
                              std::uint32_t array_class = 6) {
  return mat_element(14, mat_element(6, raw(array_class) + raw(std::uint32_t{0})) +
                             mat_element(5, raw(rows) + raw(columns)) + mat_element(1, name) + mat_element(9, data));
}
inline std::string mat_head() {
  std::string head = "MATLAB 5.0 MAT-file, by hand";
  head.resize(124, ' ');
  return head + raw(std::uint16_t{0x0100}) + "IM";
}

}  // namespace ligne::array_test
