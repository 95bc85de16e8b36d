#include "gpu/vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_raii.hpp>

#include "gpu/driver/library.hpp"

namespace hn {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::uint32_t kBindings = 3;
constexpr auto kCompute = vk::PipelineBindPoint::eCompute;

std::string version_text(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

// The smallest comes first.
std::tuple<int, std::string, std::uint32_t> rank_of(const vk::raii::PhysicalDevice& device) {
  using Type = vk::PhysicalDeviceType;
  const vk::PhysicalDeviceProperties properties = device.getProperties();
  constexpr std::array kFirst = {Type::eDiscreteGpu, Type::eIntegratedGpu, Type::eVirtualGpu, Type::eCpu};
  const auto type = std::ranges::find(kFirst, properties.deviceType);
  return {static_cast<int>(type - kFirst.begin()), properties.deviceName.data(), properties.driverVersion};
}

// One instance, and what belongs to it, in a process.
class Instance {
 public:
  static Result<std::unique_ptr<Instance>> create() {
    // From here on it stays loaded: the context would unload it.
    const auto library = Library::open({"libvulkan.so.1", "libvulkan.so"});
    if (!library) return fail("libvulkan is not here: " + library.error().message);
    try {
      return std::make_unique<Instance>();
    } catch (const vk::IncompatibleDriverError&) {
      return fail("libvulkan finds no driver that works");
    } catch (const std::exception& error) {
      return fail(error.what());
    }
  }

  Instance() = default;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  // The messages of the layers since the last call.
  std::string complaints() { return std::exchange(complaints_, {}); }

  // In the order in which they are numbered.
  std::vector<vk::raii::PhysicalDevice> devices() const {
    vk::raii::PhysicalDevices devices(instance_);
    std::ranges::stable_sort(devices, {}, rank_of);
    return devices;
  }

  VulkanDeviceInfo describe(const vk::raii::PhysicalDevice& device) const {
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    VulkanDeviceInfo info{properties.deviceName.data(), "", "Vulkan " + version_text(properties.apiVersion),
                          validated_};
    if (!knows_1_2(device)) return info;
    const auto found = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = found.get<vk::PhysicalDeviceDriverProperties>();
    info.driver = driver.driverName.data();
    if (driver.driverInfo[0] != '\0') info.version += fmt::format(", {}", driver.driverInfo.data());
    return info;
  }

  // The features of a device by which shaders have integers of 8 bits, as Slang writes them.
  std::optional<vk::PhysicalDeviceShaderFloat16Int8Features> bytes_of(const vk::raii::PhysicalDevice& device) const {
    if (!knows_1_2(device)) return std::nullopt;
    using Bytes = vk::PhysicalDeviceShaderFloat16Int8Features;
    return device.getFeatures2<vk::PhysicalDeviceFeatures2, Bytes>().get<Bytes>();
  }

 private:
  bool knows_1_2(const vk::raii::PhysicalDevice& device) const {
    return std::min(version_, device.getProperties().apiVersion) >= VK_API_VERSION_1_2;
  }

  std::uint32_t version() const {
    if (!context_.getDispatcher()->vkEnumerateInstanceVersion) return VK_API_VERSION_1_0;
    return std::min<std::uint32_t>(context_.enumerateInstanceVersion(), VK_API_VERSION_1_2);
  }

  bool has_validation_layer() const {
    return std::ranges::any_of(context_.enumerateInstanceLayerProperties(), [](const vk::LayerProperties& layer) {
      return std::string_view(layer.layerName.data()) == kValidationLayer;
    });
  }

  vk::raii::Instance make_instance() const {
    const vk::ApplicationInfo application(nullptr, 0, nullptr, 0, version_);
    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    if (validated_) {
      layers.push_back(kValidationLayer);
      extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    return {context_, vk::InstanceCreateInfo({}, &application, layers, extensions)};
  }

  vk::raii::DebugUtilsMessengerEXT make_messenger() {
    if (!validated_) return nullptr;
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    // Not the loader's messages on other drivers.
    constexpr auto kType = vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation;
    return {instance_, vk::DebugUtilsMessengerCreateInfoEXT({}, Severity::eError | Severity::eWarning, kType,
                                                            take_complaint, this)};
  }

  static VKAPI_ATTR VkBool32 VKAPI_CALL take_complaint(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                       VkDebugUtilsMessageTypeFlagsEXT,
                                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* self) {
    static_cast<Instance*>(self)->complaints_ += fmt::format("{}\n", data->pMessage);
    return VK_FALSE;  // so that the call goes on
  }

  vk::raii::Context context_;
  std::uint32_t version_ = version();
  bool validated_ = has_validation_layer();
  std::string complaints_;
  vk::raii::Instance instance_ = make_instance();
  vk::raii::DebugUtilsMessengerEXT messenger_ = make_messenger();
};

struct Kernel final : VulkanKernel {
  explicit Kernel(vk::raii::Pipeline made) : pipeline(std::move(made)) {}
  vk::raii::Pipeline pipeline;
};

// A buffer that the CPU sees.
struct Buffer {
  vk::raii::DeviceMemory memory = nullptr;  // goes after the buffer in it
  vk::raii::Buffer buffer = nullptr;
  void* words = nullptr;
  vk::DeviceSize bytes = 0;
};

class Device final : public VulkanDevice {
 public:
  Device(std::unique_ptr<Instance> instance, vk::raii::PhysicalDevice gpu)
      : instance_(std::move(instance)), gpu_(std::move(gpu)) {}

  const VulkanDeviceInfo& info() const override { return info_; }
  bool is_lost() const override { return lost_; }

  Result<std::unique_ptr<VulkanKernel>> build(std::span<const std::uint32_t> spirv) override {
    std::optional<vk::raii::ShaderModule> module;
    HN_DO(guarded([&] { module.emplace(device_, vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data())); }));
    std::unique_ptr<Kernel> kernel;
    HN_DO(guarded([&] {
      const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, **module, "main");
      kernel = std::make_unique<Kernel>(
          vk::raii::Pipeline(device_, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout_)));
    }));
    return kernel;
  }

  Result<void> run(const VulkanKernel& kernel, std::span<const std::uint32_t> points,
                   std::span<const std::uint32_t> uniforms, std::uint32_t groups,
                   std::span<std::uint32_t> results) override {
    HN_DO(guarded([&] {
      fill(kResultsBinding, results);
      fill(kPointsBinding, points);
      fill(kUniformsBinding, uniforms);
      record(static_cast<const Kernel&>(kernel), groups);
      queue_.submit(vk::SubmitInfo(nullptr, nullptr, *commands_), *fence_);
      (void)device_.waitForFences(*fence_, true, std::numeric_limits<std::uint64_t>::max());
      device_.resetFences(*fence_);
    }));
    std::memcpy(results.data(), buffers_[kResultsBinding].words, results.size_bytes());
    return {};
  }

  // Makes a result of what throws. Who breaks a rule of Vulkan may get any values, so a complaint comes before all
  // else.
  template <typename Function>
  Result<void> guarded(Function function) {
    std::string refusal;
    try {
      function();
    } catch (const vk::SystemError& error) {
      refusal = error.what();
      lost_ = lost_ || error.code() == vk::Result::eErrorDeviceLost;  // it does not come back
    }
    if (const std::string complaints = instance_->complaints(); !complaints.empty()) {
      return fail("the validation layers complain", complaints);
    }
    if (!refusal.empty()) return fail(refusal);
    return {};
  }

 private:
  std::uint32_t compute_family() const {
    const auto families = gpu_.getQueueFamilyProperties();
    const auto family = std::ranges::find_if(families, [](const vk::QueueFamilyProperties& one) {
      return static_cast<bool>(one.queueFlags & vk::QueueFlagBits::eCompute);
    });
    if (family == families.end()) throw std::runtime_error(fmt::format("{} runs no compute shaders", info_.name));
    return static_cast<std::uint32_t>(family - families.begin());
  }

  vk::raii::Device make_device() const {
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, family_, 1, &priority);
    const auto bytes = instance_->bytes_of(gpu_);
    return {gpu_, vk::DeviceCreateInfo({}, queue, {}, {}, nullptr, bytes ? &*bytes : nullptr)};
  }

  vk::raii::DescriptorSetLayout make_set_layout() const {
    std::array<vk::DescriptorSetLayoutBinding, kBindings> bindings;
    for (std::uint32_t i = 0; i < kBindings; ++i) {
      bindings[i] = {i, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute};
    }
    return {device_, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
  }

  vk::raii::DescriptorPool make_sets() const {
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer, kBindings);
    return {device_, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size)};
  }

  vk::raii::DescriptorSet make_set() const {
    vk::raii::DescriptorSets sets(device_, vk::DescriptorSetAllocateInfo(*sets_, *set_layout_));
    return std::move(sets.front());
  }

  vk::raii::CommandBuffer make_commands() const {
    vk::raii::CommandBuffers commands(device_,
                                      vk::CommandBufferAllocateInfo(*pool_, vk::CommandBufferLevel::ePrimary, 1));
    return std::move(commands.front());
  }

  // The words go into the buffer of the binding, which grows if it must.
  void fill(std::uint32_t binding, std::span<const std::uint32_t> words) {
    Buffer& buffer = buffers_[binding];
    if (buffer.bytes < words.size_bytes()) {
      buffer = {};
      buffer = make_buffer(words.size_bytes());
      const vk::DescriptorBufferInfo whole(*buffer.buffer, 0, VK_WHOLE_SIZE);
      const vk::WriteDescriptorSet write(*set_, binding, 0, vk::DescriptorType::eStorageBuffer, nullptr, whole);
      device_.updateDescriptorSets(write, nullptr);
    }
    std::memcpy(buffer.words, words.data(), words.size_bytes());
  }

  Buffer make_buffer(vk::DeviceSize bytes) const {
    Buffer made;
    made.bytes = bytes;
    made.buffer = vk::raii::Buffer(device_, vk::BufferCreateInfo({}, bytes, vk::BufferUsageFlagBits::eStorageBuffer));
    const vk::MemoryRequirements needs = made.buffer.getMemoryRequirements();
    made.memory =
        vk::raii::DeviceMemory(device_, vk::MemoryAllocateInfo(needs.size, memory_type(needs.memoryTypeBits)));
    made.buffer.bindMemory(*made.memory, 0);
    made.words = made.memory.mapMemory(0, VK_WHOLE_SIZE);
    return made;
  }

  // Vulkan promises memory that the CPU sees without further ado for every buffer; reading is faster where it is
  // cached.
  std::uint32_t memory_type(std::uint32_t allowed) const {
    using Property = vk::MemoryPropertyFlagBits;
    const vk::PhysicalDeviceMemoryProperties memory = gpu_.getMemoryProperties();
    const vk::MemoryPropertyFlags seen = Property::eHostVisible | Property::eHostCoherent;
    for (const vk::MemoryPropertyFlags wanted : {seen | Property::eHostCached, seen}) {
      for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        if ((allowed & (1u << i)) != 0 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
      }
    }
    return 0;
  }

  void record(const Kernel& kernel, std::uint32_t groups) const {
    pool_.reset();
    commands_.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    commands_.bindPipeline(kCompute, *kernel.pipeline);
    commands_.bindDescriptorSets(kCompute, *layout_, 0, *set_, nullptr);
    commands_.dispatch(groups, 1, 1);
    const vk::MemoryBarrier written(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands_.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {}, written,
                              nullptr, nullptr);
    commands_.end();
  }

  std::unique_ptr<Instance> instance_;
  vk::raii::PhysicalDevice gpu_;
  VulkanDeviceInfo info_ = instance_->describe(gpu_);
  bool lost_ = false;
  std::uint32_t family_ = compute_family();
  vk::raii::Device device_ = make_device();
  vk::raii::Queue queue_{device_, family_, 0};
  vk::raii::DescriptorSetLayout set_layout_ = make_set_layout();
  vk::raii::PipelineLayout layout_{device_, vk::PipelineLayoutCreateInfo({}, *set_layout_)};
  vk::raii::DescriptorPool sets_ = make_sets();
  vk::raii::DescriptorSet set_ = make_set();
  vk::raii::CommandPool pool_{device_, vk::CommandPoolCreateInfo({}, family_)};
  vk::raii::CommandBuffer commands_ = make_commands();
  vk::raii::Fence fence_{device_, vk::FenceCreateInfo()};
  std::array<Buffer, kBindings> buffers_;
};

}  // namespace

Result<std::unique_ptr<VulkanDevice>> open_vulkan_device(int number) {
  HN_TRY(auto instance, Instance::create());
  try {
    std::vector<vk::raii::PhysicalDevice> devices = instance->devices();
    const auto index = static_cast<std::size_t>(number);
    if (index >= devices.size()) {
      return fail(fmt::format("there is no Vulkan device {}; this machine has {}", number, devices.size()));
    }
    auto device = std::make_unique<Device>(std::move(instance), std::move(devices[index]));
    HN_DO(device->guarded([] {}));
    return device;
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

int vulkan_device_count() {
  try {
    const auto instance = Instance::create();
    return instance ? static_cast<int>((*instance)->devices().size()) : 0;
  } catch (const vk::SystemError&) {
    return 0;
  }
}

}  // namespace hn
