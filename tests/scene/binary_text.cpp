#include "binary_text.hpp"

#include "main/script.hpp"
#include "zip_builder.hpp"

namespace ligne::test {
namespace {

template <class Number>
std::string raw(double value, bool big) {
  const Number number = static_cast<Number>(value);
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return big == (std::endian::native == std::endian::big) ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

std::string number(const std::string& type, double value, bool big) {
  if (type == "f4") return raw<float>(value, big);
  if (type == "f8") return raw<double>(value, big);
  const int size = type.at(1) - '0';
  if (size == 1)
    return raw<std::uint8_t>(type[0] == 'i' ? static_cast<std::uint8_t>(static_cast<std::int8_t>(value)) : value, big);
  if (size == 2) return type[0] == 'i' ? raw<std::int16_t>(value, big) : raw<std::uint16_t>(value, big);
  if (size == 4) return type[0] == 'i' ? raw<std::int32_t>(value, big) : raw<std::uint32_t>(value, big);
  return type[0] == 'i' ? raw<std::int64_t>(value, big) : raw<std::uint64_t>(value, big);
}

std::string u4(std::size_t value) { return number("u4", static_cast<double>(value), false); }

std::string block(std::size_t type, const std::string& data) { return u4(type) + u4(data.size()) + data; }
std::string element(std::size_t type, const std::string& data) {
  return block(type, data) + std::string((8 - data.size() % 8) % 8, '\0');
}

class Assembler {
 public:
  explicit Assembler(std::string_view text) : rest_(text) {}

  /// Up to the end of the group.
  std::string contents() {
    std::string bytes, literal;
    while (!rest_.empty() && rest_[0] != '>') {
      if (rest_[0] == '<') {
        rest_.remove_prefix(1);
        bytes += unescaped(literal) + group();
        literal.clear();
        continue;
      }
      const std::size_t taken = rest_[0] == '\\' ? 2 : 1;
      literal += rest_.substr(0, taken);
      rest_.remove_prefix(std::min(taken, rest_.size()));
    }
    return bytes + unescaped(literal);
  }

 private:
  std::string word() {
    const std::size_t end = std::min(rest_.find_first_of(" >"), rest_.size());
    const std::string word(rest_.substr(0, end));
    rest_.remove_prefix(std::min(rest_.size(), end + (end < rest_.size() && rest_[end] == ' ' ? 1 : 0)));
    return unescaped(word);
  }
  std::size_t count() { return std::stoul(word()); }

  std::string group() {
    std::string bytes = bytes_of(word());
    if (rest_.empty()) throw std::invalid_argument("a group without its end");
    rest_.remove_prefix(1);
    return bytes;
  }

  std::string bytes_of(std::string name) {
    if (name == "zeros") return std::string(count(), '\0');
    if (name == "fill" || name == "head") {
      const std::size_t size = count();
      std::string bytes = contents();
      bytes.resize(name == "fill" ? size : std::min(size, bytes.size()), '\0');
      return bytes;
    }
    if (name == "cut") {
      const std::size_t size = count();
      std::string bytes = contents();
      return bytes.substr(0, bytes.size() - size);
    }
    if (name == "repeat") {
      const std::size_t times = count();
      const std::string one = contents();
      std::string bytes;
      for (std::size_t i = 0; i < times; ++i) bytes += one;
      return bytes;
    }
    if (name == "deflate") {
      const int window = static_cast<int>(count());
      return zip_test::deflated(contents(), window);
    }
    if (name == "zip") {
      const std::vector<std::string> names = parts_of(word(), ',');
      const std::string text = contents();
      std::vector<std::pair<std::string, std::string>> files;
      for (const std::string& file : names) files.emplace_back(file, text);
      return zip_test::zip(files);
    }
    if (name.starts_with("chunk")) {
      const std::string text = contents();
      return number("u2", std::stoi(name.substr(5), nullptr, 16), false) + u4(text.size() + 6) + text;
    }
    if (name == "block" || name == "element") {
      const std::size_t type = count();
      return name == "block" ? block(type, contents()) : element(type, contents());
    }
    if (name == "matrix") return matrix();
    return name == "npy" ? npy() : numbers(name);
  }

  std::string matrix() {
    const std::string name = word();
    const std::size_t rows = count(), columns = count(), kind = count();
    return element(
        14, element(6, u4(kind) + u4(0)) + element(5, u4(rows) + u4(columns)) + element(1, name) + element(9, contents()));
  }

  std::string npy() {
    const std::string version = word(), type = word(), order = word(), shape = word();
    const std::string head = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (" + shape + "), }\n";
    return "\x93NUMPY" + number("u1", std::stod(version), false) + '\0' +
           number(version == "1" ? "u2" : "u4", static_cast<double>(head.size()), false) + head + contents();
  }

  std::string numbers(std::string type) {
    const bool big = type.starts_with("big:");
    type = type.substr(type.find(':') + 1);
    std::string bytes;
    while (!rest_.empty() && rest_[0] != '>') bytes += number(type, value(word()), big);
    return bytes;
  }

  static double value(const std::string& word) { return word == "nan" || word == "inf" ? std::stod(word) : value_of(word); }

  std::string_view rest_;
};

}  // namespace

std::string binary_of(std::string_view text) { return Assembler(text).contents(); }

}  // namespace ligne::test
