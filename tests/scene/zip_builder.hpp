#pragma once
/// Small ZIP archives and other packed bytes, written by the tests themselves.

#include <zlib.h>

#include "support/standard.hpp"

namespace ligne::zip_test {

/// The text packed by deflate. `window` as zlib takes it: -15 for the bare stream, 15 with its own head, 31 as gzip.
inline std::string deflated(const std::string& text, int window) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

inline std::string little(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
  return out;
}

/// An archive of entries, each a name and its text. `wide`: sizes and places stand in the fields of ZIP64.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& entries, bool packed = true,
                       bool wide = false) {
  std::string out, directory;
  for (const auto& [name, text] : entries) {
    const std::string data = packed ? deflated(text, -MAX_WBITS) : text;
    const std::uint64_t crc = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    const std::string method = little(packed ? 8 : 0, 2), at = little(out.size(), 8);
    const std::string extra =
        wide ? little(1, 2) + little(24, 2) + little(text.size(), 8) + little(data.size(), 8) + at : std::string();
    const std::string sizes = wide ? std::string(8, '\xff') : little(data.size(), 4) + little(text.size(), 4);
    out += "PK\3\4" + little(20, 2) + little(0, 2) + method + little(0, 4) + little(crc, 4) + little(data.size(), 4) +
           little(text.size(), 4) + little(name.size(), 2) + little(0, 2) + name + data;
    directory += "PK\1\2" + little(20, 2) + little(20, 2) + little(0, 2) + method + little(0, 4) + little(crc, 4) + sizes +
                 little(name.size(), 2) + little(extra.size(), 2) + std::string(10, '\0') +
                 (wide ? std::string(4, '\xff') : at.substr(0, 4)) + name + extra;
  }
  const std::uint64_t begin = out.size(), count = entries.size();
  out += directory;
  if (wide) {
    const std::uint64_t end64 = out.size();
    out += "PK\6\6" + little(44, 8) + little(45, 2) + little(45, 2) + little(0, 8) + little(count, 8) + little(count, 8) +
           little(directory.size(), 8) + little(begin, 8);
    out += "PK\6\7" + little(0, 4) + little(end64, 8) + little(1, 4);
  }
  out += "PK\5\6" + little(0, 4) + (wide ? std::string(4, '\xff') : little(count, 2) + little(count, 2)) +
         little(directory.size(), 4) + (wide ? std::string(4, '\xff') : little(begin, 4)) + little(0, 2);
  return out;
}

/// A 3MF whose model is the part that the relationships name.
inline std::string three_mf(const std::string& model, bool packed = true, bool wide = false) {
  return zip({{"[Content_Types].xml", "<Types/>"},
              {"_rels/.rels",
               "<Relationships><Relationship Target='/3D/model one.model' Id='r' "
               "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>"},
              {"3D/model one.model", model}},
             packed, wide);
}

}  // namespace ligne::zip_test
