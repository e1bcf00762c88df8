#pragma once
/// Small TIFF files in words, of one strip without packing each, with " ; " between their pictures and tags:
///
///     TYPE COLUMNS ROWS BANDS NUMBERS...   a picture of numbers f4, i2, i4, u1, u2, or of u2 that are said to be f2
///     doubles TAG N N ...                  a tag of it; also shorts, longs, and text TAG TEXT

#include "binary_text.hpp"
#include "main/script.hpp"
#include "zip_builder.hpp"

namespace ligne::height_test {

/// The bytes of the words from the first one on.
inline std::string numbers_in(const std::string& type, const std::vector<std::string>& words, std::size_t first) {
  std::string text = "<" + type;
  for (std::size_t i = first; i < words.size(); ++i) text += " " + words[i];
  return test::binary_of(text + ">");
}

class TiffPicture {
 public:
  explicit TiffPicture(const std::vector<std::string>& words)
      : pixels_(numbers_in(words[0] == "f2" ? "u2" : words[0], words, 4)) {
    const char kind = words[0][0], bytes = words[0][1];
    std::string bits, formats;
    for (unsigned long band = std::stoul(words.at(3)); band > 0; --band) {
      bits += " " + std::to_string(8 * (bytes - '0'));
      formats += kind == 'u' ? " 1" : kind == 'i' ? " 2" : " 3";
    }
    for (const std::string& tag : std::initializer_list<std::string>{
             "longs 256 " + words[1], "longs 257 " + words[2], "shorts 258" + bits, "shorts 259 1", "shorts 262 1",
             "longs 273 0", "shorts 277 " + words[3], "longs 278 " + words[2], "longs 279 " + std::to_string(pixels_.size()),
             "shorts 339" + formats})
      add(tag);
    if (pixels_.size() % 2) pixels_ += '\0';
  }

  void add(std::string_view text) {
    static const std::map<std::string, std::pair<std::size_t, std::string>> kTypes{
        {"text", {2, ""}}, {"shorts", {3, "u2"}}, {"longs", {4, "u4"}}, {"doubles", {12, "f8"}}};
    const std::vector<std::string> words = test::words_of(text);
    const auto& [type, number] = kTypes.at(test::take_word(text));
    Entry entry{type, words.size() - 2, {}};
    test::take_word(text);
    entry.data = number.empty() ? test::unescaped(text) + '\0' : numbers_in(number, words, 2);
    if (number.empty()) entry.count = entry.data.size();
    entry.data.resize(std::max<std::size_t>(4, entry.data.size() + entry.data.size() % 2));
    entries_[std::stoul(words.at(1))] = entry;
  }

  /// Writes the directory, its longer values and the pixels; `more`: another directory begins behind them.
  void write(std::string& out, bool more) const {
    constexpr std::size_t kPlaceOfPixels = 273;
    using zip_test::little;
    const std::size_t longer_at = out.size() + 2 + 12 * entries_.size() + 4;
    std::string directory = little(entries_.size(), 2), longer;
    std::size_t pixels_at = longer_at;
    for (const auto& [tag, e] : entries_) pixels_at += e.data.size() > 4 ? e.data.size() : 0;
    for (const auto& [tag, e] : entries_) {
      const bool is_longer = e.data.size() > 4;
      directory += little(tag, 2) + little(e.type, 2) + little(e.count, 4);
      directory += is_longer ? little(longer_at + longer.size(), 4) : tag == kPlaceOfPixels ? little(pixels_at, 4) : e.data;
      if (is_longer) longer += e.data;
    }
    out += directory + little(more ? pixels_at + pixels_.size() : 0, 4) + longer + pixels_;
  }

 private:
  struct Entry {
    std::size_t type = 0, count = 0;
    std::string data;
  };
  std::string pixels_;
  std::map<std::size_t, Entry> entries_;
};

inline std::string tiff_of(std::string_view text) {
  std::vector<TiffPicture> pictures;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(" ; ", begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    if (part.size() > 1 && std::isdigit(static_cast<unsigned char>(part[1])))
      pictures.emplace_back(test::words_of(part));
    else
      pictures.back().add(part);
    begin = end + 3;
  }
  std::string out("II*\0\x08\0\0\0", 8);
  for (std::size_t k = 0; k < pictures.size(); ++k) pictures[k].write(out, k + 1 < pictures.size());
  return out;
}

}  // namespace ligne::height_test
