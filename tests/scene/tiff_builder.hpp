#pragma once
/// Small TIFF files in memory: one strip without packing, any tags.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ligne::height_test {

class TiffBuilder {
 public:
  enum Type : std::uint16_t { kAscii = 2, kShort = 3, kLong = 4, kDouble = 12 };

  template <class Sample>
  TiffBuilder(std::uint32_t columns, std::uint32_t rows, const std::vector<Sample>& samples, std::uint16_t format,
              std::uint16_t bands = 1) {
    pixels_.assign(reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(Sample));
    longs(256, {columns});
    longs(257, {rows});
    shorts(258, std::vector<std::uint16_t>(bands, static_cast<std::uint16_t>(8 * sizeof(Sample))));
    shorts(259, {1});
    shorts(262, {1});
    longs(273, {0});  // becomes the place of the pixels
    shorts(277, {bands});
    longs(278, {rows});
    longs(279, {static_cast<std::uint32_t>(pixels_.size())});
    shorts(339, std::vector<std::uint16_t>(bands, format));
  }
  TiffBuilder& shorts(std::uint16_t tag, const std::vector<std::uint16_t>& v) { return add(tag, kShort, v, v.size()); }
  TiffBuilder& longs(std::uint16_t tag, const std::vector<std::uint32_t>& v) { return add(tag, kLong, v, v.size()); }
  TiffBuilder& doubles(std::uint16_t tag, const std::vector<double>& v) { return add(tag, kDouble, v, v.size()); }
  TiffBuilder& text(std::uint16_t tag, const std::string& t) {
    return add(tag, kAscii, std::vector<char>(t.c_str(), t.c_str() + t.size() + 1), t.size() + 1);
  }
  /// Another picture in the file.
  TiffBuilder& then(const TiffBuilder& next) {
    next_.push_back(next);
    return *this;
  }

  std::string bytes() const {
    std::string out("II*\0\x08\0\0\0", 8);
    write(out, !next_.empty());
    for (std::size_t k = 0; k < next_.size(); ++k) next_[k].write(out, k + 1 < next_.size());
    return out;
  }

 private:
  struct Entry {
    std::uint16_t tag, type;
    std::uint32_t count;
    std::string data;
  };

  template <class Values>
  TiffBuilder& add(std::uint16_t tag, std::uint16_t type, const Values& values, std::size_t count) {
    Entry entry{tag, type, static_cast<std::uint32_t>(count), {}};
    entry.data.assign(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
    auto at = entries_.begin();
    while (at != entries_.end() && at->tag < tag) ++at;
    if (at != entries_.end() && at->tag == tag) at = entries_.erase(at);
    entries_.insert(at, entry);
    return *this;
  }
  template <class Number>
  static void put(std::string& out, Number number) {
    out.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  /// The directory, its longer values, the pixels; `more`: another directory begins behind them.
  void write(std::string& out, bool more) const {
    std::size_t at = out.size() + 2 + 12 * entries_.size() + 4;
    std::string directory, longer;
    put(directory, static_cast<std::uint16_t>(entries_.size()));
    std::size_t pixels_at = at;
    for (const Entry& e : entries_) pixels_at += e.data.size() > 4 ? e.data.size() + e.data.size() % 2 : 0;
    for (const Entry& e : entries_) {
      put(directory, e.tag);
      put(directory, e.type);
      put(directory, e.count);
      std::string value = e.data;
      if (e.tag == 273) {
        value.clear();
        put(value, static_cast<std::uint32_t>(pixels_at));
      }
      if (value.size() > 4) {
        put(directory, static_cast<std::uint32_t>(at + longer.size()));
        longer += value;
        if (longer.size() % 2) longer += '\0';
      } else {
        value.resize(4);
        directory += value;
      }
    }
    const std::size_t end = pixels_at + pixels_.size() + pixels_.size() % 2;
    put(directory, static_cast<std::uint32_t>(more ? end : 0));
    out += directory + longer + pixels_;
    if (pixels_.size() % 2) out += '\0';
  }

  std::string pixels_;
  std::vector<Entry> entries_;
  std::vector<TiffBuilder> next_;
};

}  // namespace ligne::height_test
