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

/// A compressed buffer view: `count` elements of `stride` bytes. The rules of the extension for modes, filters and strides
/// hold (check_meshopt()).
struct MeshoptView {
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
  std::size_t count = 0, stride = 0;
};

/// An empty phrase, or the rule of the extension that a view breaks.
std::string check_meshopt(const MeshoptView& view);

/// The elements, or nothing and a phrase in `cause` where the stream is broken. The memory asked for is at most 64 times as
/// large as the stream.
/// Source: Khronos, EXT_meshopt_compression, appendix A (bitstream) and B (filters).
std::vector<std::byte> decode_meshopt(std::span<const std::byte> stream, const MeshoptView& view, std::string& cause);

/// Applies a filter to decoded attributes, in place (appendix B).
void apply_meshopt_filter(const MeshoptView& view, std::span<std::byte> elements);

}  // namespace ligne
