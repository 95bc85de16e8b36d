// NumPy's arrays as the package reads and writes them: any axes, any strides, points by the block.
// SPDX-License-Identifier: MIT

#pragma once

#include <nanobind/nanobind.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace hashnoise::python {

// The memory of an array, for as long as this lives. The GIL must be held where it begins and ends.
class Memory {
 public:
  Memory(nanobind::handle array, int flags) {
    if (PyObject_GetBuffer(array.ptr(), &view_, flags) != 0) throw nanobind::python_error();
  }
  ~Memory() { PyBuffer_Release(&view_); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  const Py_buffer& view() const { return view_; }
  // Whether its numbers are of one of these formats, as Python's struct names them, and have so many bytes. The order
  // of the bytes is the processor's.
  bool holds(std::string_view formats, std::ptrdiff_t size) const {
    std::string_view format = view_.format == nullptr ? "" : view_.format;
    format.remove_prefix(std::min(format.find_first_not_of("@=<^"), format.size()));  // of numbers at odd places
    return view_.itemsize == size && format.size() == 1 && formats.find(format[0]) != std::string_view::npos;
  }

 private:
  Py_buffer view_{};
};

enum class Kind { kFloat32, kFloat64, kInt32, kInt64 };

inline Kind kind_of(const Memory& memory) {
  if (memory.holds("f", 4)) return Kind::kFloat32;
  if (memory.holds("d", 8)) return Kind::kFloat64;
  if (memory.holds("il", 4)) return Kind::kInt32;
  if (memory.holds("lq", 8)) return Kind::kInt64;
  throw std::invalid_argument("an array must be of float32, float64, int32 or int64");
}

// An array along the axes of the result. Steps are in bytes, and 0 along an axis with a single element.
struct StridedArray {
  std::byte* data = nullptr;
  Kind kind = Kind::kFloat32;
  std::vector<std::ptrdiff_t> steps{};
};

// `array` as one that is broadcast to so many axes. Its shape must fit.
inline StridedArray broadcast(const Memory& memory, const std::vector<std::ptrdiff_t>& shape) {
  const Py_buffer& view = memory.view();
  const auto axes = static_cast<std::size_t>(view.ndim);
  if (axes > shape.size()) throw std::invalid_argument("an array has more axes than the result");
  StridedArray strided{static_cast<std::byte*>(view.buf), kind_of(memory),
                       std::vector<std::ptrdiff_t>(shape.size(), 0)};
  for (std::size_t i = 0; i < axes; ++i) {
    const std::size_t axis = shape.size() - axes + i;
    if (view.shape[i] == shape[axis]) {
      strided.steps[axis] = view.shape[i] == 1 ? 0 : view.strides[i];
    } else if (view.shape[i] != 1) {
      throw std::invalid_argument("the shape of an array does not fit the result");
    }
  }
  return strided;
}

// The points of a result, in the order in which the last of the arrays has them in memory, and the arrays along them.
class Walk {
 public:
  Walk(std::vector<std::ptrdiff_t> shape, std::vector<StridedArray> arrays)
      : shape_(std::move(shape)), arrays_(std::move(arrays)) {
    for (std::size_t axis = shape_.size(); axis-- > 0;) {
      if (shape_[axis] == 1) erase(axis);
    }
    order_axes();
    for (std::size_t axis = shape_.size(); axis-- > 0;) {
      if (axis + 1 >= shape_.size() || !is_one_with_next(axis)) continue;
      shape_[axis + 1] *= shape_[axis];
      erase(axis);
    }
  }

  const StridedArray& array(std::size_t index) const { return arrays_[index]; }

  // Whether the array's `count` points from `begin` lie one behind the other, as numbers of this kind.
  bool is_row(std::size_t index, Kind kind, std::size_t begin, std::size_t count) const {
    const StridedArray& array = arrays_[index];
    const std::ptrdiff_t size = size_of(kind);
    if (array.kind != kind || reinterpret_cast<std::uintptr_t>(array.data) % static_cast<std::size_t>(size) != 0) {
      return false;
    }
    if (shape_.empty() || is_packed(array, size)) return true;
    return array.steps.back() == size && begin % length() + count <= length() &&
           std::all_of(array.steps.begin(), array.steps.end(), [&](std::ptrdiff_t step) { return step % size == 0; });
  }

  std::byte* place(std::size_t index, std::size_t point) const {
    const StridedArray& array = arrays_[index];
    std::byte* at = array.data;
    for (std::size_t axis = shape_.size(); axis-- > 0;) {
      const auto size = static_cast<std::size_t>(shape_[axis]);
      at += static_cast<std::ptrdiff_t>(point % size) * array.steps[axis];
      point /= size;
    }
    return at;
  }

  // Calls visit(where in the array, step, where in the block, points) for the rest of each row.
  template <class Visit>
  void rows(std::size_t index, std::size_t begin, std::size_t count, const Visit& visit) const {
    const std::ptrdiff_t step = shape_.empty() ? 0 : arrays_[index].steps.back();
    for (std::size_t done = 0; done < count;) {
      const std::size_t part = std::min(count - done, length() - (begin + done) % length());
      visit(place(index, begin + done), step, done, part);
      done += part;
    }
  }

  template <class From, class To>
  void gather(std::size_t index, std::size_t begin, std::size_t count, To* to) const {
    rows(index, begin, count, [to](const std::byte* from, std::ptrdiff_t step, std::size_t first, std::size_t points) {
      From value;
      if (step == 0) {
        std::memcpy(&value, from, sizeof value);
        std::fill_n(to + first, points, static_cast<To>(value));
      } else if (step == sizeof value) {  // a loop of its own, which compilers vectorize
        for (std::size_t i = 0; i < points; ++i) {
          std::memcpy(&value, from + i * sizeof value, sizeof value);
          to[first + i] = static_cast<To>(value);
        }
      } else {
        for (std::size_t i = 0; i < points; ++i) {
          std::memcpy(&value, from + static_cast<std::ptrdiff_t>(i) * step, sizeof value);
          to[first + i] = static_cast<To>(value);
        }
      }
    });
  }

  void scatter(const float* from, std::size_t index, std::size_t begin, std::size_t count,
               std::ptrdiff_t offset) const {
    rows(index, begin, count, [=](std::byte* to, std::ptrdiff_t step, std::size_t first, std::size_t points) {
      for (std::size_t i = 0; i < points; ++i) {
        std::memcpy(to + offset + static_cast<std::ptrdiff_t>(i) * step, from + first + i, sizeof *from);
      }
    });
  }

 private:
  std::size_t length() const { return shape_.empty() ? 1 : static_cast<std::size_t>(shape_.back()); }

  static std::ptrdiff_t size_of(Kind kind) { return kind == Kind::kFloat32 || kind == Kind::kInt32 ? 4 : 8; }

  // Whether all of its points lie one behind the other.
  bool is_packed(const StridedArray& array, std::ptrdiff_t size) const {
    for (std::size_t axis = shape_.size(); axis-- > 0;) {
      if (array.steps[axis] != size) return false;
      size *= shape_[axis];
    }
    return true;
  }

  bool is_one_with_next(std::size_t axis) const {
    return std::all_of(arrays_.begin(), arrays_.end(), [&](const StridedArray& array) {
      return array.steps[axis] == array.steps[axis + 1] * shape_[axis + 1];
    });
  }

  // The axis along which the last array has its numbers side by side comes last: so transposed arrays are read and
  // written in rows, too.
  void order_axes() {
    const std::vector<std::ptrdiff_t> steps = arrays_.back().steps;
    std::vector<std::size_t> order(shape_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(steps[a]) > std::abs(steps[b]); });
    const auto reorder = [&](std::vector<std::ptrdiff_t>& along) {
      const std::vector<std::ptrdiff_t> before = along;
      for (std::size_t i = 0; i < order.size(); ++i) along[i] = before[order[i]];
    };
    reorder(shape_);
    for (StridedArray& array : arrays_) reorder(array.steps);
  }

  void erase(std::size_t axis) {
    const auto at = static_cast<std::ptrdiff_t>(axis);
    shape_.erase(shape_.begin() + at);
    for (StridedArray& array : arrays_) array.steps.erase(array.steps.begin() + at);
  }

  std::vector<std::ptrdiff_t> shape_;
  std::vector<StridedArray> arrays_;
};

}  // namespace hashnoise::python
