#pragma once
/// TIFF files in words, with " ; " between their pictures and tags:
///
///     TYPE COLUMNS ROWS BANDS NUMBERS...   a picture of numbers f4, i2, i4, u1, u2, or of u2 that are said to be f2
///     doubles TAG N N ...                  a tag of it; also shorts, longs, and text TAG TEXT

#include "main/script.hpp"
#include "tiff_builder.hpp"

namespace ligne::height_test {

template <class Sample>
TiffBuilder tiff_picture(const std::vector<std::string>& words, std::uint16_t format) {
  std::vector<Sample> samples;
  for (std::size_t i = 4; i < words.size(); ++i) samples.push_back(static_cast<Sample>(test::value_of(words[i])));
  const auto number = [&](std::size_t i) { return static_cast<std::uint32_t>(std::stoul(words.at(i))); };
  return {number(1), number(2), samples, format, static_cast<std::uint16_t>(number(3))};
}

inline TiffBuilder tiff_picture(const std::vector<std::string>& words) {
  constexpr std::uint16_t kUnsigned = 1, kSigned = 2, kFloat = 3;
  if (words[0] == "f4") return tiff_picture<float>(words, kFloat);
  if (words[0] == "i2") return tiff_picture<std::int16_t>(words, kSigned);
  if (words[0] == "i4") return tiff_picture<std::int32_t>(words, kSigned);
  if (words[0] == "u1") return tiff_picture<std::uint8_t>(words, kUnsigned);
  return tiff_picture<std::uint16_t>(words, words[0] == "f2" ? kFloat : kUnsigned);
}

inline void add_tag(TiffBuilder& picture, const std::vector<std::string>& words, const std::string& text) {
  const auto tag = static_cast<std::uint16_t>(std::stoul(words.at(1)));
  const auto numbers = [&](auto kind) {
    std::vector<decltype(kind)> list;
    for (std::size_t i = 2; i < words.size(); ++i) list.push_back(static_cast<decltype(kind)>(test::value_of(words[i])));
    return list;
  };
  if (words[0] == "doubles") picture.doubles(tag, numbers(0.0));
  if (words[0] == "shorts") picture.shorts(tag, numbers(std::uint16_t{}));
  if (words[0] == "longs") picture.longs(tag, numbers(std::uint32_t{}));
  if (words[0] == "text") picture.text(tag, text);
}

inline std::string tiff_of(std::string_view text) {
  std::vector<TiffBuilder> pictures;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(" ; ", begin), text.size());
    std::string_view part = text.substr(begin, end - begin);
    const std::vector<std::string> words = test::words_of(part);
    if (words.at(0)[0] == 'f' || words[0][0] == 'i' || words[0][0] == 'u') {
      pictures.push_back(tiff_picture(words));
    } else {
      test::take_word(part), test::take_word(part);
      add_tag(pictures.back(), words, test::unescaped(part));
    }
    begin = end + 3;
  }
  for (std::size_t k = 1; k < pictures.size(); ++k) pictures.front().then(pictures[k]);
  return pictures.front().bytes();
}

}  // namespace ligne::height_test
