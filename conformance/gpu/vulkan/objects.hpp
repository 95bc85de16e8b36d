// Objects of Vulkan, whose library is loaded at run time: what all that use it need.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan.h>

#include <utility>

namespace hn {

// A structure of Vulkan, empty but for its type.
template <typename Structure>
Structure of_type(VkStructureType type) {
  Structure structure{};
  structure.sType = type;
  return structure;
}

// An object of the device, destroyed with this. Its device and the function live longer.
template <typename Handle>
class UniqueHandle {
 public:
  using Destroy = void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*);

  UniqueHandle() = default;
  UniqueHandle(VkDevice device, Handle handle, Destroy destroy) : device_(device), handle_(handle), destroy_(destroy) {}
  UniqueHandle(UniqueHandle&& other) noexcept
      : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)), destroy_(other.destroy_) {}
  UniqueHandle& operator=(UniqueHandle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  ~UniqueHandle() {
    if (handle_ != VK_NULL_HANDLE) destroy_(device_, handle_, nullptr);
  }

  Handle get() const { return handle_; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

}  // namespace hn
