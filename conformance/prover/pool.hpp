// Vectors that are made and dropped by the million: their memory is kept, by sizes that are powers of two.
#pragma once

#include <bit>
#include <cstddef>
#include <new>
#include <vector>

namespace hn::prover {

inline void* unused[12];  // of 16 * 2^i bytes: each begins with the next one's address
inline std::size_t size_of_pool(std::size_t bytes) { return std::bit_width((bytes - 1) / 16); }

template <typename T>
struct Pool {
  using value_type = T;
  Pool() = default;
  template <typename Other>
  Pool(const Pool<Other>&) {}
  T* allocate(std::size_t count) {
    const std::size_t i = size_of_pool(count * sizeof(T));
    if (i >= std::size(unused)) return static_cast<T*>(::operator new(count * sizeof(T)));
    void* const found = unused[i];
    if (!found) return static_cast<T*>(::operator new (std::size_t{16} << i));
    unused[i] = *static_cast<void**>(found);
    return static_cast<T*>(found);
  }
  void deallocate(T* p, std::size_t count) {
    const std::size_t i = size_of_pool(count * sizeof(T));
    if (i >= std::size(unused)) return ::operator delete(p);
    *reinterpret_cast<void**>(p) = unused[i];
    unused[i] = p;
  }
  bool operator==(const Pool&) const { return true; }
};
template <typename T>
using Vector = std::vector<T, Pool<T>>;

}  // namespace hn::prover
