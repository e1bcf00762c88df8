#include "scene/readers/gltf/gltf_accessor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Value for the index of the first bad element if all are good.
constexpr std::size_t kAllGood = std::numeric_limits<std::size_t>::max();

std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

bool is_index_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Layout of elements in a buffer view.
struct ElementLayout {
  std::size_t count, element_size;  ///< the size in bytes
  int component_type;
  bool may_stride = false;  ///< the view's stride applies; otherwise elements are adjacent
};

GltfElements in_view(GltfDocument& document, const std::string& place, int view_index, std::size_t offset,
                     const ElementLayout& layout) {
  const auto [count, element_size, component_type, may_stride] = layout;
  const tinygltf::BufferView& view = document.model.bufferViews[static_cast<std::size_t>(view_index)];
  const std::size_t stride = may_stride && view.byteStride != 0 ? view.byteStride : element_size;
  if (stride < element_size) document.fail(place, "its elements are larger than their byteStride");
  const bool fits = count == 0 || (offset <= view.byteLength && element_size <= view.byteLength - offset &&
                                   count - 1 <= (view.byteLength - offset - element_size) / stride);
  if (!fits) {
    document.fail(place, std::to_string(count) + " elements do not fit into bufferView " + std::to_string(view_index) +
                             " of " + std::to_string(view.byteLength) + " bytes");
  }
  const std::span<const std::byte> bytes = document.view_bytes(static_cast<std::size_t>(view_index));
  // An accessor without elements may have any offset.
  const std::byte* data = count == 0 ? bytes.data() : bytes.data() + offset;
  return {data, count, stride, component_type};
}

GltfAccessor open_accessor(GltfDocument& document, std::size_t index, std::size_t components) {
  const tinygltf::Accessor& from = document.model.accessors[index];
  GltfAccessor accessor;
  accessor.place = "accessor " + std::to_string(index);
  accessor.normalized = from.normalized;
  if (from.count >= kNone) document.fail(accessor.place, "has more than 4294967294 elements");
  const std::size_t element_size = components * component_size(from.componentType);
  if (from.bufferView >= 0) {
    accessor.elements = in_view(document, accessor.place, from.bufferView, from.byteOffset,
                                {from.count, element_size, from.componentType, true});
  } else {
    // Zeros take no bytes in the file, so their count is accepted only up to the length of the file.
    if (from.count > document.bytes_read()) {
      document.fail(accessor.place, "claims " + std::to_string(from.count) + " elements, but has no bufferView");
    }
    accessor.elements = {nullptr, from.count, element_size, from.componentType};
  }
  if (from.sparse.isSparse) {
    const auto count = static_cast<std::size_t>(from.sparse.count);
    const auto& indices = from.sparse.indices;
    const auto& values = from.sparse.values;
    if (!is_index_type(indices.componentType)) document.fail(accessor.place, "its sparse indices are not unsigned integers");
    accessor.sparse_indices = in_view(document, accessor.place + ", sparse indices", indices.bufferView,
                                      static_cast<std::size_t>(indices.byteOffset),
                                      {count, component_size(indices.componentType), indices.componentType});
    accessor.sparse_values = in_view(document, accessor.place + ", sparse values", values.bufferView,
                                     static_cast<std::size_t>(values.byteOffset), {count, element_size, from.componentType});
  }
  return accessor;
}

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

/// Calls work with a value of the C++ type of a component.
template <class Work>
auto with_type(int component_type, const Work& work) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return work(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return work(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return work(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return work(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return work(std::uint32_t{});
    default:
      return work(float{});
  }
}

/// Calls work as with_type() does, for the types of indices (is_index_type()).
template <class Work>
auto with_index_type(int component_type, const Work& work) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return work(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return work(std::uint16_t{});
    default:
      return work(std::uint32_t{});
  }
}

std::uint32_t load_index(const GltfElements& from, std::size_t i) {
  return with_index_type(from.component_type,
                         [&](auto type) -> std::uint32_t { return load<decltype(type)>(from.data + i * from.stride); });
}

/// The element that the i-th sparse value replaces. Throws InputError if there is no such element.
std::uint32_t sparse_index(const GltfDocument& document, const GltfAccessor& accessor, std::size_t i) {
  const std::uint32_t at = load_index(accessor.sparse_indices, i);
  if (at < accessor.count()) return at;
  document.fail(accessor.place,
                "sparse index " + std::to_string(at) + " of " + std::to_string(accessor.count()) + " elements");
}

/// Number k of element i; normalized integers are scaled to -1 to 1.
double load_component(const GltfElements& from, std::size_t i, std::size_t k, bool normalized) {
  return with_type(from.component_type, [&](auto type) -> double {
    using T = decltype(type);
    const auto value = static_cast<double>(load<T>(from.data + i * from.stride + k * sizeof(T)));
    if (!normalized || std::is_floating_point_v<T>) return value;
    return std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
  });
}

/// Result of reading: the largest absolute value, and the first invalid element.
struct ReadAccessor {
  double largest = 0;
  std::size_t bad = kAllGood;
  friend ReadAccessor operator+(const ReadAccessor& a, const ReadAccessor& b) {
    return {std::max(a.largest, b.largest), std::min(a.bad, b.bad)};
  }
};

/// Whether a transform leaves every point unchanged.
bool is_identity(const glm::dmat4& m) { return m == glm::dmat4(1); }

/// Reads elements and calls put(i, position) for each.
template <class T, class Put>
ReadAccessor read_as(const GltfElements& from, double scale, const Put& put) {
  return parallel_reduce(from.count, kShortWorkBlock, ReadAccessor{}, [&](std::size_t begin, std::size_t end) {
    ReadAccessor met;
    T largest = 0;  // of floats; integers are always valid
    for (std::size_t i = begin; i != end; ++i) {
      const std::byte* at = from.data + i * from.stride;
      const T x = load<T>(at), y = load<T>(at + sizeof(T)), z = load<T>(at + 2 * sizeof(T));
      if constexpr (std::is_floating_point_v<T>) {
        const T most = std::max({std::abs(x), std::abs(y), std::abs(z)});
        if (!(std::abs(x) + std::abs(y) + std::abs(z) < std::numeric_limits<T>::infinity()) &&
            !(std::isfinite(x) && std::isfinite(y) && std::isfinite(z))) {
          met.bad = std::min(met.bad, i);
        }
        largest = std::max(largest, most);
        put(i, Point3(x, y, z));
      } else {
        // The most negative normalized integer also means -1.
        const Point3 p = glm::max(Point3(x, y, z) * scale, scale == 1 ? -std::numeric_limits<double>::infinity() : -1.0);
        met.largest = std::max({met.largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        put(i, p);
      }
    }
    met.largest = std::max(met.largest, static_cast<double>(largest));
    return met;
  });
}

/// The value of an integer 1 as a component.
template <class T>
double scale_of(bool normalized) {
  return normalized && std::is_integral_v<T> ? 1.0 / static_cast<double>(std::numeric_limits<T>::max()) : 1.0;
}

template <class Put>
ReadAccessor read_elements(const GltfElements& from, bool normalized, const Put& put) {
  if (!from.data) {
    for (std::size_t i = 0; i < from.count; ++i) put(i, Point3(0));
    return {};
  }
  return with_type(from.component_type, [&](auto type) {
    using T = decltype(type);
    return read_as<T>(from, scale_of<T>(normalized), put);
  });
}

/// Writes positions transformed by `move`; sparse ones replace others.
template <class Move>
double read_moved(const GltfDocument& document, const GltfAccessor& accessor, std::span<Point3> out, const Move& move) {
  const auto check = [&](const ReadAccessor& met, const char* what) {
    if (met.bad != kAllGood) document.fail(accessor.place, std::string(what) + std::to_string(met.bad) + " is not finite");
    return met.largest;
  };
  double largest =
      check(read_elements(accessor.elements, accessor.normalized, [&](std::size_t i, const Point3& p) { out[i] = move(p); }),
            "position ");
  const GltfElements& indices = accessor.sparse_indices;
  for (std::size_t i = 0; i < indices.count; ++i) sparse_index(document, accessor, i);
  // Sequential, so that the last of two values for one element counts at any number of threads.
  std::vector<Point3> values(indices.count);
  const ReadAccessor met = read_elements(accessor.sparse_values, accessor.normalized,
                                         [&](std::size_t i, const Point3& p) { values[i] = move(p); });
  for (std::size_t i = 0; i < indices.count; ++i) out[load_index(indices, i)] = values[i];
  return std::max(largest, check(met, "sparse position "));
}

}  // namespace

bool GltfAccessor::is_float() const { return elements.component_type == TINYGLTF_COMPONENT_TYPE_FLOAT; }

double GltfAccessor::rounding_step(double largest) const {
  // Adjustable. Rounded coordinates reach this number of steps at least, since 10 bits are the coarsest that tools offer for
  // parts; fewer steps count something, such as blocks, and are exact.
  constexpr double kQuantizedSteps = 1024;
  if (is_float()) return 0;
  const double step = with_type(elements.component_type, [&](auto type) { return scale_of<decltype(type)>(normalized); });
  return largest >= kQuantizedSteps * step ? step : 0;
}

GltfAccessor position_accessor(GltfDocument& document, std::size_t accessor) {
  const tinygltf::Accessor& from = document.model.accessors[accessor];
  const std::string place = "accessor " + std::to_string(accessor);
  if (from.type != TINYGLTF_TYPE_VEC3) document.fail(place, "holds positions, but is not a VEC3");
  if (from.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    document.fail(place, "holds positions of 32-bit integers, which glTF does not allow");
  }
  return open_accessor(document, accessor, 3);
}

GltfAccessor index_accessor(GltfDocument& document, std::size_t accessor) {
  const tinygltf::Accessor& from = document.model.accessors[accessor];
  const std::string place = "accessor " + std::to_string(accessor);
  if (from.type != TINYGLTF_TYPE_SCALAR) document.fail(place, "holds indices, but is not a SCALAR");
  if (!is_index_type(from.componentType)) document.fail(place, "holds indices that are not unsigned integers");
  return open_accessor(document, accessor, 1);
}

std::vector<double> read_values(GltfDocument& document, std::size_t index, std::size_t components) {
  const tinygltf::Accessor& from = document.model.accessors[index];
  const std::string place = "accessor " + std::to_string(index);
  const int needed = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(from.type));
  if (needed != static_cast<int>(components)) {
    document.fail(place, "has " + std::to_string(needed) + " numbers in an element, not " + std::to_string(components));
  }
  const GltfAccessor accessor = open_accessor(document, index, components);
  std::vector<double> values(accessor.count() * components, 0.0);
  const auto read = [&](const GltfElements& elements, const auto& place_of) {
    for (std::size_t i = 0; elements.data && i < elements.count; ++i) {
      const std::size_t at = place_of(i);
      if (at >= accessor.count()) document.fail(place, "sparse index " + std::to_string(at) + " is beyond its elements");
      for (std::size_t k = 0; k < components; ++k) {
        const double value = load_component(elements, i, k, accessor.normalized);
        if (!std::isfinite(value)) document.fail(place, "element " + std::to_string(at) + " is not finite");
        values[at * components + k] = value;
      }
    }
  };
  read(accessor.elements, [](std::size_t i) { return i; });
  read(accessor.sparse_values, [&](std::size_t i) { return std::size_t{load_index(accessor.sparse_indices, i)}; });
  return values;
}

double read_positions(const GltfDocument& document, const GltfAccessor& accessor, const glm::dmat4& transform,
                      std::span<Point3> out) {
  if (is_identity(transform)) return read_moved(document, accessor, out, [](const Point3& p) { return p; });
  return read_moved(document, accessor, out, [&](const Point3& p) { return Point3(transform * glm::dvec4(p, 1)); });
}

void read_indices(const GltfDocument& document, const GltfAccessor& accessor, std::uint32_t vertex_count,
                  std::uint32_t first_vertex, std::span<std::uint32_t> out) {
  const GltfElements& from = accessor.elements;
  const auto check = [&](std::size_t i, std::uint32_t index) {
    if (index < vertex_count) return;
    document.fail(accessor.place, "index " + std::to_string(index) + " at " + std::to_string(i) + " is not below the " +
                                      std::to_string(vertex_count) + " vertices");
  };
  if (!from.data) {
    if (from.count != 0) check(0, 0);
    std::fill(out.begin(), out.end(), first_vertex);
  } else {
    const std::size_t bad = with_index_type(from.component_type, [&](auto type) {
      using T = decltype(type);
      const auto read = [&](std::size_t begin, std::size_t end) {
        std::uint32_t largest = 0;
        for (std::size_t i = begin; i != end; ++i) {
          const std::uint32_t index = load<T>(from.data + i * from.stride);
          largest = std::max(largest, index);
          out[i] = first_vertex + index;
        }
        return largest < vertex_count ? kAllGood : begin;
      };
      return parallel_reduce(from.count, kShortWorkBlock, kAllGood, read,
                             [](std::size_t a, std::size_t b) { return std::min(a, b); });
    });
    // Only the block of the first bad index is known. An index is bad even if a sparse one replaces it.
    for (std::size_t i = bad; i < from.count; ++i) check(i, load_index(from, i));
  }
  for (std::size_t i = 0; i < accessor.sparse_indices.count; ++i) {
    const std::uint32_t at = sparse_index(document, accessor, i), index = load_index(accessor.sparse_values, i);
    check(at, index);
    out[at] = first_vertex + index;
  }
}

}  // namespace ligne
