// The classic format: https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html

#include "scene/tables/netcdf_header.hpp"

#include <algorithm>
#include <bit>

#include "files/input_error.hpp"
#include "files/message_text.hpp"
#include "scene/readers/load_bytes.hpp"

namespace ligne {
namespace {

constexpr std::uint32_t kDimensionTag = 0x0A, kVariableTag = 0x0B, kAttributeTag = 0x0C;
constexpr std::size_t kPadding = 4;
constexpr std::size_t kMostAxes = 32;

std::size_t padded(std::size_t bytes) { return (bytes + kPadding - 1) / kPadding * kPadding; }

class HeaderReader {
 public:
  HeaderReader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  NetcdfHeader read() {
    constexpr std::size_t kMark = 4;
    version_ = std::to_integer<unsigned>(bytes_[kMark - 1]);
    at_ = kMark;
    take_count();  // number of records, which follows from the bytes after the header
    read_dimensions();
    header_.attributes = take_attributes();
    read_variables();
    count_records();
    return std::move(header_);
  }

 private:
  InputError error(const std::string& cause) const { return {name_, "netCDF header: " + cause}; }

  void need(std::size_t bytes) const {
    if (bytes > bytes_.size() - at_) throw error("ends early");
  }
  template <typename Number>
  Number take() {
    need(sizeof(Number));
    const auto value = load_bytes<Number>(bytes_.data() + at_, std::endian::big);
    at_ += sizeof(Number);
    return value;
  }
  bool is_64_bit() const { return version_ == 5; }
  std::uint64_t take_count() { return is_64_bit() ? take<std::uint64_t>() : take<std::uint32_t>(); }
  std::uint64_t take_offset() { return version_ == 1 ? take<std::uint32_t>() : take<std::uint64_t>(); }

  /// The number of elements of a list, each of which takes at least four bytes.
  std::size_t take_list(std::uint32_t tag) {
    const auto found = take<std::uint32_t>();
    const std::uint64_t count = take_count();
    if (found == 0 && count == 0) return 0;
    if (found != tag) throw error("a list begins with " + std::to_string(found) + ", not with " + std::to_string(tag));
    if (count > (bytes_.size() - at_) / kPadding) throw error("ends early");
    return count;
  }

  std::string take_name() {
    const std::uint64_t length = take_count();
    if (length > bytes_.size() - at_) throw error("ends early");
    const std::string text(reinterpret_cast<const char*>(bytes_.data()) + at_, length);
    need(std::min(padded(length), bytes_.size() - at_));
    at_ += std::min(padded(length), bytes_.size() - at_);
    return text;
  }

  NetcdfType take_type() {
    const auto type = take<std::uint32_t>();
    const auto last = is_64_bit() ? NetcdfType::uint64 : NetcdfType::float64;
    if (type < 1 || type > static_cast<std::uint32_t>(last)) throw error("unknown type " + std::to_string(type));
    return static_cast<NetcdfType>(type);
  }

  void read_dimensions() {
    const std::size_t count = take_list(kDimensionTag);
    for (std::size_t k = 0; k < count; ++k) {
      NetcdfDimension& dimension = header_.dimensions.emplace_back();
      dimension.name = take_name();
      dimension.size = take_count();
      dimension.is_record = dimension.size == 0;
    }
  }

  NetcdfAttributes take_attributes() {
    NetcdfAttributes attributes;
    const std::size_t count = take_list(kAttributeTag);
    for (std::size_t k = 0; k < count; ++k) {
      const std::string name = take_name();
      const NetcdfType type = take_type();
      const std::uint64_t length = take_count();
      if (length > (bytes_.size() - at_) / bytes_of(type)) throw error("ends early");
      NetcdfAttribute& attribute = attributes[name];
      attribute = {};
      if (type == NetcdfType::character) {
        attribute.text.assign(reinterpret_cast<const char*>(bytes_.data()) + at_, length);
      } else {
        for (std::size_t i = 0; i < length; ++i)
          attribute.numbers.push_back(netcdf_value(bytes_.data() + at_ + i * bytes_of(type), type));
      }
      at_ += std::min(padded(length * bytes_of(type)), bytes_.size() - at_);
    }
    return attributes;
  }

  void read_variables() {
    const std::size_t count = take_list(kVariableTag);
    for (std::size_t k = 0; k < count; ++k) {
      NetcdfVariable& variable = header_.variables.emplace_back();
      variable.name = take_name();
      const std::uint64_t axes = take_count();
      if (axes > kMostAxes) throw error("variable " + shown(variable.name) + " has " + std::to_string(axes) + " dimensions");
      for (std::uint64_t i = 0; i < axes; ++i) {
        const std::uint64_t dimension = take_count();
        if (dimension >= header_.dimensions.size())
          throw error("variable " + shown(variable.name) + " has an unknown dimension");
        variable.dimensions.push_back(dimension);
      }
      variable.is_record = axes > 0 && header_.dimensions[variable.dimensions[0]].is_record;
      variable.attributes = take_attributes();
      variable.type = take_type();
      take_count();  // size in bytes, which follows from the dimensions
      variable.begin = take_offset();
      if (variable.begin > bytes_.size())
        throw error("variable " + shown(variable.name) + " begins past the end of the file");
    }
  }

  /// Size in bytes of one record of a variable, or of all of it. Throws InputError if the file is smaller.
  std::size_t part_bytes(const NetcdfVariable& variable) const {
    std::size_t bytes = bytes_of(variable.type);
    for (std::size_t i = variable.is_record ? 1 : 0; i < variable.dimensions.size(); ++i) {
      const std::size_t size = header_.dimensions[variable.dimensions[i]].size;
      if (size != 0 && bytes > bytes_.size() / size)
        throw InputError(name_, "is truncated: variable " + shown(variable.name) + " is longer than the file");
      bytes *= size;
    }
    return bytes;
  }

  void count_records() {
    std::size_t begin = bytes_.size(), variables = 0, last = 0;
    for (const NetcdfVariable& variable : header_.variables) {
      if (!variable.is_record) continue;
      begin = std::min(begin, variable.begin);
      last = part_bytes(variable);
      header_.record_bytes += padded(last);
      ++variables;
    }
    if (variables == 1) header_.record_bytes = last;  // a single record variable is not padded
    const std::size_t records =
        header_.record_bytes == 0 ? 0 : (bytes_.size() - begin + kPadding - 1) / header_.record_bytes;
    for (NetcdfDimension& dimension : header_.dimensions) {
      if (dimension.is_record) dimension.size = records;
    }
  }

  std::span<const std::byte> bytes_;
  const std::string& name_;
  unsigned version_ = 1;
  std::size_t at_ = 0;
  NetcdfHeader header_;
};

}  // namespace

std::size_t bytes_of(NetcdfType type) {
  switch (type) {
    case NetcdfType::byte:
    case NetcdfType::character:
    case NetcdfType::uint8:
      return 1;
    case NetcdfType::int16:
    case NetcdfType::uint16:
      return 2;
    case NetcdfType::int32:
    case NetcdfType::float32:
    case NetcdfType::uint32:
      return 4;
    default:
      return 8;
  }
}

double netcdf_value(const std::byte* at, NetcdfType type) {
  const auto load = [&]<typename Number>(Number) { return static_cast<double>(load_bytes<Number>(at, std::endian::big)); };
  switch (type) {
    case NetcdfType::byte:
      return load(std::int8_t{});
    case NetcdfType::character:
    case NetcdfType::uint8:
      return load(std::uint8_t{});
    case NetcdfType::int16:
      return load(std::int16_t{});
    case NetcdfType::uint16:
      return load(std::uint16_t{});
    case NetcdfType::int32:
      return load(std::int32_t{});
    case NetcdfType::uint32:
      return load(std::uint32_t{});
    case NetcdfType::float32:
      return load(float{});
    case NetcdfType::int64:
      return load(std::int64_t{});
    case NetcdfType::uint64:
      return load(std::uint64_t{});
    default:
      return load(double{});
  }
}

NetcdfHeader read_netcdf_header(std::span<const std::byte> bytes, const std::string& name) {
  constexpr std::size_t kShortest = 32;
  if (bytes.size() < kShortest) throw InputError(name, "netCDF header: ends early");
  return HeaderReader(bytes, name).read();
}

}  // namespace ligne
