#include "scene/readers/gltf/gltf_draco.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "scene/model/diagnostics.hpp"
#include "scene/readers/gltf/gltf_extensions.hpp"

#ifdef LIGNE_HAVE_DRACO
#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#include <draco/mesh/mesh.h>
#endif

namespace ligne {

#ifdef LIGNE_HAVE_DRACO

namespace {

std::unique_ptr<draco::Mesh> decode_mesh(std::span<const std::byte> bytes, std::string& cause) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  decoder.SetSkipAttributeTransform(draco::GeometryAttribute::POSITION);
  try {
    auto result = decoder.DecodeMeshFromBuffer(&buffer);
    if (result.ok()) return std::move(result).value();
    cause = "broken (" + result.status().error_msg_string() + ")";
  } catch (const std::bad_alloc&) {
    cause = "broken, or needs more memory than there is";
  } catch (const std::length_error&) {
    cause = "broken, or needs more memory than there is";
  }
  return nullptr;
}

/// `n` numbers for each point; nothing if one is broken.
template <std::int8_t n>
std::vector<double> attribute_values(const draco::PointAttribute& attribute, std::uint32_t points) {
  std::vector<double> values(n * std::size_t{points});
  for (std::uint32_t i = 0; i < points; ++i) {
    double* const to = &values[n * std::size_t{i}];
    const bool good = attribute.ConvertValue<double, n>(attribute.mapped_index(draco::PointIndex(i)), to);
    if (!good || !std::all_of(to, to + n, [](double v) { return std::isfinite(v); })) return {};
  }
  return values;
}

/// From stored values to coordinates: the encoder stores numbers of steps, or the coordinates themselves.
struct Quantization {
  Point3 origin{0};
  double step = 1;
  bool is_rounded = false;

  explicit Quantization(const draco::PointAttribute& attribute) {
    draco::AttributeQuantizationTransform transform;
    if (!attribute.GetAttributeTransformData() || !transform.InitFromAttribute(attribute)) return;
    origin = {transform.min_value(0), transform.min_value(1), transform.min_value(2)};
    step = transform.range() / (std::ldexp(1.0, transform.quantization_bits()) - 1);
    is_rounded = true;
  }
};

}  // namespace

DracoMesh decode_draco(std::span<const std::byte> bytes, const std::map<std::string, int>& ids, const std::string& name,
                       const std::string& place) {
  const auto fail = [&](const std::string& cause) { throw InputError(name, place + ": its Draco mesh is " + cause); };
  std::string cause;
  const std::unique_ptr<draco::Mesh> mesh = decode_mesh(bytes, cause);
  if (!mesh) fail(cause);
  const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(ids.at("POSITION")));
  if (!attribute || attribute->num_components() != 3) fail("without positions");

  DracoMesh out;
  const Quantization quantization(*attribute);
  if (quantization.is_rounded) out.step = std::abs(quantization.step);
  const std::uint32_t points = mesh->num_points();
  out.positions.resize(points);
  for (std::uint32_t i = 0; i < points; ++i) {
    Point3& p = out.positions[i];
    if (!attribute->ConvertValue<double, 3>(attribute->mapped_index(draco::PointIndex(i)), &p.x)) fail("broken (positions)");
    p = quantization.origin + p * quantization.step;
    const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) fail("broken (a position is not finite)");
    out.largest = std::max(out.largest, most);
  }
  for (const auto& [key, id] : ids) {
    if (key == "POSITION") continue;
    const draco::PointAttribute* other = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    if (key.starts_with("TEXCOORD_")) {
      if (other && other->num_components() == 2) out.coordinates = attribute_values<2>(*other, points);
      continue;
    }
    if (!other || other->num_components() != 4) fail("without " + key);
    std::vector<double>& values = out.joints[key] = attribute_values<4>(*other, points);
    if (values.empty()) fail("broken (" + key + ")");
  }
  out.corners.reserve(3 * static_cast<std::size_t>(mesh->num_faces()));
  for (std::uint32_t f = 0; f < mesh->num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh->face(draco::FaceIndex(f))) {
      if (corner.value() >= points) fail("broken (a corner names no point)");
      out.corners.push_back(corner.value());
    }
  }
  return out;
}

#else

DracoMesh decode_draco(std::span<const std::byte>, const std::map<std::string, int>&, const std::string& name,
                       const std::string& place) {
  throw InputError(
      name, place + ": needs the glTF extension " + kDracoExtension + ", and this program was built without libdraco");
}

#endif

}  // namespace ligne
