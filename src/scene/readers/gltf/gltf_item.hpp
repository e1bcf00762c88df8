#pragma once
/// Reads a JSON object of a glTF file field by field. Every access checks, and errors name the array, the index and the
/// field.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// One object of the file, and its name in errors.
class GltfItem {
 public:
  using Json = nlohmann::json;

  GltfItem(const Json& value, std::string place, const std::string& name)
      : value_(value), place_(std::move(place)), name_(name) {
    if (!value_.is_object()) fail("is not a JSON object");
  }

  [[noreturn]] void fail(const std::string& cause) const { throw InputError(name_, place_ + ": " + cause); }

  const Json* find(const char* key) const {
    const auto it = value_.find(key);
    return it == value_.end() ? nullptr : &*it;
  }
  std::optional<GltfItem> object(const char* key) const {
    const Json* v = find(key);
    if (!v) return std::nullopt;
    return GltfItem(*v, place_ + ", " + key, name_);
  }
  GltfItem required_object(const char* key) const {
    std::optional<GltfItem> item = object(key);
    if (!item) fail(std::string(key) + " is missing");
    return *item;
  }
  const Json* array(const char* key) const {
    const Json* v = find(key);
    if (v && !v->is_array()) fail(std::string(key) + " is not an array");
    return v;
  }
  std::string text(const char* key) const {
    const Json* v = find(key);
    if (!v) return {};
    if (!v->is_string()) fail(std::string(key) + " is not a string");
    return v->get<std::string>();
  }
  std::optional<std::size_t> whole(const char* key) const {
    const Json* v = find(key);
    if (!v) return std::nullopt;
    return whole(*v, key);
  }
  std::size_t required_whole(const char* key) const {
    const std::optional<std::size_t> v = whole(key);
    if (!v) fail(std::string(key) + " is missing");
    return *v;
  }
  /// An index into an array of `size` items.
  std::optional<std::size_t> index(const char* key, std::size_t size) const {
    const std::optional<std::size_t> v = whole(key);
    if (v) check_index(*v, key, size);
    return v;
  }
  std::size_t required_index(const char* key, std::size_t size) const {
    const std::size_t v = required_whole(key);
    check_index(v, key, size);
    return v;
  }
  Json indices(const char* key, std::size_t size) const {
    Json out = Json::array();
    if (const Json* list = array(key)) {
      for (const Json& v : *list) {
        const std::size_t i = whole(v, key);
        check_index(i, key, size);
        out.push_back(i);
      }
    }
    return out;
  }
  /// `size` numbers, or nothing if the key is absent.
  Json numbers(const char* key, std::size_t size) const {
    const Json* list = array(key);
    if (!list) return nullptr;
    if (list->size() != size) fail(std::string(key) + " does not have " + std::to_string(size) + " numbers");
    if (!std::all_of(list->begin(), list->end(), [](const Json& v) { return v.is_number(); })) {
      fail(std::string(key) + " has a value that is not a number");
    }
    return *list;
  }
  /// Any number of numbers; nothing if the key is absent.
  Json numbers(const char* key) const {
    const Json* list = array(key);
    return list ? numbers(key, list->size()) : Json();
  }
  const std::string& place() const { return place_; }
  const std::string& file() const { return name_; }
  const Json& value() const { return value_; }

 private:
  /// Largest number up to which a double holds every whole number.
  static constexpr double kMaxWhole = 9007199254740992.0;

  std::size_t whole(const Json& v, const char* key) const {
    if (v.is_number_unsigned()) return v.get<std::size_t>();
    // Some exporters write whole numbers as 3.0.
    if (v.is_number_float() && v.get<double>() >= 0 && v.get<double>() <= kMaxWhole &&
        std::floor(v.get<double>()) == v.get<double>()) {
      return static_cast<std::size_t>(v.get<double>());
    }
    fail(std::string(key) + " is not a whole number from 0 on");
  }
  void check_index(std::size_t v, const char* key, std::size_t size) const {
    if (v >= size) fail(std::string(key) + " names number " + std::to_string(v) + " of " + std::to_string(size));
  }

  const Json& value_;
  std::string place_;
  const std::string& name_;
};

}  // namespace ligne
