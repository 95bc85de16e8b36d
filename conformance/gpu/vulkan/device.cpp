#include "gpu/vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "gpu/driver/library.hpp"
#include "gpu/vulkan/objects.hpp"

namespace hn {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::uint32_t kBindings = 3;

std::string name_of(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
      return "VK_ERROR_DEVICE_LOST";
    default:
      return fmt::format("{}", static_cast<int>(result));
  }
}

tl::unexpected<Error> refused(std::string_view function, VkResult result) {
  return fail(fmt::format("{} returns {}", function, name_of(result)));
}

std::string version_text(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

// The functions of an instance. One instance, and what belongs to it, in a process.
class Instance {
 public:
  static Result<std::unique_ptr<Instance>> create() {
    const auto library = Library::open({"libvulkan.so.1", "libvulkan.so"});
    if (!library) return fail("libvulkan is not here: " + library.error().message);
    auto instance = std::make_unique<Instance>(*library);
    HN_DO(instance->start());
    return instance;
  }

  explicit Instance(const Library& library)
      : find_(library.function<std::remove_pointer_t<PFN_vkGetInstanceProcAddr>>("vkGetInstanceProcAddr")) {}
  ~Instance() {
    if (messenger_ != VK_NULL_HANDLE) {
      call<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT")(instance_, messenger_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE) call<PFN_vkDestroyInstance>("vkDestroyInstance")(instance_, nullptr);
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  template <typename Pointer>
  Pointer call(const char* name) const {
    return reinterpret_cast<Pointer>(find_(instance_, name));
  }

  bool validated() const { return messenger_ != VK_NULL_HANDLE; }

  // The messages of the layers since the last call.
  std::string complaints() { return std::exchange(complaints_, {}); }

  // In the order in which they are numbered.
  Result<std::vector<VkPhysicalDevice>> devices() const {
    const auto enumerate = call<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
    std::uint32_t count = 0;
    VkResult done = enumerate(instance_, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    if (done == VK_SUCCESS) done = enumerate(instance_, &count, devices.data());
    if (done != VK_SUCCESS) return refused("vkEnumeratePhysicalDevices", done);
    devices.resize(count);
    std::stable_sort(devices.begin(), devices.end(),
                     [&](VkPhysicalDevice a, VkPhysicalDevice b) { return rank_of(a) < rank_of(b); });
    return devices;
  }

  VkPhysicalDeviceProperties properties_of(VkPhysicalDevice device) const {
    VkPhysicalDeviceProperties properties{};
    call<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(device, &properties);
    return properties;
  }

  VulkanDeviceInfo describe(VkPhysicalDevice device) const {
    const VkPhysicalDeviceProperties properties = properties_of(device);
    VulkanDeviceInfo info{properties.deviceName, "", "Vulkan " + version_text(properties.apiVersion), validated()};
    if (version_ < VK_API_VERSION_1_2 || properties.apiVersion < VK_API_VERSION_1_2) return info;
    auto driver = of_type<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto all = of_type<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    all.pNext = &driver;
    call<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(device, &all);
    info.driver = driver.driverName;
    if (driver.driverInfo[0] != '\0') info.version += fmt::format(", {}", driver.driverInfo);
    return info;
  }

 private:
  Result<void> start() {
    if (!find_) return fail("libvulkan has no vkGetInstanceProcAddr");
    if (const auto ask = call<PFN_vkEnumerateInstanceVersion>("vkEnumerateInstanceVersion")) ask(&version_);
    version_ = std::min<std::uint32_t>(version_, VK_API_VERSION_1_2);
    auto application = of_type<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.apiVersion = version_;
    auto messages =
        of_type<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    messages.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT;
    messages.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;  // not the loader's messages on other drivers
    messages.pfnUserCallback = take_complaint;
    messages.pUserData = this;
    const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    auto info = of_type<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    if (has_validation_layer()) {
      info.enabledLayerCount = 1;
      info.ppEnabledLayerNames = &kValidationLayer;
      info.enabledExtensionCount = 1;
      info.ppEnabledExtensionNames = &extension;
    }
    const VkResult made = call<PFN_vkCreateInstance>("vkCreateInstance")(&info, nullptr, &instance_);
    if (made == VK_ERROR_INCOMPATIBLE_DRIVER) return fail("libvulkan finds no driver that works");
    if (made != VK_SUCCESS) return refused("vkCreateInstance", made);
    if (info.enabledLayerCount == 0) return {};
    const auto listen = call<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT");
    const VkResult heard = listen(instance_, &messages, nullptr, &messenger_);
    return heard == VK_SUCCESS ? Result<void>() : refused("vkCreateDebugUtilsMessengerEXT", heard);
  }

  bool has_validation_layer() const {
    const auto list = call<PFN_vkEnumerateInstanceLayerProperties>("vkEnumerateInstanceLayerProperties");
    std::uint32_t count = 0;
    if (list(&count, nullptr) != VK_SUCCESS) return false;
    std::vector<VkLayerProperties> layers(count);
    if (list(&count, layers.data()) != VK_SUCCESS) return false;
    return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
      return std::string_view(layer.layerName) == kValidationLayer;
    });
  }

  static VKAPI_ATTR VkBool32 VKAPI_CALL take_complaint(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                       VkDebugUtilsMessageTypeFlagsEXT,
                                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* self) {
    static_cast<Instance*>(self)->complaints_ += fmt::format("{}\n", data->pMessage);
    return VK_FALSE;  // so that the call goes on
  }

  // The smallest comes first.
  std::tuple<int, std::string, std::uint32_t> rank_of(VkPhysicalDevice device) const {
    const VkPhysicalDeviceProperties properties = properties_of(device);
    constexpr std::array kFirst = {VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU,
                                   VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU, VK_PHYSICAL_DEVICE_TYPE_CPU};
    const auto type = std::find(kFirst.begin(), kFirst.end(), properties.deviceType);
    return {static_cast<int>(type - kFirst.begin()), properties.deviceName, properties.driverVersion};
  }

  PFN_vkGetInstanceProcAddr find_;
  std::uint32_t version_ = VK_API_VERSION_1_0;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::string complaints_;
};

class Kernel final : public VulkanKernel {
 public:
  explicit Kernel(UniqueHandle<VkPipeline> pipeline) : pipeline_(std::move(pipeline)) {}
  VkPipeline pipeline() const { return pipeline_.get(); }

 private:
  UniqueHandle<VkPipeline> pipeline_;
};

// A buffer that the CPU sees.
struct Buffer {
  UniqueHandle<VkDeviceMemory> memory;  // goes after the buffer in it
  UniqueHandle<VkBuffer> buffer;
  void* words = nullptr;
  VkDeviceSize bytes = 0;
};

class Device final : public VulkanDevice {
 public:
  explicit Device(std::unique_ptr<Instance> instance) : instance_(std::move(instance)) {}
  ~Device() override {
    // The objects of the device go before it.
    buffers_ = {};
    fence_ = {};
    pool_ = {};
    sets_ = {};
    layout_ = {};
    set_layout_ = {};
    if (device_ != VK_NULL_HANDLE) call<PFN_vkDestroyDevice>("vkDestroyDevice")(device_, nullptr);
  }

  Result<void> start(int number) {
    HN_TRY(const auto devices, instance_->devices());
    const auto index = static_cast<std::size_t>(number);
    if (index >= devices.size()) {
      return fail(fmt::format("there is no Vulkan device {}; this machine has {}", number, devices.size()));
    }
    gpu_ = devices[index];
    info_ = instance_->describe(gpu_);
    HN_DO(create_device());
    HN_DO(create_layout());
    HN_DO(create_set());
    HN_DO(create_commands());
    return without_complaints();
  }

  const VulkanDeviceInfo& info() const override { return info_; }
  bool is_lost() const override { return lost_; }

  Result<std::unique_ptr<VulkanKernel>> build(std::span<const std::uint32_t> spirv) override {
    auto module_info = of_type<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    module_info.codeSize = spirv.size_bytes();
    module_info.pCode = spirv.data();
    const auto module = create<VkShaderModule, PFN_vkCreateShaderModule, PFN_vkDestroyShaderModule>(
        "vkCreateShaderModule", "vkDestroyShaderModule", module_info);
    HN_DO(without_complaints());
    if (!module) return tl::unexpected(module.error());
    auto info = of_type<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module->get();
    info.stage.pName = "main";
    info.layout = layout_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult made = call<PFN_vkCreateComputePipelines>("vkCreateComputePipelines")(device_, VK_NULL_HANDLE, 1,
                                                                                         &info, nullptr, &pipeline);
    UniqueHandle<VkPipeline> owned(device_, pipeline, call<PFN_vkDestroyPipeline>("vkDestroyPipeline"));
    HN_DO(without_complaints());
    if (made != VK_SUCCESS) return note("vkCreateComputePipelines", made);
    return std::make_unique<Kernel>(std::move(owned));
  }

  Result<void> run(const VulkanKernel& kernel, std::span<const std::uint32_t> points,
                   std::span<const std::uint32_t> uniforms, std::uint32_t groups,
                   std::span<std::uint32_t> results) override {
    HN_DO(fill(kResultsBinding, results));
    HN_DO(fill(kPointsBinding, points));
    HN_DO(fill(kUniformsBinding, uniforms));
    const auto done = record(static_cast<const Kernel&>(kernel).pipeline(), groups).and_then([&] { return submit(); });
    HN_DO(without_complaints());
    if (!done) return done;
    std::memcpy(results.data(), buffers_[kResultsBinding].words, results.size_bytes());
    return {};
  }

 private:
  template <typename Pointer>
  Pointer call(const char* name) const {
    return instance_->call<Pointer>(name);
  }

  // An error of a function of the device; a device that is lost does not come back.
  tl::unexpected<Error> note(std::string_view function, VkResult result) {
    if (result == VK_ERROR_DEVICE_LOST) lost_ = true;
    return refused(function, result);
  }
  Result<void> noted(std::string_view function, VkResult result) {
    return result == VK_SUCCESS ? Result<void>() : note(function, result);
  }

  // Who breaks a rule of Vulkan may get any values.
  Result<void> without_complaints() {
    const std::string complaints = instance_->complaints();
    return complaints.empty() ? Result<void>() : fail("the validation layers complain", complaints);
  }

  template <typename Handle, typename Create, typename Destroy, typename Info>
  Result<UniqueHandle<Handle>> create(const char* create_name, const char* destroy_name, const Info& info) {
    Handle handle = VK_NULL_HANDLE;
    const VkResult made = call<Create>(create_name)(device_, &info, nullptr, &handle);
    if (made != VK_SUCCESS) return note(create_name, made);
    return UniqueHandle<Handle>(device_, handle, call<Destroy>(destroy_name));
  }

  Result<void> create_device() {
    std::uint32_t count = 0;
    const auto list = call<PFN_vkGetPhysicalDeviceQueueFamilyProperties>("vkGetPhysicalDeviceQueueFamilyProperties");
    list(gpu_, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    list(gpu_, &count, families.data());
    const auto family = std::find_if(families.begin(), families.end(), [](const VkQueueFamilyProperties& one) {
      return (one.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0;
    });
    if (family == families.end()) return fail(fmt::format("{} runs no compute shaders", info_.name));
    family_ = static_cast<std::uint32_t>(family - families.begin());
    const float priority = 1.0f;
    auto queue = of_type<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = family_;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    auto info = of_type<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    HN_DO(noted("vkCreateDevice", call<PFN_vkCreateDevice>("vkCreateDevice")(gpu_, &info, nullptr, &device_)));
    call<PFN_vkGetDeviceQueue>("vkGetDeviceQueue")(device_, family_, 0, &queue_);
    call<PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties")(gpu_, &memory_);
    return {};
  }

  Result<void> create_layout() {
    std::array<VkDescriptorSetLayoutBinding, kBindings> bindings{};
    for (std::uint32_t i = 0; i < kBindings; ++i) {
      bindings[i].binding = i;
      bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
      bindings[i].descriptorCount = 1;
      bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    auto set_info = of_type<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    set_info.bindingCount = kBindings;
    set_info.pBindings = bindings.data();
    HN_TRY(set_layout_,
           create<VkDescriptorSetLayout, PFN_vkCreateDescriptorSetLayout, PFN_vkDestroyDescriptorSetLayout>(
               "vkCreateDescriptorSetLayout", "vkDestroyDescriptorSetLayout", set_info));
    const VkDescriptorSetLayout set_layout = set_layout_.get();
    auto info = of_type<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_layout;
    HN_TRY(layout_, create<VkPipelineLayout, PFN_vkCreatePipelineLayout, PFN_vkDestroyPipelineLayout>(
                        "vkCreatePipelineLayout", "vkDestroyPipelineLayout", info));
    return {};
  }

  Result<void> create_set() {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kBindings};
    auto pool_info = of_type<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    HN_TRY(sets_, create<VkDescriptorPool, PFN_vkCreateDescriptorPool, PFN_vkDestroyDescriptorPool>(
                      "vkCreateDescriptorPool", "vkDestroyDescriptorPool", pool_info));
    const VkDescriptorSetLayout set_layout = set_layout_.get();
    auto info = of_type<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    info.descriptorPool = sets_.get();
    info.descriptorSetCount = 1;
    info.pSetLayouts = &set_layout;
    return noted("vkAllocateDescriptorSets",
                 call<PFN_vkAllocateDescriptorSets>("vkAllocateDescriptorSets")(device_, &info, &set_));
  }

  Result<void> create_commands() {
    auto pool_info = of_type<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool_info.queueFamilyIndex = family_;
    HN_TRY(pool_, create<VkCommandPool, PFN_vkCreateCommandPool, PFN_vkDestroyCommandPool>(
                      "vkCreateCommandPool", "vkDestroyCommandPool", pool_info));
    auto info = of_type<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    info.commandPool = pool_.get();
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    HN_DO(noted("vkAllocateCommandBuffers",
                call<PFN_vkAllocateCommandBuffers>("vkAllocateCommandBuffers")(device_, &info, &commands_)));
    const auto fence_info = of_type<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    HN_TRY(fence_,
           create<VkFence, PFN_vkCreateFence, PFN_vkDestroyFence>("vkCreateFence", "vkDestroyFence", fence_info));
    return {};
  }

  // The words go into the buffer of the binding, which grows if it must.
  Result<void> fill(std::uint32_t binding, std::span<const std::uint32_t> words) {
    Buffer& buffer = buffers_[binding];
    if (buffer.bytes < words.size_bytes()) {
      buffer = {};
      HN_TRY(buffer, create_buffer(words.size_bytes()));
      const VkDescriptorBufferInfo whole{buffer.buffer.get(), 0, VK_WHOLE_SIZE};
      auto write = of_type<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
      write.dstSet = set_;
      write.dstBinding = binding;
      write.descriptorCount = 1;
      write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
      write.pBufferInfo = &whole;
      call<PFN_vkUpdateDescriptorSets>("vkUpdateDescriptorSets")(device_, 1, &write, 0, nullptr);
    }
    std::memcpy(buffer.words, words.data(), words.size_bytes());
    return {};
  }

  Result<Buffer> create_buffer(VkDeviceSize bytes) {
    Buffer made;
    made.bytes = bytes;
    auto info = of_type<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    HN_TRY(made.buffer,
           create<VkBuffer, PFN_vkCreateBuffer, PFN_vkDestroyBuffer>("vkCreateBuffer", "vkDestroyBuffer", info));
    VkMemoryRequirements needs{};
    call<PFN_vkGetBufferMemoryRequirements>("vkGetBufferMemoryRequirements")(device_, made.buffer.get(), &needs);
    auto memory = of_type<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    memory.allocationSize = needs.size;
    memory.memoryTypeIndex = memory_type(needs.memoryTypeBits);
    HN_TRY(made.memory,
           create<VkDeviceMemory, PFN_vkAllocateMemory, PFN_vkFreeMemory>("vkAllocateMemory", "vkFreeMemory", memory));
    HN_DO(noted("vkBindBufferMemory",
                call<PFN_vkBindBufferMemory>("vkBindBufferMemory")(device_, made.buffer.get(), made.memory.get(), 0)));
    HN_DO(noted("vkMapMemory",
                call<PFN_vkMapMemory>("vkMapMemory")(device_, made.memory.get(), 0, VK_WHOLE_SIZE, 0, &made.words)));
    return made;
  }

  // Vulkan promises memory that the CPU sees without further ado for every buffer; reading is faster where it is
  // cached.
  std::uint32_t memory_type(std::uint32_t allowed) const {
    constexpr VkMemoryPropertyFlags kSeen = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    for (const VkMemoryPropertyFlags wanted : {kSeen | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, kSeen}) {
      for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
        const bool fits = (allowed & (1u << i)) != 0 && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted;
        if (fits) return i;
      }
    }
    return 0;
  }

  Result<void> record(VkPipeline pipeline, std::uint32_t groups) {
    HN_DO(noted("vkResetCommandPool", call<PFN_vkResetCommandPool>("vkResetCommandPool")(device_, pool_.get(), 0)));
    auto info = of_type<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    HN_DO(noted("vkBeginCommandBuffer", call<PFN_vkBeginCommandBuffer>("vkBeginCommandBuffer")(commands_, &info)));
    constexpr auto kCompute = VK_PIPELINE_BIND_POINT_COMPUTE;
    call<PFN_vkCmdBindPipeline>("vkCmdBindPipeline")(commands_, kCompute, pipeline);
    call<PFN_vkCmdBindDescriptorSets>("vkCmdBindDescriptorSets")(commands_, kCompute, layout_.get(), 0, 1, &set_, 0,
                                                                 nullptr);
    call<PFN_vkCmdDispatch>("vkCmdDispatch")(commands_, groups, 1, 1);
    auto written = of_type<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    call<PFN_vkCmdPipelineBarrier>("vkCmdPipelineBarrier")(commands_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                                                           VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &written, 0, nullptr, 0,
                                                           nullptr);
    return noted("vkEndCommandBuffer", call<PFN_vkEndCommandBuffer>("vkEndCommandBuffer")(commands_));
  }

  Result<void> submit() {
    auto info = of_type<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    const VkFence fence = fence_.get();
    HN_DO(noted("vkQueueSubmit", call<PFN_vkQueueSubmit>("vkQueueSubmit")(queue_, 1, &info, fence)));
    HN_DO(noted("vkWaitForFences",
                call<PFN_vkWaitForFences>("vkWaitForFences")(device_, 1, &fence, VK_TRUE, UINT64_MAX)));
    return noted("vkResetFences", call<PFN_vkResetFences>("vkResetFences")(device_, 1, &fence));
  }

  std::unique_ptr<Instance> instance_;
  VulkanDeviceInfo info_{};
  bool lost_ = false;
  VkPhysicalDevice gpu_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
  VkDevice device_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  UniqueHandle<VkDescriptorSetLayout> set_layout_;
  UniqueHandle<VkPipelineLayout> layout_;
  UniqueHandle<VkDescriptorPool> sets_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  UniqueHandle<VkCommandPool> pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  UniqueHandle<VkFence> fence_;
  std::array<Buffer, kBindings> buffers_;
};

}  // namespace

Result<std::unique_ptr<VulkanDevice>> open_vulkan_device(int number) {
  HN_TRY(auto instance, Instance::create());
  auto device = std::make_unique<Device>(std::move(instance));
  HN_DO(device->start(number));
  return device;
}

int vulkan_device_count() {
  const auto instance = Instance::create();
  if (!instance) return 0;
  const auto devices = (*instance)->devices();
  return devices ? static_cast<int>(devices->size()) : 0;
}

}  // namespace hn
