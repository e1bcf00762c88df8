// Source: PKWARE, APPNOTE.TXT - .ZIP File Format Specification, 6.3.10: sections 4.3.12 (directory), 4.3.14 to 4.3.16 (its
// end), 4.5.3 (ZIP64), and RFC 1951 (zlib's raw inflate).

#include "scene/readers/zip_archive.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr std::uint32_t kLocalMark = 0x04034b50, kDirectoryMark = 0x02014b50, kEndMark = 0x06054b50, kEnd64Mark = 0x06064b50,
                        kLocator64Mark = 0x07064b50;
constexpr std::uint64_t kLocalBytes = 30, kDirectoryBytes = 46, kEndBytes = 22, kEnd64Bytes = 56, kLocator64Bytes = 20;
constexpr std::uint64_t kLongestComment = 65535;
constexpr std::uint64_t kNo32 = 0xffffffff, kNo16 = 0xffff;  ///< values that refer to the 64-bit field
constexpr std::uint16_t kStored = 0, kDeflated = 8, kExtra64 = 1;
/// Largest ratio by which Deflate expands data: 258 bytes from two bits.
constexpr std::uint64_t kMostGrowth = 1032;

}  // namespace

ZipArchive::ZipArchive(std::span<const std::byte> bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {
  read_directory();
}

void ZipArchive::fail(const std::string& cause) const { throw InputError(name_, "ZIP: " + cause); }

std::uint64_t ZipArchive::number(std::uint64_t at, int bytes) const {
  if (at > bytes_.size() || static_cast<std::uint64_t>(bytes) > bytes_.size() - at) fail("cut off");
  std::uint64_t value = 0;
  for (int i = bytes - 1; i >= 0; --i)
    value = value << 8 | std::to_integer<std::uint64_t>(bytes_[at + static_cast<unsigned>(i)]);
  return value;
}

void ZipArchive::read_directory() {
  // The end record of the directory precedes a comment of any length.
  std::uint64_t end = bytes_.size();
  const std::uint64_t first = end - std::min(end, kEndBytes + kLongestComment);
  bool found = false;
  for (std::uint64_t at = end < kEndBytes ? 0 : end - kEndBytes; !found && end >= kEndBytes; --at) {
    found = number(at, 4) == kEndMark;
    if (found) end = at;
    if (at == first) break;
  }
  if (!found) fail("no directory at its end");
  std::uint64_t count = number(end + 10, 2), at = number(end + 16, 4);
  if ((count == kNo16 || at == kNo32) && end >= kLocator64Bytes && number(end - kLocator64Bytes, 4) == kLocator64Mark) {
    const std::uint64_t end64 = number(end - kLocator64Bytes + 8, 8);
    if (end64 > bytes_.size() - std::min<std::uint64_t>(bytes_.size(), kEnd64Bytes) || number(end64, 4) != kEnd64Mark)
      fail("its directory is broken");
    count = number(end64 + 32, 8);
    at = number(end64 + 48, 8);
  }
  for (std::uint64_t i = 0; i < count; ++i) read_entry(at);
}

void ZipArchive::read_entry(std::uint64_t& at) {
  if (number(at, 4) != kDirectoryMark) fail("its directory is broken");
  ZipEntry entry{.method = static_cast<std::uint16_t>(number(at + 10, 2)),
                 .packed = number(at + 20, 4),
                 .size = number(at + 24, 4),
                 .header = number(at + 42, 4),
                 .is_encrypted = (number(at + 8, 2) & 1) != 0};
  const std::uint64_t name = number(at + 28, 2), extra = number(at + 30, 2), comment = number(at + 32, 2);
  at += kDirectoryBytes;
  if (name + extra + comment > bytes_.size() - at) fail("its directory is cut off");
  entry.name.assign(reinterpret_cast<const char*>(bytes_.data() + at), name);
  std::ranges::replace(entry.name, '\\', '/');
  std::uint64_t field = at + name;
  const std::uint64_t extra_end = field + extra;
  at = extra_end + comment;
  while (field + 4 <= extra_end) {
    const std::uint64_t id = number(field, 2), length = number(field + 2, 2);
    std::uint64_t value = field + 4;
    field = value + length;
    if (id != kExtra64 || field > extra_end) continue;
    for (std::uint64_t* wide : {&entry.size, &entry.packed, &entry.header}) {
      if (*wide != kNo32 || value + 8 > field) continue;
      *wide = number(value, 8);
      value += 8;
    }
  }
  entries_.push_back(std::move(entry));
}

const ZipEntry* ZipArchive::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(entries_, [&](const ZipEntry& entry) { return equal_ignoring_case(entry.name, name); });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::byte> ZipArchive::read(const ZipEntry& entry) const {
  const std::string what = "entry " + shown(entry.name) + " ";
  if (entry.is_encrypted) fail(what + "is encrypted");
  if (entry.method != kStored && entry.method != kDeflated)
    fail(what + "is packed by method " + std::to_string(entry.method));
  if (number(entry.header, 4) != kLocalMark) fail(what + "is not where the directory says");
  const std::uint64_t begin = entry.header + kLocalBytes + number(entry.header + 26, 2) + number(entry.header + 28, 2);
  if (begin > bytes_.size() || entry.packed > bytes_.size() - begin) fail(what + "is cut off");
  if (entry.size / kMostGrowth > entry.packed || entry.size > std::numeric_limits<std::uint32_t>::max()) {
    fail(what + "claims " + std::to_string(entry.size) + " bytes");
  }
  const std::span<const std::byte> packed = bytes_.subspan(begin, entry.packed);
  if (entry.method == kStored) {
    if (entry.size != entry.packed) fail(what + "has two sizes");
    return {packed.begin(), packed.end()};
  }
  std::vector<std::byte> out(entry.size);
  z_stream stream{};
  // Negative: raw, without zlib's header.
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
  stream.avail_in = static_cast<uInt>(std::min<std::uint64_t>(packed.size(), std::numeric_limits<uInt>::max()));
  Bytef nothing = 0;
  stream.next_out = out.empty() ? &nothing : reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = inflate(&stream, Z_FINISH);
  const bool whole = result == Z_STREAM_END && stream.total_out == out.size();
  inflateEnd(&stream);
  if (!whole) fail(what + "is broken");
  return out;
}

}  // namespace ligne
