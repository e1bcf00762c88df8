#pragma once
/// The header of a netCDF file in one of its classic formats.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace ligne {

enum class NetcdfType : std::uint32_t {
  byte = 1,
  character,
  int16,
  int32,
  float32,
  float64,
  uint8,
  uint16,
  uint32,
  int64,
  uint64,
};

std::size_t bytes_of(NetcdfType type);
double netcdf_value(const std::byte* at, NetcdfType type);

struct NetcdfAttribute {
  std::string text;             ///< text of a character attribute
  std::vector<double> numbers;  ///< values of a numeric attribute
};
using NetcdfAttributes = std::map<std::string, NetcdfAttribute>;

struct NetcdfDimension {
  std::string name;
  std::size_t size = 0;
  bool is_record = false;  ///< its size grows with the file
};

struct NetcdfVariable {
  std::string name;
  std::vector<std::size_t> dimensions;
  NetcdfAttributes attributes;
  NetcdfType type = NetcdfType::byte;
  std::size_t begin = 0;
  bool is_record = false;
};

struct NetcdfHeader {
  std::vector<NetcdfDimension> dimensions;
  NetcdfAttributes attributes;
  std::vector<NetcdfVariable> variables;
  std::size_t record_bytes = 0;  ///< distance between records
};

/// Throws InputError. Rejects counts that do not fit into the bytes.
NetcdfHeader read_netcdf_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace ligne
