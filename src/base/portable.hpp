#pragma once
/// Parts of C++20 that some standard libraries lack (libc++ before version 20). Each has a stand-in with the same
/// results. Where the standard library has the part, the name refers to that. The stand-ins are always compiled, so
/// that the tests can compare them with the standard library.

#include <atomic>
#include <charconv>
#include <memory>
#include <type_traits>

namespace ligne {
namespace library_fallback {

/// std::from_chars for a decimal double: the grammar of std::chars_format::general, independent of the locale,
/// correctly rounded.
std::from_chars_result from_chars(const char* first, const char* last, double& value);

/// std::atomic_ref with the operations that the project uses, made of builtins that GCC and Clang share.
template <class T>
class AtomicRef {
 public:
  explicit AtomicRef(T& object) : object_(std::addressof(object)) {
    static_assert(std::is_trivially_copyable_v<T> && __atomic_always_lock_free(sizeof(T), nullptr));
  }

  T load(std::memory_order order = std::memory_order_seq_cst) const {
    std::remove_const_t<T> value;
    __atomic_load(object_, &value, builtin(order));
    return value;
  }
  void store(T value, std::memory_order order = std::memory_order_seq_cst) const {
    __atomic_store(object_, &value, builtin(order));
  }
  T exchange(T value, std::memory_order order = std::memory_order_seq_cst) const {
    T old;
    __atomic_exchange(object_, &value, &old, builtin(order));
    return old;
  }
  T fetch_sub(T value, std::memory_order order = std::memory_order_seq_cst) const {
    return __atomic_fetch_sub(object_, value, builtin(order));
  }
  bool compare_exchange_weak(T& expected, T desired, std::memory_order order = std::memory_order_seq_cst) const {
    return __atomic_compare_exchange(object_, &expected, &desired, true, builtin(order), failure(order));
  }

 private:
  static constexpr int builtin(std::memory_order order) {
    switch (order) {
      case std::memory_order_relaxed:
        return __ATOMIC_RELAXED;
      case std::memory_order_consume:
        return __ATOMIC_CONSUME;
      case std::memory_order_acquire:
        return __ATOMIC_ACQUIRE;
      case std::memory_order_release:
        return __ATOMIC_RELEASE;
      case std::memory_order_acq_rel:
        return __ATOMIC_ACQ_REL;
      default:
        return __ATOMIC_SEQ_CST;
    }
  }
  /// Memory order of the load if the exchange fails.
  static constexpr int failure(std::memory_order order) {
    if (order == std::memory_order_release) return __ATOMIC_RELAXED;
    return order == std::memory_order_acq_rel ? __ATOMIC_ACQUIRE : builtin(order);
  }

  T* object_;
};

}  // namespace library_fallback

#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
inline std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  return std::from_chars(first, last, value);
}
#else
using library_fallback::from_chars;
#endif

#if defined(__cpp_lib_atomic_ref)
template <class T>
using AtomicRef = std::atomic_ref<T>;
#else
template <class T>
using AtomicRef = library_fallback::AtomicRef<T>;
#endif

}  // namespace ligne
