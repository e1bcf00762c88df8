#pragma once
/// Decoder of the streams of the glTF extension EXT_meshopt_compression.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ligne {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

/// A compressed buffer view: `count` elements of `stride` bytes. It obeys the rules of the extension for modes, filters
/// and strides (check_meshopt()).
struct MeshoptView {
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
  std::size_t count = 0, stride = 0;
};

/// The rule of the extension that a view breaks, as a phrase; empty if none.
std::string check_meshopt(const MeshoptView& view);

/// The elements, or nothing and a phrase in `cause` if the stream is broken. Allocates at most 64 times the size of the
/// stream.
/// Source: Khronos, EXT_meshopt_compression, appendix A (bitstream) and B (filters).
std::vector<std::byte> decode_meshopt(std::span<const std::byte> stream, const MeshoptView& view, std::string& cause);

/// Applies a filter to decoded attributes, in place (appendix B).
void apply_meshopt_filter(const MeshoptView& view, std::span<std::byte> elements);

}  // namespace ligne
