#include "scene/readers/gltf/meshopt_codec.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace ligne {
namespace {

constexpr std::uint8_t kAttributesHeader = 0xa0, kTrianglesHeader = 0xe1, kIndicesHeader = 0xd1;
constexpr std::size_t kGroup = 16;  ///< elements whose deltas of one byte are stored together
constexpr std::size_t kMostBlock = 256, kMostBlockBytes = 8192;
constexpr std::size_t kLeastAttributesTail = 32, kTrianglesTail = 16, kIndicesTail = 4;
/// Largest ratio by which a stream grows: a group of 16 equal bytes takes two bits.
constexpr std::size_t kMostGrowth = 64;

/// Reads a stream. Beyond its end it returns zeros and sets `broken`.
class Source {
 public:
  explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool broken = false;

  std::uint8_t byte() {
    if (at_ >= bytes_.size()) {
      broken = true;
      return 0;
    }
    return std::to_integer<std::uint8_t>(bytes_[at_++]);
  }
  std::span<const std::byte> bytes(std::size_t n) {
    if (n > bytes_.size() - at_) {
      broken = true;
      n = 0;
    }
    at_ += n;
    return bytes_.subspan(at_ - n, n);
  }
  /// Reads a number with seven bits per byte, lowest first; the highest bit of a byte says whether another one follows.
  std::uint32_t number() {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 35; shift += 7) {
      const std::uint32_t next = byte();
      value |= (next & 0x7f) << shift;
      if (next < 0x80) return value;
    }
    broken = true;
    return 0;
  }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

/// Decodes a number whose sign is in the lowest bit.
template <class T>
T unzigzag(T v) {
  return static_cast<T>((v & 1) != 0 ? ~(v >> 1) : v >> 1);
}

/// Reads one byte of the deltas of 16 elements, with `bits` bits each. A delta with all bits set follows as a whole
/// byte.
void read_deltas(Source& source, unsigned bits, std::array<std::uint8_t, kGroup>& deltas) {
  const unsigned escape = (1u << bits) - 1, per_byte = 8 / bits;
  const std::span<const std::byte> packed = source.bytes(2 * bits);
  if (source.broken) return;
  for (unsigned i = 0; i < kGroup; ++i) {
    const auto byte = std::to_integer<unsigned>(packed[i / per_byte]);
    const unsigned value = byte >> (8 - bits * (i % per_byte + 1)) & escape;
    deltas[i] = value == escape ? source.byte() : static_cast<std::uint8_t>(value);
  }
}

void read_group(Source& source, unsigned mode, std::array<std::uint8_t, kGroup>& deltas) {
  deltas.fill(0);
  if (mode == 1) read_deltas(source, 2, deltas);
  if (mode == 2) read_deltas(source, 4, deltas);
  if (mode != 3) return;
  const std::span<const std::byte> whole = source.bytes(kGroup);
  if (!source.broken) std::memcpy(deltas.data(), whole.data(), kGroup);
}

/// Reads byte `k` of the elements of a block. `value` is this byte of the previous element, and becomes that of the
/// last one.
void read_byte_of_block(Source& source, std::size_t k, std::size_t stride, std::span<std::byte> block, std::uint8_t& value) {
  const std::size_t elements = block.size() / stride, groups = (elements + kGroup - 1) / kGroup;
  const std::span<const std::byte> modes = source.bytes((groups + 3) / 4);
  std::array<std::uint8_t, kGroup> deltas{};
  for (std::size_t group = 0; group < groups && !source.broken; ++group) {
    read_group(source, std::to_integer<unsigned>(modes[group / 4]) >> (2 * (group % 4)) & 3, deltas);
    const std::size_t first = kGroup * group, end = std::min(elements, first + kGroup);
    for (std::size_t i = first; i < end; ++i) {
      value = static_cast<std::uint8_t>(value + unzigzag(deltas[i - first]));
      block[i * stride + k] = std::byte{value};
    }
  }
}

void decode_attributes(std::span<const std::byte> stream, const MeshoptView& view, std::span<std::byte> out,
                       std::string& cause) {
  const std::size_t tail = std::max(view.stride, kLeastAttributesTail);
  if (stream.size() < 1 + tail) {
    cause = "shorter than its ends";
    return;
  }
  // The element that precedes the first is stored at the end.
  std::vector<std::uint8_t> last(view.stride);
  std::memcpy(last.data(), stream.data() + stream.size() - view.stride, view.stride);
  Source source(stream.subspan(1, stream.size() - 1 - tail));
  const std::size_t most = std::min(kMostBlockBytes / view.stride & ~(kGroup - 1), kMostBlock) * view.stride;
  for (std::size_t at = 0; at < out.size() && !source.broken; at += most) {
    const std::span<std::byte> block = out.subspan(at, std::min(most, out.size() - at));
    for (std::size_t k = 0; k < view.stride; ++k) read_byte_of_block(source, k, view.stride, block, last[k]);
  }
  if (source.broken || !source.at_end()) cause = source.broken ? "cut off" : "longer than its elements";
}

void store_index(std::span<std::byte> out, std::size_t i, std::size_t stride, std::uint32_t index) {
  for (std::size_t k = 0; k < stride; ++k) out[i * stride + k] = static_cast<std::byte>(index >> (8 * k) & 0xff);
}

/// Decodes triangles; holds the state that their codes change.
class TriangleDecoder {
 public:
  TriangleDecoder(Source& data, std::span<const std::byte> table) : data_(data), table_(table) {}

  using Triangle = std::array<std::uint32_t, 3>;

  Triangle next(std::uint8_t code) {
    const unsigned high = code >> 4, low = code & 15;
    return high < 15 ? of_edge(high, low) : low < 14 ? of_table(low) : of_data(low == 14);
  }

 private:
  /// A triangle of a recent edge and a vertex: the next one, a recent one, one adjacent to the last explicit one, or an
  /// explicit one.
  Triangle of_edge(unsigned edge, unsigned low) {
    const auto [a, b] = edges_[(edge_end_ - 1 - edge) & 15];
    std::uint32_t c = 0;
    if (low == 0)
      c = next_++;
    else if (low < 13)
      c = recent(low);
    else if (low < 15)
      c = last_ += low == 13 ? ~0u : 1u;
    else
      c = written();
    push_edge(c, b);
    push_edge(a, c);
    if (low == 0 || low >= 13) push_vertex(c);
    return {a, b, c};
  }

  Triangle of_table(unsigned low) {
    const auto code = std::to_integer<unsigned>(table_[low]);
    const std::uint32_t a = next_++;
    return of_codes(a, code >> 4, code & 15, false);
  }

  Triangle of_data(bool begins_with_next) {
    const unsigned code = data_.byte();
    if (code == 0) next_ = 0;
    const std::uint32_t a = begins_with_next ? next_++ : written();
    return of_codes(a, code >> 4, code & 15, true);
  }

  /// `may_be_written`: code 15 means an explicit vertex; the table has none.
  Triangle of_codes(std::uint32_t a, unsigned z, unsigned w, bool may_be_written) {
    const auto vertex = [&](unsigned code) {
      return code == 0 ? next_++ : code == 15 && may_be_written ? written() : recent(code - 1);
    };
    const std::uint32_t b = vertex(z), c = vertex(w);
    push_edge(b, a);
    push_edge(c, b);
    push_edge(a, c);
    push_vertex(a);
    if (z == 0 || (z == 15 && may_be_written)) push_vertex(b);
    if (w == 0 || (w == 15 && may_be_written)) push_vertex(c);
    return {a, b, c};
  }

  std::uint32_t written() { return last_ += unzigzag(data_.number()); }
  std::uint32_t recent(unsigned i) const { return vertices_[(vertex_end_ - 1 - i) & 15]; }
  void push_edge(std::uint32_t a, std::uint32_t b) { edges_[edge_end_++ & 15] = {a, b}; }
  void push_vertex(std::uint32_t v) { vertices_[vertex_end_++ & 15] = v; }

  Source& data_;
  std::span<const std::byte> table_;
  std::uint32_t next_ = 0, last_ = 0;
  std::array<std::array<std::uint32_t, 2>, 16> edges_{};
  std::array<std::uint32_t, 16> vertices_{};
  unsigned edge_end_ = 0, vertex_end_ = 0;
};

void decode_triangles(std::span<const std::byte> stream, const MeshoptView& view, std::span<std::byte> out,
                      std::string& cause) {
  const std::size_t triangles = view.count / 3;
  if (stream.size() < 1 + triangles + kTrianglesTail) {
    cause = "cut off";
    return;
  }
  const std::span<const std::byte> codes = stream.subspan(1, triangles);
  Source data(stream.subspan(1 + triangles, stream.size() - 1 - triangles - kTrianglesTail));
  TriangleDecoder decoder(data, stream.last(kTrianglesTail));
  for (std::size_t t = 0; t < triangles && !data.broken; ++t) {
    const auto corners = decoder.next(std::to_integer<std::uint8_t>(codes[t]));
    for (std::size_t k = 0; k < 3; ++k) store_index(out, 3 * t + k, view.stride, corners[k]);
  }
  if (data.broken || !data.at_end()) cause = data.broken ? "cut off" : "longer than its triangles";
}

void decode_indices(std::span<const std::byte> stream, const MeshoptView& view, std::span<std::byte> out,
                    std::string& cause) {
  if (stream.size() < 1 + kIndicesTail) {
    cause = "cut off";
    return;
  }
  Source source(stream.subspan(1, stream.size() - 1 - kIndicesTail));
  std::array<std::uint32_t, 2> last{};
  for (std::size_t i = 0; i < view.count && !source.broken; ++i) {
    const std::uint32_t code = source.number();
    store_index(out, i, view.stride, last[code & 1] += unzigzag(code >> 1));
  }
  if (source.broken || !source.at_end()) cause = source.broken ? "cut off" : "longer than its indices";
}

}  // namespace

std::string check_meshopt(const MeshoptView& view) {
  const std::size_t stride = view.stride;
  if (view.mode == MeshoptMode::attributes) {
    if (stride == 0 || stride % 4 != 0 || stride > 256) return "byteStride is not a multiple of 4 up to 256";
    if (view.filter == MeshoptFilter::octahedral && stride != 4 && stride != 8)
      return "OCTAHEDRAL needs a byteStride of 4 or 8";
    if (view.filter == MeshoptFilter::quaternion && stride != 8) return "QUATERNION needs a byteStride of 8";
    return "";
  }
  if (stride != 2 && stride != 4) return "byteStride of indices is not 2 or 4";
  if (view.filter != MeshoptFilter::none) return "indices have no filter";
  return view.mode == MeshoptMode::triangles && view.count % 3 != 0 ? "count of TRIANGLES is not a multiple of 3" : "";
}

std::vector<std::byte> decode_meshopt(std::span<const std::byte> stream, const MeshoptView& view, std::string& cause) {
  constexpr std::array kHeaders{kAttributesHeader, kTrianglesHeader, kIndicesHeader};
  const std::byte header{kHeaders[static_cast<std::size_t>(view.mode)]};
  if (stream.empty() || stream[0] != header) {
    cause = "not of this mode, or of a later version";
    return {};
  }
  if (view.count > kMostGrowth * stream.size() / view.stride) {
    cause = "too short for so many elements";
    return {};
  }
  std::vector<std::byte> out(view.count * view.stride);
  if (view.mode == MeshoptMode::attributes)
    decode_attributes(stream, view, out, cause);
  else if (view.mode == MeshoptMode::triangles)
    decode_triangles(stream, view, out, cause);
  else
    decode_indices(stream, view, out, cause);
  if (!cause.empty()) return {};
  apply_meshopt_filter(view, out);
  return out;
}

}  // namespace ligne
